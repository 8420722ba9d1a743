// SPDX-License-Identifier: MIT
#pragma once

/// PNG in: most textures are PNG, and this way there is no C library between a stranger's bytes and
/// Patina that writes to the terminal and jumps out of calls.

#include "io/image_decode.h"

namespace patina::io {

/// Of the IHDR chunk, with the channels that decode_png makes: palettes and transparent colours
/// count as RGB(A).
Result<ImageHeader> read_png_header(std::span<const std::byte> encoded);

/// Decodes all of PNG 1.2: every colour type and depth, palettes, tRNS, Adam7. 16 bits stay U16,
/// smaller depths become U8. Check the size of read_png_header first: it is what is allocated.
Result<ImagePtr> decode_png(std::span<const std::byte> encoded);

}  // namespace patina::io
