// SPDX-License-Identifier: MIT
#include "render/radiance_map.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "core/formulae/formulae.h"
#include "core/parallel.h"
#include "scene/sample_values.h"

namespace patina::render {
namespace {

constexpr std::int64_t kMapRowsPerTask = 16;

float linear_sample(const Image& image, int x, int y, int channel) {
    if (image.type != SampleType::F32) return linear_value(image, x, y, channel);
    const float value = stored_value(image, x, y, channel);
    return std::isfinite(value) && value > 0.0f ? value : 0.0f;
}

glm::vec3 linear_texel(const Image& image, int x, int y) {
    if (image.channels < 3) return glm::vec3(linear_sample(image, x, y, 0));
    return {linear_sample(image, x, y, 0), linear_sample(image, x, y, 1),
            linear_sample(image, x, y, 2)};
}

}  // namespace

Result<RadianceMap> radiance_map(const Image& equirect) {
    const std::size_t count =
        static_cast<std::size_t>(equirect.width) * static_cast<std::size_t>(equirect.height);
    if (count == 0 || equirect.data.size() != equirect.row_bytes() * std::size_t(equirect.height))
        return failure("environment map has no pixels: give an equirectangular .hdr or .exr");
    RadianceMap map{equirect.width, equirect.height, std::vector<glm::vec3>(count)};
    parallel_for(0, equirect.height, kMapRowsPerTask, [&](std::int64_t first, std::int64_t last) {
        glm::vec3* texel = map.texels.data() + std::size_t(first) * std::size_t(equirect.width);
        for (int y = int(first); y < int(last); ++y)
            for (int x = 0; x < equirect.width; ++x) *texel++ = linear_texel(equirect, x, y);
    });
    return map;
}

float texel_solid_angle(const RadianceMap& map, int y) {
    const double top = glm::pi<double>() * y / map.height;
    const double bottom = glm::pi<double>() * (y + 1) / map.height;
    return static_cast<float>((std::cos(top) - std::cos(bottom)) * 2.0 * glm::pi<double>() /
                              map.width);
}

float texel_solid_angle_at_horizon(int width, int height) {
    return glm::two_pi<float>() / static_cast<float>(width) * glm::pi<float>() /
           static_cast<float>(height);
}

RadianceMap halved(const RadianceMap& map) {
    RadianceMap half{std::max(1, map.width / 2), std::max(1, map.height / 2), {}};
    half.texels.resize(std::size_t(half.width) * std::size_t(half.height));
    parallel_for(0, half.height, kMapRowsPerTask, [&](std::int64_t first, std::int64_t last) {
        for (int y = int(first); y < int(last); ++y)
            for (int x = 0; x < half.width; ++x) {
                glm::vec3 sum(0.0f);
                float weight = 0.0f;
                // Odd sizes: the last texel stands for three.
                const int y_end = y == half.height - 1 ? map.height : 2 * y + 2;
                const int x_end = x == half.width - 1 ? map.width : 2 * x + 2;
                for (int sy = 2 * y; sy < y_end; ++sy) {
                    const float solid_angle = texel_solid_angle(map, sy);
                    for (int sx = 2 * x; sx < x_end; ++sx) {
                        sum += solid_angle * map.at(sx, sy);
                        weight += solid_angle;
                    }
                }
                half.texels[std::size_t(y) * std::size_t(half.width) + std::size_t(x)] =
                    sum / weight;
            }
    });
    return half;
}

RadianceMap reduced_to_width(RadianceMap map, int width) {
    while (map.width > width && map.height > 1) map = halved(map);
    return map;
}

glm::vec3 direction_at(float u, float v) {
    const formulae::Real3 direction = formulae::equirect_direction({u, v});
    return {direction.x, direction.y, direction.z};
}

glm::vec3 texel_direction(const RadianceMap& map, int x, int y) {
    return direction_at((static_cast<float>(x) + 0.5f) / static_cast<float>(map.width),
                        (static_cast<float>(y) + 0.5f) / static_cast<float>(map.height));
}

float luminance_of(const glm::vec3& linear) {
    return formulae::luminance({linear.x, linear.y, linear.z});
}

glm::vec3 radiance_from(const RadianceMap& map, const glm::vec3& direction_map) {
    const auto [u, v] = formulae::equirect_uv(
        {direction_map.x, std::clamp(direction_map.y, -1.0f, 1.0f), direction_map.z});
    const float x = u * static_cast<float>(map.width) - 0.5f;
    const float y = v * static_cast<float>(map.height) - 0.5f;
    const float x_floor = std::floor(x);
    const float y_floor = std::floor(y);
    const auto column = [&](int i) { return (i % map.width + map.width) % map.width; };
    const auto row = [&](int i) { return std::clamp(i, 0, map.height - 1); };
    const int x0 = column(int(x_floor));
    const int x1 = column(int(x_floor) + 1);
    const int y0 = row(int(y_floor));
    const int y1 = row(int(y_floor) + 1);
    const glm::vec3 top = glm::mix(map.at(x0, y0), map.at(x1, y0), x - x_floor);
    const glm::vec3 bottom = glm::mix(map.at(x0, y1), map.at(x1, y1), x - x_floor);
    return glm::mix(top, bottom, y - y_floor);
}

}  // namespace patina::render
