// SPDX-License-Identifier: MIT
#pragma once

/// Decoded pixels, as they are stored: no colour conversion has happened. What the numbers mean
/// (sRGB or linear, which channel) is said by whoever reads them.

#include <cstddef>
#include <cstdint>
#include <memory>

#include "core/hash.h"
#include "core/pixel_memory.h"

namespace patina {

enum class SampleType : std::uint8_t { U8, U16, F32 };

constexpr std::size_t sample_bytes(SampleType type) {
    return type == SampleType::U8 ? 1 : type == SampleType::U16 ? 2 : 4;
}

/// Row 0 is the top row (v = 0 in glTF). Rows are tightly packed, channels interleaved.
/// U8 and U16 stand for 0..1; F32 is unbounded and finite.
struct Image {
    int width = 0;     ///< 1 to 16384
    int height = 0;    ///< 1 to 16384
    int channels = 0;  ///< 1 grey, 2 grey+alpha, 3 RGB, 4 RGBA
    SampleType type = SampleType::U8;
    /// width * height * channels * sample_bytes(type); resize() does not clear it.
    PixelVector<std::byte> data = {};

    std::size_t row_bytes() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(channels) *
               sample_bytes(type);
    }
    bool operator==(const Image&) const = default;
};

using ImagePtr = std::shared_ptr<const Image>;

/// Hash of size, layout and pixels: the same for a PNG that was packed differently.
Hash128 content_hash(const Image& image);

}  // namespace patina
