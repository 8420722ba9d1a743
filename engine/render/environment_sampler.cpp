// SPDX-License-Identifier: MIT
#include "render/environment_sampler.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/packing.hpp>

#include "core/formulae/formulae.h"

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
};

/// The interval of `shares` that holds u.
Picked pick(const float* shares, std::size_t count, float u) {
    const float* end = shares + count;
    const float* found = std::min(std::upper_bound(shares, end, u), end - 1);
    const float low = found == shares ? 0.0f : found[-1];
    const float share = std::max(*found - low, 1e-12f);
    return {static_cast<std::size_t>(found - shares), std::clamp((u - low) / share, 0.0f, 1.0f)};
}

/// For u of 0 to 1, -1 to 1 as densely as a texel has a share in what is read so many texels aside.
float tent(float u) {
    return u < 0.5f ? std::sqrt(2.0f * u) - 1.0f : 1.0f - std::sqrt(2.0f - 2.0f * u);
}

/// What brings the brightest texel into half floats.
float scale_of(const RadianceMap& map) {
    float most = 0.0f;
    for (const glm::vec3& texel : map.texels) most = std::max({most, texel.x, texel.y, texel.z});
    return most > formulae::LARGEST_HALF ? formulae::LARGEST_HALF / most : 1.0f;
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

float EnvironmentSampler::density_at(const glm::vec2& texel) const {
    const int low_row = static_cast<int>(std::floor(texel.y - 0.5f));
    const float high_share = texel.y - 0.5f - std::floor(texel.y - 0.5f);
    const int low_column = static_cast<int>(std::floor(texel.x - 0.5f));
    const float right_share = texel.x - 0.5f - std::floor(texel.x - 0.5f);
    const auto light_of_row = [&](int y) {
        const int row = std::clamp(y, 0, map_->height - 1);
        const auto at = [&](int x) {
            return luminance_of(map_->at((x + map_->width) % map_->width, row));
        };
        return std::lerp(at(low_column), at(low_column + 1), right_share) *
               texel_solid_angle(*map_, row);
    };
    const float light = std::lerp(light_of_row(low_row), light_of_row(low_row + 1), high_share);
    const float height = static_cast<float>(map_->height);
    const float sine = std::max(std::sin(glm::pi<float>() * texel.y / height), 1e-6f);
    const float solid_angle = texel_solid_angle_at_horizon(map_->width, map_->height) * sine;
    return std::max(light / (static_cast<float>(total_luminance_) * solid_angle), 1e-12f);
}

EnvironmentSample EnvironmentSampler::sample(const glm::vec2& u) const {
    assert(has_light());
    const auto width = static_cast<std::size_t>(map_->width);
    const Picked row = pick(rows_.data(), rows_.size(), u.y);
    const Picked column = pick(columns_.data() + row.index * width, width, u.x);
    glm::vec2 texel(static_cast<float>(column.index) + 0.5f + tent(column.within),
                    static_cast<float>(row.index) + 0.5f + tent(row.within));
    const glm::vec2 size(map_->width, map_->height);
    texel.x -= std::floor(texel.x / size.x) * size.x;
    // Beyond a pole the row at it is read again.
    texel.y = std::min(std::abs(texel.y), 2.0f * size.y - texel.y);
    EnvironmentSample result;
    result.towards = direction_at(texel.x / size.x, texel.y / size.y);
    result.radiance_linear = radiance_from(*map_, result.towards);
    result.density = density_at(texel);
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
    return {formulae::unit_from_bits(formulae::mirrored_bits(i)), formulae::unit_from_bits(second)};
}

}  // namespace patina::render
