// SPDX-License-Identifier: MIT
#include "io/last_channel.h"

#include <array>
#include <bit>
#include <cassert>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include "core/parallel.h"

namespace patina::io {
namespace {

template <typename Sample>
bool all_one(const Image& image) {
    constexpr auto one =
        std::is_same_v<Sample, float> ? Sample{1} : std::numeric_limits<Sample>::max();
    const auto* const samples = reinterpret_cast<const Sample*>(image.data.data());
    const std::size_t count = image.data.size() / sizeof(Sample);
    const auto step = static_cast<std::size_t>(image.channels);
    for (std::size_t i = step - 1; i < count; i += step)
        if (samples[i] < one) return false;
    return true;
}

/// RGB8 of RGBA8, four texels at a time in three words.
void copy_without_alpha(const std::byte* rgba, std::byte* rgb, std::int64_t texels) {
    static_assert(std::endian::native == std::endian::little);
    std::int64_t i = 0;
    for (; i + 4 <= texels; i += 4) {
        std::array<std::uint32_t, 4> in = {};
        std::memcpy(in.data(), rgba + i * 4, sizeof in);
        const std::array<std::uint32_t, 3> out = {(in[0] & 0xffffffu) | in[1] << 24,
                                                  (in[1] >> 8 & 0xffffu) | in[2] << 16,
                                                  (in[2] >> 16 & 0xffu) | in[3] << 8};
        std::memcpy(rgb + i * 3, out.data(), sizeof out);
    }
    for (; i < texels; ++i) std::memcpy(rgb + i * 3, rgba + i * 4, 3);
}

}  // namespace

bool last_is_one(const Image& image) {
    switch (image.type) {
        case SampleType::U8:
            return all_one<std::uint8_t>(image);
        case SampleType::U16:
            return all_one<std::uint16_t>(image);
        case SampleType::F32:
            return all_one<float>(image);
    }
    return false;
}

Image without_last(const Image& image) {
    assert(image.channels > 1);
    Image result{.width = image.width,
                 .height = image.height,
                 .channels = image.channels - 1,
                 .type = image.type,
                 .data = {}};
    result.data.resize(result.row_bytes() * static_cast<std::size_t>(result.height));
    const bool rgba8 = image.channels == 4 && image.type == SampleType::U8;
    const auto from_bytes = static_cast<std::int64_t>(image.row_bytes()) / image.width;
    const auto to_bytes = static_cast<std::int64_t>(result.row_bytes()) / image.width;
    const auto texels =
        static_cast<std::int64_t>(image.width) * static_cast<std::int64_t>(image.height);
    parallel_for(0, texels, 1 << 16, [&](std::int64_t first, std::int64_t last) {
        const std::byte* from = image.data.data() + first * from_bytes;
        std::byte* to = result.data.data() + first * to_bytes;
        if (rgba8) return copy_without_alpha(from, to, last - first);
        for (std::int64_t i = first; i < last; ++i, from += from_bytes, to += to_bytes)
            std::memcpy(to, from, static_cast<std::size_t>(to_bytes));
    });
    return result;
}

}  // namespace patina::io
