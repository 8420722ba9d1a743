// SPDX-License-Identifier: MIT
#include "render/environment_samples.h"

#include <algorithm>
#include <array>
#include <span>

namespace patina::render {
namespace {

constexpr int kMapUnit = 11;
constexpr std::uint32_t kLightSamples = 8;  ///< LIGHT_SAMPLES of the shader

}  // namespace

Result<SampledEnvironment> upload_sampled_environment(const EnvironmentSampling& sampling) {
    Result<gl::Texture> texture =
        gl::Texture::make({.label = "environment.map",
                           .size = {sampling.width, sampling.height},
                           .format = gl::Format::Rgba16F,
                           .levels = static_cast<int>(sampling.levels.size())});
    if (!texture) return passed_on(texture);
    for (int level = 0; level < static_cast<int>(sampling.levels.size()); ++level)
        texture->upload_halves(
            {.size = {std::max(sampling.width >> level, 1), std::max(sampling.height >> level, 1)},
             .level = level},
            sampling.levels[static_cast<std::size_t>(level)]);
    gl::Sampler reading = gl::Sampler::make(
        {.label = "environment.map", .wrap_u = gl::Wrap::Repeat, .mip = gl::MipFilter::Linear});
    return SampledEnvironment{sampling.sampler, std::move(*texture), std::move(reading),
                              sampling.scale};
}

void bind_environment_samples(gl::Pass& pass, gl::Program& program,
                              const SampledEnvironment& environment, const StillDraw& draw) {
    pass.bind_texture(program, "environment_map", kMapUnit, environment.map, &environment.reading);
    const glm::ivec2 size = environment.map.size();
    program.set("map_scale", environment.scale);
    program.set("map_texel_angle", texel_solid_angle_at_horizon(size.x, size.y));
    program.set("draw_index", draw.index);
    program.set("draw_count", draw.count);

    std::array<glm::vec4, kLightSamples> towards = {};
    std::array<glm::vec4, kLightSamples> radiance = {};
    const EnvironmentSampler& sampler = *environment.sampler;
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
