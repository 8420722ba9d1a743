// SPDX-License-Identifier: MIT
#pragma once

/// The row filters of PNG undone (PNG 1.2, section 6).

#include <cstddef>
#include <cstdint>

namespace patina::io {

/// Turns a filtered row into its bytes, in place. `above` is the unfiltered row before it, zeros
/// for the first one; `pixel_bytes` (1 to 8) is how far Sub, Average and Paeth look back. False for
/// a filter that does not exist.
bool unfilter_png_row(std::uint8_t filter, std::uint8_t* row, const std::uint8_t* above,
                      std::size_t row_bytes, std::size_t pixel_bytes);

}  // namespace patina::io
