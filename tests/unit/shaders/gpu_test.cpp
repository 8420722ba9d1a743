// SPDX-License-Identifier: MIT
// The shared formulae compiled as GLSL and run in a fragment shader agree with the same text
// compiled as C++.
#include <algorithm>
#include <cmath>
#include <iostream>

#include "core/formulae/formulae.h"
#include "gl/headless_test_context.h"
#include "gl/pass.h"
#include "shaders/probes.h"

namespace patina {
namespace formulae {
namespace {
#undef PROBES_GLSL
#include "shaders/probes.glsl"
}  // namespace
}  // namespace formulae

namespace {

constexpr int kInputSide = 64;
static_assert(kInputSide * kInputSide == kProbeInputs);

/// Four of the input planes, from `first`, as one texture.
gl::Texture input_texture(std::string_view label, std::size_t first) {
    auto texture = gl::Texture::make({.label = std::string(label),
                                      .size = {kInputSide, kInputSide},
                                      .format = gl::Format::Rgba32F});
    EXPECT_TRUE(texture) << texture.error().message;
    std::vector<float> texels;
    for (std::size_t i = 0; i < kProbeInputs; ++i)
        for (std::size_t k = 0; k < 4; ++k) texels.push_back(probe_inputs()[first + k][i]);
    texture->upload({.size = {kInputSide, kInputSide}}, texels);
    return std::move(*texture);
}

formulae::Real4 on_cpu(int which, std::size_t i) {
    const ProbeInputs& in = probe_inputs();
    return formulae::probe(which, formulae::Real4(in[0][i], in[1][i], in[2][i], in[3][i]),
                           formulae::Real4(in[4][i], in[5][i], in[6][i], in[7][i]));
}

float relative_error(float expected, float actual) {
    return std::abs(actual - expected) / std::max(1.0f, std::abs(expected));
}

/// The largest relative error of any component; NaN counts as infinite.
float worst_error(int which, const std::vector<float>& gpu) {
    float worst = 0.0f;
    for (std::size_t i = 0; i < kProbeInputs; ++i) {
        const formulae::Real4 cpu = on_cpu(which, i);
        const float expected[4] = {cpu.x, cpu.y, cpu.z, cpu.w};
        for (std::size_t k = 0; k < 4; ++k) {
            const float error = relative_error(expected[k], gpu[i * 4 + k]);
            worst = std::isnan(error) ? INFINITY : std::max(worst, error);
        }
    }
    return worst;
}

/// What the shader writes beside the result, so that a target left as it was cannot pass.
bool canary_is_alive(int which, const std::vector<float>& canary) {
    for (std::size_t i = 0; i < kProbeInputs; ++i) {
        const float x = static_cast<float>(i % kInputSide) + 0.5f;
        const float y = static_cast<float>(i / kInputSide) + 0.5f;
        if (canary[i * 4] != static_cast<float>(which) || canary[i * 4 + 1] != x ||
            canary[i * 4 + 2] != y || canary[i * 4 + 3] != 1234.5f)
            return false;
    }
    return true;
}

TEST_F(GlTest, TheGpuComputesEverySharedFormulaAsTheCpuDoes) {
    const std::filesystem::path root(PATINA_SOURCE_DIR);
    auto program = gl::Program::make({.label = "probe",
                                      .folders = {root / "shaders", root / "tests/unit"},
                                      .vertex_file = "shaders/probe.vert",
                                      .fragment_file = "shaders/probe.frag"});
    ASSERT_TRUE(program) << program.error().message;
    auto target = gl::Framebuffer::make(
        {.label = "probe",
         .size = {kInputSide, kInputSide},
         .colors = {{"result", gl::Format::Rgba32F}, {"canary", gl::Format::Rgba32F}}});
    ASSERT_TRUE(target) << target.error().message;
    const gl::Texture a = input_texture("inputs a", 0);
    const gl::Texture b = input_texture("inputs b", 4);
    const gl::VertexArray triangle = gl::VertexArray::make({.label = "triangle"});
    std::cout << "renderer: " << gl::renderer_description() << "\n";

    for (int which = 0; which < kProbeCount; ++which) {
        {
            gl::Pass pass({.label = kProbes[which].name,
                           .target = &*target,
                           .state = {.depth_test = gl::DepthTest::Off},
                           .clear_colors = {glm::vec4(-7.0f), glm::vec4(-7.0f)}});
            program->set("which", which);
            pass.bind_texture(*program, "inputs_a", 0, a);
            pass.bind_texture(*program, "inputs_b", 1, b);
            pass.draw(*program, triangle, {.count = 3});
        }
        EXPECT_TRUE(
            canary_is_alive(which, target->read_color(1, {0, 0}, {kInputSide, kInputSide})));
        const float worst =
            worst_error(which, target->read_color(0, {0, 0}, {kInputSide, kInputSide}));
        EXPECT_LE(worst, kProbes[which].gpu_tolerance) << kProbes[which].name;
        RecordProperty(kProbes[which].name, std::to_string(worst));
    }
}

}  // namespace
}  // namespace patina
