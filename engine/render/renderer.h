// SPDX-License-Identifier: MIT
#pragma once

/// The deferred renderer. What lives in this folder: values that describe a view, the surfaces and
/// the light (view.h, surface.h, environment.h), and this, which draws them. The one idea: all that
/// can be seen of a surface is written to the G-buffer once, and every shading model, channel view
/// and comparison reads it from there. May include core, scene, document, composite and gl.
///
/// A Renderer belongs to the OpenGL context that is current when it is made, and to its thread:
/// every function, and the destructor, needs that context current.

#include <array>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "render/environment.h"
#include "render/surface.h"
#include "render/view.h"
#include "scene/scene.h"

namespace patina::render {

/// What one pass took, by a timer query of the GPU.
struct PassCost {
    std::string_view name;  ///< "G-buffer", "Lighting", "Post" ...
    double gpu_ms = 0.0;
};

/// What one side of a comparison costs (a single view has only the left one).
struct SideCost {
    std::vector<PassCost> passes;
    double frame_ms = 0.0;  ///< the sum of `passes`
    std::size_t gbuffer_bytes = 0;
    std::size_t environment_bytes = 0;  ///< what of it this shading model reads
    std::size_t bytes() const { return gbuffer_bytes + environment_bytes; }
};

struct FrameStats {
    SideCost left;
    std::optional<SideCost> right;
    std::size_t material_texture_bytes = 0;
    std::size_t triangles = 0;
};

/// What the G-buffer and the inspection pass hold at one pixel.
struct Probe {
    int instance = -1;   ///< index into Scene::instances
    int primitive = -1;  ///< index into Mesh::primitives
    int source_material = -1;
    glm::vec2 uv = glm::vec2(0.0f);  ///< TEXCOORD_0, as in the file
    /// By ChannelView, as many numbers as ChannelViewInfo::components; in its unit, colours linear,
    /// light as radiance before exposure.
    std::array<glm::vec3, kChannelViewCount> values = {};
    const glm::vec3& operator[](ChannelView view) const {
        return values[static_cast<std::size_t>(view)];
    }
};

/// The radiance that both shadings of a view give a pixel, linear, before exposure.
struct SideValues {
    glm::vec3 left = glm::vec3(0.0f);
    glm::vec3 right = glm::vec3(0.0f);
};

/// What a pixel belongs to.
struct Pick {
    int instance = -1;
    int primitive = -1;
    int source_material = -1;
};

/// Where a G-buffer or picture pixel is: x from the left, y from the top.
struct Pixel {
    int x = 0;
    int y = 0;
    bool operator==(const Pixel&) const = default;
};

struct PictureSize {
    int width = 0;
    int height = 0;
    bool operator==(const PictureSize&) const = default;
};
inline constexpr int kMaxPictureSide = 16384;

/// A still that is made a draw at a time, so that a window stays alive meanwhile.
struct Still {
    View view;
    PictureSize size;
    int samples = 1;
    bool linear = false;  ///< radiance, or raw values of a channel, in place of display light
    int drawn = 0;
    bool is_finished() const { return drawn >= samples; }
};

/// A picture that gets better a draw at a time while nothing moves.
struct Refinement {
    View view;
    PictureSize size;
    int draws = 256;  ///< when it is finished
    int drawn = 0;
    bool is_finished() const { return drawn >= draws; }
};
/// How many of at most `most` draws make the view better: none for channels and differences, which
/// hold exact numbers, and as many as smooth edges need where no draw samples the environment.
int refining_draws(const View& view, int most);

/// What the draws of a still came to, display light or radiance, bottom row first.
struct StillMean {
    PictureSize size;
    std::vector<float> rgba_premultiplied;
    bool dithered = false;  ///< to be, when it is rounded
};
/// RGBA, U8 or U16, sRGB-encoded, straight alpha, row 0 at the top. Any thread.
Image srgb_image(const StillMean& still, SampleType type = SampleType::U8);
/// RGBA, F32, premultiplied, as it was drawn; row 0 at the top. Any thread.
Image linear_image(const StillMean& still);

struct RendererState;  // renderer_state.h

class Renderer {
  public:
    /// Compiles the programs (shaders are found by resource_folder). Needs OpenGL 4.1 core.
    static Result<Renderer> create();
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    /// Uploads the meshes of a scene and forgets the one before. Materials are kept.
    Status set_scene(const ScenePtr& scene);
    /// Draws these parts of the scene as if they had that source_material, and all others with
    /// their own; until the next set_scene.
    void assign_materials(const std::map<PartRef, int>& source_materials);

