// SPDX-License-Identifier: MIT
#include "editor/settings.h"

#include <array>
#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/json.h"
#include "core/user_folder.h"

namespace patina::editor {
namespace {

namespace fs = std::filesystem;

constexpr double kMostPixels = 16384.0;

/// A number of the file within its range, or what was there before.
template <typename Number>
void read_number(const SortedJson& object, const char* key, double minimum, double maximum,
                 Number& value) {
    const auto found = object.find(key);
    if (found == object.end() || !found->is_number()) return;
    const auto number = found->get<double>();
    if (number >= minimum && number <= maximum) value = static_cast<Number>(number);
}

void read_flag(const SortedJson& object, const char* key, bool& value) {
    const auto found = object.find(key);
    if (found != object.end() && found->is_boolean()) value = found->get<bool>();
}

void read_names(const SortedJson& object, const char* key, std::set<std::string>& names) {
    const auto found = object.find(key);
    if (found == object.end() || !found->is_array()) return;
    for (const SortedJson& name : *found)
        if (name.is_string()) names.insert(name.get<std::string>());
}

struct SplitterKey {
    const char* key;
    float Splitters::*member;
};
constexpr std::array<SplitterKey, 4> kSplitters = {{{"left", &Splitters::left},
                                                    {"right", &Splitters::right},
                                                    {"shelf", &Splitters::shelf},
                                                    {"materials", &Splitters::materials}}};

}  // namespace

fs::path settings_file() {
    const fs::path folder = user_folder("XDG_CONFIG_HOME", ".config");
    return folder.empty() ? folder : folder / "editor.json";
}

Settings read_settings(const fs::path& file) {
    Settings settings;
    std::error_code error;
    if (file.empty() || !fs::is_regular_file(file, error)) return settings;
    const Result<std::string> text = read_text_file(file);
    if (!text) return settings;
    const SortedJson json = SortedJson::parse(*text, nullptr, false);
    if (!json.is_object()) return settings;
    read_number(json, "window_width", 640.0, kMostPixels, settings.window_width);
    read_number(json, "window_height", 400.0, kMostPixels, settings.window_height);
    read_number(json, "scale", 1.0, 2.5, settings.scale);
    read_flag(json, "shelf_open", settings.shelf_open);
    read_flag(json, "small_cards", settings.small_cards);
    read_names(json, "favourites", settings.favourites);
    read_flag(json, "keep_previous", settings.keep_previous);
    read_flag(json, "refine_when_idle", settings.refine_when_idle);
    if (const auto splitters = json.find("splitters");
        splitters != json.end() && splitters->is_object())
        for (const SplitterKey& each : kSplitters)
            read_number(*splitters, each.key, 0.0, kMostPixels, settings.splitters.*each.member);
    return settings;
}

Status write_settings(const fs::path& file, const Settings& settings) {
    if (file.empty()) return {};
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    if (error)
        return failure("{}: cannot make this folder: {}", file.parent_path().string(),
                       error.message());
    SortedJson json = {{"window_width", settings.window_width},
                       {"window_height", settings.window_height},
                       {"scale", settings.scale},
                       {"shelf_open", settings.shelf_open},
                       {"small_cards", settings.small_cards},
                       {"favourites", settings.favourites},
                       {"keep_previous", settings.keep_previous},
                       {"refine_when_idle", settings.refine_when_idle}};
    for (const SplitterKey& each : kSplitters)
        json["splitters"][each.key] = settings.splitters.*each.member;
    return write_file_atomically(file, json.dump(2) + "\n");
}

}  // namespace patina::editor
