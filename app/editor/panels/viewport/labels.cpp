// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "document/edits.h"
#include "editor/panels/viewport/parts.h"
#include "editor/widgets/buttons.h"
#include "editor/widgets/number_text.h"

namespace patina::editor {
namespace {

std::string_view shading_note(const render::Shading& shading) {
    if (shading.path == render::RenderPath::Forward) return "forward path";
    if (shading.model != render::ShadingModel::Pbr)
        return shading.phong == render::PhongSettings{} ? "exponent from roughness"
                                                        : "own settings";
    if (shading.terms == render::kLectureTerms) return "lecture terms";
    return shading.terms == render::PbrTerms{} ? "glTF 2.0, GGX" : "chosen terms";
}

struct Chip {
    std::string_view title;
    std::string_view note;
    std::string first;
    std::string second;
};

/// A dark plate with two lines at the top; `x` is its left edge, or its right one with
/// Align::Right.
void draw_chip(Ui& ui, float x, float y, const Chip& chip, Align align) {
    const float title = text_width(ui.fonts.title13, chip.title);
    const float extra = chip.note.empty() ? 0 : text_width(ui.fonts.body13, chip.note) + ui.px(5);
    const float first = text_width(ui.fonts.value12, chip.first);
    const float second =
        chip.second.empty() ? 0 : text_width(ui.fonts.value12, chip.second) + ui.px(12);
    const float width = std::ceil(std::max(title + extra, first + second)) + ui.px(20);
    const float left = align == Align::Right ? x - width : x;
    const Rect box{left, y, left + width, y + ui.px(46)};
    fill(ui, box, theme::kOverlay, 4);
    note(ui, box,
         {.label = chip.title,
          .kind = "label",
          .value = chip.second.empty() ? chip.first : chip.first + ", " + chip.second});
    Rect lines = box.inset(ui.px(10), ui.px(6));
    Rect top = lines.cut_top(ui.px(16));
    Rect bottom = {lines.x0, lines.y0 + ui.px(2), lines.x1, lines.y0 + ui.px(18)};
    if (align == Align::Right) {
        top.x0 = top.x1 - std::ceil(title + extra);
        bottom.x0 = bottom.x1 - std::ceil(first + second);
    }
    text(ui, top.cut_left(std::ceil(title) + 1), ui.fonts.title13, theme::kText, chip.title);
    top.cut_left(ui.px(4));
    text(ui, {top.x0, top.y0, top.x1 + 2, top.y1}, ui.fonts.body13, theme::kText2, chip.note);
    text(ui, bottom.cut_left(std::ceil(first) + 1), ui.fonts.value12, theme::kText2, chip.first);
    text(ui, {bottom.x0, bottom.y0, bottom.x1 + 2, bottom.y1}, ui.fonts.value12, theme::kText2,
         chip.second, Align::Right);
}

Chip shading_chip(const render::Shading& shading, const render::SideCost& cost, bool with_note) {
    return {.title = label_of(shading),
            .note = with_note ? shading_note(shading) : std::string_view(),
            .first = number_text(cost.frame_ms, {.unit = "ms"}),
            .second = megabytes(cost.bytes(), 1)};
}

Chip difference_chip(const render::View& view) {
    return {.title = "Difference",
            .note = {},
            .first = fmt::format("|{} \u2212 {}| in luminance", label_of(view.left),
                                 label_of(view.right)),
            .second = {}};
}

}  // namespace

void draw_labels(Ui& ui, const Rect& rect, const Shown& shown, const render::View& view) {
    const float y = rect.y0 + ui.px(8);
    const float gap = ui.px(8);
    const render::FrameStats& stats = shown.cost.frame;
    const render::SideCost right = stats.right.value_or(render::SideCost{});
    if (view.channel != render::ChannelView::Final) {
        const render::ChannelViewInfo& row = info(view.channel);
        draw_chip(ui, rect.x0 + gap, y,
                  {.title = row.label,
                   .note = {},
                   .first = std::string(row.target),
                   .second = std::string(row.unit)},
                  Align::Left);
        return;
    }
    const bool roomy = rect.width() / ui.scale > 900;
    switch (view.compare) {
        case render::CompareMode::Single:
            draw_chip(ui, rect.x0 + gap, y, shading_chip(view.left, stats.left, true), Align::Left);
            return;
        case render::CompareMode::Split: {
            const float x = rect.x0 + view.divider * rect.width();
            draw_chip(ui, x - ui.px(12), y, shading_chip(view.left, stats.left, roomy),
                      Align::Right);
            draw_chip(ui, x + ui.px(12), y, shading_chip(view.right, right, roomy), Align::Left);
            return;
        }
        case render::CompareMode::TwoViews: {
            const float step = rect.width() / static_cast<float>(view_columns(view));
            const bool notes = step / ui.scale > 240;
            draw_chip(ui, rect.x0 + gap, y, shading_chip(view.left, stats.left, notes),
                      Align::Left);
            draw_chip(ui, rect.x0 + step + gap, y, shading_chip(view.right, right, notes),
                      Align::Left);
            if (render::shows_difference_beside(view))
                draw_chip(ui, rect.x0 + 2 * step + gap, y, difference_chip(view), Align::Left);
            return;
        }
        case render::CompareMode::Difference:
            draw_chip(ui, rect.x0 + gap, y, difference_chip(view), Align::Left);
            return;
    }
}

/// Says that something else than the whole material is on screen, and ends it.
void draw_part_note(Ui& ui, const Rect& rect, const Shown& shown, ViewState& state) {
    const bool mask = state.viewed_mask.value != 0;
    const LayerId id = mask ? state.viewed_mask : state.solo;
    if (id.value == 0 || !shown.material) return;
    const LayerPtr layer = find_layer(*shown.material, id);
    if (!layer) return;
    const std::string words = mask ? "Mask of " + layer->name : layer->name + " alone";
    const float most = std::min(rect.width() * 0.4f, ui.px(320));
    const float width =
        std::min(std::ceil(text_width(ui.fonts.medium13, words)) + 1, most) + ui.px(50);
    const float x = std::floor(rect.center_x() - 0.5f * width);
    const float y = rect.y1 - ui.px(44);
    Rect box{x, y, x + width, y + ui.px(32)};
    fill(ui, box, theme::kOverlay, 6);
    outline(ui, box, theme::kAccent, 6, 1);
    note(ui, box, {.label = words, .kind = "label"});
    const bool closed = icon_button(
        ui, box.cut_right(ui.px(32)),
        {.icon = icon::kClose, .label = "Show the whole material", .key = "Esc", .size = 13});
    box.cut_left(ui.px(12));
    text(ui, box, ui.fonts.medium13, theme::kText, words);
    if (closed) state.solo = state.viewed_mask = {};
}

}  // namespace patina::editor
