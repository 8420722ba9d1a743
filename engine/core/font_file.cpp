// SPDX-License-Identifier: MIT
#include "core/font_file.h"

#include <vector>

#include "core/program_folders.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> font_folders() {
    std::vector<fs::path> folders;
    if (const Result<fs::path> own = resource_folder("fonts")) folders.push_back(*own);
    for (const char* folder :
         {"/usr/share/fonts/opentype/inter", "/usr/share/fonts/truetype/inter",
          "/usr/share/fonts/opentype/font-awesome", "/usr/share/fonts/truetype/font-awesome",
          "/usr/share/fonts-font-awesome/fonts", "/usr/local/share/fonts"})
        folders.emplace_back(folder);
    return folders;
}

}  // namespace

Result<fs::path> font_file(std::initializer_list<std::string_view> names) {
    for (const fs::path& folder : font_folders())
        for (const std::string_view name : names) {
            std::error_code error;
            if (fs::is_regular_file(folder / name, error)) return folder / name;
        }
    return failure("font {} was not found; install the packages fonts-inter and fonts-font-awesome",
                   *names.begin());
}

}  // namespace patina
