// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>

#include "document/edits.h"
#include "document/references.h"
#include "editor/panels/adjustment_editor.h"
#include "editor/panels/blend_combo.h"
#include "editor/panels/choice_combo.h"
#include "editor/panels/kind_menus.h"
#include "editor/panels/layer/parts.h"
#include "editor/panels/levels_fields.h"
#include "editor/panels/placement_fields.h"
#include "editor/panels/source_editor.h"
#include "editor/panels/surface_fields.h"
#include "editor/widgets/buttons.h"
#include "editor/widgets/popup_menu.h"
#include "editor/widgets/slider.h"
#include "editor/widgets/text_field.h"

namespace patina::editor {
namespace {

Requests draw_levels(Ui& ui, Rect& rest, const LayerSubject& subject, const MaskEntry& entry) {
    Requests requests;
    if (const auto change = levels_fields(ui, rest, entry.levels))
        requests.edit(
            set_mask_entry_levels(subject.material, subject.layer, entry, change->levels));
    return requests;
}

/// Where an image or a procedural of the mask lies on the model.
Requests draw_placement(Ui& ui, Rect& rest, const PlacedSource& source, ViewState& view) {
    Requests requests;
    const Place place(ui, "UV transform");
    requests.append(draw_projection(ui, rest, {source}));
    requests.append(draw_transform(ui, rest, {source}, view.unfolded.uv_scale_linked));
    return requests;
}

Requests draw_entry_menu(Ui& ui, const LayerSubject& subject, const MaskEntry& entry, int index,
                         ViewState& view) {
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
    if (menu.item({.icon = icon::kPencil, .label = "Rename entry", .key = "F2"}))
        view.renaming_mask_entry = entry.id;
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

/// The row itself, beside its fields: a click unfolds it, a double click renames it.
void press_entry(Ui& ui, const Rect& row, const MaskEntry& entry, ViewState& view) {
    const bool open = view.unfolded.mask_entry == entry.id;
    const Tip tip{entry.name, "Click to edit it, double-click to rename, right click for more"};
    const Press pressed = press(ui, row,
                                {.label = entry.name,
                                 .kind = "mask entry",
                                 .value = open ? "open" : "folded",
                                 .tip = &tip});
    if (pressed.hovered && !open) fill(ui, row.inset(ui.px(4), 0), theme::kOpenRow, 4);
    if (pressed.hovered || pressed.focused) view.mask_entry_at_hand = entry.id;
    if (pressed.double_clicked) view.renaming_mask_entry = entry.id;
    // The first of two clicks has unfolded or folded it: the second takes that back.
    if (pressed.clicked || pressed.double_clicked)
        view.unfolded.mask_entry = open ? std::nullopt : std::optional(entry.id);
    if (pressed.right_clicked) ImGui::OpenPopup("entry menu");
}

Requests draw_entry_row(Ui& ui, const Rect& row, const LayerSubject& subject,
                        const MaskEntry& entry, ViewState& view) {
    Requests requests;
    Rect inner = row.inset(ui.px(12), 0);
    const Rect thumb = inner.cut_left(ui.px(28)).centered(ui.px(28), ui.px(28));
    inner.cut_left(ui.px(8));
    const Rect opacity_box = inner.cut_right(ui.px(subject.wide ? 64 : 44))
                                 .centered(ui.px(subject.wide ? 64 : 44), ui.px(24));
    inner.cut_right(ui.px(8));
    const Rect combine_box = inner.cut_right(ui.px(84)).centered(ui.px(84), ui.px(24));
    inner.cut_right(ui.px(6));
    const ParameterInfo& row_of_combine = info(Parameter::MaskEntryCombine);
    const auto combine = blend_combo(
        ui, combine_box, {.label = row_of_combine.label, .tooltip = row_of_combine.tooltip},
        ChannelKind::Scalar, entry.combine, BlendOf::Mask);
    if (combine)
        requests.edit(set_mask_entry_combine(subject.material, subject.layer, entry, *combine));
    const auto opacity =
        percent(ui, opacity_box, Parameter::MaskEntryOpacity, entry.opacity, subject.wide);
    if (opacity)
        requests.edit(set_mask_entry_opacity(subject.material, subject.layer, entry,
                                             static_cast<float>(*opacity)));
    bool renaming = view.renaming_mask_entry == entry.id;
    if (!renaming) press_entry(ui, row, entry, view);
    const Faded hidden(ui, !entry.visible);
    fill(ui, thumb, rgb(0x0D0D0D), 3);
    picture(ui, thumb, subject.shown.thumbnails->mask_entry(subject.material, subject.layer, entry),
            3);
    Rect words = inner.centered(inner.width(), ui.px(32));
    const Rect name_box = words.cut_top(ui.px(17));
    if (!renaming) {
        text(ui, name_box, ui.fonts.body13, theme::kText, entry.name);
    } else {
        const Rect field = name_box.inset(-ui.px(4), -ui.px(1));
        if (const auto name = rename_field(ui, field, entry.name, renaming))
            requests.edit(rename_mask_entry(subject.material, subject.layer, entry, *name));
        if (!renaming) view.renaming_mask_entry = {};
    }
    text(ui, words, ui.fonts.caption11, theme::kText3, kind_name(entry));
    return requests;
}

/// What the entry is made of: its source and levels, or its adjustment.
Requests draw_entry_editor(Ui& ui, Rect& rest, const LayerSubject& subject, const MaskEntry& entry,
                           ViewState& view) {
    if (entry.adjustment)
        return draw_adjustment(ui, rest, subject.material, subject.layer, entry, view);
    const SourcePlace source = source_place(subject.material, subject.layer, entry);
    Requests requests = draw_source_editor(
        ui, rest, {source, entry.source, std::nullopt, subject.layer.id, entry.id}, subject.shown);
    if (transform_of(entry.source) != nullptr)
        requests.append(draw_placement(ui, rest, {source, &entry.source}, view));
    requests.append(draw_levels(ui, rest, subject, entry));
    return requests;
}

Requests draw_entry(Ui& ui, Rect& rest, const LayerSubject& subject, const MaskEntry& entry,
                    int index, ViewState& view) {
    const Place place(ui, entry.name, entry.id.value);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.ChannelsSplit(2);
    list.ChannelsSetCurrent(1);
    const Rect row = rest.cut_top(ui.px(theme::kMaskRow));
    Requests requests = draw_entry_row(ui, row, subject, entry, view);
    requests.append(draw_entry_menu(ui, subject, entry, index, view));
    const bool open = view.unfolded.mask_entry == entry.id;
    if (open) {
        Rect editor = rest;
        editor.x0 += ui.px(48);
        editor.x1 -= ui.px(12);
        const float top = editor.y0;
        requests.append(draw_entry_editor(ui, editor, subject, entry, view));
        rest.cut_top(editor.y0 - top + ui.px(4));
    }
    list.ChannelsSetCurrent(0);
    if (open) fill(ui, {row.x0, row.y0, row.x1, rest.y0}, theme::kOpenRow);
    list.ChannelsMerge();
    return requests;
}

/// What masks begin with most; a second menu has all of them.
constexpr std::array kUsualMasks = {ProceduralKind::ValueNoise,  ProceduralKind::PerlinNoise,
                                    ProceduralKind::WorleyNoise, ProceduralKind::Grunge,
                                    ProceduralKind::Cracks,      ProceduralKind::Scratches,
                                    ProceduralKind::Spots,       ProceduralKind::Bricks};

constexpr const char* kAllProcedurals = "add procedural mask";

/// @param all  set when all procedurals are asked for
Requests draw_add_entry_menu(Ui& ui, const LayerSubject& subject, bool& all) {
    Requests requests;
    PopupMenu menu(ui, "add mask", 170);
    if (!menu.open()) return requests;
    for (const ProceduralKind kind : kUsualMasks)
        if (menu.item({.icon = icon::kNoise, .label = choice(kind).label}))
            requests.edit(
                add_mask_entry(subject.material, subject.layer, procedural_mask_entry(kind)));
    all = menu.item({.icon = icon::kNoise, .label = "All procedurals\u2026"});
    for (const ReliefKind kind : {ReliefKind::Cavity, ReliefKind::Edge})
        if (menu.item({.icon = icon::kNoise, .label = choice(kind).label}))
            requests.edit(add_mask_entry(subject.material, subject.layer, relief_mask_entry(kind)));
    const auto others = referable_layers(subject.material.stack, subject.layer.id);
    if (!others.empty() && menu.item({.icon = icon::kLink, .label = "Another layer"})) {
        const MaskEntry entry{.name = others.front()->name,
                              .source = ReferenceSource{.layer = others.front()->id}};
        requests.edit(add_mask_entry(subject.material, subject.layer, entry));
    }
    const auto parts = worn_parts(*subject.shown.document, subject.material.id);
    if (!parts.empty() && menu.item({.icon = icon::kGrid, .label = "Parts of the model"}))
        requests.edit(
            add_mask_entry(subject.material, subject.layer, geometry_mask_entry(parts.front())));
    if (menu.item({.icon = icon::kImage, .label = "Image\u2026"}))
        requests.ask(ChooseImageFor{subject.layer.id, std::monostate{}});
    if (menu.item({.icon = icon::kDroplet, .label = "Value"}))
        requests.edit(add_mask_entry(subject.material, subject.layer, value_mask_entry()));
    // It changes what the entries before it make.
    if (menu.item({.icon = icon::kInvert,
                   .label = "Adjustment",
                   .enabled = !subject.layer.mask.entries.empty()}))
        requests.edit(add_mask_entry(subject.material, subject.layer,
                                     adjustment_mask_entry(AdjustmentKind::Levels)));
    return requests;
}

Requests draw_mask_head(Ui& ui, Rect& rest, const LayerSubject& subject, ViewState& view) {
    Requests requests;
    const Mask& mask = subject.layer.mask;
    Rect head = rest.cut_top(ui.px(theme::kPanelTitle));
    hairline(ui, head);
    head.cut_right(ui.px(6));
    const Rect plus = head.cut_right(ui.px(26));
    if (icon_button(ui, plus, {.icon = icon::kPlus, .label = "Add mask entry"}))
        ImGui::OpenPopup("add mask");
    place_popup(plus, 0);
    bool all = false;
    requests.append(draw_add_entry_menu(ui, subject, all));
    if (all) ImGui::OpenPopup(kAllProcedurals);
    place_popup(plus, 0);
    if (const auto kind = procedural_menu(ui, kAllProcedurals))
        requests.edit(
            add_mask_entry(subject.material, subject.layer, procedural_mask_entry(*kind)));
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

}  // namespace

Requests draw_mask(Ui& ui, Rect& rest, const LayerSubject& subject, ViewState& view) {
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

}  // namespace patina::editor
