// SPDX-License-Identifier: MIT
#pragma once

/// Light from all around, filtered for the renderer. CPU work on the pool's threads; the result is
/// a value that is uploaded in one go, so no frame waits for it: ask for Quality::First, show it,
/// ask for Quality::Finished on a worker, show that. The same texels with any number of threads.
///
/// Directions: (x, y, z) reads an equirectangular map at u = 0.5 + atan2(z, x) / 2pi,
/// v = acos(y) / pi from the top row, so the centre column lies towards +X. Radiance is linear
/// Rec. 709, without unit: 1 is white at exposure 0.

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <string_view>
#include <vector>

#include "core/progress.h"
#include "core/result.h"
#include "document/document.h"
#include "render/environment_sampler.h"
#include "render/radiance_map.h"
#include "render/sky_light.h"
#include "scene/image.h"

namespace patina::render {

/// A cube map in half floats: faces +X -X +Y -Y +Z -Z with OpenGL's orientation, rows from t = 0,
/// RGBA with alpha 1. levels[i] is face_size >> i texels a side.
inline constexpr std::size_t kHalfCubeChannels = 4;
struct HalfCube {
    int face_size = 0;
    std::vector<std::vector<std::uint16_t>> levels;  ///< 6 * side * side * kHalfCubeChannels each
    std::size_t bytes() const;
};

/// What is small and bright in a map: a sun, a lamp. Lit as a light of its own.
struct EnvironmentSun {
    /// Unit, in the directions of the map; world_from_environment (gpu_environment.h) takes it to
    /// the world.
    glm::vec3 towards_map = glm::vec3(0.0f, 1.0f, 0.0f);
    glm::vec3 irradiance_linear = glm::vec3(0.0f);  ///< on a surface that faces it
    float radius_radians = 0.0f;                    ///< of a disc as wide
};

/// A sun is no even disc: so far from its middle, in its radii, a map is taken to be of it.
inline constexpr float kSunReach = 1.5f;

/// A directional light that the traditional models have in place of a bright part of a map.
struct EnvironmentKey {
    /// The way it travels, unit, in the directions of the map as EnvironmentSun::towards_map.
    glm::vec3 direction_map = glm::vec3(0.0f, -1.0f, 0.0f);
    glm::vec3 irradiance_linear = glm::vec3(0.0f);  ///< on a surface that faces it
    bool operator==(const EnvironmentKey&) const = default;
};

enum class FilterQuality {
    First,     ///< to have light at once: small faces, few samples
    Finished,  ///< what is kept
};

/// An environment ready for the renderer.
struct FilteredEnvironment {
    Hash128 source;  ///< content_hash of the map it was made of
    FilterQuality quality = FilterQuality::First;
    /// What was filtered, at most 2048 texels wide: stills that converge read it.
    std::shared_ptr<const RadianceMap> map;
    /// environment_sampling of `map` where a worker has made it; null: the renderer makes it when a
    /// picture first needs it.
    std::shared_ptr<const EnvironmentSampling> sampling = nullptr;
    /// Radiance convolved with GGX for n = v = r; level i is for the roughness
    /// prefiltered_roughness(i / (levels - 1)). Level 0 is the map itself; the others, and
    /// `diffuse`, are without `suns`.
    HalfCube specular;
    /// The map where it is finer than level 0, of up to kBackdropFace texels a side of a face: what
    /// a sharp background shows. One level, or none.
    HalfCube backdrop = {};
    /// Irradiance / pi: what a white Lambert surface sends out. One level.
    HalfCube diffuse;
    std::vector<EnvironmentSun> suns;  ///< at most kMostSuns
    /// What the traditional models see of the map: its strongest directional lights, at least one
    /// and at most kMostKeys, the strongest first, and the mean of what is left of its radiance.
    /// Their sum over a sphere keeps the map's energy.
    glm::vec3 ambient_linear = glm::vec3(0.0f);
    std::vector<EnvironmentKey> keys = {{}};
    SkyShares sky = even_sky();  ///< sky_shares of `map` and `suns`
};

/// As fine as maps of 4096 texels around.
inline constexpr int kBackdropFace = 1024;
/// At most this many suns are taken out of a map, the strongest.
inline constexpr std::size_t kMostSuns = 4;
/// A key, a fill and a rim: what fixed-function artists set up.
inline constexpr std::size_t kMostKeys = 3;

/// Sets what is read of an equirectangular map and not filtered, `map` and `backdrop`, as
/// `environment.quality` asks.
Status set_map(const Image& equirect, FilteredEnvironment& environment,
               const Progress& progress = {});

/// Filters an equirectangular map of any size: 1 to 4 channels (grey or RGB; alpha is ignored), F32
/// linear, or U8/U16 taken as sRGB. Peaks beyond 65504 are kept in all that is filtered; in the
/// sharp level, where a half float ends, their energy goes to the texels around them.
Result<FilteredEnvironment> filter_environment(const Image& equirect, FilterQuality quality,
                                               const Progress& progress = {});

struct BuiltinEnvironment {
    std::string_view id;
    std::string_view label;
    std::string_view tooltip;
};
/// The built-in one whose sun stands where EnvironmentSettings says.
inline constexpr std::string_view kSkyEnvironment = "sky";
inline constexpr std::array<BuiltinEnvironment, 3> kBuiltinEnvironments = {{
    {"studio", "Studio", "Three soft boxes in a dark room"},
    {kSkyEnvironment, "Sky", "A clear sky with its sun, which can be raised and lowered"},
    {"white", "White", "The same light from everywhere"},
}};
/// Whether EnvironmentSettings::name is one of them, and no file.
bool is_builtin_environment(std::string_view name);

/// Rows that are enough for the soft edges of all of them.
inline constexpr int kBuiltinHeight = 256;

/// One of kBuiltinEnvironments as an equirectangular map, RGB F32, 2 * height x height. Unknown
/// names are a failure that lists the known ones.
/// @param sun_elevation_degrees  of the sky's sun above the horizon, 0 to 90
Result<Image> builtin_environment(std::string_view id, int height = kBuiltinHeight,
                                  float sun_elevation_degrees = kSunElevationDegrees);

/// The roughness of a position 0 to 1 among the levels of FilteredEnvironment::specular, and back.
/// More levels are spent on smooth surfaces, where the eye sees steps.
float prefiltered_roughness(float level_share);
float prefiltered_level_share(float roughness);

}  // namespace patina::render
