// SPDX-License-Identifier: MIT
#include "io/preset_library.h"

#include <algorithm>

#include "core/files.h"
#include "core/log.h"

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

Result<std::vector<fs::path>> shipped_files() {
    const auto folder = resource_folder("presets");
    if (!folder) return passed_on(folder);
    std::vector<fs::path> paths;
    std::error_code error;
    for (fs::directory_iterator at(*folder, error), end; !error && at != end; at.increment(error))
        if (at->path().extension() == ".json" && at->path().filename() != kSchemaFile)
            paths.push_back(at->path());
    if (error)
        return failure("{}: cannot list it: {}", quoted_for_message(folder->string()),
                       error.message());
    std::sort(paths.begin(), paths.end());
    return paths;
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
    const auto paths = shipped_files();
    if (!paths) return passed_on(paths);
    std::vector<PresetFile> presets;
    for (const fs::path& path : *paths) {
        auto file = read_preset(path);
        if (file)
            presets.push_back(std::move(*file));
        else
            log_warning("{}", file.error().message);
    }
    std::sort(presets.begin(), presets.end(),
              [](const PresetFile& a, const PresetFile& b) { return a.preset.id < b.preset.id; });
    return presets;
}

Result<PresetFile> find_preset(std::string_view name_or_path) {
    if (is_path(name_or_path)) return read_preset(name_or_path);
    auto presets = shipped_presets();
    if (!presets) return passed_on(presets);
    std::string known;
    for (PresetFile& file : *presets) {
        if (file.preset.id == name_or_path) return std::move(file);
        known += (known.empty() ? "" : ", ") + file.preset.id;
    }
    return failure("no preset is named '{}'; there are {}", quoted_for_message(name_or_path),
                   known);
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
