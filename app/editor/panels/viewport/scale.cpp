// SPDX-License-Identifier: MIT
#include <array>
#include <optional>

#include "editor/panels/viewport/parts.h"
#include "editor/widgets/heat.h"
#include "editor/widgets/number_text.h"

namespace patina::editor {
namespace {

struct Scale {
    std::string_view title;
    std::array<std::string, 3> ticks;
    bool heat = false;
};

std::optional<Scale> scale_of(const render::View& view) {
    if (view.channel == render::ChannelView::Final) {
        if (view.compare != render::CompareMode::Difference) return std::nullopt;
        const auto top = static_cast<double>(view.difference_range);
        return Scale{.title = "Difference in linear luminance",
                     .ticks = {"0.00", number_text(0.5 * top), number_text(top) + " and above"},
                     .heat = true};
    }
    const render::ChannelViewInfo& row = info(view.channel);
    if (row.display != render::ChannelDisplay::Scalar) return std::nullopt;
    return Scale{.title = row.label, .ticks = {"0.0", "0.5", "1.0"}};
}

}  // namespace

void draw_scale(Ui& ui, const Rect& rect, const render::View& view) {
    const std::optional<Scale> shown = scale_of(view);
    if (!shown) return;
    const Scale& scale = *shown;
    const float width = scale.heat ? 236.0f : 180.0f;
    const Rect box{rect.x1 - ui.px(8 + width), rect.y1 - ui.px(8 + 60), rect.x1 - ui.px(8),
                   rect.y1 - ui.px(8)};
    fill(ui, box, theme::kOverlay, 4);
    Rect inner = box.inset(ui.px(10), ui.px(8));
    text(ui, inner.cut_top(ui.px(14)), ui.fonts.caption11, theme::kText2, scale.title);
    inner.cut_top(ui.px(4));
    const Rect bar = inner.cut_top(ui.px(10));
    if (scale.heat) {
        heat_bar(ui, bar);
    } else {
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddRectFilledMultiColor(ImVec2(bar.x0, bar.y0), ImVec2(bar.x1, bar.y1), IM_COL32_BLACK,
                                     IM_COL32_WHITE, IM_COL32_WHITE, IM_COL32_BLACK);
    }
    inner.cut_top(ui.px(3));
    const Rect ticks = inner.cut_top(ui.px(14));
    text(ui, ticks, ui.fonts.caption11, theme::kText, scale.ticks[0]);
    text(ui, ticks, ui.fonts.caption11, theme::kText, scale.ticks[1], Align::Center);
    text(ui, ticks, ui.fonts.caption11, theme::kText, scale.ticks[2], Align::Right);
}

}  // namespace patina::editor
