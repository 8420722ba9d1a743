// SPDX-License-Identifier: MIT
#include "render/gpu_environment.h"

#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <span>

#include "render/environment_brdf.h"

namespace patina::render {
namespace {

constexpr int kTableSize = 64;
constexpr int kSpecularUnit = 8;
constexpr int kDiffuseUnit = 9;
constexpr int kBrdfUnit = 10;
constexpr int kDiffuseBrdfUnit = 13;
constexpr int kBackdropUnit = 14;

/// One with several levels reads linearly within and between them by itself; see gl::Texture.
Result<gl::Texture> upload_cube(const HalfCube& cube, std::string label) {
    Result<gl::Texture> texture =
        gl::Texture::make({.label = std::move(label),
                           .size = {cube.face_size, cube.face_size},
                           .format = gl::Format::Rgba16F,
                           .shape = gl::TextureShape::Cube,
                           .levels = static_cast<int>(cube.levels.size())});
    if (!texture) return texture;
    for (std::size_t level = 0; level < cube.levels.size(); ++level) {
        const int side = cube.face_size >> level;
        const std::size_t face_values =
            static_cast<std::size_t>(side) * static_cast<std::size_t>(side) * kHalfCubeChannels;
        for (int face = 0; face < 6; ++face)
            texture->upload_halves(
                {.size = {side, side}, .level = static_cast<int>(level), .face = face},
                std::span(cube.levels[level])
                    .subspan(static_cast<std::size_t>(face) * face_values, face_values));
    }
    return texture;
}

Result<gl::Texture> upload_table(std::string label, std::span<const float> texels) {
    Result<gl::Texture> texture = gl::Texture::make({.label = std::move(label),
                                                     .size = {kTableSize, kTableSize},
                                                     .format = gl::Format::Rgba32F});
    if (texture) texture->upload({.size = {kTableSize, kTableSize}}, texels);
    return texture;
}

}  // namespace

Result<GpuEnvironment> upload_environment(const FilteredEnvironment& environment) {
    Result<gl::Texture> specular = upload_cube(environment.specular, "environment.specular");
    if (!specular) return passed_on(specular);
    Result<gl::Texture> diffuse = upload_cube(environment.diffuse, "environment.diffuse");
    if (!diffuse) return passed_on(diffuse);
    std::optional<gl::Texture> backdrop;
    if (!environment.backdrop.levels.empty()) {
        Result<gl::Texture> sharp = upload_cube(environment.backdrop, "environment.backdrop");
        if (!sharp) return passed_on(sharp);
        backdrop = std::move(*sharp);
    }
    return GpuEnvironment{.specular = std::move(*specular),
                          .backdrop = std::move(backdrop),
                          .diffuse = std::move(*diffuse),
                          .ambient_linear = environment.ambient_linear,
                          .keys = environment.keys,
                          .sky = environment.sky,
                          .suns = environment.suns,
                          .map = environment.map,
                          .sampling = environment.sampling,
                          .levels = static_cast<int>(environment.specular.levels.size())};
}

std::size_t GpuEnvironment::bytes() const {
    return specular.bytes() + diffuse.bytes() + (backdrop ? backdrop->bytes() : 0);
}

Result<EnvironmentTables> upload_environment_tables(const PbrTerms& terms) {
    const std::vector<EnvironmentBrdf> mirrored = environment_brdf_table(kTableSize, terms);
    Result<gl::Texture> first =
        upload_table("environment.brdf", std::span(&mirrored.front().scale, 4 * mirrored.size()));
    if (!first) return passed_on(first);
    EnvironmentTables tables{std::move(*first), std::nullopt};
    if (terms.diffuse == DiffuseTerm::Lambert || terms.diffuse == DiffuseTerm::Lecture)
        return tables;
    const std::vector<EnvironmentDiffuse> diffuse = environment_diffuse_table(kTableSize, terms);
    std::vector<float> texels;
    for (const EnvironmentDiffuse& entry : diffuse)
        texels.insert(texels.end(), {entry.entering, entry.grazing, 0.0f, 1.0f});
    Result<gl::Texture> second = upload_table("environment.diffuse brdf", texels);
    if (!second) return passed_on(second);
    tables.diffuse = std::move(*second);
    return tables;
}

std::size_t EnvironmentTables::bytes() const {
    return mirrored.bytes() + (diffuse ? diffuse->bytes() : 0);
}

glm::mat3 environment_from_world(float rotation_degrees) {
    return glm::mat3(
        glm::rotate(glm::mat4(1.0f), glm::radians(-rotation_degrees), glm::vec3(0.0f, 1.0f, 0.0f)));
}

glm::mat3 world_from_environment(float rotation_degrees) {
    return glm::transpose(environment_from_world(rotation_degrees));
}

namespace {

/// Laid out as passes/environment.glsl says.
void set_suns(gl::Program& program, const std::vector<EnvironmentSun>& suns) {
    std::array<glm::vec4, kMostSuns> towards = {};
    std::array<glm::vec4, kMostSuns> irradiance = {};
    for (std::size_t i = 0; i < suns.size(); ++i) {
        towards[i] = {suns[i].towards_map, suns[i].radius_radians};
        irradiance[i] = {suns[i].irradiance_linear, std::cos(kSunReach * suns[i].radius_radians)};
    }
    program.set("sun_count", static_cast<int>(suns.size()));
    program.set("sun_towards[0]", std::span<const glm::vec4>(towards));
    program.set("sun_irradiance[0]", std::span<const glm::vec4>(irradiance));
}

}  // namespace

void bind_environment(gl::Pass& pass, gl::Program& program, const GpuEnvironment& environment,
                      const EnvironmentTables& tables, const gl::Sampler& linear,
                      const View& view) {
    pass.bind_texture(program, "specular_environment", kSpecularUnit, environment.specular);
    pass.bind_texture(program, "diffuse_environment", kDiffuseUnit, environment.diffuse, &linear);
    if (environment.backdrop)
        pass.bind_texture(program, "environment_sharp", kBackdropUnit, *environment.backdrop,
                          &linear);
    else
        pass.bind_texture(program, "environment_sharp", kBackdropUnit, environment.specular);
    pass.bind_texture(program, "environment_brdf", kBrdfUnit, tables.mirrored, &linear);
    if (tables.diffuse)
        pass.bind_texture(program, "diffuse_brdf", kDiffuseBrdfUnit, *tables.diffuse, &linear);
    program.set("environment_levels", static_cast<float>(environment.levels));
    program.set("environment_from_world",
                environment_from_world(view.environment_rotation_degrees));
    program.set("environment_intensity", view.environment_intensity);
    set_suns(program, environment.suns);
}

Result<GpuGroundShadow> upload_ground_shadow(GroundShadow shadow) {
    Result<gl::Texture> light = gl::Texture::make(
        {.label = "ground shadow", .size = {shadow.side, shadow.side}, .format = gl::Format::R8});
    if (!light) return passed_on(light);
    return GpuGroundShadow{std::move(shadow), std::move(*light), std::nullopt, std::nullopt};
}

void update_ground_shadow(GpuGroundShadow& shadow, const SkyShares& sky, float rotation_degrees) {
    if (shadow.rotation_degrees == rotation_degrees) return;
    const int side = shadow.shadow.side;
    const std::vector<std::uint8_t> light = floor_light(shadow.shadow, sky, rotation_degrees);
    shadow.light.upload({.size = {side, side}}, std::span<const std::uint8_t>(light));
    shadow.rotation_degrees = rotation_degrees;
}

}  // namespace patina::render
