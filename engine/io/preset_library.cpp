// SPDX-License-Identifier: MIT
#include "io/preset_library.h"

#include <algorithm>

#include "core/files.h"
#include "core/log.h"
#include "core/program_folders.h"
#include "core/user_folder.h"
#include "document/record.h"

namespace patina::io {
namespace {

namespace fs = std::filesystem;

/// A preset is text; its images are files of their own.
constexpr std::uint64_t kPresetLimitBytes = std::uint64_t{16} << 20;
/// It lies among the presets and is none.
constexpr std::string_view kSchemaFile = "schema.json";

bool is_path(std::string_view name) {
    return name.find('/') != std::string_view::npos || name.ends_with(".json");
}

Result<std::vector<fs::path>> preset_files(const fs::path& folder) {
    std::vector<fs::path> paths;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
        if (at->path().extension() == ".json" && at->path().filename() != kSchemaFile)
            paths.push_back(at->path());
    if (error)
        return failure("{}: cannot list it: {}", quoted_for_message(folder.string()),
                       error.message());
    std::sort(paths.begin(), paths.end());
    return paths;
}

bool has_id(const std::vector<PresetFile>& presets, const std::string& id) {
    return std::any_of(presets.begin(), presets.end(),
                       [&](const PresetFile& file) { return file.preset.id == id; });
}

/// Reads those that are good and not there yet.
void add_presets(const std::vector<fs::path>& paths, std::vector<PresetFile>& presets) {
    for (const fs::path& path : paths) {
        auto file = read_preset(path);
        if (!file)
            log_warning("{}", file.error().message);
        else if (has_id(presets, file->preset.id))
            log_warning("{}: left out, for there is another preset '{}'; give it another id",
                        quoted_for_message(path.string()), file->preset.id);
        else
            presets.push_back(std::move(*file));
    }
}

/// The file name of an image that goes beside the preset: named by its content.
std::string image_file_name(const ImageAsset& image) {
    const bool jpeg = image.mime_type == "image/jpeg";
    return to_hex(image.hash) + (jpeg ? ".jpg" : ".png");
}

struct NamedBytes {
    std::string name;
    std::shared_ptr<const Bytes> bytes;
};

/// The images that the layers read, named in the preset.
Result<std::vector<NamedBytes>> take_images(const Document& document, Preset& preset) {
    std::vector<NamedBytes> files;
    preset.images.clear();
    for (const Hash128& hash : images_of(preset.layers)) {
        const auto found = document.images.find(hash);
        if (found == document.images.end())
            return failure("an image that the layers read is missing from the file");
        const ImageAsset& image = *found->second;
        const auto encoded = image.encoded.bytes();
        if (!encoded) return failure("an image that the layers read has no bytes");
        preset.images.push_back({.file = image_file_name(image), .hash = hash});
        files.push_back({preset.images.back().file, encoded});
    }
    return files;
}

bool is_before(const PresetFile& a, const PresetFile& b) {
    return a.preset.id < b.preset.id;
}

}  // namespace

Result<PresetFile> read_preset(const fs::path& path) {
    const auto text = read_text_file(path, kPresetLimitBytes);
    if (!text) return passed_on(text);
    auto preset = preset_from_json(*text, quoted_for_message(path.string()));
    if (!preset) return passed_on(preset);
    return PresetFile{path, std::move(*preset)};
}

Result<std::vector<PresetFile>> shipped_presets() {
    const auto folder = resource_folder("presets");
    if (!folder) return passed_on(folder);
    const auto paths = preset_files(*folder);
    if (!paths) return passed_on(paths);
    std::vector<PresetFile> presets;
    add_presets(*paths, presets);
    std::sort(presets.begin(), presets.end(), is_before);
    return presets;
}

fs::path user_preset_folder() {
    const fs::path folder = user_folder("XDG_DATA_HOME", ".local/share");
    return folder.empty() ? folder : folder / "presets";
}

Result<std::vector<PresetFile>> all_presets() {
    auto presets = shipped_presets();
    if (!presets) return presets;
    std::error_code error;
    const fs::path folder = user_preset_folder();
    if (folder.empty() || !fs::is_directory(folder, error)) return presets;
    if (const auto paths = preset_files(folder))
        add_presets(*paths, *presets);
    else
        log_warning("{}", paths.error().message);
    std::sort(presets->begin(), presets->end(), is_before);
    return presets;
}

Result<PresetFile> find_preset(std::string_view name_or_path) {
    if (is_path(name_or_path)) return read_preset(name_or_path);
    auto presets = all_presets();
    if (!presets) return passed_on(presets);
    std::string known;
    for (PresetFile& file : *presets) {
        if (file.preset.id == name_or_path) return std::move(file);
        known += (known.empty() ? "" : ", ") + file.preset.id;
    }
    return failure("no preset is named '{}'; there are {}", quoted_for_message(name_or_path),
                   known);
}

std::string preset_id_of(std::string_view name) {
    constexpr std::size_t kLongest = 64;
    std::string id;
    for (const char letter : name) {
        const bool upper = letter >= 'A' && letter <= 'Z';
        const char lower = upper ? static_cast<char>(letter - 'A' + 'a') : letter;
        if ((lower >= 'a' && lower <= 'z') || (lower >= '0' && lower <= '9'))
            id += lower;
        else if (!id.empty() && id.back() != '-')
            id += '-';
    }
    id.resize(std::min(id.size(), kLongest));
    while (id.ends_with('-')) id.pop_back();
    return id.empty() ? "preset" : id;
}

Result<PresetFile> write_preset(const fs::path& file, Preset preset, const Document& document) {
    const auto images = take_images(document, preset);
    if (!images) return passed_on(images);
    const std::string text = preset_to_json(preset);
    // What the caller was told may not be fit for a preset.
    auto read = preset_from_json(text, quoted_for_message(file.string()));
    if (!read) return passed_on(read);
    const fs::path folder = file.parent_path();
    std::error_code error;
    if (!folder.empty()) fs::create_directories(folder, error);
    if (error)
        return failure("{}: cannot make the folder: {}", quoted_for_message(folder.string()),
                       error.message());
    for (const NamedBytes& image : *images)
        if (const Status written =
                write_file_atomically(folder / image.name, std::span(*image.bytes));
            !written)
            return passed_on(written);
    if (const Status written = write_file_atomically(file, text); !written)
        return passed_on(written);
    return PresetFile{file, std::move(*read)};
}

Result<std::vector<ImageAssetPtr>> add_preset_images(const PresetFile& file, ImageStore& images) {
    std::vector<fs::path> paths;
    for (const PresetImage& image : file.preset.images)
        paths.push_back(file.path.parent_path() / image.file);
    std::vector<ImageAssetPtr> assets;
    for (Result<ImageAssetPtr>& asset : images.add_files(paths)) {
        if (!asset) return passed_on(asset);
        const std::size_t i = assets.size();
        if ((*asset)->hash != file.preset.images[i].hash)
            return failure("{}: its pixels are not those that preset '{}' was made with",
                           quoted_for_message(paths[i].string()), file.preset.id);
        assets.push_back(std::move(*asset));
    }
    return assets;
}

}  // namespace patina::io
