// SPDX-License-Identifier: MIT
#pragma once

/// The passes that draw meshes: G-buffer and inspection. Inside engine/render only.

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "render/renderer_state.h"

namespace patina::render {

/// The vertices of a mesh, for every program that draws surfaces.
inline constexpr std::string_view kSurfaceVertexFile = "passes/surface.vert";

/// The camera of a frame, ready for the shaders.
struct FrameCamera {
    glm::mat4 clip_from_world = glm::mat4(1.0f);
    glm::mat4 view_from_world = glm::mat4(1.0f);
    glm::vec3 position = glm::vec3(0.0f);  ///< in the world
    glm::vec3 forward = glm::vec3(0.0f);   ///< in the world, unit
    DepthRange range;
    glm::ivec2 size = glm::ivec2(0);
    float level_bias = 0.0f;  ///< of textures: below 0 for draws that are averaged
};
/// @param jitter_pixels  where in a pixel its sample lies, from its middle, -0.5 to 0.5
FrameCamera frame_camera(const View& view, const Bounds& bounds, glm::ivec2 size,
                         glm::vec2 jitter_pixels);

/// The pixels that a box can cover, of a picture that the camera sees it in.
gl::Viewport area_seen(const Bounds& bounds, const FrameCamera& camera);

enum class SurfaceSet { Opaque, Blended, All };
bool belongs(const GpuMaterial& material, SurfaceSet surfaces);
/// What casts shadows, in maps and on the floor. What blends stands for glass and smoke, which let
/// light through: no shadow is nearer to theirs than that of a solid.
inline constexpr SurfaceSet kShadowCasters = SurfaceSet::Opaque;

/// The programs of a pass that draws surfaces, with the inputs of surface.vert and material.glsl:
/// one for each set of textures that materials have.
class SurfacePrograms {
  public:
    /// @param variant  without TEXTURED_SLOTS
    /// @param reads    the slots whose textures the pass needs
    /// @param set_up   gives a program what is the same for all surfaces
    SurfacePrograms(ShaderVariants& shaders, ShaderVariant variant, SlotBits reads,
                    std::function<void(gl::Program&)> set_up)
        : shaders_(shaders),
          variant_(std::move(variant)),
          reads_(reads),
          set_up_(std::move(set_up)) {}
    /// Set up.
    Result<gl::Program*> program_for(const GpuMaterial& material);

  private:
    ShaderVariants& shaders_;
    ShaderVariant variant_;
    SlotBits reads_;
    std::function<void(gl::Program&)> set_up_;
    std::map<SlotBits, gl::Program*> ready_;
};

/// Draws the items of a set in that order.
Status draw_surfaces(const RendererState& state, gl::Pass& pass, SurfacePrograms& programs,
                     const gl::State& base, const std::vector<std::size_t>& order,
                     SurfaceSet surfaces);

/// Draws the blended items, everything behind something else before it: the items by their middles,
/// of each the faces that look away first, and these by their middles.
Status draw_blended_surfaces(RendererState& state, gl::Pass& pass, SurfacePrograms& programs,
                             const gl::State& base, const Camera& camera);

/// Whether a side's picture comes without the G-buffer. Channels are read from it on either path.
bool is_forward(const View& view, const Shading& shading);
/// Whether roughness takes in the normal map's variance. Channels show roughness as it is.
bool filters_normals(const View& view);
/// Which sides read the G-buffer; nothing where none does.
std::optional<FrameSide> gbuffer_readers(const View& view);

/// Draws the G-buffer, or only the pixel `only` of it.
Result<gl::Framebuffer*> draw_gbuffer(RendererState& state, GBufferTargets& targets,
                                      const View& view, const FrameCamera& camera,
                                      SurfaceSet surfaces,
                                      const std::optional<gl::Viewport>& only = std::nullopt);

/// What the inspection pass writes, as passes/inspection.frag numbers it.
enum class Inspected { Alpha, Tangent, GeometricNormal, Uv0, Uv1, Ids, UvChecker };
/// What it has to write for a channel; nothing for those that it does not serve.
std::optional<Inspected> inspected_for(ChannelView channel);
Result<gl::Framebuffer*> draw_inspection(RendererState& state, const View& view,
                                         const FrameCamera& camera, Inspected inspected,
                                         const std::optional<gl::Viewport>& only = std::nullopt);

}  // namespace patina::render
