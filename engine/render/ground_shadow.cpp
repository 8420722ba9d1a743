// SPDX-License-Identifier: MIT
#include "render/ground_shadow.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "core/parallel.h"

namespace patina::render {
namespace {

/// How far the map reaches beyond the scene, in radii of its base.
constexpr float kReach = 2.2f;
constexpr int kSteps = 20;

/// The lowest and highest surface over each texel, metres above the floor; low > high where none.
struct Columns {
    int side;
    float texel_metres;
    std::vector<float> low;
    std::vector<float> high;

    void include(int x, int z, float height) {
        const std::size_t i = static_cast<std::size_t>(z) * static_cast<std::size_t>(side) +
                              static_cast<std::size_t>(x);
        low[i] = std::min(low[i], height);
        high[i] = std::max(high[i], height);
    }
};

/// Marks every texel whose middle a triangle covers, seen from above, and those of its corners, so
/// that walls leave a mark. Corners are in texels (x, z) and metres above the floor (y).
void rasterize(const std::array<glm::vec3, 3>& corners, Columns& columns) {
    const auto inside = [&](float v) {
        return std::clamp(static_cast<int>(v), 0, columns.side - 1);
    };
    for (const glm::vec3& corner : corners)
        columns.include(inside(corner.x), inside(corner.z), corner.y);
    const glm::vec3 low = glm::min(corners[0], glm::min(corners[1], corners[2]));
    const glm::vec3 high = glm::max(corners[0], glm::max(corners[1], corners[2]));
    const glm::vec2 a(corners[0].x, corners[0].z);
    const glm::vec2 ab = glm::vec2(corners[1].x, corners[1].z) - a;
    const glm::vec2 ac = glm::vec2(corners[2].x, corners[2].z) - a;
    const float area = ab.x * ac.y - ab.y * ac.x;
    if (std::abs(area) < 1e-12f) return;
    for (int z = inside(low.z); z <= inside(high.z); ++z)
        for (int x = inside(low.x); x <= inside(high.x); ++x) {
            const glm::vec2 p =
                glm::vec2(static_cast<float>(x) + 0.5f, static_cast<float>(z) + 0.5f) - a;
            const float u = (p.x * ac.y - p.y * ac.x) / area;
            const float v = (ab.x * p.y - ab.y * p.x) / area;
            if (u < 0.0f || v < 0.0f || u + v > 1.0f) continue;
            columns.include(x, z,
                            corners[0].y + u * (corners[1].y - corners[0].y) +
                                v * (corners[2].y - corners[0].y));
        }
}

void rasterize(const Primitive& primitive, const glm::mat4& world_from_local,
               const glm::vec3& floor_corner, Columns& columns) {
    const auto texel = [&](std::uint32_t index) {
        const glm::vec3 world =
            glm::vec3(world_from_local * glm::vec4(primitive.positions[index], 1.0f));
        const glm::vec3 from_corner = world - floor_corner;
        return glm::vec3(from_corner.x / columns.texel_metres, from_corner.y,
                         from_corner.z / columns.texel_metres);
    };
    for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3)
        rasterize({texel(primitive.indices[i]), texel(primitive.indices[i + 1]),
                   texel(primitive.indices[i + 2])},
                  columns);
}

/// Sixteen values, each once in every 4 x 4 texels: what smooth() averages away. They turn the
/// azimuths of a texel against those of the texels around.
constexpr int kTurns = 16;
int turn_of(int x, int z) {
    return (5 * (x & 3) + 4 * (z & 3)) % kTurns;
}

/// In the directions of the world, from +X towards +Z.
float azimuth_angle(std::size_t azimuth, int turn) {
    return glm::two_pi<float>() *
           (static_cast<float>(azimuth) + (static_cast<float>(turn) + 0.5f) / kTurns) /
           kGroundAzimuths;
}

/// The bands of the sky that columns block towards one azimuth, of a point of the floor in texels.
std::uint32_t hidden_bands(const Columns& columns, const glm::vec2& from, float angle) {
    const glm::vec2 direction(std::cos(angle), std::sin(angle));
    std::uint32_t hidden = 0;
    for (int s = 0; s < kSteps; ++s) {
        // Steps grow with distance: near columns matter most.
        const float share = (static_cast<float>(s) + 0.5f) / kSteps;
        const float distance = 0.5f + share * share * static_cast<float>(columns.side) * 0.6f;
        const int cx = static_cast<int>(from.x + direction.x * distance);
        const int cz = static_cast<int>(from.y + direction.y * distance);
        if (cx < 0 || cz < 0 || cx >= columns.side || cz >= columns.side) break;
        const std::size_t i =
            static_cast<std::size_t>(cz) * static_cast<std::size_t>(columns.side) +
            static_cast<std::size_t>(cx);
        if (columns.low[i] > columns.high[i]) continue;
        const auto band = [&](float height) {
            const float slope = std::max(height, 0.0f) / (distance * columns.texel_metres);
            return static_cast<int>(kSkyBands * slope * slope / (1.0f + slope * slope));
        };
        for (int k = band(columns.low[i]); k <= std::min(band(columns.high[i]), kSkyBands - 1); ++k)
            hidden |= 1u << static_cast<unsigned>(k);
    }
    return hidden;
}

HiddenSky hidden_sky(const Columns& columns, int x, int z) {
    HiddenSky hidden;
    const glm::vec2 middle(static_cast<float>(x) + 0.5f, static_cast<float>(z) + 0.5f);
    for (std::size_t a = 0; a < kGroundAzimuths; ++a)
        hidden[a] = hidden_bands(columns, middle, azimuth_angle(a, turn_of(x, z)));
    return hidden;
}

/// What of the light comes through each band of the sector about each azimuth of a turn.
using SectorShares = std::array<std::array<float, kSkyBands>, kGroundAzimuths>;

SectorShares sector_shares(const SkyShares& sky, int turn, float rotation_degrees) {
    constexpr float kCellsPerSector = static_cast<float>(kSkyAzimuths) / kGroundAzimuths;
    SectorShares shares = {};
    for (std::size_t a = 0; a < kGroundAzimuths; ++a) {
        // The map turns counter-clockwise: what lies at an angle of the world is at a greater one
        // of the map, which begins at -pi.
        const float angle =
            azimuth_angle(a, turn) + glm::radians(rotation_degrees) + glm::pi<float>();
        const float middle = angle / glm::two_pi<float>() * kSkyAzimuths;
        const float first = middle - 0.5f * kCellsPerSector;
        const float last = middle + 0.5f * kCellsPerSector;
        for (int cell = static_cast<int>(std::floor(first)); static_cast<float>(cell) < last;
             ++cell) {
            const auto begin = static_cast<float>(cell);
            const float part = std::min(last, begin + 1.0f) - std::max(first, begin);
            const auto& bands =
                sky[static_cast<std::size_t>((cell % kSkyAzimuths + kSkyAzimuths) % kSkyAzimuths)];
            for (std::size_t k = 0; k < kSkyBands; ++k) shares[a][k] += part * bands[k];
        }
    }
    return shares;
}

float hidden_share(const HiddenSky& hidden, const SectorShares& shares) {
    float sum = 0.0f;
    for (std::size_t a = 0; a < kGroundAzimuths; ++a)
        for (std::uint32_t bits = hidden[a]; bits != 0; bits &= bits - 1)
            sum += shares[a][static_cast<std::size_t>(std::countr_zero(bits))];
    return sum;
}

/// The mean over 5 x 5 texels weighted 1 2 2 2 1 along each side: every turn has the same weight.
std::vector<float> smooth(const std::vector<float>& values, int side) {
    constexpr std::array<float, 5> kWeights = {0.125f, 0.25f, 0.25f, 0.25f, 0.125f};
    const auto at = [&](int x, int z) {
        return static_cast<std::size_t>(std::clamp(z, 0, side - 1)) *
                   static_cast<std::size_t>(side) +
               static_cast<std::size_t>(std::clamp(x, 0, side - 1));
    };
    std::vector<float> rows(values.size(), 0.0f);
    std::vector<float> result(values.size(), 0.0f);
    for (int z = 0; z < side; ++z)
        for (int x = 0; x < side; ++x)
            for (int i = 0; i < 5; ++i)
                rows[at(x, z)] += kWeights[static_cast<std::size_t>(i)] * values[at(x + i - 2, z)];
    for (int z = 0; z < side; ++z)
        for (int x = 0; x < side; ++x)
            for (int i = 0; i < 5; ++i)
                result[at(x, z)] += kWeights[static_cast<std::size_t>(i)] * rows[at(x, z + i - 2)];
    return result;
}

/// 0 in the outermost tenth, so that the map has no visible edge.
float edge_fade(float x, float z, int side) {
    const glm::vec2 from_middle =
        glm::abs(glm::vec2(x, z) / static_cast<float>(side) * 2.0f - 1.0f);
    const float rim = std::min(1.0f, glm::length(from_middle));
    return 1.0f - glm::smoothstep(0.7f, 0.98f, rim);
}

}  // namespace

