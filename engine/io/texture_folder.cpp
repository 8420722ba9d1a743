// SPDX-License-Identifier: MIT
#include "io/texture_folder.h"

#include <algorithm>
#include <map>

#include "document/check.h"
#include "io/image_decode.h"

namespace patina::io {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 1000;

Result<std::vector<fs::path>> image_files(const fs::path& folder) {
    std::error_code error;
    std::vector<fs::path> files;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
        std::error_code ignored;
        if (!it->is_regular_file(ignored)) continue;
        const std::string name = it->path().filename().string();
        if (!name.empty() && name[0] != '.' && has_image_extension(name))
            files.push_back(it->path());
        if (files.size() > kMostFiles)
            return failure("{}: holds more than {} images; pick the folder of one material",
                           quoted_for_message(folder.string()), kMostFiles);
    }
    if (error)
        return failure("{}: cannot be read as a folder: {}", quoted_for_message(folder.string()),
                       error.message());
    std::sort(files.begin(), files.end());
    return files;
}

/// Gives each channel to the file that suits it best; of equals, to the first by name.
void share_out_channels(std::vector<TextureUseOfFile>& files) {
    std::map<Channel, TextureUseOfFile*> best;
    for (TextureUseOfFile& file : files)
        for (const TextureChannel& channel : file.guess.channels) {
            TextureUseOfFile*& holder = best[channel.channel];
            if (!holder || file.guess.preference > holder->guess.preference) holder = &file;
        }
    for (TextureUseOfFile& file : files)
        for (const TextureChannel& channel : file.guess.channels)
            if (best[channel.channel] == &file) file.used.push_back(channel);
}

std::string described(const TextureUseOfFile& file) {
    const std::string name = quoted_for_message(file.file.filename().string(), 80);
    if (file.guess.channels.empty()) return name + ": not used, its name does not say what it is";
    if (file.used.empty())
        return fmt::format("{}: not used, another file suits better (\"{}\")", name,
                           file.guess.word);
    std::string text = name + ": ";
    for (const TextureChannel& channel : file.used) {
        if (&channel != &file.used.front()) text += ", ";
        text += info(channel.channel).id;
        if (file.guess.channels.size() > 1)
            text += fmt::format(" from {}", choice(channel.pick).id);
        if (channel.invert) text += " inverted";
    }
    if (file.guess.directx_normal) text += ", DirectX";
    return text + fmt::format(" (\"{}\")", file.guess.word);
}

ImageSource source_of(const TextureChannel& channel, const TextureUseOfFile& file,
                      const ImageAsset& image) {
    ImageSource source;
    source.image = image.hash;
    source.pick = channel.pick;
    source.invert = channel.invert;
    source.directx_normal = channel.channel == Channel::Normal && file.guess.directx_normal;
    if (info(channel.channel).kind == ChannelKind::Color) source.color_space = image.color_space;
    // 0.5 is the surface, 0 and 1 are half a height below and above it.
    if (channel.channel == Channel::Height) source.add = glm::vec3(-0.5f);
    return source;
}

void feed(Layer& layer, const TextureUseOfFile& file, const ImageAsset& image) {
    for (const TextureChannel& channel : file.used) {
        ChannelSettings& settings = at(layer.channels, channel.channel);
        settings.enabled = true;
        settings.source = source_of(channel, file, image);
        const bool has_alpha = image.channels == 2 || image.channels == 4;
        ChannelSettings& opacity = at(layer.channels, Channel::Opacity);
        if (channel.channel != Channel::BaseColor || !has_alpha || opacity.enabled) continue;
        opacity.enabled = true;
        opacity.source =
            source_of({.channel = Channel::Opacity, .pick = ChannelPick::Alpha}, file, image);
    }
}

/// By the places of `files`; null for those that no channel uses.
Result<std::vector<ImageAssetPtr>> decoded(const std::vector<TextureUseOfFile>& files,
                                           ImageStore& store, const Progress& progress) {
    std::vector<fs::path> paths;
    for (const TextureUseOfFile& file : files)
        if (!file.used.empty()) paths.push_back(file.file);
    const std::vector<Result<ImageAssetPtr>> added = store.add_files(paths, progress);
    if (progress.cancelled()) return failure("cancelled");
    std::vector<ImageAssetPtr> images;
    auto next = added.begin();
    for (const TextureUseOfFile& file : files) {
        images.push_back(nullptr);
        if (file.used.empty()) continue;
        if (!*next) return passed_on(*next);
        images.back() = **next++;
    }
    return images;
}

}  // namespace

Result<TextureFolder> read_texture_folder(const fs::path& folder, ImageStore& store,
                                          const Progress& progress) {
    const auto paths = image_files(folder);
    if (!paths) return passed_on(paths);
    TextureFolder result;
    for (const fs::path& path : *paths) {
        const TextureGuess guess = guess_texture(path.filename().string());
        result.files.push_back({.file = path, .guess = guess, .used = {}, .described = {}});
    }
    share_out_channels(result.files);
    for (TextureUseOfFile& file : result.files) file.described = described(file);
    if (std::all_of(result.files.begin(), result.files.end(),
                    [](const TextureUseOfFile& file) { return file.used.empty(); }))
        return failure("{}: no image there says in its name what it is (such as wood_rough.png)",
                       quoted_for_message(folder.string()));
    progress.set_stage(fmt::format("Decoding {} textures", result.files.size()));
    const auto images = decoded(result.files, store, progress);
    if (!images) return passed_on(images);
    const std::string name = fs::weakly_canonical(folder).filename().string();
    result.layer.name = check_name(name) ? name : "Textures";
    // Opacity has a file of its own before it is looked for in the base colour's alpha.
    for (const bool opacity : {true, false})
        for (std::size_t i = 0; i < result.files.size(); ++i) {
            const TextureUseOfFile& file = result.files[i];
            if (file.used.empty()) continue;
            if ((file.used.front().channel == Channel::Opacity) != opacity) continue;
            feed(result.layer, file, *(*images)[i]);
            result.images.push_back((*images)[i]);
        }
    return result;
}

bool is_texture_folder(const fs::path& path) {
    std::error_code error;
    return fs::is_directory(path, error);
}

}  // namespace patina::io