    /// How primitives with this Primitive::source_material look from now on. Only what differs from
    /// the surface set before is uploaded; mips are made on the CPU.
    /// @param changed  when the baked maps are the ones set before but for these texels: the only
    ///                 ones that are uploaded of maps whose size is unchanged
    Status set_material(int source_material, const SurfaceMaterial& surface,
                        const std::optional<TexelRect>& changed = std::nullopt);
    /// Forgets all materials; primitives without one are drawn with plain_surface().
    void clear_materials();

    /// Uploads the light of all views and forgets the one before.
    Status set_environment(const FilteredEnvironment& environment);

    /// Draws a view at `size`; the picture stays in a texture of the renderer until the next draw.
    /// Needs a scene and an environment, as all that draws. Sides are 1 to kMaxPictureSide. Costs
    /// are those of the last frame whose queries have ended.
    Result<FrameStats> draw(const View& view, PictureSize size);
    /// The costs of the last frame drawn, of stills too.
    FrameStats stats() const;
    /// The name of that texture for Dear ImGui (ImTextureID), sRGB-encoded RGBA8, row 0 at the
    /// bottom as OpenGL has it. Valid until the next draw of another size.
    std::uintptr_t picture_texture() const;

    /// One more draw, with its own sub-pixel offset, and their mean in radiance becomes the picture
    /// that picture_texture() and read_picture() give, until the next draw(). The first draws read
    /// the environment filtered, and with `draws` beyond those the others sample it, so that the
    /// picture converges to the integral of the BRDF over it; its noise is never more than that of
    /// a still of 64 samples. The mean of the first few is not shown: they are less smooth than
    /// what draw() makes. Pictures, strips, stills and probes may be drawn in between; other
    /// refinements may not, and scene, materials and light must stay as they are. Costs are not
    /// measured.
    Status refine(Refinement& refinement);

    /// Draws the kStripChannelCount channels of `view` (left shading) into one picture, each
    /// `thumbnail` large, beside each other from the left; one G-buffer serves them all.
    Status draw_strip(const View& view, PictureSize thumbnail);
    /// As picture_texture(): kStripChannelCount * thumbnail wide.
    std::uintptr_t strip_texture() const;

    /// Draws `samples` times with sub-pixel offsets and averages: a still without jagged edges.
    /// From 64 samples on each draw samples the environment where a side on screen is PBR, and the
    /// picture converges to the integral of the BRDF over it. It is read filtered with fewer, with
    /// the difference beside, and here by all channels but the final picture.
    /// RGBA, U8 or U16, sRGB-encoded, straight alpha, row 0 at the top.
    Result<Image> still_srgb(const View& view, PictureSize size, int samples,
                             SampleType type = SampleType::U8);
    /// The same as linear radiance without exposure and tone map, or the raw numbers of a channel:
    /// RGBA F32, premultiplied, alpha is coverage.
    Result<Image> still_linear(const View& view, PictureSize size, int samples);

    /// Lays the edges of the triangles, as the view shows them, over a still of it, which has to be
    /// sRGB-encoded.
    Status lay_wires(const View& view, Image& still);

    /// The same in steps: one more draw with its own sub-pixel offset, and what the draws so far
    /// come to. Pictures may be drawn in between, other stills may not.
    Status draw_sample(Still& still);
    Result<StillMean> mean(const Still& still);

    /// The picture of the last draw: RGBA U8, sRGB-encoded, row 0 at the top.
    Result<Image> read_picture();

    /// What the view shows at a pixel of the picture of the last draw; nothing where no surface is.
    Result<std::optional<Probe>> probe(Pixel pixel);
    /// What that pixel belongs to; nothing where no surface is or nothing can be drawn.
    std::optional<Pick> pick(Pixel pixel);
    /// What both shadings give the surface at that pixel, whatever the view compares and whichever
    /// channel it shows; nothing where no surface is.
    Result<std::optional<SideValues>> probe_sides(Pixel pixel);
    /// |luminance left - luminance right|, exposed, of each pixel that the model covers in a
    /// picture of `size`, in no particular order.
    Result<std::vector<float>> differences(const View& view, PictureSize size);

    /// Bounds of what is drawn, in the world.
    const Bounds& bounds_world() const;
    /// How fine a picture so high shows a material: see texels_seen of gpu_scene.h.
    float texels_seen(int source_material, int uv_set, const Camera& camera,
                      int picture_height) const;

  private:
    explicit Renderer(std::unique_ptr<RendererState> state);
    Result<StillMean> finished_still(Still still);
    std::unique_ptr<RendererState> state_;
};

}  // namespace patina::render
