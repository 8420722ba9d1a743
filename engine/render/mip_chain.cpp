// SPDX-License-Identifier: MIT
#include "render/mip_chain.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstring>
#include <glm/glm.hpp>

#include "core/formulae/formulae.h"
#include "core/parallel.h"
#include "core/stored_values.h"
#include "scene/sample_values.h"

namespace patina::render {
namespace {

constexpr std::int64_t kRowsPerTask = 32;
constexpr int kChannels = 4;

/// Steps of the table that encodes linear light: a step is 0.8 of a byte where sRGB is steepest.
constexpr int kEncodeSteps = 4096;

using BytesOfLinear = std::array<std::uint8_t, kEncodeSteps + 1>;

const BytesOfLinear& bytes_of_linear() {
    static const BytesOfLinear table = [] {
        BytesOfLinear made;
        for (std::size_t i = 0; i < made.size(); ++i)
            made[i] = static_cast<std::uint8_t>(
                formulae::srgb_from_linear(static_cast<float>(i) / kEncodeSteps) * 255.0f + 0.5f);
        return made;
    }();
    return table;
}

/// Which stored channel feeds red, green, blue and alpha; -1 is 1.
std::array<int, kChannels> channel_sources(int channels) {
    switch (channels) {
        case 1:
            return {0, 0, 0, -1};
        case 2:
            return {0, 0, 0, 1};
        case 3:
            return {0, 1, 2, -1};
        default:
            return {0, 1, 2, 3};
    }
}

std::size_t texel_index(const MipLevel& level, int x, int y) {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(level.width) +
            static_cast<std::size_t>(x)) *
           kChannels;
}

void copy_byte_row(const Image& image, MipLevel& level, int y, int x0, int x1) {
    std::uint8_t* out = level.bytes.data() + texel_index(level, x0, y);
    const std::byte* row = image.data.data() + static_cast<std::size_t>(y) * image.row_bytes();
    if (image.channels == kChannels) {
        std::memcpy(out, row + static_cast<std::size_t>(x0) * kChannels,
                    static_cast<std::size_t>(x1 - x0) * kChannels);
        return;
    }
    const std::array<int, kChannels> sources = channel_sources(image.channels);
    for (int x = x0; x < x1; ++x)
        for (const int source : sources)
            *out++ =
                source < 0 ? 255 : std::to_integer<std::uint8_t>(row[x * image.channels + source]);
}

void copy_float_row(const Image& image, bool srgb, MipLevel& level, int y, int x0, int x1) {
    float* out = level.floats.data() + texel_index(level, x0, y);
    const std::array<int, kChannels> sources = channel_sources(image.channels);
    for (int x = x0; x < x1; ++x)
        for (int c = 0; c < kChannels; ++c) {
            const int source = sources[static_cast<std::size_t>(c)];
            const bool encoded = srgb && c < 3;
            *out++ = source < 0 ? 1.0f
                     : encoded  ? linear_value(image, x, y, source)
                                : stored_value(image, x, y, source);
        }
}

/// Alpha of a texel: a deviation of normals, 0 to 1.
void set_deviation(TexelStorage storage, MipLevel& level, std::size_t texel, float deviation) {
    if (storage == TexelStorage::Rgba8)
        level.bytes[texel + 3] =
            static_cast<std::uint8_t>(std::min(deviation, 1.0f) * 255.0f + 0.5f);
    else
        level.floats[texel + 3] = deviation;
}

void copy_texels(MipChain& chain, const Image& image, const TexelRect& rect) {
    parallel_for(rect.y0, rect.y1, kRowsPerTask, [&](std::int64_t first, std::int64_t last) {
        for (int y = static_cast<int>(first); y < static_cast<int>(last); ++y) {
            if (chain.storage == TexelStorage::Rgba8)
                copy_byte_row(image, chain.levels[0], y, rect.x0, rect.x1);
            else
                copy_float_row(image, chain.meaning == TexelMeaning::Srgb, chain.levels[0], y,
                               rect.x0, rect.x1);
            if (chain.meaning != TexelMeaning::Normals) continue;
            for (int x = rect.x0; x < rect.x1; ++x)
                set_deviation(chain.storage, chain.levels[0], texel_index(chain.levels[0], x, y),
                              0.0f);
        }
    });
}

/// The texels of the finer level that a coarse one stands for: two, or three at the end of an odd
/// side, or the only one.
struct Span {
    int first;
    int last;  // one beyond
};
Span fine_span(int coarse, int coarse_side, int fine_side) {
    return {std::min(2 * coarse, fine_side - 1),
            coarse == coarse_side - 1 ? fine_side : 2 * coarse + 2};
}

void average_bytes(const MipLevel& fine, const Span& xs, const Span& ys, bool srgb,
                   std::uint8_t* out) {
    const int count = (xs.last - xs.first) * (ys.last - ys.first);
    const std::array<float, 256>& linear = linear_of_bytes();
    const BytesOfLinear& encoded = bytes_of_linear();
    for (int c = 0; c < kChannels; ++c) {
        if (srgb && c < 3) {
            float sum = 0.0f;
            for (int y = ys.first; y < ys.last; ++y)
                for (int x = xs.first; x < xs.last; ++x)
                    sum +=
                        linear[fine.bytes[texel_index(fine, x, y) + static_cast<std::size_t>(c)]];
            const float mean = sum / static_cast<float>(count);
            out[c] = encoded[static_cast<std::size_t>(mean * kEncodeSteps + 0.5f)];
        } else {
            int sum = 0;
            for (int y = ys.first; y < ys.last; ++y)
                for (int x = xs.first; x < xs.last; ++x)
                    sum += fine.bytes[texel_index(fine, x, y) + static_cast<std::size_t>(c)];
            out[c] = static_cast<std::uint8_t>((sum + count / 2) / count);
        }
    }
}

void average_floats(const MipLevel& fine, const Span& xs, const Span& ys, float* out) {
    const float share = 1.0f / static_cast<float>((xs.last - xs.first) * (ys.last - ys.first));
    for (int c = 0; c < kChannels; ++c) {
        float sum = 0.0f;
        for (int y = ys.first; y < ys.last; ++y)
            for (int x = xs.first; x < xs.last; ++x)
                sum += fine.floats[texel_index(fine, x, y) + static_cast<std::size_t>(c)];
        out[c] = sum * share;
    }
}

glm::vec4 values_at(TexelStorage storage, const MipLevel& level, std::size_t texel) {
    glm::vec4 values;
    for (std::size_t c = 0; c < kChannels; ++c)
        values[static_cast<int>(c)] = storage == TexelStorage::Rgba8
                                          ? unit_value(level.bytes[texel + c])
                                          : level.floats[texel + c];
    return values;
}

/// How much the normals of a coarse texel vary: within the finer ones, and between those.
float deviation_of(TexelStorage storage, const MipLevel& fine, const Span& xs, const Span& ys) {
    const float share = 1.0f / static_cast<float>((xs.last - xs.first) * (ys.last - ys.first));
    glm::vec3 mean(0.0f);
    float mean_of_squares = 0.0f;
    float within = 0.0f;
    for (int y = ys.first; y < ys.last; ++y)
        for (int x = xs.first; x < xs.last; ++x) {
            const glm::vec4 values = values_at(storage, fine, texel_index(fine, x, y));
            const glm::vec3 normal(formulae::signed_from_encoded(values.x),
                                   formulae::signed_from_encoded(values.y),
                                   formulae::signed_from_encoded(values.z));
            mean += share * normal;
            mean_of_squares += share * glm::dot(normal, normal);
            within += share * values.a * values.a;
        }
    const float between = std::max(mean_of_squares - glm::dot(mean, mean), 0.0f);
    return std::sqrt(within + between);
}

TexelRect coarse_rect(const TexelRect& fine, const MipLevel& coarse) {
    // The last texel of an odd side belongs to the last coarse one.
    return {std::min(fine.x0 / 2, coarse.width - 1), std::min(fine.y0 / 2, coarse.height - 1),
            std::min((fine.x1 + 1) / 2, coarse.width), std::min((fine.y1 + 1) / 2, coarse.height)};
}

void average_level(MipChain& chain, std::size_t index, const TexelRect& rect) {
    const MipLevel& fine = chain.levels[index - 1];
    MipLevel& coarse = chain.levels[index];
    parallel_for(rect.y0, rect.y1, kRowsPerTask, [&](std::int64_t first, std::int64_t last) {
        for (int y = static_cast<int>(first); y < static_cast<int>(last); ++y)
            for (int x = rect.x0; x < rect.x1; ++x) {
                const Span xs = fine_span(x, coarse.width, fine.width);
                const Span ys = fine_span(y, coarse.height, fine.height);
                const std::size_t out = texel_index(coarse, x, y);
                if (chain.storage == TexelStorage::Rgba8)
                    average_bytes(fine, xs, ys, chain.meaning == TexelMeaning::Srgb,
                                  coarse.bytes.data() + out);
                else
                    average_floats(fine, xs, ys, coarse.floats.data() + out);
                if (chain.meaning == TexelMeaning::Normals)
                    set_deviation(chain.storage, coarse, out,
                                  deviation_of(chain.storage, fine, xs, ys));
            }
    });
}

}  // namespace

