// SPDX-License-Identifier: MIT
#pragma once

/// A filtered environment and the floor's shadow on the GPU.

#include <optional>

#include "core/result.h"
#include "gl/pass.h"
#include "gl/sampler.h"
#include "gl/texture.h"
#include "render/environment.h"
#include "render/ground_shadow.h"
#include "render/view.h"

namespace patina::render {

struct GpuEnvironment {
    gl::Texture specular;
    std::optional<gl::Texture> backdrop;  ///< where it is finer than `specular`
    gl::Texture diffuse;
    glm::vec3 ambient_linear;
    std::vector<EnvironmentKey> keys;  ///< before rotation
    SkyShares sky;
    std::vector<EnvironmentSun> suns;
    std::shared_ptr<const RadianceMap> map;
    std::shared_ptr<const EnvironmentSampling> sampling;  ///< until it is uploaded
    int levels = 1;
    std::size_t bytes() const;  ///< of its textures
};

Result<GpuEnvironment> upload_environment(const FilteredEnvironment& environment);
/// How surfaces with some terms mirror and scatter the environment.
struct EnvironmentTables {
    gl::Texture mirrored;  ///< environment_brdf_table
    std::optional<gl::Texture>
        diffuse;  ///< environment_diffuse_table; unset: Lambert's closed form
    std::size_t bytes() const;
};
Result<EnvironmentTables> upload_environment_tables(const PbrTerms& terms);

/// From world directions to those of the map: the map turns counter-clockwise from above.
glm::mat3 environment_from_world(float rotation_degrees);
/// And back.
glm::mat3 world_from_environment(float rotation_degrees);

/// Sets what passes/environment.glsl reads. Takes texture units 8 to 10, 13 and 14.
void bind_environment(gl::Pass& pass, gl::Program& program, const GpuEnvironment& environment,
                      const EnvironmentTables& tables, const gl::Sampler& linear, const View& view);

struct GpuGroundShadow {
    GroundShadow shadow;
    gl::Texture light;                      ///< floor_light
    std::optional<float> rotation_degrees;  ///< of the environment that it is made for; unset: none
    /// The items of the scene that it is of; unset: another scene's.
    std::optional<std::vector<std::size_t>> casters;
};
/// Its light is made by update_ground_shadow.
Result<GpuGroundShadow> upload_ground_shadow(GroundShadow shadow);
/// Weighs what is hidden with that sky, where it has not been.
void update_ground_shadow(GpuGroundShadow& shadow, const SkyShares& sky, float rotation_degrees);

}  // namespace patina::render
