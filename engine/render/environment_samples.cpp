// SPDX-License-Identifier: MIT
#include "render/environment_samples.h"

#include <algorithm>
#include <array>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/packing.hpp>
#include <span>

namespace patina::render {
namespace {

constexpr int kMapUnit = 11;
constexpr std::uint32_t kLightSamples = 8;  ///< LIGHT_SAMPLES of the shader

/// What brings the brightest texel into half floats.
float scale_of(const RadianceMap& map) {
    float most = 0.0f;
    for (const glm::vec3& texel : map.texels) most = std::max({most, texel.x, texel.y, texel.z});
    return most > kLargestHalf ? kLargestHalf / most : 1.0f;
}

void upload_level(gl::Texture& texture, const RadianceMap& map, int level, float scale) {
    std::vector<std::uint16_t> halves;
    halves.reserve(map.texels.size() * 4);
    for (const glm::vec3& texel : map.texels) {
        for (int c = 0; c < 3; ++c) halves.push_back(glm::packHalf1x16(texel[c] * scale));
        halves.push_back(glm::packHalf1x16(1.0f));
    }
    texture.upload_halves({.size = {map.width, map.height}, .level = level}, halves);
}

}  // namespace

Result<SampledEnvironment> upload_sampled_environment(std::shared_ptr<const RadianceMap> map) {
    const int levels = gl::full_level_count({map->width, map->height});
    Result<gl::Texture> texture = gl::Texture::make({.label = "environment.map",
                                                     .size = {map->width, map->height},
                                                     .format = gl::Format::Rgba16F,
                                                     .levels = levels});
    if (!texture) return passed_on(texture);
    const float scale = scale_of(*map);
    RadianceMap level = *map;
    for (int i = 0; i < levels; ++i) {
        if (i > 0) level = halved(level);
        upload_level(*texture, level, i, scale);
    }
    gl::Sampler reading = gl::Sampler::make(
        {.label = "environment.map", .wrap_u = gl::Wrap::Repeat, .mip = gl::MipFilter::Linear});
    return SampledEnvironment{EnvironmentSampler(std::move(map)), std::move(*texture),
                              std::move(reading), scale};
}

void bind_environment_samples(gl::Pass& pass, gl::Program& program,
                              const SampledEnvironment& environment, const StillDraw& draw) {
    pass.bind_texture(program, "environment_map", kMapUnit, environment.map, &environment.reading);
    const glm::vec2 size(environment.map.size());
    program.set("map_scale", environment.scale);
    program.set("map_texel_angle", glm::two_pi<float>() / size.x * glm::pi<float>() / size.y);
    program.set("draw_index", draw.index);
    program.set("draw_count", draw.count);

    std::array<glm::vec4, kLightSamples> towards = {};
    std::array<glm::vec4, kLightSamples> radiance = {};
    const EnvironmentSampler& sampler = environment.sampler;
    program.set("light_sample_count", sampler.has_light() ? static_cast<int>(kLightSamples) : 0);
    if (!sampler.has_light()) return;
    for (std::uint32_t i = 0; i < kLightSamples; ++i) {
        const EnvironmentSample sample =
            sampler.sample(sobol_point(static_cast<std::uint32_t>(draw.index) * kLightSamples + i));
        towards[i] = {sample.towards, sample.density};
        radiance[i] = {sample.radiance_linear, 0.0f};
    }
    program.set("density_per_luminance", static_cast<float>(1.0 / sampler.total_luminance()));
    program.set("light_sample_towards[0]", std::span<const glm::vec4>(towards));
    program.set("light_sample_radiance[0]", std::span<const glm::vec4>(radiance));
}

}  // namespace patina::render
