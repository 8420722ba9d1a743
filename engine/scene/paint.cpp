// SPDX-License-Identifier: MIT
#include "scene/paint.h"

#include <array>
#include <cassert>
#include <cstring>
#include <limits>

namespace patina {
namespace {

constexpr std::size_t kChannels = 4;

std::byte* texel_at(Image& picture, int x, int y) {
    return picture.data.data() + static_cast<std::size_t>(y) * picture.row_bytes() +
           static_cast<std::size_t>(x) * kChannels * sample_bytes(picture.type);
}

/// Porter and Duff's "over", with straight alpha.
template <typename Sample>
void lay_over_texel(std::byte* texel, const glm::vec4& color) {
    constexpr auto most = static_cast<float>(std::numeric_limits<Sample>::max());
    std::array<Sample, kChannels> samples;
    std::memcpy(samples.data(), texel, sizeof samples);
    const float behind = (1.0f - color.a) * static_cast<float>(samples[3]) / most;
    const float alpha = color.a + behind;
    if (alpha <= 0.0f) return;
    for (int c = 0; c < 3; ++c) {
        Sample& sample = samples[static_cast<std::size_t>(c)];
        const float mixed =
            (color[c] * color.a + behind * static_cast<float>(sample) / most) / alpha;
        sample = static_cast<Sample>(mixed * most + 0.5f);
    }
    samples[3] = static_cast<Sample>(alpha * most + 0.5f);
    std::memcpy(texel, samples.data(), sizeof samples);
}

}  // namespace

void lay_over(Image& picture, int x, int y, const glm::vec4& color) {
    assert(picture.channels == 4 && picture.type != SampleType::F32);
    if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) return;
    picture.type == SampleType::U8 ? lay_over_texel<std::uint8_t>(texel_at(picture, x, y), color)
                                   : lay_over_texel<std::uint16_t>(texel_at(picture, x, y), color);
}

void lay_over(Image& picture, const TexelBox& box, const glm::vec4& color) {
    for (int y = box.y0; y < box.y1; ++y)
        for (int x = box.x0; x < box.x1; ++x) lay_over(picture, x, y, color);
}

void put(Image& picture, int x, int y, const Image& part) {
    assert(part.type == picture.type && part.channels == picture.channels);
    assert(x >= 0 && y >= 0 && x + part.width <= picture.width &&
           y + part.height <= picture.height);
    for (int row = 0; row < part.height; ++row)
        std::memcpy(texel_at(picture, x, y + row),
                    part.data.data() + static_cast<std::size_t>(row) * part.row_bytes(),
                    part.row_bytes());
}

}  // namespace patina