std::vector<TexelRect> update_mip_chain(MipChain& chain, const Image& image,
                                        const TexelRect& rect) {
    assert(chain.levels[0].width == image.width && chain.levels[0].height == image.height);
    std::vector<TexelRect> changed = {rect};
    copy_texels(chain, image, rect);
    for (std::size_t i = 1; i < chain.levels.size(); ++i) {
        changed.push_back(coarse_rect(changed.back(), chain.levels[i]));
        average_level(chain, i, changed.back());
    }
    return changed;
}

MipChain mip_chain(const Image& image, TexelMeaning meaning) {
    MipChain chain;
    chain.storage = image.type == SampleType::U8 ? TexelStorage::Rgba8 : TexelStorage::RgbaFloat;
    chain.meaning = meaning;
    for (int width = image.width, height = image.height;;
         width = std::max(1, width / 2), height = std::max(1, height / 2)) {
        MipLevel level{width, height, {}, {}};
        const std::size_t count = static_cast<std::size_t>(width) *
                                  static_cast<std::size_t>(height) * std::size_t{kChannels};
        if (chain.storage == TexelStorage::Rgba8)
            level.bytes.resize(count);
        else
            level.floats.resize(count);
        chain.levels.push_back(std::move(level));
        if (width == 1 && height == 1) break;
    }
    update_mip_chain(chain, image, {0, 0, image.width, image.height});
    return chain;
}

}  // namespace patina::render
