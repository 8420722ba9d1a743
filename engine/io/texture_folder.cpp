// SPDX-License-Identifier: MIT
#include "io/texture_folder.h"

#include <algorithm>
#include <map>
#include <set>

#include "document/check.h"
#include "io/image_decode.h"
#include "io/last_channel.h"

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

/// Whether the name begins with those words: "metal_032" with "metal", not with "met".
bool begins_with(std::string_view name, std::string_view words) {
    return name.substr(0, words.size()) == words &&
           (name.size() == words.size() || words.empty() || name[words.size()] == '_');
}

/// "Metal032.png" beside "Metal032_2K_Color.png" is a picture of the material and no texture of
/// it: the word that it was guessed from is part of the material's name.
void drop_pictures(std::vector<TextureUseOfFile>& files) {
    std::set<std::string> stems;
    for (const TextureUseOfFile& file : files) stems.insert(file.guess.stem());
    for (TextureUseOfFile& file : files) {
        const std::string name = words_as_stem(file.file.stem().string());
        const std::string& own = file.guess.before;
        const auto holds_word = [&](const std::string& stem) {
            return stem.size() > own.size() && begins_with(stem, own) && begins_with(name, stem);
        };
        if (std::any_of(stems.begin(), stems.end(), holds_word)) file.guess = {};
    }
}

/// The materials that the files are textures of, by the stems of their names.
std::set<std::string> materials_of(const std::vector<TextureUseOfFile>& files) {
    std::set<std::string> stems;
    for (const TextureUseOfFile& file : files)
        if (!file.guess.channels.empty() && !file.guess.stem().empty())
            stems.insert(file.guess.stem());
    return stems;
}

/// Fails where the files are of several materials: as one layer they would hide each other.
Status check_one_material(const std::vector<TextureUseOfFile>& files, const fs::path& folder) {
    const std::set<std::string> stems = materials_of(files);
    if (stems.size() < 2) return {};
    std::string names;
    for (const std::string& stem : stems) names += (names.empty() ? "" : ", ") + stem;
    return failure(
        "{}: holds the textures of {} materials: {}; give each a folder of its own, or name the "
        "one that is meant: {}",
        quoted_for_message(folder.string()), stems.size(), quoted_for_message(names, 200),
        quoted_for_message((folder / *stems.begin()).string()));
}

/// The image files of a folder, or those of one material where the path goes on with its name.
Result<std::vector<TextureUseOfFile>> texture_files(const fs::path& path) {
    std::error_code error;
    const bool of_one =
        !fs::is_directory(path, error) && fs::is_directory(path.parent_path(), error);
    const auto paths = image_files(of_one ? path.parent_path() : path);
    if (!paths) return passed_on(paths);
    std::vector<TextureUseOfFile> files;
    for (const fs::path& file : *paths)
        files.push_back({.file = file,
                         .guess = guess_texture(file.filename().string()),
                         .used = {},
                         .described = {}});
    drop_pictures(files);
    if (!of_one) {
        if (const Status one = check_one_material(files, path); !one) return passed_on(one);
        return files;
    }
    const std::string wanted = words_as_stem(path.filename().string());
    std::erase_if(files, [&](const TextureUseOfFile& file) { return file.guess.stem() != wanted; });
    if (wanted.empty() || files.empty())
        return failure("{}: is no folder, and no texture's name in {} begins so",
                       quoted_for_message(path.string()),
                       quoted_for_message(path.parent_path().string()));
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
        if (file.guess.channels.size() > 1 || channel.pick == ChannelPick::Alpha)
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
    }
}

bool has_clear_texels(const ImageAsset& image, ImageStore& store) {
    if (image.channels != 2 && image.channels != 4) return false;
    const auto pixels = store.pixels(image.hash);
    return pixels && !last_is_one(**pixels);
}

const TextureChannel* use_for(const TextureUseOfFile& file, Channel channel) {
    const auto found =
        std::find_if(file.used.begin(), file.used.end(),
                     [&](const TextureChannel& use) { return use.channel == channel; });
    return found == file.used.end() ? nullptr : &*found;
}

/// Opacity that no file is for is the alpha of the base colour, where that says something.
void take_opacity_from_alpha(std::vector<TextureUseOfFile>& files,
                             const std::vector<ImageAssetPtr>& images, ImageStore& store) {
    for (const TextureUseOfFile& file : files)
        if (use_for(file, Channel::Opacity)) return;
    for (std::size_t i = 0; i < files.size(); ++i)
        if (use_for(files[i], Channel::BaseColor) && has_clear_texels(*images[i], store))
            files[i].used.push_back({.channel = Channel::Opacity, .pick = ChannelPick::Alpha});
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
    auto files = texture_files(folder);
    if (!files) return passed_on(files);
    TextureFolder result{.layer = {}, .images = {}, .files = std::move(*files)};
    share_out_channels(result.files);
    if (std::all_of(result.files.begin(), result.files.end(),
                    [](const TextureUseOfFile& file) { return file.used.empty(); }))
        return failure("{}: no image there says in its name what it is (such as wood_rough.png)",
                       quoted_for_message(folder.string()));
    progress.set_stage(fmt::format("Decoding {} textures", result.files.size()));
    const auto images = decoded(result.files, store, progress);
    if (!images) return passed_on(images);
    take_opacity_from_alpha(result.files, *images, store);
    const std::string name = fs::weakly_canonical(folder).filename().string();
    result.layer.name = check_name(name) ? name : "Textures";
    for (std::size_t i = 0; i < result.files.size(); ++i) {
        TextureUseOfFile& file = result.files[i];
        file.described = described(file);
        if (file.used.empty()) continue;
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
