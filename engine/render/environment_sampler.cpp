// SPDX-License-Identifier: MIT
#include "render/environment_sampler.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/packing.hpp>

namespace patina::render {
namespace {

/// Turns amounts into the share that lies before the end of each; returns their sum.
double accumulate_shares(const std::vector<double>& amounts, float* shares) {
    double total = 0.0;
    for (const double amount : amounts) total += amount;
    double before = 0.0;
    for (std::size_t i = 0; i < amounts.size(); ++i) {
        before += amounts[i];
        shares[i] = total > 0.0 ? static_cast<float>(before / total) : 1.0f;
    }
    shares[amounts.size() - 1] = 1.0f;
    return total;
}

struct Picked {
    std::size_t index;
    float within;  ///< 0 to 1
    float share;   ///< of all
};

/// The interval of `shares` that holds u.
Picked pick(const float* shares, std::size_t count, float u) {
    const float* end = shares + count;
    const float* found = std::min(std::upper_bound(shares, end, u), end - 1);
    const float low = found == shares ? 0.0f : found[-1];
    const float share = std::max(*found - low, 1e-12f);
    return {static_cast<std::size_t>(found - shares), std::clamp((u - low) / share, 0.0f, 1.0f),
            share};
}

std::uint32_t reversed_bits(std::uint32_t bits) {
    std::uint32_t result = 0;
    for (int i = 0; i < 32; ++i) result |= ((bits >> i) & 1u) << (31 - i);
    return result;
}

float unit_from_bits(std::uint32_t bits) {
    return static_cast<float>(bits >> 8) * 0x1p-24f;
}

/// What brings the brightest texel into half floats.
float scale_of(const RadianceMap& map) {
    float most = 0.0f;
    for (const glm::vec3& texel : map.texels) most = std::max({most, texel.x, texel.y, texel.z});
    return most > kLargestHalf ? kLargestHalf / most : 1.0f;
}

std::vector<std::uint16_t> packed(const RadianceMap& map, float scale) {
    std::vector<std::uint16_t> halves;
    halves.reserve(map.texels.size() * 4);
    for (const glm::vec3& texel : map.texels) {
        for (int c = 0; c < 3; ++c) halves.push_back(glm::packHalf1x16(texel[c] * scale));
        halves.push_back(glm::packHalf1x16(1.0f));
    }
    return halves;
}

}  // namespace

EnvironmentSampler::EnvironmentSampler(std::shared_ptr<const RadianceMap> map)
    : map_(std::move(map)) {
    const auto width = static_cast<std::size_t>(map_->width);
    const auto height = static_cast<std::size_t>(map_->height);
    rows_.resize(height);
    columns_.resize(width * height);
    std::vector<double> row_light(height);
    std::vector<double> texel_light(width);
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x)
            texel_light[x] = luminance_of(map_->texels[y * width + x]);
        row_light[y] = accumulate_shares(texel_light, columns_.data() + y * width) *
                       texel_solid_angle(*map_, static_cast<int>(y));
    }
    total_luminance_ = accumulate_shares(row_light, rows_.data());
}

EnvironmentSample EnvironmentSampler::sample(const glm::vec2& u) const {
    assert(has_light());
    const auto width = static_cast<std::size_t>(map_->width);
    const Picked row = pick(rows_.data(), rows_.size(), u.y);
    const Picked column = pick(columns_.data() + row.index * width, width, u.x);
    // Even in solid angle within the row: even in the cosine.
    const auto polar = [&](std::size_t edge) {
        return std::cos(glm::pi<float>() * static_cast<float>(edge) /
                        static_cast<float>(map_->height));
    };
    const float cosine = std::lerp(polar(row.index), polar(row.index + 1), row.within);
    EnvironmentSample result;
    result.towards =
        direction_at((static_cast<float>(column.index) + column.within) / static_cast<float>(width),
                     std::acos(std::clamp(cosine, -1.0f, 1.0f)) / glm::pi<float>());
    result.radiance_linear = radiance_from(*map_, result.towards);
    result.density =
        row.share * column.share / texel_solid_angle(*map_, static_cast<int>(row.index));
    return result;
}

std::shared_ptr<const EnvironmentSampling> environment_sampling(
    std::shared_ptr<const RadianceMap> map) {
    auto sampling = std::make_shared<EnvironmentSampling>();
    sampling->width = map->width;
    sampling->height = map->height;
    sampling->scale = scale_of(*map);
    sampling->levels.push_back(packed(*map, sampling->scale));
    for (RadianceMap level = *map; level.width > 1 || level.height > 1;) {
        level = halved(level);
        sampling->levels.push_back(packed(level, sampling->scale));
    }
    sampling->sampler = std::make_shared<const EnvironmentSampler>(std::move(map));
    return sampling;
}

glm::vec2 sobol_point(std::uint32_t i) {
    // Direction numbers of Sobol's second dimension: each is the one before, xor itself halved.
    std::uint32_t second = 0;
    std::uint32_t direction = 1u << 31;
    for (std::uint32_t bits = i; bits != 0; bits >>= 1) {
        if ((bits & 1u) != 0) second ^= direction;
        direction ^= direction >> 1;
    }
    return {unit_from_bits(reversed_bits(i)), unit_from_bits(second)};
}

}  // namespace patina::render