GroundShadow ground_shadow(const std::vector<FloorCaster>& casters, const Bounds& bounds_world,
                           int side) {
    GroundShadow shadow;
    shadow.side = side;
    shadow.hidden.assign(static_cast<std::size_t>(side) * static_cast<std::size_t>(side),
                         HiddenSky{});
    if (bounds_world.empty()) return shadow;
    const glm::vec3 center = bounds_world.center();
    const glm::vec3 half = 0.5f * (bounds_world.high - bounds_world.low);
    shadow.center_world = {center.x, bounds_world.low.y, center.z};
    shadow.extent = kReach * std::max(glm::length(glm::vec2(half.x, half.z)), 1e-6f);

    Columns columns{side, 2.0f * shadow.extent / static_cast<float>(side), {}, {}};
    columns.low.assign(shadow.hidden.size(), 1e30f);
    columns.high.assign(shadow.hidden.size(), -1e30f);
    const glm::vec3 corner = shadow.center_world - glm::vec3(shadow.extent, 0.0f, shadow.extent);
    for (const FloorCaster& caster : casters)
        rasterize(*caster.primitive, caster.world_from_local, corner, columns);

    parallel_for(0, side, 4, [&](std::int64_t first, std::int64_t last) {
        for (int z = static_cast<int>(first); z < static_cast<int>(last); ++z)
            for (int x = 0; x < side; ++x)
                shadow.hidden[static_cast<std::size_t>(z) * static_cast<std::size_t>(side) +
                              static_cast<std::size_t>(x)] = hidden_sky(columns, x, z);
    });
    return shadow;
}

