// SPDX-License-Identifier: MIT
#pragma once

/// The texels of a PNG that the program wrote, as libpng reads it.

#include <array>
#include <string>

namespace patina::cli_tests {

struct Picture {
    int width = 0;
    int height = 0;
    std::string rgba;  ///< 8 bits a number, row 0 at the top

    std::array<int, 4> texel(int x, int y) const;
};

/// Empty, and the test has failed, where that is no PNG.
Picture png_picture(const std::string& path);

}  // namespace patina::cli_tests
