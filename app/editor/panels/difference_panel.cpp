// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "editor/panels/panels.h"
#include "editor/widgets/heat.h"
#include "editor/widgets/number_text.h"

namespace patina::editor {
namespace {

/// Roots of the shares: a few bright pixels are to be seen beside many equal ones.
void draw_bars(const Ui& ui, const Rect& rect, const std::vector<float>& shares) {
    const float most = *std::max_element(shares.begin(), shares.end());
    if (most <= 0.0f) return;
    const float step = rect.width() / static_cast<float>(shares.size());
    for (std::size_t i = 0; i < shares.size(); ++i) {
        if (shares[i] <= 0.0f) continue;
        const float height = std::max(std::sqrt(shares[i] / most) * rect.height(), ui.px(1));
        const float x = rect.x0 + static_cast<float>(i) * step;
        fill(ui, {std::floor(x), rect.y1 - height, std::floor(x + step), rect.y1},
             theme::kTrackFull);
    }
}

void draw_ticks(const Ui& ui, const Rect& rect, float range) {
    constexpr int kQuarters = 4;
    const int step = rect.width() > ui.px(400) ? 1 : 2;
    for (int i = 0; i <= kQuarters; i += step) {
        const double value = static_cast<double>(range) * i / kQuarters;
        const float x = rect.x0 + rect.width() * static_cast<float>(i) / kQuarters;
        const Rect around{x - ui.px(60), rect.y0, x + ui.px(60), rect.y1};
        if (i == 0)
            text(ui, rect, ui.fonts.caption11, theme::kText2, number_text(value));
        else if (i == kQuarters)
            text(ui, rect, ui.fonts.caption11, theme::kText2, number_text(value) + " and above",
                 Align::Right);
        else
            text(ui, around, ui.fonts.caption11, theme::kText2, number_text(value), Align::Center);
    }
}

}  // namespace

void draw_difference_plot(Ui& ui, const Rect& rect, const render::DifferenceStats& stats,
                          float range) {
    Rect rest = rect;
    draw_ticks(ui, rest.cut_bottom(ui.px(16)), range);
    rest.cut_bottom(ui.px(2));
    const Rect heat = rest.cut_bottom(ui.px(10));
    fill(ui, rest, theme::kBase);
    for (int i = 1; i < 4; ++i) {
        const float x = std::floor(rest.x0 + rest.width() * static_cast<float>(i) / 4.0f);
        fill(ui, {x, rest.y0, x + ui.px(1), rest.y1}, theme::kTableLine);
    }
    draw_bars(ui, rest, stats.shares);
    heat_bar(ui, heat);
}

Requests draw_difference_panel(Ui& ui, const Rect& rect, const Shown& shown, ViewState& view) {
    if (rect.empty()) return {};
    const Place place(ui, "Difference");
    fill(ui, rect, theme::kPanel, 6, ImDrawFlags_RoundCornersBottom);
    if (!shown.comparison) return {};
    const render::DifferenceStats& stats = shown.comparison->difference;
    Rect rest = rect.inset(ui.px(12), ui.px(6));
    Rect title = rest.cut_top(ui.px(24));
    const std::array<std::pair<std::string_view, float>, 3> figures = {
        {{"largest", stats.largest}, {"95 % below", stats.below_95}, {"mean", stats.mean}}};
    for (const auto& [name, value] : figures) {
        const std::string words =
            fmt::format("{} {}", name, number_text(static_cast<double>(value), {.decimals = 3}));
        const Rect box = title.cut_right(std::ceil(text_width(ui.fonts.value12, words)) + 1);
        text(ui, box, ui.fonts.value12, theme::kText2, words);
        note(ui, box, {.label = name, .kind = "figure", .value = words});
        title.cut_right(ui.px(16));
    }
    title.x0 = text(ui, title, ui.fonts.title13, theme::kText, "Difference in linear luminance");
    title.cut_left(ui.px(8));
    text(ui, title, ui.fonts.value12, theme::kText3, "share of the model\u2019s pixels");
    rest.cut_top(ui.px(2));
    draw_difference_plot(ui, rest, stats, view.view.difference_range);
    return {};
}

}  // namespace patina::editor
