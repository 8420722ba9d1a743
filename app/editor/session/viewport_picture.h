// SPDX-License-Identifier: MIT
#pragma once

/// The picture of the viewport and the strip of channels: drawn when the view, the scene or the
/// light has changed, and not otherwise.

#include <optional>

#include "core/result.h"
#include "editor/session/live_materials.h"
#include "editor/state/shown.h"
#include "render/difference_stats.h"
#include "render/renderer.h"

namespace patina::editor {

class ViewportPicture {
  public:
    static Result<ViewportPicture> create();

    void set_scene(const ScenePtr& scene);
    void set_materials(const std::vector<LiveMaterials::Changed>& changed);
    void set_environment(const render::FilteredEnvironment& environment);

    /// Parts that are drawn as if they had these numbers (Primitive::source_material).
    void assign_materials(std::map<PartRef, int> numbers);
    /// Draws what is out of date. While `moving` a slow picture is drawn at half its size and the
    /// strip is left for later. True when something was drawn.
    bool draw(const render::View& view, render::PictureSize size, render::PictureSize card,
              bool moving);
    /// What draw() would still have to do if nothing moved.
    bool out_of_date() const { return !sharp_ || !strip_drawn_; }

    /// Says how many draws the picture shall be the mean of, 0 for the one of draw(): what refine()
    /// works towards from now on.
    void set_refining_draws(int draws);
    /// One more draw, where there is something left to refine.
    void refine();
    /// How far that is, of what is drawn now: 0 of 0 where nothing is refined.
    RefinementShown refinement() const;

    const render::FrameStats& stats() const { return stats_; }
    double frame_ms() const { return frame_ms_; }
    int pictures_drawn() const { return pictures_drawn_; }
    const Bounds& bounds() const { return renderer_.bounds_world(); }
    /// See Renderer::texels_seen.
    float texels_seen(int source_material, int uv_set, const render::Camera& camera,
                      int picture_height) const {
        return renderer_.texels_seen(source_material, uv_set, camera, picture_height);
    }
    std::uintptr_t texture() const { return drawn_ ? renderer_.picture_texture() : 0; }
    std::uintptr_t strip_texture() const {
        return strip_drawn_once_ ? renderer_.strip_texture() : 0;
    }

    /// At a point in shares of the picture.
    std::optional<render::Probe> probe(glm::vec2 at);
    std::optional<render::Pick> pick(glm::vec2 at);
    /// The light that both shadings give a point, before exposure.
    std::optional<render::SideValues> sides(glm::vec2 at);
    /// How far both shadings are apart, as of the last picture, at half of its size. Made anew
    /// when another picture has been drawn or another range is asked for.
    const render::DifferenceStats& difference();
    render::Pixel pixel(glm::vec2 at) const;
    render::Renderer& renderer() { return renderer_; }

  private:
    explicit ViewportPicture(render::Renderer renderer) : renderer_(std::move(renderer)) {}

    render::Renderer renderer_;
    std::map<PartRef, int> assigned_;
    std::optional<render::View> drawn_;
    std::optional<render::View> strip_view_;
    render::PictureSize drawn_size_;
    render::PictureSize strip_size_;
    bool scene_changed_ = true;
    bool strip_stale_ = true;
    bool sharp_ = false;  ///< drawn at full size
    bool strip_drawn_ = false;
    bool strip_drawn_once_ = false;
    int refining_draws_ = 0;
    std::optional<render::Refinement> refinement_;  ///< of what is drawn; unset: not begun
    bool unrefined_wanted_ = false;                 ///< a refined picture is on screen
    render::FrameStats stats_;
    double frame_ms_ = 0.0;
    int pictures_drawn_ = 0;
    render::DifferenceStats difference_;
    int difference_of_ = -1;  ///< pictures_drawn_ when it was made
};

}  // namespace patina::editor
