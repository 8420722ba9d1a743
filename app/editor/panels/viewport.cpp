// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/formulae/formulae.h"
#include "document/edits.h"
#include "editor/panels/panels.h"
#include "editor/widgets/buttons.h"
#include "editor/widgets/color_field.h"
#include "editor/widgets/heat.h"
#include "editor/widgets/number_text.h"

namespace patina::editor {
namespace {

constexpr float kDegreesPerPixel = 0.35f;
constexpr float kLightDegreesPerPixel = 0.5f;

// --- labels --------------------------------------------------------------------------------------

std::string_view shading_note(const render::Shading& shading) {
    if (shading.model != render::ShadingModel::Pbr) return "exponent from roughness";
    if (shading.terms == render::kLectureTerms) return "lecture terms";
    return shading.terms == render::PbrTerms{} ? "glTF 2.0, GGX" : "chosen terms";
}

std::string_view label_of(const render::Shading& shading) {
    return render::kShadingModels[static_cast<std::size_t>(shading.model)].label;
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

// --- the divider ---------------------------------------------------------------------------------

void draw_divider(Ui& ui, const Rect& rect, render::View& view) {
    const float x = std::round(rect.x0 + view.divider * rect.width());
    const Tip tip{"Divider", "Drag to compare, Left and Right move it by 1 %"};
    const Rect grab{x - ui.px(6), rect.y0, x + ui.px(6), rect.y1};
    const Rect handle = Rect{x, rect.y0, x, rect.y1}.centered(ui.px(30), ui.px(30));
    const std::string value = number_text(static_cast<double>(view.divider), {.decimals = 3});
    const Press on_handle = press(
        ui, handle,
        {.label = "Divider", .kind = "handle", .value = value, .tip = &tip, .focusable = false});
    const Press on_line =
        press(ui, grab, {.label = "Divider line", .kind = "handle", .focusable = false});
    const bool lit = on_handle.hovered || on_line.hovered || on_handle.held || on_line.held;
    if (lit) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if ((on_handle.held || on_line.held) && ImGui::GetIO().MouseDelta.x != 0.0f)
        view.divider =
            std::clamp(view.divider + ImGui::GetIO().MouseDelta.x / rect.width(), 0.0f, 1.0f);
    fill(ui, {x - ui.px(2), rect.y0, x + ui.px(2), rect.y1}, theme::kBase);
    fill(ui, {x - ui.px(1), rect.y0, x + ui.px(1), rect.y1},
         on_handle.held || on_line.held ? theme::kAccentHigh : theme::kText);
    disc(ui, x, handle.center_y(), 15, theme::kBase);
    disc(ui, x, handle.center_y(), 13, lit ? IM_COL32_WHITE : theme::kText);
    const float y = handle.center_y();
    const float a = ui.px(3);
    const float b = ui.px(6);
    const float h = ui.px(4);
    for (const float side : {-1.0f, 1.0f}) {
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.PathLineTo(ImVec2(x + side * a, y - h));
        list.PathLineTo(ImVec2(x + side * b, y));
        list.PathLineTo(ImVec2(x + side * a, y + h));
        list.PathStroke(theme::kBase, 0, 1.8f * ui.scale);
    }
}

// --- tools and gizmo -----------------------------------------------------------------------------

Requests draw_tools(Ui& ui, const Rect& rect, const Shown& shown, ViewState& view) {
    Requests requests;
    const Place place(ui, "Tools");
    constexpr int kTools = 5;
    const float height = ui.px(6 + 26 * kTools + 2 * (kTools - 1));
    Rect box{rect.x1 - ui.px(40), rect.y0 + ui.px(8), rect.x1 - ui.px(8),
             rect.y0 + ui.px(8) + height};
    fill(ui, box, theme::kOverlay, 6);
    box = box.inset(ui.px(3));
    const auto button = [&](const IconButton& spec) {
        const bool clicked = icon_button(ui, box.cut_top(ui.px(26)), spec);
        box.cut_top(ui.px(2));
        return clicked;
    };
    const bool open = shown.document != nullptr;
    if (button({.icon = icon::kFrame, .label = "Frame the model", .key = "F", .enabled = open}))
        requests.ask(Action::FrameModel);
    const bool probing = view.tool == ViewportTool::Probe;
    if (button({.icon = icon::kEyedropper,
                .label = "Read and explain",
                .tooltip = "Shows every channel under the pointer; click explains a texel",
                .key = "I",
                .enabled = open,
                .on = probing}))
        requests.ask(Action::ProbeTool);
    const bool uv = view.view.channel == render::ChannelView::Uv0;
    if (button({.icon = icon::kGrid,
                .label = "UV coordinates",
                .tooltip = "Shows the first texture coordinates on the model",
                .key = "U",
                .enabled = open,
                .on = uv}))
        view.view.channel = uv ? render::ChannelView::Final : render::ChannelView::Uv0;
    if (button({.icon = icon::kSun,
                .label = "Lights",
                .tooltip = "Opens the lights in the Material tab",
                .enabled = open}))
        requests.ask(Action::ShowLights);
    if (button({.icon = icon::kCamera, .label = "Save the view as PNG", .enabled = open}))
        requests.ask(Action::SaveView);
    return requests;
}

/// The world's axes as the camera sees them; the nearest is drawn last.
void draw_gizmo(Ui& ui, const Rect& rect, const render::Camera& camera) {
    const glm::mat4 view = render::view_from_world(camera);
    const float x = rect.x0 + ui.px(44);
    const float y = rect.y1 - ui.px(44);
    struct Axis {
        const char* name;
        ImU32 color;
        glm::vec3 tip;
    };
    std::array<Axis, 3> axes = {{{"X", rgb(0xD9655B), glm::vec3(view[0])},
                                 {"Y", rgb(0x7FB14F), glm::vec3(view[1])},
                                 {"Z", rgb(0x5B8FD9), glm::vec3(view[2])}}};
    std::sort(axes.begin(), axes.end(),
              [](const Axis& a, const Axis& b) { return a.tip.z < b.tip.z; });
    for (const Axis& axis : axes) {
        const float tip_x = x + 25 * ui.scale * axis.tip.x;
        const float tip_y = y - 25 * ui.scale * axis.tip.y;
        line(ui, x, y, tip_x, tip_y, axis.color, 2);
        disc(ui, tip_x, tip_y, 7, axis.color);
        const Rect letter = Rect{tip_x, tip_y, tip_x, tip_y}.centered(ui.px(14), ui.px(14));
        text(ui, letter, ui.fonts.medium11, rgb(0x0D0D0D), axis.name, Align::Center);
    }
}

// --- scales --------------------------------------------------------------------------------------

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

void draw_scale(Ui& ui, const Rect& rect, const Scale& scale) {
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

// --- probe ---------------------------------------------------------------------------------------

std::string probe_text(const render::ChannelViewInfo& row, const glm::vec3& value) {
    if (row.view == render::ChannelView::BaseColor) return hex_color(value);
    const int decimals = row.components == 1 || row.view == render::ChannelView::F0 ? 3 : 2;
    std::string words;
    for (int i = 0; i < row.components; ++i)
        words += (i > 0 ? "  " : "") +
                 number_text(static_cast<double>(value[i]), {.decimals = decimals});
    return words;
}

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

// --- toasts and the empty state ------------------------------------------------------------------

Requests draw_toast(Ui& ui, const Rect& box, const ToastShown& toast) {
    Requests requests;
    const Place place(ui, "Toast", static_cast<std::uint64_t>(toast.id));
    const bool error = toast.kind == ToastKind::Error;
    note(ui, box, {.label = toast.message, .kind = "toast", .value = error ? "error" : "note"});
    const ImVec2 mouse = ImGui::GetMousePos();
    if (box.contains(mouse.x, mouse.y)) requests.ask(HoldToast{toast.id});
    fill(ui, box, theme::kPopup, 6);
    outline(ui, box, theme::kBorder, 6);
    fill(ui, {box.x0, box.y0, box.x0 + ui.px(3), box.y1}, error ? theme::kError : theme::kAccent, 6,
         ImDrawFlags_RoundCornersLeft);
    Rect rest = box;
    rest.cut_left(ui.px(12));
    rest.cut_right(ui.px(8));
    icon_glyph(ui, rest.cut_left(ui.px(18)),
               error                           ? icon::kWarning
               : toast.kind == ToastKind::Note ? icon::kInfo
                                               : icon::kCheck,
               error ? theme::kError : theme::kAccentHigh, 14);
    rest.cut_left(ui.px(8));
    if (icon_button(ui, rest.cut_right(ui.px(26)),
                    {.icon = icon::kClose, .label = "Dismiss", .size = 13}))
        requests.ask(DismissToast{toast.id});
    if (!toast.link.empty()) {
        const TextButton link{.label = toast.link, .link = true};
        const Rect link_box = rest.cut_right(text_button_width(ui, link));
        if (text_button(ui, link_box.centered(link_box.width(), ui.px(26)), link)) {
            requests.ask(toast.action);
            requests.ask(DismissToast{toast.id});
        }
    }
    rest.cut_right(ui.px(8));
    const float wanted = text_width(ui.fonts.body13, toast.message);
    if (wanted <= rest.width())
        text(ui, rest, ui.fonts.body13, theme::kText, toast.message);
    else
        paragraph(ui, rest.inset(0, ui.px(6)), ui.fonts.body13, theme::kText, toast.message);
    return requests;
}

Requests draw_toasts(Ui& ui, const Rect& rect, std::span<const ToastShown> toasts) {
    Requests requests;
    float bottom = rect.y1 - ui.px(12);
    for (auto toast = toasts.rbegin(); toast != toasts.rend(); ++toast) {
        const float link =
            toast->link.empty() ? 0 : text_width(ui.fonts.medium13, toast->link) + ui.px(16);
        const float words = text_width(ui.fonts.body13, toast->message);
        const float most = std::min(rect.width() - ui.px(24), ui.px(560));
        const float chrome = link + ui.px(12 + 18 + 8 + 8 + 26 + 8);
        const float width = std::min(std::ceil(words + chrome) + 2, most);
        const float lines = std::ceil(words / std::max(width - chrome, 1.0f) * 1.1f);
        const float height = words + chrome <= width ? ui.px(44) : ui.px(14) + lines * ui.px(17);
        const Rect box{rect.x1 - ui.px(12) - width, bottom - height, rect.x1 - ui.px(12), bottom};
        requests.append(draw_toast(ui, box, *toast));
        bottom = box.y0 - ui.px(8);
    }
    return requests;
}

Requests draw_empty(Ui& ui, const Rect& rect) {
    Requests requests;
    fill(ui, rect, rgb(0x1A1A1A));
    Rect column = rect.centered(ui.px(360), ui.px(70));
    text(ui, column.cut_top(ui.px(20)), ui.fonts.body13, theme::kText2,
         "Open a model or drop a .glb here", Align::Center);
    column.cut_top(ui.px(14));
    const TextButton open{
        .label = "Open", .icon = icon::kFolderOpen, .key = "Ctrl O", .main = true};
    const TextButton sample{.label = "Try the sample"};
    const float open_width = text_button_width(ui, open);
    const float sample_width = text_button_width(ui, sample);
    Rect row = column.cut_top(ui.px(26)).centered(open_width + sample_width + ui.px(8), ui.px(26));
    if (text_button(ui, row.cut_left(open_width), open)) requests.ask(Action::Open);
    row.cut_left(ui.px(8));
    if (text_button(ui, row.cut_left(sample_width), sample)) requests.ask(Action::OpenSample);
    return requests;
}

// --- the camera ----------------------------------------------------------------------------------

Requests move_camera(Ui& ui, const Rect& rect, const Press& pressed, const Shown& shown,
                     ViewState& state) {
    Requests requests;
    render::Camera& camera = state.view.camera;
    const ImGuiIO& io = ImGui::GetIO();
    const ImVec2 moved = io.MouseDelta;
    const bool over = pressed.hovered || pressed.held;
    if (pressed.held && (moved.x != 0.0f || moved.y != 0.0f)) {
        if (io.KeyShift) {
            const float turned = shown.document->environment.rotation_degrees +
                                 moved.x * kLightDegreesPerPixel / ui.scale;
            requests.edit(set_environment_rotation(std::remainder(turned, 360.0f)));
        } else if (state.tool == ViewportTool::Move) {
            camera = render::orbited(camera, -moved.x * kDegreesPerPixel / ui.scale,
                                     moved.y * kDegreesPerPixel / ui.scale);
        }
    }
    if (pressed.released) ui.edit_ended = true;
    if (over && ImGui::IsMouseDragging(ImGuiMouseButton_Middle, 0.0f))
        camera = render::panned(camera, -moved.x / rect.height(), moved.y / rect.height());
    if (over && ImGui::IsMouseDragging(ImGuiMouseButton_Right, 0.0f))
        camera = render::dollied(camera, -moved.y / (ui.scale * 160.0f));
    if (pressed.hovered && io.MouseWheel != 0.0f)
        camera = render::dollied(camera, io.MouseWheel * 0.25f);
    return requests;
}

Requests pick_with(const Rect& rect, const Press& pressed, ViewState& state) {
    Requests requests;
    const ImVec2 mouse = ImGui::GetMousePos();
    const float x = (mouse.x - rect.x0) / rect.width();
    const float y = (mouse.y - rect.y0) / rect.height();
    const ImVec2 dragged = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, 4.0f);
    const bool probing = state.tool == ViewportTool::Probe;
    if (pressed.clicked && dragged.x == 0.0f && dragged.y == 0.0f)
        requests.ask(PickAt{x, y, probing});
    // With the numbers beside it a click says which point they are of.
    const bool numbers = is_comparing(state) && (state.right_tab == RightTab::Inspect ||
                                                 render::shows_difference_beside(state.view));
    if (pressed.clicked && numbers && dragged.x == 0.0f && dragged.y == 0.0f)
        state.crosshair = glm::vec2(x, y);
    return requests;
}

}  // namespace

Requests draw_viewport(Ui& ui, const Rect& rect, const Shown& shown, ViewState& state) {
    const Place place(ui, "Viewport");
    if (!shown.document) {
        Requests requests = draw_empty(ui, rect);
        requests.append(draw_toasts(ui, rect, shown.toasts));
        return requests;
    }
    fill(ui, rect, rgb(0x1A1A1A));
    picture(ui, rect, shown.viewport);
    Requests requests;
    const render::View& view = state.view;
    const bool split =
        view.compare == render::CompareMode::Split && view.channel == render::ChannelView::Final;
    // What lies on top takes the pointer first.
    requests.append(draw_toasts(ui, rect, shown.toasts));
    requests.append(draw_tools(ui, rect, shown, state));
    draw_part_note(ui, rect, shown, state);
    if (split) draw_divider(ui, rect, state.view);
    draw_labels(ui, rect, shown, view);
    draw_seams(ui, rect, view);
    if (!shown.comparison || !shown.comparison->values || view_columns(view) == 1)
        draw_gizmo(ui, rect, view.camera);
    if (const auto scale = scale_of(view); scale && shown.toasts.empty())
        draw_scale(ui, rect, *scale);
    const Press pressed =
        press(ui, rect, {.label = "Model", .kind = "viewport", .focusable = false});
    requests.append(move_camera(ui, rect, pressed, shown, state));
    requests.append(pick_with(rect, pressed, state));
    if (state.crosshair) draw_crosshairs(ui, rect, view, *state.crosshair);
    if (shown.comparison && shown.comparison->values)
        draw_luminances(ui, rect, view, *shown.comparison->values);
    if (shown.hovered && pressed.hovered && !pressed.held)
        draw_probe(ui, rect, *shown.hovered, shown, view.channel);
    return requests;
}

}  // namespace patina::editor
