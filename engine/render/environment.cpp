// SPDX-License-Identifier: MIT
#include "render/environment.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/packing.hpp>

#include "core/formulae/formulae.h"
#include "core/parallel.h"
#include "render/environment_brdf.h"
#include "render/environment_suns.h"
#include "render/radiance_cube.h"
#include "render/radiance_map.h"

namespace patina::render {
namespace {

/// What the two qualities cost.
struct FilterSettings {
    int largest_face;
    unsigned samples;  ///< a texel of level 1; twice as many with each level that follows
    int diffuse_face;
    int diffuse_map_width;  ///< the map is halved to this before it is convolved with a cosine
};
FilterSettings settings_of(FilterQuality quality) {
    switch (quality) {
        case FilterQuality::First:
            return {128, 32, 16, 64};
        case FilterQuality::Finished:
            break;
    }
    return {512, 256, 32, 128};
}

/// Texels of the cube as fine as those of the map, which go four times round the horizon.
int face_size_for(int map_width, int largest_face) {
    const auto wanted = static_cast<unsigned>(std::max(1, map_width / 4));
    return std::clamp(static_cast<int>(std::bit_ceil(wanted)), 64, largest_face);
}

void pack(const glm::vec3& radiance, std::uint16_t* out) {
    const glm::vec3 finite = glm::min(radiance, formulae::LARGEST_HALF);
    out[0] = glm::packHalf1x16(finite.x);
    out[1] = glm::packHalf1x16(finite.y);
    out[2] = glm::packHalf1x16(finite.z);
    out[3] = glm::packHalf1x16(1.0f);
}

/// Calls `radiance(direction)` for every texel of a level and packs what it returns.
template <typename Radiance>
std::vector<std::uint16_t> packed_level(int side, const Progress& progress,
                                        const Radiance& radiance) {
    std::vector<std::uint16_t> level(static_cast<std::size_t>(kCubeFaces) *
                                     static_cast<std::size_t>(side) *
                                     static_cast<std::size_t>(side) * kHalfCubeChannels);
    parallel_for(0, std::int64_t{kCubeFaces} * side, 4, [&](std::int64_t first, std::int64_t last) {
        if (progress.cancelled()) return;
        for (std::int64_t row = first; row < last; ++row)
            for (int x = 0; x < side; ++x) {
                const auto texel = static_cast<std::size_t>(row * side + x);
                const glm::vec3 direction = cube_texel_direction(static_cast<int>(row / side), side,
                                                                 x, static_cast<int>(row % side));
                pack(radiance(direction), level.data() + texel * kHalfCubeChannels);
            }
    });
    return level;
}

/// What a half float cannot hold goes to the texels around it in equal parts, until none is too
/// bright: the sharp level keeps the power of a sun. Faces are apart; a sun on an edge keeps its
/// share on each.
void spread_peaks(CubeLevel& level) {
    for (int round = 0; round < 64; ++round) {
        bool found = false;
        for (int face = 0; face < kCubeFaces; ++face)
            for (int y = 0; y < level.side; ++y)
                for (int x = 0; x < level.side; ++x) {
                    glm::vec4& texel = level.texels[level.index(face, x, y)];
                    const glm::vec4 excess =
                        glm::max(texel - formulae::LARGEST_HALF, glm::vec4(0.0f));
                    if (excess == glm::vec4(0.0f)) continue;
                    found = true;
                    texel -= excess;
                    for (int dy = -1; dy <= 1; ++dy)
                        for (int dx = -1; dx <= 1; ++dx) {
                            const int nx = std::clamp(x + dx, 0, level.side - 1);
                            const int ny = std::clamp(y + dy, 0, level.side - 1);
                            if (nx == x && ny == y) continue;
                            level.texels[level.index(face, nx, ny)] += excess / 8.0f;
                        }
                }
        if (!found) return;
    }
}

std::vector<std::uint16_t> sharp_level(CubeLevel level, const Progress& progress) {
    spread_peaks(level);
    return packed_level(level.side, progress, [&](const glm::vec3& direction) {
        return radiance_from(level, direction);
    });
}

/// A direction of the lobe, its share of it, and the level of the source whose texels are as large
/// as the part of the lobe that it stands for.
struct LobeSample {
    glm::vec3 direction;
    float weight;
    std::size_t level;
};

/// By filtered importance sampling.
std::vector<LobeSample> filtered_lobe(float roughness, unsigned count, int face_size,
                                      std::size_t levels) {
    const float texel_angle =
        4.0f * glm::pi<float>() /
        (6.0f * static_cast<float>(face_size) * static_cast<float>(face_size));
    std::vector<LobeSample> samples;
    for (const LobeDirection& each : prefiltered_lobe(roughness, count)) {
        const float level = formulae::filtered_level(each.solid_angle, texel_angle);
        samples.push_back({each.direction, each.weight,
                           static_cast<std::size_t>(
                               std::clamp(level + 0.5f, 0.0f, static_cast<float>(levels - 1)))});
    }
    return samples;
}

/// Columns: two directions across n, and n.
glm::mat3 frame_about(const glm::vec3& n) {
    const formulae::Across across = formulae::across_of({n.x, n.y, n.z});
    return {{across.x_axis.x, across.x_axis.y, across.x_axis.z},
            {across.y_axis.x, across.y_axis.y, across.y_axis.z},
            n};
}

/// @param sharp   the whole map, for the first level
/// @param source  the map without suns, for the others
HalfCube filter_specular(CubeLevel sharp, const RadianceCube& source,
                         const FilterSettings& settings, const Progress& progress) {
    HalfCube cube{source[0].side, {}};
    cube.levels.push_back(sharp_level(std::move(sharp), progress));
    for (int i = 1; i < kPrefilteredLevels; ++i) {
        const float roughness =
            prefiltered_roughness(static_cast<float>(i) / (kPrefilteredLevels - 1));
        const std::vector<LobeSample> lobe =
            filtered_lobe(roughness, settings.samples << (i - 1), source[0].side, source.size());
        cube.levels.push_back(
            packed_level(source[0].side >> i, progress, [&](const glm::vec3& normal) {
                const glm::mat3 world_from_lobe = frame_about(normal);
                glm::vec3 sum(0.0f);
                for (const LobeSample& sample : lobe)
                    sum += sample.weight *
                           radiance_from(source[sample.level], world_from_lobe * sample.direction);
                return sum;
            }));
        progress.report(static_cast<float>(i) / kPrefilteredLevels);
    }
    return cube;
}

/// A texel of a small map as a light: direction, radiance x solid angle, and solid angle.
struct TexelLight {
    glm::vec3 direction;
    glm::vec3 power;
    float solid_angle;
};

std::vector<TexelLight> texel_lights(const RadianceMap& map) {
    std::vector<TexelLight> lights;
    lights.reserve(map.texels.size());
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x)
            lights.push_back({texel_direction(map, x, y), texel_solid_angle(map, y) * map.at(x, y),
                              texel_solid_angle(map, y)});
    return lights;
}

/// Each texel of the map is summed under the cosine: no spherical harmonics, which ring beside a
/// sun.
HalfCube filter_diffuse(const std::vector<TexelLight>& lights, int face_size,
                        const Progress& progress) {
    HalfCube cube{face_size, {}};
    cube.levels.push_back(packed_level(face_size, progress, [&](const glm::vec3& normal) {
        glm::vec3 sum(0.0f);
        for (const TexelLight& light : lights)
            sum += std::max(glm::dot(light.direction, normal), 0.0f) * light.power;
        return sum / glm::pi<float>();
    }));
    return cube;
}

/// Half the angle of the cone around a bright direction that becomes a light, and the least angle
/// between two: twice that.
constexpr float kKeyConeCosine = 0.9f;  // 26 degrees
constexpr float kBetweenKeysCosine = 0.62f;
/// A weaker one than this share of the first is left in the ambient light.
constexpr float kLeastKeyShare = 0.1f;

glm::vec3 total_power(const std::vector<TexelLight>& lights) {
    glm::vec3 total(0.0f);
    for (const TexelLight& light : lights) total += light.power;
    return total;
}

bool is_apart(const glm::vec3& towards, const std::vector<EnvironmentKey>& keys) {
    return std::none_of(keys.begin(), keys.end(), [&](const EnvironmentKey& key) {
        return glm::dot(-key.direction_map, towards) > kBetweenKeysCosine;
    });
}

/// The middle of the cone with the most light, of those that are apart from `keys`.
glm::vec3 brightest_cone(const std::vector<TexelLight>& lights,
                         const std::vector<EnvironmentKey>& keys) {
    glm::vec3 axis(0.0f, 1.0f, 0.0f);
    float strongest = -1.0f;
    for (const TexelLight& middle : lights) {
        if (!is_apart(middle.direction, keys)) continue;
        float strength = 0.0f;
        for (const TexelLight& light : lights)
            if (glm::dot(light.direction, middle.direction) > kKeyConeCosine)
                strength += luminance_of(light.power);
        if (strength > strongest) {
            strongest = strength;
            axis = middle.direction;
        }
    }
    return axis;
}

/// What stands out of the mean radiance around an axis, as one light.
EnvironmentKey key_around(const glm::vec3& axis, const std::vector<TexelLight>& lights,
                          const glm::vec3& mean) {
    glm::vec3 power(0.0f);
    glm::vec3 towards(0.0f);
    float cone_angle = 0.0f;
    for (const TexelLight& light : lights) {
        if (glm::dot(light.direction, axis) <= kKeyConeCosine) continue;
        power += light.power;
        towards += luminance_of(light.power) * light.direction;
        cone_angle += light.solid_angle;
    }
    EnvironmentKey key;
    key.irradiance_linear = glm::max(power - mean * cone_angle, glm::vec3(0.0f));
    if (glm::length(towards) > 0.0f) key.direction_map = -glm::normalize(towards);
    return key;
}

/// Splits the map into its strongest directional lights and what is left, spread evenly.
void split_for_traditional_models(const std::vector<TexelLight>& lights,
                                  FilteredEnvironment& environment) {
    constexpr float kSphere = 4.0f * glm::pi<float>();
    glm::vec3 rest = total_power(lights);
    const glm::vec3 mean = rest / kSphere;
    environment.keys.clear();
    while (environment.keys.size() < kMostKeys) {
        const EnvironmentKey key =
            key_around(brightest_cone(lights, environment.keys), lights, mean);
        const float strength = luminance_of(key.irradiance_linear);
        if (!environment.keys.empty() &&
            strength <= kLeastKeyShare * luminance_of(environment.keys[0].irradiance_linear))
            break;
        rest -= key.irradiance_linear;
        environment.keys.push_back(key);
    }
    environment.ambient_linear = glm::max(rest, glm::vec3(0.0f)) / kSphere;
}

}  // namespace

