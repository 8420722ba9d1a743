// SPDX-License-Identifier: MIT
#include "io/texture_names.h"

#include <algorithm>
#include <array>
#include <cctype>

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
constexpr TextureChannel kSmoothnessInAlpha = {
    .channel = Channel::Roughness, .pick = ChannelPick::Alpha, .invert = true};
/// As Unity's standard materials have them.
constexpr Kind kMetallicSmoothness = {
    .channels = {part(Channel::Metalness, ChannelPick::Red), kSmoothnessInAlpha},
    .count = 2,
    .preference = 1};
/// As those of its high definition pipeline have them; blue is the mask of details.
constexpr Kind kMaskMap = {
    .channels = {part(Channel::Metalness, ChannelPick::Red),
                 part(Channel::Occlusion, ChannelPick::Green), kSmoothnessInAlpha},
    .count = 3,
    .preference = 1};

struct Word {
    std::string_view word;  ///< one or several words of the name run together
    Kind kind;
};
constexpr auto kWords = std::to_array<Word>({
    {"albedo", one(whole(Channel::BaseColor), 3)},
    {"basecolor", one(whole(Channel::BaseColor), 3)},
    {"basecolour", one(whole(Channel::BaseColor), 3)},
    {"basecol", one(whole(Channel::BaseColor), 3)},
    {"albedotransparency", one(whole(Channel::BaseColor), 3)},
    {"basemap", one(whole(Channel::BaseColor), 3)},
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
    {"normalogl", kNormalGl},
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
    {"aoroughnessmetallic", kOrm},
    {"aoroughnessmetalness", kOrm},
    {"aoroughmetal", kOrm},
    {"orm", kOrm},
    {"arm", kOrm},
    {"rma", packed(Channel::Roughness, Channel::Metalness, Channel::Occlusion)},
    {"mra", packed(Channel::Metalness, Channel::Roughness, Channel::Occlusion)},
    {"metallicroughness", kMetallicRoughness},
    {"metalnessroughness", kMetallicRoughness},
    {"roughnessmetallic", kMetallicRoughness},
    {"roughnessmetalness", kMetallicRoughness},
    {"metalrough", kMetallicRoughness},
    {"metallicsmoothness", kMetallicSmoothness},
    {"maskmap", kMaskMap},
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

using Words = std::vector<std::string>;

bool is_number(const std::string& word) {
    return std::all_of(word.begin(), word.end(), is_digit);
}

/// Versions and formats: v, jpg.
bool says_nothing(const std::string& word) {
    constexpr std::array kPassedOver = std::to_array<std::string_view>(
        {"k", "v", "jpg", "jpeg", "png", "tif", "tiff", "exr", "hdr", "map", "texture", "tex"});
    return std::find(kPassedOver.begin(), kPassedOver.end(), word) != kPassedOver.end();
}

/// Without resolutions (2k, 4096) and formats. Other numbers tell one material from the next.
std::string joined(std::span<const std::string> words) {
    constexpr auto kSides =
        std::to_array<std::string_view>({"256", "512", "1024", "2048", "4096", "8192", "16384"});
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        const bool of_thousands = i + 1 < words.size() && words[i + 1] == "k" && is_number(word);
        if (of_thousands || std::find(kSides.begin(), kSides.end(), word) != kSides.end()) continue;
        if (says_nothing(word)) continue;
        text += (text.empty() ? "" : "_") + word;
    }
    return text;
}

template <typename Table>
const Word* find_word(const Table& table, std::string_view text) {
    const auto found = std::find_if(table.begin(), table.end(),
                                    [&](const Word& entry) { return entry.word == text; });
    return found == table.end() ? nullptr : &*found;
}

/// An entry of the tables, and the words of the name that it is.
struct FoundWord {
    const Word* entry = nullptr;
    std::size_t first = 0;
    std::size_t past = 0;
};

/// The entry for the most words that end with words[last].
FoundWord longest_ending(const Words& words, std::size_t last) {
    FoundWord found;
    std::string text;
    for (std::size_t i = last + 1; i-- > 0 && last - i < 3;) {
        text.insert(0, words[i]);
        if (const Word* entry = find_word(kWords, text)) found = {entry, i, last + 1};
    }
    return found;
}

FoundWord find_in(const Words& words) {
    std::size_t last = words.size();
    while (last > 0 && (is_number(words[last - 1]) || says_nothing(words[last - 1]))) --last;
    if (last > 1)
        if (const Word* entry = find_word(kLetters, words[last - 1]))
            return {entry, last - 1, last};
    FoundWord found;
    for (last = words.size(); last-- > 0 && !found.entry;) found = longest_ending(words, last);
    return found;
}

Words words_before_ending(std::string_view file_name) {
    return words_of(file_name.substr(0, file_name.rfind('.')));
}

}  // namespace

TextureGuess guess_texture(std::string_view file_name) {
    const Words words = words_before_ending(file_name);
    const FoundWord found = find_in(words);
    if (!found.entry) return {};
    const Kind& kind = found.entry->kind;
    const std::span<const std::string> all(words);
    return {.channels = {kind.channels.begin(), kind.channels.begin() + kind.count},
            .directx_normal = kind.directx_normal,
            .word = std::string(found.entry->word),
            .preference = kind.preference,
            .before = joined(all.first(found.first)),
            .after = joined(all.subspan(found.past))};
}

std::string words_as_stem(std::string_view name) {
    return joined(words_of(name));
}

}  // namespace patina::io
