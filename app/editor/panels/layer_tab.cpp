// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "document/edits.h"
#include "editor/panels/adjustment_editor.h"
#include "editor/panels/blend_combo.h"
#include "editor/panels/choice_combo.h"
#include "editor/panels/levels_fields.h"
#include "editor/panels/panels.h"
#include "editor/panels/source_editor.h"
#include "editor/widgets/buttons.h"
#include "editor/widgets/form.h"
#include "editor/widgets/number_text.h"
#include "editor/widgets/popup_menu.h"
#include "editor/widgets/slider.h"

namespace patina::editor {
namespace {

/// What all parts of the tab are about.
struct Subject {
    const Material& material;
    const Layer& layer;
    const Shown& shown;
    bool wide = true;  ///< room for the Blend column
};

/// The group that holds the layer, if any.
const Layer* parent_of(const std::vector<LayerPtr>& layers, LayerId id) {
    for (const LayerPtr& layer : layers) {
        const auto* group = std::get_if<GroupContent>(&layer->content);
        if (group == nullptr) continue;
        for (const LayerPtr& child : group->children)
            if (child->id == id) return layer.get();
        if (const Layer* found = parent_of(group->children, id)) return found;
    }
    return nullptr;
}

std::optional<double> percent(Ui& ui, const Rect& rect, Parameter parameter, float value,
                              bool wide) {
    NumberSpec spec = number_spec(parameter);
    spec.shown_label = {};
    if (!wide) spec.unit = {};
    return number_field(ui, rect, spec, static_cast<double>(value));
}

// --- the head ------------------------------------------------------------------------------------

Requests draw_head(Ui& ui, Rect& rest, const Subject& subject) {
    Requests requests;
    const Layer& layer = subject.layer;
    Rect head = rest.cut_top(ui.px(56));
    head.cut_left(ui.px(12));
    head.cut_right(ui.px(8));
    const Rect square = head.cut_left(ui.px(36)).centered(ui.px(36), ui.px(36));
    fill(ui, square, rgb(0x0D0D0D), 3);
    picture(ui, square, subject.shown.thumbnails->layer(subject.material, layer), 3);
    head.cut_left(ui.px(10));
    if (icon_button(ui, head.cut_right(ui.px(26)),
                    {.icon = layer.locked ? icon::kLock : icon::kUnlock,
                     .label = layer.locked ? "Unlock layer" : "Lock layer",
                     .tooltip = info(Parameter::LayerLocked).tooltip}))
        requests.edit(set_layer_locked(subject.material, layer, !layer.locked));
    if (icon_button(ui, head.cut_right(ui.px(26)),
                    {.icon = layer.visible ? icon::kEye : icon::kEyeSlash,
                     .label = layer.visible ? "Hide layer" : "Show layer",
                     .key = "H"}))
        requests.edit(set_layer_visible(subject.material, layer, !layer.visible));
    Rect words = head.centered(head.width(), ui.px(34));
    text(ui, words.cut_top(ui.px(18)), ui.fonts.name15, theme::kText, layer.name);
    words.cut_top(ui.px(2));
    const Layer* parent = parent_of(subject.material.stack, layer.id);
    std::string kind = layer.is_group() ? "Group" : layer.is_adjustment() ? "Adjustment" : "Fill";
    kind +=
        parent != nullptr ? " \u00b7 in " + parent->name : " \u00b7 of " + subject.material.name;
    text(ui, words, ui.fonts.caption11, theme::kText3, kind);

    Rect line_box = rest.cut_top(ui.px(26)).inset(ui.px(12), ui.px(1));
    const Rect mode_box = line_box.cut_left(ui.px(subject.wide ? 118 : 96));
    line_box.cut_left(ui.px(4));
    const auto mode = blend_combo(
        ui, mode_box, {.label = "Blend mode", .tooltip = info(Parameter::LayerMode).tooltip},
        ChannelKind::Color, layer.mode, layer.is_group() ? BlendOf::Group : BlendOf::Channel);
    if (mode) requests.edit(set_layer_mode(subject.material, layer, *mode));
    const auto opacity = number_field(ui, line_box, number_spec(Parameter::LayerOpacity),
                                      static_cast<double>(layer.opacity));
    if (opacity)
        requests.edit(set_layer_opacity(subject.material, layer, static_cast<float>(*opacity)));
    rest.cut_top(ui.px(4));
    Rect space_box = rest.cut_top(ui.px(theme::kFieldHeight)).inset(ui.px(12), 0);
    const auto space =
        parameter_combo(ui, space_box, Parameter::LayerBlendSpace, layer.blend_space);
    if (space) requests.edit(set_layer_blend_space(subject.material, layer, *space));
    rest.cut_top(ui.px(4));
    const Rect clip_box = rest.cut_top(ui.px(theme::kFieldHeight)).inset(ui.px(12), 0);
    const ParameterInfo& clip = info(Parameter::LayerClipped);
    if (labelled_checkbox(ui, clip_box, clip.label, layer.clipped, clip.tooltip))
        requests.edit(set_layer_clipped(subject.material, layer, !layer.clipped));
    rest.cut_top(ui.px(10));
    return requests;
}

// --- channels ------------------------------------------------------------------------------------

/// The columns of a channel's row: 16 4 80 1fr 78 44 with gaps of 4, and no blend when narrow.
struct ChannelColumns {
    Rect box;
    Rect name;
    Rect value;
    Rect blend;
    Rect opacity;
};

ChannelColumns columns_of(const Ui& ui, Rect row, bool wide) {
    ChannelColumns columns;
    const float gap = ui.px(4);
    row = row.inset(ui.px(12), ui.px(2));
    columns.box = row.cut_left(ui.px(16));
    row.cut_left(ui.px(8));
    columns.name = row.cut_left(ui.px(80));
    row.cut_left(gap);
    columns.opacity = row.cut_right(ui.px(44));
    row.cut_right(gap);
    if (wide) {
        columns.blend = row.cut_right(ui.px(84));
        row.cut_right(gap);
    }
    columns.value = row;
    return columns;
}

Requests draw_channel_value(Ui& ui, const Rect& rect, const EditedSource& edited,
                            const Subject& subject, ViewState& view) {
    if (std::holds_alternative<ConstantSource>(edited.source))
        return draw_constant(ui, rect, edited, false);
    const std::string name = source_name(edited.source, edited.channel, *subject.shown.document);
    const Tip tip{name, "Click to edit the source"};
    const Press pressed =
        press(ui, rect, {.label = "Source", .kind = "source", .value = name, .tip = &tip});
    fill(ui, rect, pressed.hovered ? theme::kFieldHover : theme::kField, 4);
    Rect inner = rect;
    inner.cut_left(ui.px(4));
    inner.cut_right(ui.px(6));
    const Rect swatch = inner.cut_left(ui.px(18)).centered(ui.px(18), ui.px(18));
    fill(ui, swatch, rgb(0x0D0D0D), 3);
    picture(
        ui, swatch,
        subject.shown.thumbnails->channel_source(subject.material, subject.layer, *edited.channel),
        3);
    inner.cut_left(ui.px(6));
    text(ui, inner, ui.fonts.value12, theme::kText, name);
    if (pressed.clicked) {
        const bool open = view.unfolded.channel == edited.channel;
        view.unfolded.channel = open ? std::nullopt : edited.channel;
    }
    return {};
}

void draw_channel_name(Ui& ui, const Rect& rect, Channel channel, bool on, bool can_open,
                       ViewState& view) {
    const ChannelInfo& row = info(channel);
    const Tip tip{std::string(row.label), std::string(row.tooltip)};
    const Press pressed = press(ui, rect,
                                {.label = row.label,
                                 .kind = "name",
                                 .value = view.unfolded.channel == channel ? "open" : "",
                                 .enabled = can_open,
                                 .tip = &tip});
    const ImU32 color = !on ? theme::kText3 : theme::kText;
    text(ui, rect, ui.fonts.body13, color, row.label);
    if (!pressed.clicked) return;
    if (view.unfolded.channel == channel)
        view.unfolded.channel.reset();
    else
        view.unfolded.channel = channel;
}

Requests draw_channel_row(Ui& ui, Rect& rest, Channel channel, const Subject& subject,
                          ViewState& view) {
    // A normal is no number that an adjustment could change.
    if (subject.layer.is_adjustment() && channel == Channel::Normal) return {};
    Requests requests;
    const Place place(ui, info(channel).label);
    const Layer& layer = subject.layer;
    const ChannelSettings& settings = at(layer.channels, channel);
    const bool fills = !layer.is_group() && !layer.is_adjustment();
    const bool open = settings.enabled && fills && view.unfolded.channel == channel;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.ChannelsSplit(2);
    list.ChannelsSetCurrent(1);
    const Rect row = rest.cut_top(ui.px(theme::kChannelRow));
    const ChannelColumns columns = columns_of(ui, row, subject.wide);
    if (checkbox(ui, columns.box, info(channel).label, settings.enabled,
                 info(Parameter::ChannelEnabled).tooltip))
        requests.edit(set_channel_enabled(subject.material, layer, channel, !settings.enabled));
    draw_channel_name(ui, columns.name, channel, settings.enabled, settings.enabled && fills, view);
    const SourcePlace source = source_place(subject.material, layer, channel);
    const EditedSource edited{source, settings.source, channel, layer.id, {}};
    if (!settings.enabled) {
        text(ui, columns.value.inset(ui.px(8), 0), ui.fonts.value12, theme::kText3, "Off");
    } else {
        if (!fills)
            text(ui, columns.value.inset(ui.px(8), 0), ui.fonts.value12, theme::kText3,
                 layer.is_group() ? "Of its layers" : "Adjusted");
        else
            requests.append(draw_channel_value(ui, columns.value, edited, subject, view));
        if (subject.wide) {
            const auto mode = blend_combo(
                ui, columns.blend,
                {.label = "Channel blend", .tooltip = info(Parameter::ChannelMode).tooltip},
                info(channel).kind, effective_blend_mode(layer, channel));
            if (mode) requests.edit(set_channel_mode(subject.material, layer, channel, *mode));
        }
        const auto opacity =
            percent(ui, columns.opacity, Parameter::ChannelOpacity, settings.opacity, false);
        if (opacity)
            requests.edit(set_channel_opacity(subject.material, layer, channel,
                                              static_cast<float>(*opacity)));
    }
    if (open) {
        rest.cut_top(ui.px(2));
        Rect editor = rest;
        editor.x0 += ui.px(36);
        editor.x1 -= ui.px(12);
        const float top = editor.y0;
        requests.append(draw_source_editor(ui, editor, edited, subject.shown));
        rest.cut_top(editor.y0 - top + ui.px(4));
    }
    list.ChannelsSetCurrent(0);
    if (open) fill(ui, {row.x0, row.y0, row.x1, rest.y0}, theme::kOpenRow);
    list.ChannelsMerge();
    return requests;
}

Requests draw_channels(Ui& ui, Rect& rest, const Subject& subject, ViewState& view) {
    Requests requests;
    std::size_t on = 0;
    for (const ChannelSettings& settings : subject.layer.channels) on += settings.enabled ? 1 : 0;
    Rect head = rest.cut_top(ui.px(theme::kPanelTitle));
    hairline(ui, head);
    if (section(ui, head,
                {.title = "Channels",
                 .count = fmt::format("{} of {}", on, kChannelCount),
                 .open = view.unfolded.channels}))
        view.unfolded.channels = !view.unfolded.channels;
    if (!view.unfolded.channels) return requests;
    head.cut_right(ui.px(12));
    text(ui, head, ui.fonts.caption11, theme::kText3, "Opacity, %", Align::Right);
    if (subject.wide) {
        head.cut_right(ui.px(48));
        text(ui, head.cut_right(ui.px(84)), ui.fonts.caption11, theme::kText3, "Blend");
    }
    for (const ChannelInfo& row : kChannels)
        requests.append(draw_channel_row(ui, rest, row.channel, subject, view));
    rest.cut_top(ui.px(8));
    return requests;
}

// --- mask ----------------------------------------------------------------------------------------

std::string kind_of(const Source& source) {
    if (std::holds_alternative<ImageSource>(source)) return "Image";
    return std::holds_alternative<ProceduralSource>(source) ? "Procedural" : "Value";
}

Requests draw_levels(Ui& ui, Rect& rest, const Subject& subject, const MaskEntry& entry) {
    Requests requests;
    if (const auto change = levels_fields(ui, rest, entry.levels))
        requests.edit(
            set_mask_entry_levels(subject.material, subject.layer, entry, change->levels));
    return requests;
}

Requests draw_entry_menu(Ui& ui, const Subject& subject, const MaskEntry& entry, int index) {
    Requests requests;
    PopupMenu menu(ui, "entry menu", 170);
    if (!menu.open()) return requests;
    const Material& material = subject.material;
    const Layer& layer = subject.layer;
    const int last = static_cast<int>(layer.mask.entries.size()) - 1;
    if (menu.item({.icon = icon::kEye, .label = entry.visible ? "Hide entry" : "Show entry"}))
        requests.edit(set_mask_entry_visible(material, layer, entry, !entry.visible));
    if (menu.item({.icon = icon::kInvert, .label = "Invert", .ticked = entry.invert}))
        requests.edit(set_mask_entry_invert(material, layer, entry, !entry.invert));
    if (menu.item({.icon = icon::kClone, .label = "Duplicate entry"}))
        requests.edit(duplicate_mask_entry(material, layer, entry));
    if (menu.item({.label = "Move up", .enabled = index > 0}))
        requests.edit(move_mask_entry(material, layer, entry, index - 1));
    if (menu.item({.label = "Move down", .enabled = index < last}))
        requests.edit(move_mask_entry(material, layer, entry, index + 1));
    if (menu.item({.icon = icon::kTrash, .label = "Remove entry"}))
        requests.edit(remove_mask_entry(material, layer, entry));
    return requests;
}

Requests draw_entry_row(Ui& ui, const Rect& row, const Subject& subject, const MaskEntry& entry,
                        ViewState& view) {
    Requests requests;
    Rect inner = row.inset(ui.px(12), 0);
    const Rect thumb = inner.cut_left(ui.px(28)).centered(ui.px(28), ui.px(28));
    inner.cut_left(ui.px(8));
    const Rect opacity_box = inner.cut_right(ui.px(subject.wide ? 64 : 44))
                                 .centered(ui.px(subject.wide ? 64 : 44), ui.px(24));
    inner.cut_right(ui.px(8));
    const Rect combine_box = inner.cut_right(ui.px(84)).centered(ui.px(84), ui.px(24));
    inner.cut_right(ui.px(6));
    const auto combine =
        parameter_combo(ui, combine_box, Parameter::MaskEntryCombine, entry.combine, false);
    if (combine)
        requests.edit(set_mask_entry_combine(subject.material, subject.layer, entry, *combine));
    const auto opacity =
        percent(ui, opacity_box, Parameter::MaskEntryOpacity, entry.opacity, subject.wide);
    if (opacity)
        requests.edit(set_mask_entry_opacity(subject.material, subject.layer, entry,
                                             static_cast<float>(*opacity)));
    const bool open = view.unfolded.mask_entry == entry.id;
    const Tip tip{entry.name, "Click to edit it, right click for more"};
    const Press pressed = press(ui, row,
                                {.label = entry.name,
                                 .kind = "mask entry",
                                 .value = open ? "open" : "folded",
                                 .tip = &tip});
    if (pressed.hovered && !open) fill(ui, row.inset(ui.px(4), 0), theme::kOpenRow, 4);
    if (pressed.clicked) view.unfolded.mask_entry = open ? std::nullopt : std::optional(entry.id);
    if (pressed.right_clicked) ImGui::OpenPopup("entry menu");
    const Faded hidden(ui, !entry.visible);
    fill(ui, thumb, rgb(0x0D0D0D), 3);
    picture(ui, thumb, subject.shown.thumbnails->mask_entry(subject.material, subject.layer, entry),
            3);
    Rect words = inner.centered(inner.width(), ui.px(32));
    text(ui, words.cut_top(ui.px(17)), ui.fonts.body13, theme::kText, entry.name);
    text(ui, words, ui.fonts.caption11, theme::kText3, kind_of(entry.source));
    return requests;
}

Requests draw_entry(Ui& ui, Rect& rest, const Subject& subject, const MaskEntry& entry, int index,
                    ViewState& view) {
    const Place place(ui, entry.name, entry.id.value);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.ChannelsSplit(2);
    list.ChannelsSetCurrent(1);
    const Rect row = rest.cut_top(ui.px(theme::kMaskRow));
    Requests requests = draw_entry_row(ui, row, subject, entry, view);
    requests.append(draw_entry_menu(ui, subject, entry, index));
    const bool open = view.unfolded.mask_entry == entry.id;
    if (open) {
        Rect editor = rest;
        editor.x0 += ui.px(48);
        editor.x1 -= ui.px(12);
        const float top = editor.y0;
        const SourcePlace source = source_place(subject.material, subject.layer, entry);
        requests.append(draw_source_editor(
            ui, editor, {source, entry.source, std::nullopt, subject.layer.id, entry.id},
            subject.shown));
        requests.append(draw_levels(ui, editor, subject, entry));
        rest.cut_top(editor.y0 - top + ui.px(4));
    }
    list.ChannelsSetCurrent(0);
    if (open) fill(ui, {row.x0, row.y0, row.x1, rest.y0}, theme::kOpenRow);
    list.ChannelsMerge();
    return requests;
}

/// What masks begin with most; any other kind can then be chosen in the entry.
constexpr std::array kUsualMasks = {ProceduralKind::ValueNoise,  ProceduralKind::PerlinNoise,
                                    ProceduralKind::WorleyNoise, ProceduralKind::Grunge,
                                    ProceduralKind::Cracks,      ProceduralKind::Scratches,
                                    ProceduralKind::Spots,       ProceduralKind::Bricks};

Requests draw_add_entry_menu(Ui& ui, const Subject& subject) {
    Requests requests;
    PopupMenu menu(ui, "add mask", 170);
    if (!menu.open()) return requests;
    for (const ProceduralKind kind : kUsualMasks)
        if (menu.item({.icon = icon::kNoise, .label = choice(kind).label}))
            requests.edit(
                add_mask_entry(subject.material, subject.layer, procedural_mask_entry(kind)));
    if (menu.item({.icon = icon::kImage, .label = "Image\u2026"}))
        requests.ask(ChooseImageFor{subject.layer.id, std::monostate{}});
    if (menu.item({.icon = icon::kDroplet, .label = "Value"}))
        requests.edit(add_mask_entry(subject.material, subject.layer, value_mask_entry()));
    return requests;
}

Requests draw_mask_head(Ui& ui, Rect& rest, const Subject& subject, ViewState& view) {
    Requests requests;
    const Mask& mask = subject.layer.mask;
    Rect head = rest.cut_top(ui.px(theme::kPanelTitle));
    hairline(ui, head);
    head.cut_right(ui.px(6));
    const Rect plus = head.cut_right(ui.px(26));
    if (icon_button(ui, plus, {.icon = icon::kPlus, .label = "Add mask entry"}))
        ImGui::OpenPopup("add mask");
    place_popup(plus, 0);
    requests.append(draw_add_entry_menu(ui, subject));
    if (!mask.entries.empty()) {
        if (icon_button(ui, head.cut_right(ui.px(26)),
                        {.icon = icon::kInvert,
                         .label = "Invert mask",
                         .tooltip = info(Parameter::MaskInvert).tooltip,
                         .on = mask.invert}))
            requests.edit(set_mask_invert(subject.material, subject.layer, !mask.invert));
        if (icon_button(ui, head.cut_right(ui.px(26)),
                        {.icon = mask.enabled ? icon::kEye : icon::kEyeSlash,
                         .label = mask.enabled ? "Switch mask off" : "Switch mask on",
                         .tooltip = info(Parameter::MaskEnabled).tooltip}))
            requests.edit(set_mask_enabled(subject.material, subject.layer, !mask.enabled));
    }
    const std::string count = mask.entries.empty()
                                  ? ""
                                  : fmt::format("{} {}", mask.entries.size(),
                                                mask.entries.size() == 1 ? "entry" : "entries");
    if (section(ui, head, {.title = "Mask", .count = count, .open = view.unfolded.mask}))
        view.unfolded.mask = !view.unfolded.mask;
    return requests;
}

Requests draw_mask(Ui& ui, Rect& rest, const Subject& subject, ViewState& view) {
    const Place place(ui, "Mask");
    Requests requests = draw_mask_head(ui, rest, subject, view);
    if (!view.unfolded.mask) return requests;
    const Mask& mask = subject.layer.mask;
    if (mask.entries.empty()) {
        Rect line_box = rest.cut_top(ui.px(26)).inset(ui.px(12), 0);
        const TextButton add{.label = "Add", .link = true};
        text(ui, line_box, ui.fonts.value12, theme::kText3, "No mask: the layer covers everything");
        const float width = text_button_width(ui, add);
        if (text_button(ui, line_box.cut_right(width), add)) requests.ask(Action::AddNoiseMask);
    } else {
        const Faded off(ui, !mask.enabled);
        int index = 0;
        for (const MaskEntry& entry : mask.entries)
            requests.append(draw_entry(ui, rest, subject, entry, index++, view));
        Rect base = rest.cut_top(ui.px(28)).inset(ui.px(12), ui.px(2));
        const auto next = number_field(ui, base, number_spec(Parameter::MaskBase),
                                       static_cast<double>(mask.base));
        if (next)
            requests.edit(
                set_mask_base(subject.material, subject.layer, static_cast<float>(*next)));
    }
    rest.cut_top(ui.px(8));
    return requests;
}

// --- UV transform --------------------------------------------------------------------------------

const UvTransform* transform_of(const Source& source) {
    if (const auto* image = std::get_if<ImageSource>(&source)) return &image->transform;
    if (const auto* procedural = std::get_if<ProceduralSource>(&source))
        return &procedural->transform;
    return nullptr;
}

/// The channel whose transform is shown: the open one, else the first that has one.
std::optional<Channel> transformed_channel(const Layer& layer, const ViewState& view) {
    const auto has = [&](Channel channel) {
        const ChannelSettings& settings = at(layer.channels, channel);
        return settings.enabled && transform_of(settings.source) != nullptr;
    };
    if (view.unfolded.channel && has(*view.unfolded.channel)) return view.unfolded.channel;
    for (const ChannelInfo& row : kChannels)
        if (has(row.channel)) return row.channel;
    return std::nullopt;
}

/// The source with the outline of the texture's unit square in it.
void draw_uv_preview(Ui& ui, const Rect& rect, const Subject& subject, Channel channel,
                     const UvTransform& transform) {
    fill(ui, rect, rgb(0x0D0D0D), 4);
    picture(ui, rect,
            subject.shown.thumbnails->channel_source(subject.material, subject.layer, channel), 4);
    const float half = 0.24f * rect.width();
    const float turn = glm::radians(transform.rotation_degrees);
    std::array<ImVec2, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) {
        const float x = (i == 1 || i == 2 ? half : -half);
        const float y = (i >= 2 ? half : -half);
        corners[i] = ImVec2(rect.center_x() + std::cos(turn) * x + std::sin(turn) * y,
                            rect.center_y() - std::sin(turn) * x + std::cos(turn) * y);
    }
    ImGui::GetWindowDrawList()->AddPolyline(corners.data(), 4, theme::kAccentHigh,
                                            ImDrawFlags_Closed, 1.5f * ui.scale);
    for (const ImVec2& corner : corners) disc(ui, corner.x, corner.y, 3.5f, theme::kText);
}

std::optional<glm::vec2> pair_fields(Ui& ui, Rect line_box, Parameter parameter,
                                     const glm::vec2& value, bool* linked) {
    NumberSpec first = number_spec(parameter);
    first.level = false;
    first.drag_per_pixel = first.step * 0.1;
    NumberSpec second = first;
    const std::string second_label = std::string(first.label) + " down";
    second.label = second_label;
    second.shown_label = {};
    const Rect last = line_box.cut_right(ui.px(56));
    const Rect middle = line_box.cut_right(ui.px(26));
    if (linked != nullptr &&
        icon_button(
            ui, middle,
            {.icon = icon::kLink, .label = "Keep both scales together", .on = *linked, .size = 12}))
        *linked = !*linked;
    glm::vec2 changed = value;
    if (const auto x = number_field(ui, line_box, first, static_cast<double>(value.x))) {
        changed.x = static_cast<float>(*x);
        if (linked != nullptr && *linked) changed.y = changed.x;
    }
    if (const auto y = number_field(ui, last, second, static_cast<double>(value.y))) {
        changed.y = static_cast<float>(*y);
        if (linked != nullptr && *linked) changed.x = changed.y;
    }
    if (changed == value) return std::nullopt;
    return changed;
}

Requests draw_uv_fields(Ui& ui, Rect column, const SourcePlace& place, const Source& source,
                        ViewState& view) {
    Requests requests;
    const UvTransform& transform = *transform_of(source);
    if (const auto* image = std::get_if<ImageSource>(&source)) {
        constexpr std::array<ComboItem, 2> kSets = {ComboItem{.label = "UV 0"},
                                                    ComboItem{.label = "UV 1"}};
        const auto set = combo(ui, next_line(ui, column),
                               {.label = "UV set", .tooltip = info(Parameter::ImageUvSet).tooltip},
                               kSets, image->uv_set);
        if (set) requests.edit(set_image_uv_set(place, *set));
    }
    if (const auto scale = pair_fields(ui, next_line(ui, column), Parameter::UvScale,
                                       transform.scale, &view.unfolded.uv_scale_linked))
        requests.edit(set_uv_scale(place, *scale));
    if (const auto offset =
            pair_fields(ui, next_line(ui, column), Parameter::UvOffset, transform.offset, nullptr))
        requests.edit(set_uv_offset(place, *offset));
    const auto rotation =
        number_field(ui, next_line(ui, column), number_spec(Parameter::UvRotation),
                     static_cast<double>(transform.rotation_degrees));
    if (rotation) requests.edit(set_uv_rotation(place, static_cast<float>(*rotation)));
    return requests;
}

Requests draw_uv(Ui& ui, Rect& rest, const Subject& subject, ViewState& view) {
    Requests requests;
    const std::optional<Channel> channel = transformed_channel(subject.layer, view);
    if (!channel) return requests;
    const Place place_name(ui, "UV transform");
    const Source& source = at(subject.layer.channels, *channel).source;
    const UvTransform& transform = *transform_of(source);
    const SourcePlace place = source_place(subject.material, subject.layer, *channel);
    Rect head = rest.cut_top(ui.px(theme::kPanelTitle));
    hairline(ui, head);
    if (view.unfolded.uv) {
        head.cut_right(ui.px(6));
        if (icon_button(ui, head.cut_right(ui.px(26)),
                        {.icon = icon::kReset,
                         .label = "Reset UV transform",
                         .enabled = transform != UvTransform{}}))
            requests.edit(set_uv_transform(place, {}));
    }
    const std::string summary =
        fmt::format("{} \u00d7 {}, {}", number_text(static_cast<double>(transform.scale.x)),
                    number_text(static_cast<double>(transform.scale.y)),
                    number_text(static_cast<double>(transform.rotation_degrees),
                                {.decimals = 1, .unit = "\u00b0"}));
    if (section(ui, head,
                {.title = "UV transform",
                 .count = info(*channel).label,
                 .summary = summary,
                 .open = view.unfolded.uv}))
        view.unfolded.uv = !view.unfolded.uv;
    if (!view.unfolded.uv) return requests;
    Rect box = rest.cut_top(ui.px(108)).inset(ui.px(12), 0);
    if (subject.wide) {
        draw_uv_preview(ui, box.cut_left(ui.px(108)), subject, *channel, transform);
        box.cut_left(ui.px(12));
    }
    requests.append(draw_uv_fields(ui, box, place, source, view));
    rest.cut_top(ui.px(12));
    return requests;
}

// --- bake ----------------------------------------------------------------------------------------

std::optional<int> resolution_combo(Ui& ui, const Rect& rect, int resolution) {
    std::vector<std::string> labels;
    std::vector<int> sizes;
    int chosen = -1;
    for (int size = kMinResolution; size <= kMaxResolution; size *= 2) {
        if (size == resolution) chosen = static_cast<int>(sizes.size());
        sizes.push_back(size);
        labels.push_back(fmt::format("{} px", size));
    }
    std::vector<ComboItem> items;
    for (const std::string& label : labels) items.push_back({.label = label});
    const ParameterInfo& row = info(Parameter::MaterialResolution);
    const auto picked =
        combo(ui, rect, {.label = row.label, .shown_label = row.label, .tooltip = row.tooltip},
              items, chosen);
    if (!picked) return std::nullopt;
    return sizes[static_cast<std::size_t>(*picked)];
}

Requests draw_bake(Ui& ui, Rect& rest, const Subject& subject, ViewState& view) {
    Requests requests;
    const Place place(ui, "Bake");
    const Material& material = subject.material;
    const Rect head = rest.cut_top(ui.px(theme::kPanelTitle));
    hairline(ui, head);
    if (section(ui, head,
                {.title = "Bake",
                 .summary = fmt::format("{} px", material.resolution),
                 .open = view.unfolded.bake}))
        view.unfolded.bake = !view.unfolded.bake;
    if (!view.unfolded.bake) return requests;
    const auto next_pair = [&] {
        return side_by_side<2>(ui, next_line(ui, rest).inset(ui.px(12), 0));
    };
    const auto first = next_pair();
    if (const auto size = resolution_combo(ui, first[0], material.resolution))
        requests.edit(set_material_resolution(material, *size));
    if (const auto mode =
            parameter_combo(ui, first[1], Parameter::MaterialAlphaMode, material.alpha_mode))
        requests.edit(set_material_alpha_mode(material, *mode));
    const auto second = next_pair();
    if (const auto ior = number_field(ui, second[0], number_spec(Parameter::MaterialIor),
                                      static_cast<double>(material.ior)))
        requests.edit(set_material_ior(material, static_cast<float>(*ior)));
    NumberSpec emission = number_spec(Parameter::MaterialEmissiveStrength);
    const auto strength =
        number_field(ui, second[1], emission, static_cast<double>(material.emissive_strength));
    if (strength)
        requests.edit(set_material_emissive_strength(material, static_cast<float>(*strength)));
    return requests;
}

}  // namespace

Requests draw_layer_tab(Ui& ui, const Rect& rect, const Shown& shown, ViewState& view) {
    Requests requests;
    if (!shown.layer) {
        text(ui, Rect{rect.x0, rect.y0, rect.x1, rect.y0 + ui.px(60)}.inset(ui.px(12), 0),
             ui.fonts.body13, theme::kText3, "Select a layer to edit it");
        return requests;
    }
    ScrollArea area(ui, "layer", rect);
    Rect rest = area.content();
    rest.y1 = rest.y0 + 1e6f;
    const float top = rest.y0;
    const Subject subject{*shown.material, *shown.layer, shown, rect.width() / ui.scale >= 320};
    {
        const Faded locked(ui, shown.layer->locked, 200);
        requests.append(draw_head(ui, rest, subject));
        requests.append(draw_adjustment(ui, rest, subject.material, subject.layer));
        requests.append(draw_channels(ui, rest, subject, view));
        requests.append(draw_mask(ui, rest, subject, view));
        requests.append(draw_uv(ui, rest, subject, view));
    }
    requests.append(draw_bake(ui, rest, subject, view));
    area.set_height(rest.y0 - top + ui.px(12));
    return requests;
}

}  // namespace patina::editor
