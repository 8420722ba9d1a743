// SPDX-License-Identifier: MIT
#pragma once

/// The five row filters of PNG (PNG 1.2, section 6) and the choice among them, in SIMD.

#include <cstddef>
#include <cstdint>

namespace patina::io {

/// Bytes that must be readable before a row's first byte and after its last one.
inline constexpr std::size_t kPngRowMargin = 64;

/// Filters one row: writes the filter's number and then `row_bytes` filtered bytes to `out`. The
/// filter is the one whose bytes, taken as signed, have the least sum of magnitudes.
/// @param row       the row's bytes; the `pixel_bytes` bytes before it are 0
/// @param previous  the row above in the same layout; all 0 above the first row
/// @param pixel_bytes  1 to 8
void filter_png_row(const std::uint8_t* row, const std::uint8_t* previous, std::size_t row_bytes,
                    std::size_t pixel_bytes, std::uint8_t* out);

}  // namespace patina::io
