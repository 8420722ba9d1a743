// SPDX-License-Identifier: MIT
#include "render/accumulation.h"

#include "core/r2_sequence.h"

namespace patina::render {

glm::vec2 sample_offset(int i) {
    const R2Point point = r2_point(i);
    return glm::vec2(point.u - 0.5, point.v - 0.5);
}

Result<gl::Framebuffer*> sum_for(SizedTarget& target, PictureSize size, int index) {
    Result<gl::Framebuffer*> sum = target.at({size.width, size.height});
    if (sum && index == 0)
        const gl::Pass clear({.label = "clear", .target = *sum, .clear_colors = {glm::vec4(0.0f)}});
    return sum;
}

Status ready_to_sample(RendererState& state) {
    if (state.sampled_environment) return {};
    GpuEnvironment& environment = *state.environment;
    if (!environment.sampling) environment.sampling = environment_sampling(environment.map);
    Result<SampledEnvironment> made = upload_sampled_environment(*environment.sampling);
    if (!made) return passed_on(made);
    state.sampled_environment.emplace(std::move(*made));
    environment.sampling.reset();
    return {};
}

Status add_radiance(RendererState& state, const View& view, PictureSize size,
                    const gl::Framebuffer& sum, const AddedDraw& draw) {
    if (draw.still)
        if (Status ready = ready_to_sample(state); !ready) return ready;
    View bare = view;
    bare.background.kind = Background::Kind::Transparent;
    return draw_frame(state, bare, {size.width, size.height},
                      {.framebuffer = &sum,
                       .output = OutputMode::Radiance,
                       .add = true,
                       .jitter_pixels = sample_offset(draw.index),
                       .still = draw.still,
                       .draw_index = draw.index,
                       .right_sum = draw.right_sum});
}

}  // namespace patina::render
