// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/formulae/formulae.h"
#include "editor/panels/choice_combo.h"
#include "editor/panels/panels.h"
#include "editor/panels/shading_fields.h"
#include "editor/widgets/buttons.h"
#include "editor/widgets/form.h"
#include "editor/widgets/number_text.h"
#include "editor/widgets/slider.h"

namespace patina::editor {
namespace {

struct TableRow {
    std::string name;
    std::string left;
    std::string right;
    bool total = false;
};

void draw_table(Ui& ui, Rect& rest, const render::View& view, const std::vector<TableRow>& rows) {
    const auto cells = [&](Rect row) {
        const Rect right = row.cut_right(ui.px(62));
        const Rect left = row.cut_right(ui.px(62));
        return std::array{row, left, right};
    };
    const Rect head = rest.cut_top(ui.px(24)).inset(ui.px(12), 0);
    const auto titles = cells(head);
    text(ui, titles[1], ui.fonts.caption11, theme::kText3, label_of(view.left), Align::Right);
    text(ui, titles[2], ui.fonts.caption11, theme::kText3, label_of(view.right), Align::Right);
    hairline(ui, {head.x0, head.y1 - ui.px(1), head.x1, head.y1}, theme::kTableLine);
    for (const TableRow& row : rows) {
        const Rect line_box = rest.cut_top(ui.px(22)).inset(ui.px(12), 0);
        const auto parts = cells(line_box);
        const ImFont* font = row.total ? ui.fonts.medium12 : ui.fonts.value12;
        if (row.total) hairline(ui, line_box, theme::kTableLine);
        text(ui, parts[0], font, row.total ? theme::kText : theme::kText2, row.name);
        text(ui, parts[1], font, theme::kText, row.left, Align::Right);
        text(ui, parts[2], font, theme::kText, row.right, Align::Right);
        ui.map.add(row.name, "figure", row.left + " " + row.right, visible_part(line_box), true);
    }
}

constexpr std::string_view kNoPass = "\u2013";

std::string pass_ms(const render::SideCost& cost, std::string_view name) {
    const auto found =
        std::find_if(cost.passes.begin(), cost.passes.end(),
                     [name](const render::PassCost& pass) { return pass.name == name; });
    return found == cost.passes.end() ? std::string(kNoPass) : number_text(found->gpu_ms);
}

std::vector<TableRow> cost_rows(const render::FrameStats& stats) {
    const render::SideCost& left = stats.left;
    const render::SideCost right = stats.right.value_or(render::SideCost{});
    std::vector<TableRow> rows;
    const auto add_row = [&](std::string_view pass) {
        rows.push_back(
            {std::string(pass) + ", ms", pass_ms(left, pass), pass_ms(right, pass), false});
    };
    for (const render::PassCost& pass : left.passes) add_row(pass.name);
    for (const render::PassCost& pass : right.passes)
        if (pass_ms(left, pass.name) == kNoPass) add_row(pass.name);
    rows.push_back({"Frame, ms", number_text(left.frame_ms), number_text(right.frame_ms), true});
    const auto mb = [](std::size_t bytes) {
        return number_text(static_cast<double>(bytes) / 1e6, {.decimals = 1});
    };
    rows.push_back({"G-buffer, MB", mb(left.gbuffer_bytes), mb(right.gbuffer_bytes)});
    rows.push_back({"Environment, MB", mb(left.environment_bytes), mb(right.environment_bytes)});
    // Both sides read those of the materials.
    const std::size_t textures = stats.material_texture_bytes;
    rows.push_back({"Textures, MB", mb(textures), mb(textures)});
    rows.push_back({"Memory, MB", mb(left.bytes() + textures), mb(right.bytes() + textures), true});
    return rows;
}

bool unfold(Ui& ui, Rect& rest, std::string_view title, bool& open) {
    rest.cut_top(ui.px(6));
    const Rect head = rest.cut_top(ui.px(theme::kPanelTitle));
    hairline(ui, head);
    if (section(ui, head, {.title = title, .open = open})) open = !open;
    return open;
}

std::vector<TableRow> value_rows(const render::SideValues& values) {
    const auto cell = [](float value) {
        return number_text(static_cast<double>(value), {.decimals = 3});
    };
    const auto luminance = [&](const glm::vec3& color) {
        return cell(formulae::luminance(formulae::Real3(color.x, color.y, color.z)));
    };
    const glm::vec3& left = values.left;
    const glm::vec3& right = values.right;
    return {{"Red", cell(left.x), cell(right.x)},
            {"Green", cell(left.y), cell(right.y)},
            {"Blue", cell(left.z), cell(right.z)},
            {"Luminance", luminance(left), luminance(right), true}};
}

/// The values under the crosshair, and the histogram where it has no panel of its own.
void draw_comparison(Ui& ui, Rect& rest, const ComparisonShown& comparison, ViewState& state) {
    if (unfold(ui, rest, "Under the crosshair", state.unfolded.crosshair)) {
        if (comparison.values)
            draw_table(ui, rest, state.view, value_rows(*comparison.values));
        else
            text(ui, rest.cut_top(ui.px(24)).inset(ui.px(12), 0), ui.fonts.body13, theme::kText3,
                 "Click the model to compare a point");
    }
    if (render::shows_difference_beside(state.view)) return;
    if (!unfold(ui, rest, "Difference", state.unfolded.difference)) return;
    const render::DifferenceStats& stats = comparison.difference;
    draw_difference_plot(ui, rest.cut_top(ui.px(104)).inset(ui.px(12), 0), stats,
                         state.view.difference_range);
    rest.cut_top(ui.px(4));
    const auto figure = [&](std::string_view name, float value) {
        const Rect row = rest.cut_top(ui.px(22)).inset(ui.px(12), 0);
        const std::string words = number_text(static_cast<double>(value), {.decimals = 3});
        text(ui, row, ui.fonts.value12, theme::kText2, name);
        text(ui, row, ui.fonts.value12, theme::kText, words, Align::Right);
        ui.map.add(name, "figure", words, visible_part(row), true);
    };
    figure("Mean", stats.mean);
    figure("95 % below", stats.below_95);
    figure("Largest", stats.largest);
}

/// How a side is shaded, and by which passes.
void choose_side(Ui& ui, Rect line_box, const ComboSpec& spec, render::Shading& shading) {
    const std::string path_label = fmt::format("{} path", spec.label);
    const Rect path_box = line_box.cut_right(ui.px(92));
    line_box.cut_right(ui.px(4));
    if (const auto model = choice_combo(ui, line_box, spec, render::kShadingModels, shading.model))
        shading.model = *model;
    if (const auto path =
            choice_combo(ui, path_box, {.label = path_label}, render::kRenderPaths, shading.path))
        shading.path = *path;
}

}  // namespace

Requests draw_compare_tab(Ui& ui, const Rect& rect, const Shown& shown, ViewState& state) {
    render::View& view = state.view;
    ScrollArea area(ui, "compare", rect);
    Rect rest = area.content();
    rest.y1 = rest.y0 + 1e6f;
    const float top = rest.y0;
    rest.cut_top(ui.px(10));
    const auto line_box = [&] { return next_line(ui, rest).inset(ui.px(12), 0); };
    choose_side(ui, line_box(), {.label = "Left", .shown_label = "Left"}, view.left);
    choose_side(ui, line_box(), {.label = "Right", .shown_label = "Right"}, view.right);
    const auto range = number_field(ui, line_box(),
                                    {.label = "Heat up to",
                                     .shown_label = "Heat up to",
                                     .minimum = 0.01,
                                     .maximum = 8.0,
                                     .standard = 1.0,
                                     .curve = SliderCurve::Logarithmic,
                                     .tooltip = "The luminance difference that is the top of the "
                                                "heat map, 0.01 to 8"},
                                    static_cast<double>(view.difference_range));
    if (range) view.difference_range = static_cast<float>(*range);
    const bool beside = render::shows_difference_beside(view);
    if (labelled_checkbox(ui, line_box(), "Show the difference beside them", beside,
                          "Two views and their difference as heat, with its histogram")) {
        view.difference_beside = !beside;
        view.compare = render::CompareMode::TwoViews;
        view.channel = render::ChannelView::Final;
    }
    rest.cut_top(ui.px(6));
    if (unfold(ui, rest, "Cost", state.unfolded.cost))
        draw_table(ui, rest, view, cost_rows(shown.cost.frame));
    if (shown.comparison) draw_comparison(ui, rest, *shown.comparison, state);
    // Last: what is compared is looked at far more often than it is set.
    if (render::shows_traditional(view)) {
        const Place place(ui, "Phong");
        if (unfold(ui, rest, "Phong", state.unfolded.phong)) phong_fields(ui, rest, view);
    }
    area.set_height(rest.y0 - top + ui.px(12));
    return {};
}

}  // namespace patina::editor
