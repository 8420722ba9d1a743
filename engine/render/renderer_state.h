// SPDX-License-Identifier: MIT
#pragma once

/// What a Renderer owns. Inside engine/render only; geometry_passes.h and picture_passes.h are the
/// steps, frame.h puts them together.

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/sampler.h"
#include "render/environment_samples.h"
#include "render/gpu_environment.h"
#include "render/gpu_materials.h"
#include "render/gpu_scene.h"
#include "render/light_block.h"
#include "render/pass_timers.h"
#include "render/renderer.h"
#include "render/shader_variants.h"
#include "render/shadow_maps.h"

namespace patina::render {

/// A framebuffer made when it is first needed and made anew for another size.
class SizedTarget {
  public:
    explicit SizedTarget(gl::FramebufferDescription description)
        : description_(std::move(description)) {}
    Result<gl::Framebuffer*> at(glm::ivec2 size);
    /// Null before the first use.
    const gl::Framebuffer* get() const { return framebuffer_ ? &*framebuffer_ : nullptr; }
    std::size_t bytes() const { return framebuffer_ ? framebuffer_->bytes() : 0; }

  private:
    gl::FramebufferDescription description_;
    std::optional<gl::Framebuffer> framebuffer_;
};

/// What base colour, metalness and F90 are kept in.
enum class GBufferPrecision {
    Bytes,  ///< for frames: half the traffic of their target
    Halves  ///< for means of many draws: rounding to bytes would be 0.7 % of a colour in each of
            ///< them
};

/// The G-buffer in its two layouts: positions are rebuilt from the depth, and `surface` is there
/// only when a material is unlit or has a specular factor.
struct GBufferTargets {
    GBufferTargets(const std::string& label, GBufferPrecision precision);
    SizedTarget plain;
    SizedTarget with_surface;
    std::size_t bytes() const { return plain.bytes() + with_surface.bytes(); }
};

struct RendererState {
    RendererState(std::filesystem::path shader_folder, GpuGroundShadow made_shadow);

    ShaderVariants shaders;
    gl::VertexArray full_screen;
    gl::Sampler linear;
    PassTimers timers;

    GpuMaterials materials;
    std::vector<std::pair<PbrTerms, EnvironmentTables>> environment_tables;  ///< of all terms seen
    std::optional<GpuEnvironment> environment;
    std::optional<SampledEnvironment> sampled_environment;  ///< made for the first still
    std::optional<GpuScene> scene;
    GpuGroundShadow shadow;
    ShadowMaps shadow_maps;
    LightBlock lights;

    GBufferTargets gbuffer;
    GBufferTargets still_gbuffer;  ///< of draws that are added up, and of probes
    GBufferTargets strip_gbuffer;
    SizedTarget inspection;
    SizedTarget radiance;  ///< blended surfaces over the deferred light
    SizedTarget left;      ///< the two sides of a difference
    SizedTarget right;
    SizedTarget picture;
    SizedTarget smoothed;
    SizedTarget wires;
    SizedTarget strip;
    SizedTarget accumulation;
    SizedTarget accumulation_right;  ///< of the right side of a sampled difference
    SizedTarget still;               ///< a sampled still, averaged and in display light
    SizedTarget refinement;          ///< radiance, summed
    SizedTarget refined;
    SizedTarget probe_values;  ///< one texel a channel

    View drawn_view;  ///< of the last frame, a sample of a still too
    View last_view;   ///< of the last draw
    PictureSize last_size;
    const SizedTarget* shown = nullptr;  ///< which target holds the picture
};

/// How the environment is mirrored and scattered with these terms; made where that has not been
/// done. Valid until others are made.
Result<const EnvironmentTables*> environment_tables(RendererState& state, const PbrTerms& terms);

/// A failure that says so while no scene or no environment has been set.
Status require_content(const RendererState& state);

}  // namespace patina::render
