// SPDX-License-Identifier: MIT
#include "editor/session/viewport_picture.h"

#include <algorithm>
#include <chrono>

#include "core/log.h"

namespace patina::editor {
namespace {

/// A frame that takes longer is drawn at half its size while something moves.
constexpr double kSlowFrameMs = 24.0;

constexpr int kDifferenceBins = 240;

void report(const Error& error) {
    log_warning("{}", error.message);
}

/// What the strip shows does not depend on the channel, the divider or the right shading.
render::View strip_view_of(const render::View& view) {
    render::View strip = view;
    strip.compare = render::CompareMode::Single;
    strip.channel = render::ChannelView::Final;
    strip.divider = 0.5f;
    strip.right = {};
    strip.difference_range = 1.0f;
    strip.wires = false;
    return strip;
}

}  // namespace

Result<ViewportPicture> ViewportPicture::create() {
    Result<render::Renderer> renderer = render::Renderer::create();
    if (!renderer) return passed_on(renderer);
    return ViewportPicture(std::move(*renderer));
}

void ViewportPicture::set_scene(const ScenePtr& scene) {
    renderer_.clear_materials();
    if (const Status set = renderer_.set_scene(scene); !set) report(set.error());
    assigned_.clear();
    scene_changed_ = true;
}

void ViewportPicture::assign_materials(std::map<PartRef, int> numbers) {
    if (numbers == assigned_) return;
    assigned_ = std::move(numbers);
    renderer_.assign_materials(assigned_);
    scene_changed_ = true;
}

void ViewportPicture::set_materials(const std::vector<LiveMaterials::Changed>& changed) {
    for (const LiveMaterials::Changed& each : changed) {
        const Status set = renderer_.set_material(each.source_material, each.surface, each.texels);
        if (!set) report(set.error());
        scene_changed_ = true;
    }
}

void ViewportPicture::set_environment(const render::FilteredEnvironment& environment) {
    if (const Status set = renderer_.set_environment(environment); !set) report(set.error());
    scene_changed_ = true;
}

bool ViewportPicture::draw(const render::View& view, render::PictureSize size,
                           render::PictureSize card, bool moving) {
    if (size.width < 1 || size.height < 1) return false;
    const bool half = moving && frame_ms_ > kSlowFrameMs;
    const render::PictureSize wanted =
        half ? render::PictureSize{std::max(size.width / 2, 1), std::max(size.height / 2, 1)}
             : size;
    bool drew = false;
    const bool stale = scene_changed_ || unrefined_wanted_ || !drawn_ || *drawn_ != view ||
                       (drawn_size_ != wanted && !(half && drawn_size_ == size));
    if (stale) {
        const auto begun = std::chrono::steady_clock::now();
        if (Result<render::FrameStats> stats = renderer_.draw(view, wanted))
            stats_ = std::move(*stats);
        else
            report(stats.error());
        const double spent =
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun)
                .count();
        // Half a picture says what a whole one would take.
        frame_ms_ = half ? std::max(spent, frame_ms_ * 0.97) : spent;
        strip_stale_ = strip_stale_ || scene_changed_;
        drawn_ = view;
        drawn_size_ = wanted;
        scene_changed_ = false;
        unrefined_wanted_ = false;
        refinement_.reset();
        ++pictures_drawn_;
        drew = true;
    }
    sharp_ = drawn_size_ == size;
    const render::View strip = strip_view_of(view);
    strip_drawn_ = card.width < 1 ||
                   (!strip_stale_ && strip_view_ && *strip_view_ == strip && strip_size_ == card);
    if (!strip_drawn_ && !moving) {
        if (const Status drawn = renderer_.draw_strip(strip, card); !drawn)
            report(drawn.error());
        else
            strip_drawn_once_ = true;
        strip_view_ = strip;
        strip_size_ = card;
        strip_stale_ = false;
        strip_drawn_ = true;
        drew = true;
    }
    return drew;
}

void ViewportPicture::set_refining_draws(int draws) {
    if (draws == refining_draws_) return;
    refining_draws_ = draws;
    // What is on screen is of more draws than wanted, or of some that another count has laid out.
    if (refinement_) unrefined_wanted_ = true;
    refinement_.reset();
}

void ViewportPicture::refine() {
    const RefinementShown now = refinement();
    if (out_of_date() || now.drawn >= now.draws) return;
    if (!refinement_)
        refinement_ = render::Refinement{.view = *drawn_, .size = drawn_size_, .draws = now.draws};
    if (const Status drawn = renderer_.refine(*refinement_); !drawn) {
        report(drawn.error());
        refinement_->drawn = refinement_->draws;  // given up until something changes
    }
}

RefinementShown ViewportPicture::refinement() const {
    if (!drawn_) return {};
    return {.drawn = refinement_ ? refinement_->drawn : 0,
            .draws = render::refining_draws(*drawn_, refining_draws_)};
}

render::Pixel ViewportPicture::pixel(glm::vec2 at) const {
    const auto along = [](float share, int count) {
        return std::clamp(static_cast<int>(share * static_cast<float>(count)), 0, count - 1);
    };
    return {along(at.x, std::max(drawn_size_.width, 1)),
            along(at.y, std::max(drawn_size_.height, 1))};
}

std::optional<render::Probe> ViewportPicture::probe(glm::vec2 at) {
    if (!drawn_) return std::nullopt;
    const Result<std::optional<render::Probe>> probe = renderer_.probe(pixel(at));
    if (probe) return *probe;
    report(probe.error());
    return std::nullopt;
}

std::optional<render::SideValues> ViewportPicture::sides(glm::vec2 at) {
    if (!drawn_) return std::nullopt;
    const Result<std::optional<render::SideValues>> values = renderer_.probe_sides(pixel(at));
    if (values) return *values;
    report(values.error());
    return std::nullopt;
}

const render::DifferenceStats& ViewportPicture::difference() {
    if (!drawn_ || difference_of_ == pictures_drawn_) return difference_;
    difference_of_ = pictures_drawn_;
    const render::PictureSize half{std::max(drawn_size_.width / 2, 1),
                                   std::max(drawn_size_.height / 2, 1)};
    const Result<std::vector<float>> pixels = renderer_.differences(*drawn_, half);
    if (!pixels) report(pixels.error());
    difference_ = render::difference_stats(pixels ? *pixels : std::vector<float>(),
                                           drawn_->difference_range, kDifferenceBins);
    return difference_;
}

std::optional<render::Pick> ViewportPicture::pick(glm::vec2 at) {
    if (!drawn_) return std::nullopt;
    return renderer_.pick(pixel(at));
}

}  // namespace patina::editor
