// SPDX-License-Identifier: MIT
#include "io/texture_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

namespace patina::io {
namespace {

constexpr TextureChannel whole(Channel channel) {
    return {.channel = channel, .pick = ChannelPick::Rgb};
}
constexpr TextureChannel part(Channel channel, ChannelPick pick) {
    return {.channel = channel, .pick = pick};
}

struct Kind {
    std::array<TextureChannel, 3> channels;
    int count = 1;
    bool directx_normal = false;
    int preference = 2;
};
constexpr Kind one(TextureChannel channel, int preference = 2) {
    return {.channels = {channel}, .preference = preference};
}
constexpr Kind scalar(Channel channel) {
    return one(part(channel, ChannelPick::Red));
}
/// Three channels of one texture; dedicated textures are preferred.
constexpr Kind packed(Channel red, Channel green, Channel blue) {
    return {.channels = {part(red, ChannelPick::Red), part(green, ChannelPick::Green),
                         part(blue, ChannelPick::Blue)},
            .count = 3,
            .preference = 1};
}
/// As glTF has them.
constexpr Kind kMetallicRoughness = {.channels = {part(Channel::Roughness, ChannelPick::Green),
                                                  part(Channel::Metalness, ChannelPick::Blue)},
                                     .count = 2,
                                     .preference = 1};
constexpr Kind kGloss =
    one({.channel = Channel::Roughness, .pick = ChannelPick::Red, .invert = true}, 1);
constexpr Kind kNormal = one(whole(Channel::Normal));
constexpr Kind kNormalGl = one(whole(Channel::Normal), 3);
constexpr Kind kNormalDx = {
    .channels = {whole(Channel::Normal)}, .directx_normal = true, .preference = 1};
constexpr Kind kOrm = packed(Channel::Occlusion, Channel::Roughness, Channel::Metalness);

struct Word {
    std::string_view word;  ///< one or several words of the name run together
    Kind kind;
};
constexpr auto kWords = std::to_array<Word>({
    {"albedo", one(whole(Channel::BaseColor), 3)},
    {"basecolor", one(whole(Channel::BaseColor), 3)},
    {"basecolour", one(whole(Channel::BaseColor), 3)},
    {"basecol", one(whole(Channel::BaseColor), 3)},
    {"base", one(whole(Channel::BaseColor))},
    {"color", one(whole(Channel::BaseColor))},
    {"colour", one(whole(Channel::BaseColor))},
    {"col", one(whole(Channel::BaseColor))},
    {"diffuse", one(whole(Channel::BaseColor))},
    {"diff", one(whole(Channel::BaseColor))},
    {"roughness", scalar(Channel::Roughness)},
    {"rough", scalar(Channel::Roughness)},
    {"rgh", scalar(Channel::Roughness)},
    {"glossiness", kGloss},
    {"gloss", kGloss},
    {"smoothness", kGloss},
    {"metalness", scalar(Channel::Metalness)},
    {"metallic", scalar(Channel::Metalness)},
    {"metal", scalar(Channel::Metalness)},
    {"mtl", scalar(Channel::Metalness)},
    {"normalgl", kNormalGl},
    {"nrmgl", kNormalGl},
    {"norgl", kNormalGl},
    {"normalopengl", kNormalGl},
    {"normaldx", kNormalDx},
    {"nrmdx", kNormalDx},
    {"nordx", kNormalDx},
    {"normaldirectx", kNormalDx},
    {"normal", kNormal},
    {"norm", kNormal},
    {"nrm", kNormal},
    {"nor", kNormal},
    {"nml", kNormal},
    {"displacement", scalar(Channel::Height)},
    {"disp", scalar(Channel::Height)},
    {"height", scalar(Channel::Height)},
    {"bump", one(part(Channel::Height, ChannelPick::Red), 1)},
    {"ambientocclusion", scalar(Channel::Occlusion)},
    {"occlusion", scalar(Channel::Occlusion)},
    {"occ", scalar(Channel::Occlusion)},
    {"ao", scalar(Channel::Occlusion)},
    {"emissive", one(whole(Channel::Emissive))},
    {"emission", one(whole(Channel::Emissive))},
    {"emit", one(whole(Channel::Emissive))},
    {"glow", one(whole(Channel::Emissive))},
    {"opacity", scalar(Channel::Opacity)},
    {"alpha", scalar(Channel::Opacity)},
    {"transparency", scalar(Channel::Opacity)},
    {"occlusionroughnessmetallic", kOrm},
    {"occlusionroughnessmetalness", kOrm},
    {"orm", kOrm},
    {"arm", kOrm},
    {"rma", packed(Channel::Roughness, Channel::Metalness, Channel::Occlusion)},
    {"mra", packed(Channel::Metalness, Channel::Roughness, Channel::Occlusion)},
    {"metallicroughness", kMetallicRoughness},
    {"metalnessroughness", kMetallicRoughness},
    {"roughnessmetallic", kMetallicRoughness},
    {"roughnessmetalness", kMetallicRoughness},
    {"metalrough", kMetallicRoughness},
});
/// Only as the last word, after a separator: T_Rock_N.
constexpr auto kLetters = std::to_array<Word>({
    {"d", one(whole(Channel::BaseColor), 1)},
    {"n", one(whole(Channel::Normal), 1)},
    {"r", one(part(Channel::Roughness, ChannelPick::Red), 1)},
    {"m", one(part(Channel::Metalness, ChannelPick::Red), 1)},
    {"h", one(part(Channel::Height, ChannelPick::Red), 1)},
    {"e", one(whole(Channel::Emissive), 1)},
});

bool is_upper(char c) {
    return c >= 'A' && c <= 'Z';
}
bool is_lower(char c) {
    return c >= 'a' && c <= 'z';
}
bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// "Wood062_2K-JPG_AmbientOcclusion" as wood, 062, 2, k, jpg, ambient, occlusion.
std::vector<std::string> words_of(std::string_view name) {
    std::vector<std::string> words;
    char before = 0;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const char c = name[i];
        const bool letter = is_upper(c) || is_lower(c);
        if (!letter && !is_digit(c)) {
            before = 0;
            continue;
        }
        const bool next_is_lower = i + 1 < name.size() && is_lower(name[i + 1]);
        const bool starts = before == 0 || is_digit(c) != is_digit(before) ||
                            (is_upper(c) && is_lower(before)) ||
                            (is_upper(c) && is_upper(before) && next_is_lower);
        if (starts) words.emplace_back();
        words.back() += is_upper(c) ? static_cast<char>(c - 'A' + 'a') : c;
        before = c;
    }
    return words;
}

/// Resolutions, versions and formats: 2k, 4096, v2, jpg.
bool says_nothing(const std::string& word) {
    constexpr std::array kPassedOver = std::to_array<std::string_view>(
        {"k", "v", "jpg", "jpeg", "png", "tif", "tiff", "exr", "hdr", "map", "texture", "tex"});
    return std::all_of(word.begin(), word.end(), is_digit) ||
           std::find(kPassedOver.begin(), kPassedOver.end(), word) != kPassedOver.end();
}

template <typename Table>
const Word* find_word(const Table& table, std::string_view text) {
    const auto found = std::find_if(table.begin(), table.end(),
                                    [&](const Word& entry) { return entry.word == text; });
    return found == table.end() ? nullptr : &*found;
}

/// The entry for the most words that end with words[last].
const Word* longest_ending(const std::vector<std::string>& words, std::size_t last) {
    const Word* found = nullptr;
    std::string text;
    for (std::size_t i = last + 1; i-- > 0 && last - i < 3;) {
        text.insert(0, words[i]);
        if (const Word* entry = find_word(kWords, text)) found = entry;
    }
    return found;
}

}  // namespace

TextureGuess guess_texture(std::string_view file_name) {
    const std::size_t dot = file_name.rfind('.');
    std::vector<std::string> words = words_of(file_name.substr(0, dot));
    while (!words.empty() && says_nothing(words.back())) words.pop_back();
    const Word* found = nullptr;
    if (words.size() > 1) found = find_word(kLetters, words.back());
    for (std::size_t last = words.size(); last-- > 0 && !found;)
        found = longest_ending(words, last);
    if (!found) return {};
    const Kind& kind = found->kind;
    return {.channels = {kind.channels.begin(), kind.channels.begin() + kind.count},
            .directx_normal = kind.directx_normal,
            .word = std::string(found->word),
            .preference = kind.preference};
}

}  // namespace patina::io
