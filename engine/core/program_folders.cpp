// SPDX-License-Identifier: MIT
#include "core/program_folders.h"

#include <functional>

namespace patina {
namespace {

std::filesystem::path executable_folder() {
    std::error_code error;
    const auto executable = std::filesystem::read_symlink("/proc/self/exe", error);
    return error ? std::filesystem::path() : executable.parent_path();
}

/// What belongs to the program: `installed` from the folder above its own, else `built` in the
/// nearest folder around it that `is_found` says has it.
Result<std::filesystem::path> found_by_program(
    const std::filesystem::path& installed, const std::filesystem::path& built,
    const std::function<bool(const std::filesystem::path& folder)>& is_found) {
    const auto program = executable_folder();
    const auto beside = (program / ".." / installed).lexically_normal();
    std::error_code error;
    if (std::filesystem::exists(beside, error)) return beside;
    for (auto folder = program; folder.has_relative_path(); folder = folder.parent_path())
        if (is_found(folder)) return folder / built;
    return failure(
        "'{}' is neither beside the program ({}) nor in a source tree or build around it; "
        "reinstall Patina",
        built.filename().string(), quoted_for_message(beside.string()));
}

}  // namespace

Result<std::filesystem::path> resource_folder(std::string_view name) {
    const auto is_found = [&](const std::filesystem::path& folder) {
        std::error_code error;
        return std::filesystem::exists(folder / "CMakePresets.json", error) &&
               std::filesystem::is_directory(folder / name, error);
    };
    return found_by_program(std::filesystem::path("share") / "patina" / name, name, is_found);
}

Result<std::filesystem::path> module_file(std::string_view name) {
    const auto built = std::filesystem::path("engine") / name;
    const auto is_found = [&](const std::filesystem::path& folder) {
        std::error_code error;
        return std::filesystem::is_regular_file(folder / built, error);
    };
    return found_by_program(std::filesystem::path("lib") / "patina" / name, built, is_found);
}

}  // namespace patina
