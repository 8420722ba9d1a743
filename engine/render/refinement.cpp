// SPDX-License-Identifier: MIT

/// The picture that gets better while nothing moves.

#include <algorithm>
#include <cassert>

#include "render/accumulation.h"
#include "render/renderer.h"
#include "render/wires.h"

namespace patina::render {
namespace {

/// Draws that read the environment filtered. They make edges smooth at once, and they weigh against
/// the noise of those that sample it: after n of these it is that of one, times sqrt(n) / (16 + n),
/// at most 1 / 8 and falling from n = 16 on. In the mean of 256 a sixteenth of what the filtered
/// light is wrong by is left.
constexpr int kFilteredDraws = 16;

/// The mean of fewer draws has rougher edges than the fast anti-aliasing of a single one.
constexpr int kLeastShownDraws = 8;

/// Beyond these draws one more is hardly seen: only every eighth mean is shown.
constexpr int kDrawsShownOneByOne = 32;
constexpr int kShownEvery = 8;

bool is_shown(const Refinement& refinement) {
    const int drawn = refinement.drawn;
    if (refinement.is_finished()) return true;
    if (drawn < kLeastShownDraws) return false;
    return drawn <= kDrawsShownOneByOne || drawn % kShownEvery == 0;
}

/// Edges of 64 steps are as fine as 8 bits show of most.
constexpr int kDrawsForEdges = 64;

AddedDraw added_draw(const Refinement& refinement) {
    AddedDraw draw{.index = refinement.drawn};
    if (shows_pbr(refinement.view) && draw.index >= kFilteredDraws)
        draw.still = StillDraw{draw.index - kFilteredDraws, refinement.draws - kFilteredDraws};
    return draw;
}

Status show_mean(RendererState& state, const Refinement& refinement, const gl::Framebuffer& sum) {
    const glm::ivec2 size(refinement.size.width, refinement.size.height);
    const Result<gl::Framebuffer*> picture = state.refined.at(size);
    if (!picture) return passed_on(picture);
    if (Status drawn = draw_averaged(state, refinement.view, size, sum, refinement.drawn,
                                     {.framebuffer = *picture, .output = OutputMode::Srgb});
        !drawn)
        return drawn;
    state.shown = &state.refined;
    return refinement.view.wires ? draw_wires(state, refinement.view, **picture) : Status{};
}

}  // namespace

int refining_draws(const View& view, int most) {
    const bool exact = view.channel != ChannelView::Final ||
                       view.compare == CompareMode::Difference || shows_difference_beside(view);
    if (exact) return 0;
    return shows_pbr(view) ? most : std::min(most, kDrawsForEdges);
}

Status Renderer::refine(Refinement& refinement) {
    if (Status ready = require_content(*state_); !ready) return ready;
    assert(refining_draws(refinement.view, refinement.draws) == refinement.draws);
    const PassTimers::Pause not_measured(state_->timers);
    const Result<gl::Framebuffer*> sum =
        sum_for(state_->refinement, refinement.size, refinement.drawn);
    if (!sum) return passed_on(sum);
    const View drawn_view = state_->drawn_view;
    const Status added =
        add_radiance(*state_, refinement.view, refinement.size, **sum, added_draw(refinement));
    state_->drawn_view = drawn_view;
    if (!added) return added;
    ++refinement.drawn;
    if (!is_shown(refinement)) return {};
    return show_mean(*state_, refinement, **sum);
}

}  // namespace patina::render
