// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>

#include "document/edits.h"
#include "editor/panels/choice_combo.h"
#include "editor/panels/mode_icons.h"
#include "editor/panels/panels.h"
#include "editor/widgets/buttons.h"
#include "editor/widgets/color_field.h"
#include "editor/widgets/popup_menu.h"
#include "editor/widgets/slider.h"

namespace patina::editor {
namespace {

/// Logical pixels of all but the shadings when every control shows its name.
constexpr float kWideWithoutShadings = 1030.0f;

void mode_segments(Ui& ui, Rect& rest, bool wide, render::View& view) {
    float total = ui.px(4);
    std::array<float, 4> widths{};
    for (std::size_t i = 0; i < widths.size(); ++i) {
        widths[i] = wide
                        ? std::ceil(text_width(ui.fonts.medium12, render::kCompareModes[i].label)) +
                              ui.px(38)
                        : ui.px(32);
        total += widths[i];
    }
    Rect box = rest.cut_left(total).centered(total, ui.px(theme::kFieldHeight));
    fill(ui, box, theme::kField, 4);
    box = box.inset(ui.px(2));
    for (std::size_t i = 0; i < widths.size(); ++i) {
        const auto& choice = render::kCompareModes[i];
        const Rect part = box.cut_left(widths[i]);
        const bool on = view.compare == choice.value;
        const Tip tip{std::string(choice.label), std::string(choice.tooltip), "V"};
        const Press pressed = press(
            ui, part,
            {.label = choice.label, .kind = "segment", .value = on ? "on" : "off", .tip = &tip});
        if (on) fill(ui, part, theme::kFieldPressed, 3);
        const ImU32 color = on || pressed.hovered ? theme::kText : theme::kText2;
        Rect inner = wide ? part.inset(ui.px(8), 0) : part;
        draw_mode_icon(ui, wide ? inner.cut_left(ui.px(16)) : inner, choice.value, color);
        if (wide) {
            inner.cut_left(ui.px(6));
            text(ui, inner, on ? ui.fonts.medium12 : ui.fonts.value12, color, choice.label);
        }
        if (pressed.clicked) view.compare = choice.value;
    }
}

Rect field_at_left(const Ui& ui, Rect& rest, float width) {
    return rest.cut_left(ui.px(width)).centered(ui.px(width), ui.px(theme::kFieldHeight));
}

Rect field_at_right(const Ui& ui, Rect& rest, float width) {
    return rest.cut_right(ui.px(width)).centered(ui.px(width), ui.px(theme::kFieldHeight));
}

/// Logical pixels for the name of a shading model.
float shading_width(const Ui& ui, const render::Shading& shading) {
    const auto& choice = render::kShadingModels[static_cast<std::size_t>(shading.model)];
    return std::max(text_width(ui.fonts.value12, choice.label) / ui.scale + 34.0f, 72.0f);
}

/// What one or two shadings take, with the button between them.
float shadings_width(const Ui& ui, const render::View& view) {
    const float left = shading_width(ui, view.left);
    if (view.compare == render::CompareMode::Single) return left;
    return left + 30.0f + shading_width(ui, view.right);
}

void shading_combos(Ui& ui, Rect& rest, render::View& view) {
    const bool both = view.compare != render::CompareMode::Single;
    const auto left = choice_combo(ui, field_at_left(ui, rest, shading_width(ui, view.left)),
                                   {.label = both ? "Left shading" : "Shading", .key = "P, O"},
                                   render::kShadingModels, view.left.model);
    if (left) view.left.model = *left;
    if (!both) return;
    rest.cut_left(ui.px(2));
    if (icon_button(ui, rest.cut_left(ui.px(26)),
                    {.icon = icon::kSwap, .label = "Swap sides", .key = "X", .size = 12}))
        std::swap(view.left, view.right);
    rest.cut_left(ui.px(2));
    const auto right =
        choice_combo(ui, field_at_left(ui, rest, shading_width(ui, view.right)),
                     {.label = "Right shading"}, render::kShadingModels, view.right.model);
    if (right) view.right.model = *right;
}

void channel_combo(Ui& ui, Rect& rest, bool wide, render::View& view) {
    std::array<ComboItem, render::kChannelViewCount> items;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const render::ChannelViewInfo& row = render::kChannelViews[i];
        const std::string_view group = i == 0 ? std::string_view()
                                       : row.origin == render::ChannelOrigin::GBuffer ? "G-buffer"
                                       : row.origin == render::ChannelOrigin::Inspection
                                           ? "Inspection"
                                           : "Lighting";
        items[i] = {.label = row.label, .group = group, .tooltip = row.tooltip};
    }
    const float width = wide ? 164.0f : view.channel == render::ChannelView::Final ? 64.0f : 98.0f;
    const auto picked =
        combo(ui, field_at_left(ui, rest, width),
              {.label = "Channel", .shown_label = wide ? "Channel" : "", .key = "0-9, C"}, items,
              static_cast<int>(view.channel));
    if (picked) view.channel = static_cast<render::ChannelView>(*picked);
}

Requests environment_combo(Ui& ui, const Rect& rect, bool wide, const Shown& shown) {
    Requests requests;
    std::vector<ComboItem> items;
    int chosen = -1;
    const std::string current = shown.document ? shown.document->environment.name : "";
    for (const EnvironmentShown& environment : shown.environments) {
        if (environment.name == current) chosen = static_cast<int>(items.size());
        items.push_back({.label = environment.label});
    }
    const Picture thumbnail = shown.thumbnails->environment(current);
    const std::string_view value =
        chosen < 0 ? std::string_view() : items[static_cast<std::size_t>(chosen)].label;
    const auto picked = combo(ui, rect,
                              {.label = "Environment",
                               .shown_value = wide ? value : std::string_view(" "),
                               .tooltip = "The light all around. Drop an .hdr or .exr to add one",
                               .enabled = shown.document != nullptr,
                               .picture = &thumbnail,
                               .picture_width = 36},
                              items, chosen);
    if (picked)
        requests.edit(
            set_environment_name(shown.environments[static_cast<std::size_t>(*picked)].name));
    return requests;
}

/// Of each side that is on screen, whether it is drawn without a G-buffer.
void path_items(PopupMenu& menu, render::View& view) {
    constexpr std::string_view tooltip =
        "Each fragment is lit as it is drawn: the same picture at another cost";
    const auto item = [&](std::string_view label, render::Shading& shading) {
        const bool forward = shading.path == render::RenderPath::Forward;
        if (menu.item({.label = label, .ticked = forward, .tooltip = tooltip}))
            shading.path = forward ? render::RenderPath::Deferred : render::RenderPath::Forward;
    };
    if (view.compare == render::CompareMode::Single) return item("Forward path", view.left);
    item("Forward path, left", view.left);
    item("Forward path, right", view.right);
}

/// The colour of the plain background, which is stored as it is on screen.
void background_color(Ui& ui, const Rect& rect, glm::vec3& srgb) {
    const auto chosen =
        color_field(ui, rect, {.label = "Background colour", .tooltip = "What is behind the model"},
                    linear_from_srgb(srgb));
    if (chosen) srgb = srgb_from_linear(*chosen);
}

void background_menu(Ui& ui, ViewState& state) {
    PopupMenu menu(ui, "view menu", 190);
    if (!menu.open()) return;
    render::View& view = state.view;
    menu.heading("Background");
    for (const auto& choice : render::kBackgrounds) {
        if (menu.item({.label = choice.label,
                       .ticked = view.background.kind == choice.value,
                       .tooltip = choice.tooltip}))
            view.background.kind = choice.value;
        const bool plain = choice.value == render::Background::Kind::Color;
        if (plain && view.background.kind == choice.value)
            background_color(ui, menu.field_row(), view.background.color_srgb);
    }
    menu.separator();
    path_items(menu, view);
    menu.separator();
    if (menu.item({.label = "Shadows",
                   .ticked = view.shadows,
                   .tooltip = "Of suns in the environment, the strongest lamps and Phong's light"}))
        view.shadows = !view.shadows;
    if (menu.item({.label = "Ground shadow", .ticked = view.ground_shadow}))
        view.ground_shadow = !view.ground_shadow;
    if (menu.item({.label = "Filter normal maps",
                   .ticked = view.filter_normals,
                   .tooltip = "What is finer than a pixel makes it rougher, instead of glinting"}))
        view.filter_normals = !view.filter_normals;
    if (menu.item({.label = "Occluded reflections",
                   .ticked = view.occlude_reflections,
                   .tooltip = "What crevices hide, and normal maps would mirror from below the "
                              "surface, is not mirrored"}))
        view.occlude_reflections = !view.occlude_reflections;
    const bool smooth = view.anti_aliasing == render::AntiAliasing::Fast;
    if (menu.item({.label = "Smooth edges", .ticked = smooth}))
        view.anti_aliasing = smooth ? render::AntiAliasing::None : render::AntiAliasing::Fast;
    if (menu.item(
            {.label = "Refine when idle",
             .ticked = state.refine_when_idle,
             .tooltip = "While nothing moves, averages ever more samples of edges and light"}))
        state.refine_when_idle = !state.refine_when_idle;
}

}  // namespace

