// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/formulae/formulae.h"
#include "document/edits.h"
#include "editor/panels/viewport/parts.h"
#include "editor/widgets/color_field.h"
#include "editor/widgets/number_text.h"

namespace patina::editor {
namespace {

std::string probe_text(const render::ChannelViewInfo& row, const glm::vec3& value) {
    if (row.view == render::ChannelView::BaseColor) return hex_color(value);
    const int decimals = row.components == 1 || row.view == render::ChannelView::F0 ? 3 : 2;
    std::string words;
    for (int i = 0; i < row.components; ++i)
        words += (i > 0 ? "  " : "") +
                 number_text(static_cast<double>(value[i]), {.decimals = decimals});
    return words;
}

void draw_crosshair(const Ui& ui, float x, float y) {
    for (const bool light : {false, true}) {
        const ImU32 color = light ? IM_COL32_WHITE : IM_COL32(0, 0, 0, 216);
        const float thickness = light ? 1.8f : 4.0f;
        ring(ui, x, y, 7, color, thickness);
        const float near = 8 * ui.scale;
        const float far = 14 * ui.scale;
        line(ui, x, y - far, x, y - near, color, thickness);
        line(ui, x, y + near, x, y + far, color, thickness);
        line(ui, x - far, y, x - near, y, color, thickness);
        line(ui, x + near, y, x + far, y, color, thickness);
    }
}

}  // namespace

void draw_probe(Ui& ui, const Rect& rect, const render::Probe& probe, const Shown& shown,
                render::ChannelView current) {
    constexpr int kRows = render::kStripChannelCount - 1;
    const ImVec2 mouse = ImGui::GetMousePos();
    const float width = ui.px(256);
    const float height = ui.px(10 + 22 + 22 * kRows + 10);
    float x = mouse.x + ui.px(20);
    float y = mouse.y + ui.px(14);
    if (x + width > rect.x1) x = mouse.x - ui.px(20) - width;
    y = std::clamp(y, rect.y0, std::max(rect.y1 - height, rect.y0));
    const Rect box{x, y, x + width, y + height};
    fill(ui, box, theme::kPopup, 6);
    outline(ui, box, theme::kBorder, 6);
    Rect inner = box.inset(ui.px(12), ui.px(10));
    const MaterialPtr material = material_of(*shown.document, probe.source_material);
    Rect title = inner.cut_top(ui.px(20));
    title.x0 =
        text(ui, title, ui.fonts.title13, theme::kText, material ? material->name : "") + ui.px(8);
    text(ui, title, ui.fonts.value12, theme::kText3,
         fmt::format("UV {:.3f}, {:.3f}", probe.uv.x, probe.uv.y));
    inner.cut_top(ui.px(2));
    for (int i = 1; i < render::kStripChannelCount; ++i) {
        const render::ChannelViewInfo& row = render::kChannelViews[static_cast<std::size_t>(i)];
        const Rect line_box = inner.cut_top(ui.px(22));
        const bool lit = row.view == current;
        if (lit) fill(ui, line_box, theme::kSelected);
        std::string label(row.label);
        if (!row.unit.empty()) label += ", " + std::string(row.unit);
        const std::string value = probe_text(row, probe[row.view]);
        text(ui, line_box, lit ? ui.fonts.medium12 : ui.fonts.value12,
             lit ? theme::kText : theme::kText2, label);
        text(ui, line_box, ui.fonts.value12, theme::kText, value, Align::Right);
        ui.map.add(row.label, "probe", value, line_box, true);
    }
}

/// Between views beside each other.
void draw_seams(const Ui& ui, const Rect& rect, const render::View& view) {
    const int columns = view_columns(view);
    for (int i = 1; i < columns; ++i) {
        const float x = std::floor(rect.x0 + rect.width() * static_cast<float>(i) /
                                                 static_cast<float>(columns));
        fill(ui, {x - ui.px(1), rect.y0, x + ui.px(1), rect.y1}, theme::kBase);
    }
}

/// A small plate at the bottom of each view: the luminance under the crosshair.
void draw_luminances(Ui& ui, const Rect& rect, const render::View& view,
                     const render::SideValues& values) {
    const auto luminance = [](const glm::vec3& color) {
        return static_cast<double>(formulae::luminance(formulae::Real3(color.x, color.y, color.z)));
    };
    const double left = luminance(values.left);
    const double right = luminance(values.right);
    const auto words = [](std::string_view name, double value) {
        return fmt::format("{} {}", name, number_text(value, {.decimals = 3}));
    };
    const std::array<std::string, 3> lines = {words("Luminance", left), words("Luminance", right),
                                              words("Difference", std::abs(left - right))};
    const int columns = view_columns(view);
    for (int i = 0; i < columns && columns > 1; ++i) {
        const std::string& line_of = lines[static_cast<std::size_t>(i)];
        const float width = text_width(ui.fonts.value12, line_of) + ui.px(20);
        const float x =
            rect.x0 + rect.width() * static_cast<float>(i) / static_cast<float>(columns) + ui.px(8);
        const Rect box{x, rect.y1 - ui.px(36), x + std::ceil(width), rect.y1 - ui.px(8)};
        fill(ui, box, theme::kOverlay, 4);
        text(ui, box, ui.fonts.value12, theme::kText, line_of, Align::Center);
        note(ui, box, {.label = line_of, .kind = "label"});
    }
}

/// The same point of the model in every view of it.
void draw_crosshairs(const Ui& ui, const Rect& rect, const render::View& view,
                     const glm::vec2& at) {
    const auto columns = static_cast<float>(view_columns(view));
    const float within = at.x * columns - std::floor(at.x * columns);
    for (float column = 0.0f; column < columns; ++column)
        draw_crosshair(ui, rect.x0 + (column + within) / columns * rect.width(),
                       rect.y0 + at.y * rect.height());
}

}  // namespace patina::editor