std::size_t HalfCube::bytes() const {
    std::size_t values = 0;
    for (const std::vector<std::uint16_t>& level : levels) values += level.size();
    return values * sizeof(std::uint16_t);
}

float prefiltered_level_share(float roughness) {
    return formulae::prefiltered_level_share(roughness);
}

float prefiltered_roughness(float level_share) {
    return formulae::prefiltered_roughness(level_share);
}

Status set_map(const Image& equirect, FilteredEnvironment& environment, const Progress& progress) {
    Result<RadianceMap> map = radiance_map(equirect);
    if (!map) return passed_on(map);
    const int face_size = face_size_for(map->width, settings_of(environment.quality).largest_face);
    const int finest_face = face_size_for(map->width, kBackdropFace);
    if (environment.quality == FilterQuality::Finished && finest_face > face_size) {
        *map = reduced_to_width(std::move(*map), 4 * finest_face);
        environment.backdrop = {finest_face,
                                {sharp_level(cube_level(*map, finest_face), progress)}};
    }
    environment.map =
        std::make_shared<const RadianceMap>(reduced_to_width(std::move(*map), 4 * face_size));
    return {};
}

Result<FilteredEnvironment> filter_environment(const Image& equirect, FilterQuality quality,
                                               const Progress& progress) {
    const FilterSettings settings = settings_of(quality);
    const int face_size = face_size_for(equirect.width, settings.largest_face);
    FilteredEnvironment environment;
    environment.source = content_hash(equirect);
    environment.quality = quality;
    if (const Status read = set_map(equirect, environment, progress); !read) return passed_on(read);
    const RadianceMap& whole = *environment.map;
    MapWithoutSuns parted = take_out_suns(whole);
    environment.suns = std::move(parted.suns);
    const RadianceCube cube = radiance_cube(parted.rest, face_size);
    environment.specular =
        filter_specular(environment.suns.empty() ? cube.front() : cube_level(whole, face_size),
                        cube, settings, progress);
    environment.diffuse = filter_diffuse(
        texel_lights(reduced_to_width(std::move(parted.rest), settings.diffuse_map_width)),
        settings.diffuse_face, progress);
    environment.sky = sky_shares(whole, environment.suns);
    constexpr int kKeySearchWidth = 32;
    split_for_traditional_models(texel_lights(reduced_to_width(whole, kKeySearchWidth)),
                                 environment);
    if (progress.cancelled()) return failure("filtering the environment was cancelled");
    progress.report(1.0f);
    return environment;
}

}  // namespace patina::render
