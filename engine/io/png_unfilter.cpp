// SPDX-License-Identifier: MIT
#include "io/png_unfilter.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace patina::io {
namespace {

enum Filter : std::uint8_t { None, Sub, Up, Average, Paeth };

std::uint8_t paeth(int left, int above, int above_left) {
    const int to_left = std::abs(above - above_left);
    const int to_above = std::abs(left - above_left);
    const int to_above_left = std::abs(left + above - 2 * above_left);
    const int nearest_of_two = to_above <= to_above_left ? above : above_left;
    const bool is_left = to_left <= to_above && to_left <= to_above_left;
    return static_cast<std::uint8_t>(is_left ? left : nearest_of_two);
}

/// With the distance known when it is compiled, the pixel before stays in registers.
template <std::size_t kPixelBytes>
void unfilter(Filter filter, std::uint8_t* row, const std::uint8_t* above, std::size_t row_bytes) {
    std::array<std::uint8_t, kPixelBytes> left = {};
    std::array<std::uint8_t, kPixelBytes> above_left = {};
    const auto each_pixel = [&](auto&& predicted) {
        for (std::size_t i = 0; i + kPixelBytes <= row_bytes; i += kPixelBytes) {
            for (std::size_t k = 0; k < kPixelBytes; ++k) {
                const std::uint8_t up = above[i + k];
                left[k] =
                    static_cast<std::uint8_t>(row[i + k] + predicted(left[k], up, above_left[k]));
                above_left[k] = up;
                row[i + k] = left[k];
            }
        }
    };
    switch (filter) {
        case None:
            return;
        case Sub:
            return each_pixel([](int a, int, int) { return a; });
        case Up:
            for (std::size_t i = 0; i < row_bytes; ++i)
                row[i] = static_cast<std::uint8_t>(row[i] + above[i]);
            return;
        case Average:
            return each_pixel([](int a, int b, int) { return (a + b) / 2; });
        case Paeth:
            return each_pixel(paeth);
    }
}

}  // namespace

bool unfilter_png_row(std::uint8_t filter_byte, std::uint8_t* row, const std::uint8_t* above,
                      std::size_t row_bytes, std::size_t pixel_bytes) {
    if (filter_byte > Paeth) return false;
    const auto filter = static_cast<Filter>(filter_byte);
    switch (pixel_bytes) {
        case 1:
            unfilter<1>(filter, row, above, row_bytes);
            return true;
        case 2:
            unfilter<2>(filter, row, above, row_bytes);
            return true;
        case 3:
            unfilter<3>(filter, row, above, row_bytes);
            return true;
        case 4:
            unfilter<4>(filter, row, above, row_bytes);
            return true;
        case 6:
            unfilter<6>(filter, row, above, row_bytes);
            return true;
        case 8:
            unfilter<8>(filter, row, above, row_bytes);
            return true;
        default:
            return false;
    }
}

}  // namespace patina::io