std::vector<std::uint8_t> floor_light(const GroundShadow& shadow, const SkyShares& sky,
                                      float rotation_degrees) {
    std::array<SectorShares, kTurns> shares;
    for (int turn = 0; turn < kTurns; ++turn)
        shares[static_cast<std::size_t>(turn)] = sector_shares(sky, turn, rotation_degrees);
    std::vector<float> dark(shadow.hidden.size());
    parallel_for(0, shadow.side, 4, [&](std::int64_t first, std::int64_t last) {
        for (int z = static_cast<int>(first); z < static_cast<int>(last); ++z)
            for (int x = 0; x < shadow.side; ++x) {
                const std::size_t i =
                    static_cast<std::size_t>(z) * static_cast<std::size_t>(shadow.side) +
                    static_cast<std::size_t>(x);
                const auto turn = static_cast<std::size_t>(turn_of(x, z));
                dark[i] = hidden_share(shadow.hidden[i], shares[turn]) *
                          edge_fade(static_cast<float>(x) + 0.5f, static_cast<float>(z) + 0.5f,
                                    shadow.side);
            }
    });
    const std::vector<float> smoothed = smooth(dark, shadow.side);
    std::vector<std::uint8_t> light(smoothed.size());
    std::transform(smoothed.begin(), smoothed.end(), light.begin(), [](float value) {
        return static_cast<std::uint8_t>(255.0f * std::clamp(1.0f - value, 0.0f, 1.0f) + 0.5f);
    });
    return light;
}

}  // namespace patina::render