Requests draw_viewport_bar(Ui& ui, const Rect& rect, const Shown& shown, ViewState& state) {
    const Place place(ui, "Viewport bar");
    fill(ui, rect, theme::kPanel, 6, ImDrawFlags_RoundCornersTop);
    render::View& view = state.view;
    const float logical = rect.width() / ui.scale;
    const bool wide = logical >= kWideWithoutShadings + shadings_width(ui, view);
    Rect rest = rect.inset(ui.px(8), 0);
    mode_segments(ui, rest, wide, view);
    rest.cut_left(ui.px(6));
    shading_combos(ui, rest, view);
    rest.cut_left(ui.px(8));
    fill(ui, rest.cut_left(ui.px(1)).centered(ui.px(1), ui.px(16)), theme::kBorder);
    rest.cut_left(ui.px(8));
    channel_combo(ui, rest, wide, view);

    Requests requests;
    if (logical >= 660) {
        const Rect more = rest.cut_right(ui.px(26));
        if (icon_button(ui, more, {.icon = icon::kEllipsis, .label = "Background and edges"}))
            ImGui::OpenPopup("view menu");
        place_popup(more, 0);
        background_menu(ui, state);
        rest.cut_right(ui.px(4));
    }
    // "PBR Neutral" would be cut off where there is little room.
    const bool neutral = view.tone_map == render::ToneMap::PbrNeutral;
    const auto tone = choice_combo(ui, field_at_right(ui, rest, wide ? 148 : 84),
                                   {.label = "Tone map",
                                    .shown_label = wide ? "Tone" : "",
                                    .shown_value = !wide && neutral ? "Neutral" : ""},
                                   render::kToneMaps, view.tone_map);
    if (tone) view.tone_map = *tone;
    rest.cut_right(ui.px(6));
    const auto exposure = number_field(ui, field_at_right(ui, rest, wide ? 128 : 84),
                                       {.label = "Exposure",
                                        .shown_label = wide ? "Exposure" : "EV",
                                        .minimum = -6.0,
                                        .maximum = 6.0,
                                        .step = 1.0 / 3.0,
                                        .always_signed = true,
                                        .tooltip = "Light times 2 to this power, \u22126 to +6 EV",
                                        .key = "[ ]"},
                                       static_cast<double>(view.exposure_ev));
    if (exposure) view.exposure_ev = static_cast<float>(*exposure);
    rest.cut_right(ui.px(6));
    requests.append(environment_combo(ui, field_at_right(ui, rest, wide ? 158 : 62), wide, shown));
    return requests;
}

}  // namespace patina::editor
