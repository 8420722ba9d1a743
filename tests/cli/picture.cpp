// SPDX-License-Identifier: MIT
#include "cli/picture.h"

#include <gtest/gtest.h>
#include <png.h>

namespace patina::cli_tests {

std::array<int, 4> Picture::texel(int x, int y) const {
    std::array<int, 4> numbers = {};
    for (std::size_t c = 0; c < numbers.size(); ++c)
        numbers[c] =
            static_cast<unsigned char>(rgba.at(4 * static_cast<std::size_t>(y * width + x) + c));
    return numbers;
}

Picture png_picture(const std::string& path) {
    png_image image = {};
    image.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_file(&image, path.c_str()) == 0) {
        ADD_FAILURE() << path << ": " << image.message;
        return {};
    }
    image.format = PNG_FORMAT_RGBA;
    Picture picture{static_cast<int>(image.width), static_cast<int>(image.height),
                    std::string(PNG_IMAGE_SIZE(image), '\0')};
    if (png_image_finish_read(&image, nullptr, picture.rgba.data(), 0, nullptr) == 0)
        ADD_FAILURE() << path << ": " << image.message;
    return picture;
}

}  // namespace patina::cli_tests
