// SPDX-License-Identifier: MIT
#pragma once

/// What passes/environment_samples.glsl reads. Inside engine/render only.

#include <optional>

#include "gl/pass.h"
#include "gl/sampler.h"
#include "gl/texture.h"
#include "render/environment_sampler.h"
#include "render/view.h"

namespace patina::render {

/// One draw of those that a still averages.
struct StillDraw {
    int index = 0;
    int count = 1;
};

/// An environment that directions are drawn from.
struct SampledEnvironment {
    std::shared_ptr<const EnvironmentSampler> sampler;
    gl::Texture map;
    gl::Sampler reading;
    float scale = 1.0f;  ///< of what `map` holds to radiance
};
/// Fails when the driver refuses the map.
Result<SampledEnvironment> upload_sampled_environment(const EnvironmentSampling& sampling);

/// Takes texture unit 11. Index of the draw decides which directions are drawn.
void bind_environment_samples(gl::Pass& pass, gl::Program& program,
                              const SampledEnvironment& environment, const StillDraw& draw);

}  // namespace patina::render
