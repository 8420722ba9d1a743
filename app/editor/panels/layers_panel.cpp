// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "document/edits.h"
#include "editor/panels/blend_combo.h"
#include "editor/panels/kind_menus.h"
#include "editor/panels/panels.h"
#include "editor/widgets/buttons.h"
#include "editor/widgets/dragging.h"
#include "editor/widgets/name_search.h"
#include "editor/widgets/number_text.h"
#include "editor/widgets/popup_menu.h"
#include "editor/widgets/text_field.h"

namespace patina::editor {
namespace {

constexpr double kGroupOpenSeconds = 0.6;  // over a folded group, dragging

struct Row {
    LayerPtr layer;
    int depth = 0;
    bool hidden = false;  ///< itself or a group around it
};

struct ListedIn {
    int depth = 0;
    bool hidden = false;
    bool all = false;  ///< also what is folded away
};

void flatten(const std::vector<LayerPtr>& layers, const ListedIn& where, const ViewState& view,
             std::vector<Row>& rows) {
    for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) {
        const bool gone = where.hidden || !(*layer)->visible;
        rows.push_back({*layer, where.depth, gone});
        if (!(*layer)->is_group() || !(where.all || is_unfolded(**layer, view))) continue;
        flatten(std::get<GroupContent>((*layer)->content).children,
                {where.depth + 1, gone, where.all}, view, rows);
    }
}

/// Top to bottom as shown; with a search only what matches, without depth.
std::vector<Row> rows_of(const Material& material, const ViewState& view) {
    std::vector<Row> rows;
    const std::optional<std::string>& search = view.layer_search;
    const bool searching = search && !search->empty();
    flatten(material.stack, {.all = searching}, view, rows);
    if (!searching) return rows;
    std::erase_if(rows, [&](const Row& row) { return !name_matches(row.layer->name, *search); });
    for (Row& row : rows) row.depth = 0;
    return rows;
}

// --- one row -------------------------------------------------------------------------------------

struct RowParts {
    Rect eye;
    Rect clip;   ///< of one that is clipped to the layer below
    Rect angle;  ///< of a group
    Rect thumbnail;
    Rect mask;  ///< empty without one
    Rect name;
    Rect details;
};

RowParts parts_of(const Ui& ui, const Row& row, const Rect& rect) {
    RowParts parts;
    Rect rest = rect;
    rest.cut_right(ui.px(10));
    parts.eye = rest.cut_left(ui.px(34));
    rest.cut_left(ui.px(16) * static_cast<float>(std::min(row.depth, 6)));
    if (row.layer->clipped) parts.clip = rest.cut_left(ui.px(16));
    if (row.layer->is_group()) parts.angle = rest.cut_left(ui.px(16));
    parts.thumbnail = rest.cut_left(ui.px(32)).centered(ui.px(32), ui.px(32));
    if (!row.layer->mask.entries.empty()) {
        rest.cut_left(ui.px(4));
        parts.mask = rest.cut_left(ui.px(32)).centered(ui.px(32), ui.px(32));
    }
    rest.cut_left(ui.px(10));
    rest = rest.centered(rest.width(), ui.px(36));
    parts.name = rest.cut_top(ui.px(18));
    rest.cut_top(ui.px(2));
    parts.details = rest;
    return parts;
}

Requests draw_eye(Ui& ui, const Rect& rect, const Material& material, const Row& row,
                  ViewState& view) {
    Requests requests;
    const bool visible = row.layer->visible;
    const Tip tip{visible ? "Hide layer" : "Show layer", "Alt-click shows it alone", "H"};
    const Press pressed =
        press(ui, rect,
              {.label = "Visible", .kind = "eye", .value = visible ? "on" : "off", .tip = &tip});
    const bool alone = view.solo == row.layer->id;
    ImU32 color = visible ? theme::kText3 : theme::kTrackFull;
    if (alone) color = theme::kAccentHigh;
    if (pressed.hovered) color = theme::kText;
    icon_glyph(ui, rect, visible ? icon::kEye : icon::kEyeSlash, color, 13);
    if (!pressed.clicked) return requests;
    if (ImGui::GetIO().KeyAlt)
        view.solo = alone ? LayerId{} : row.layer->id;
    else
        requests.edit(set_layer_visible(material, *row.layer, !visible));
    return requests;
}

void draw_square(const Ui& ui, const Rect& rect, const Picture& shown, bool ringed) {
    fill(ui, rect, rgb(0x0D0D0D), 3);
    picture(ui, rect, shown, 3);
    if (ringed) outline(ui, rect.inset(-ui.px(2)), theme::kAccentHigh, 4);
}

Requests draw_thumbnails(Ui& ui, const RowParts& parts, const Material& material, const Row& row,
                         const Shown& shown, ViewState& view) {
    Requests requests;
    const bool selected = view.layer == row.layer->id;
    draw_square(ui, parts.thumbnail, shown.thumbnails->layer(material, *row.layer), false);
    if (parts.mask.empty()) return requests;
    const Tip tip{"Mask", "Alt-click shows it on the model"};
    const bool viewed = view.viewed_mask == row.layer->id;
    const Press pressed = press(
        ui, parts.mask,
        {.label = "Mask thumbnail", .kind = "thumbnail", .value = viewed ? "on" : "", .tip = &tip});
    draw_square(ui, parts.mask, shown.thumbnails->mask(material, *row.layer), selected || viewed);
    if (!pressed.clicked) return requests;
    view.layer = row.layer->id;
    if (ImGui::GetIO().KeyAlt)
        view.viewed_mask = viewed ? LayerId{} : row.layer->id;
    else
        view.unfolded.mask = true;
    return requests;
}

/// What is special about the layer, at the right of its name.
void draw_marks(Ui& ui, Rect& rect, const Layer& layer) {
    const auto mark = [&](const char* glyph, std::string_view label, std::string words) {
        const Rect box = rect.cut_right(ui.px(16));
        rect.cut_right(ui.px(2));
        icon_glyph(ui, box, glyph, theme::kText3, 12);
        const Tip tip{std::string(label), std::move(words)};
        note(ui, box, {.label = label, .kind = "mark", .tip = &tip});
    };
    if (layer.locked)
        mark(icon::kLock, "Locked", std::string(info(Parameter::LayerLocked).tooltip));
    if (const auto* content = std::get_if<AdjustmentContent>(&layer.content))
        mark(icon::kSliders, "Adjustment", std::string(choice(content->adjustment.kind).label));
    if (layer.height_blend.enabled)
        mark(icon::kHeights, info(Parameter::HeightBlendEnabled).label,
             std::string(info(Parameter::HeightBlendEnabled).tooltip));
}

/// The arrow that says what the layer is clipped to.
void draw_clip(Ui& ui, const Rect& rect) {
    if (rect.empty()) return;
    icon_glyph(ui, rect, icon::kClip, theme::kText2, 12);
    const Tip tip{"Clipped", std::string(info(Parameter::LayerClipped).tooltip)};
    note(ui, rect, {.label = "Clipped", .kind = "mark", .tip = &tip});
}

Requests draw_name(Ui& ui, Rect rect, const Material& material, const Row& row, ViewState& view) {
    Requests requests;
    const Layer& layer = *row.layer;
    if (view.renaming_layer == layer.id) {
        bool renaming = true;
        const Rect field = rect.inset(-ui.px(6), -ui.px(1));
        if (const auto name = rename_field(ui, field, layer.name, renaming))
            requests.edit(rename_layer(material, layer, *name));
        if (!renaming) view.renaming_layer = {};
        return requests;
    }
    draw_marks(ui, rect, layer);
    const bool strong = view.layer == layer.id || layer.is_group();
    text(ui, rect, strong ? ui.fonts.medium13 : ui.fonts.body13,
         row.hidden ? theme::kText3 : theme::kText, layer.name);
    return requests;
}

Requests draw_details(Ui& ui, Rect rect, const Material& material, const Row& row,
                      const ViewState& view) {
    Requests requests;
    const Layer& layer = *row.layer;
    const std::string percent =
        number_text(static_cast<double>(layer.opacity) * 100.0, {.decimals = 0, .unit = "%"});
    const ImU32 color = row.hidden ? theme::kText3 : theme::kText2;
    text(ui, rect.cut_right(ui.px(40)), ui.fonts.caption11, color, percent, Align::Right);
    if (rect.width() > ui.px(110)) {
        rect.cut_right(ui.px(4));
        Rect track = rect.cut_right(ui.px(36)).centered(ui.px(36), ui.px(3));
        rect.cut_right(ui.px(6));
        fill(ui, track, theme::kTrack, 1.5f);
        track.x1 = track.x0 + std::round(track.width() * layer.opacity);
        if (!track.empty()) fill(ui, track, theme::kTrackFull, 1.5f);
    }
    if (view.layer == layer.id && !layer.locked) {
        const auto mode = blend_combo(ui, rect, {.label = "Blend mode", .flat = true},
                                      ChannelKind::Color, layer.mode, blend_of(layer));
        if (mode) requests.edit(set_layer_mode(material, layer, *mode));
    } else {
        text(ui, rect, ui.fonts.caption11, color, info(layer.mode).label);
    }
    return requests;
}

bool is_on(Action action, const Shown& shown) {
    return action == Action::ClipLayer && shown.layer && shown.layer->clipped;
}

void draw_row_menu(Ui& ui, const Shown& shown, Requests& requests) {
    PopupMenu menu(ui, "layer menu", 200);
    if (!menu.open()) return;
    for (const Action action :
         {Action::RenameLayer, Action::DuplicateLayer, Action::HideLayer, Action::LockLayer,
          Action::ClipLayer, Action::GroupLayer, Action::UngroupLayer, Action::AddNoiseMask,
          Action::AddImageMask, Action::ClearMask, Action::Copy, Action::Paste,
          Action::SaveLayerPreset, Action::DeleteLayer})
        if (applies(action, shown) && menu.item({.icon = info(action).icon,
                                                 .label = info(action).label,
                                                 .key = info(action).key,
                                                 .ticked = is_on(action, shown)}))
            requests.ask(action);
}

// --- dragging ------------------------------------------------------------------------------------

struct DropTarget {
    LayerPlace place;
    float y = 0.0f;  ///< of the insertion line
    int depth = 0;
};

/// Where a drop at the pointer goes: above or below a row by its halves; the lower half of an open
/// group and the middle of a folded one go into it.
std::optional<DropTarget> drop_target(const Ui& ui, const std::vector<Row>& rows,
                                      const ViewState& view, float top) {
    if (rows.empty()) return std::nullopt;
    const float height = ui.px(theme::kLayerRow);
    const float at = std::max(ImGui::GetMousePos().y - top, 0.0f) / height;
    const auto index = static_cast<std::size_t>(at);
    if (index >= rows.size()) {
        // Below everything: under the lowest layer of the stack itself.
        const auto lowest =
            std::find_if(rows.rbegin(), rows.rend(), [](const Row& row) { return row.depth == 0; });
        return DropTarget{below(lowest->layer->id), top + height * static_cast<float>(rows.size()),
                          0};
    }
    const Row& row = rows[index];
    const float share = at - static_cast<float>(index);
    const float y = top + height * static_cast<float>(index);
    const bool group = row.layer->is_group();
    const bool open = is_unfolded(*row.layer, view);
    const bool into_open = group && open && share >= 0.5f;
    const bool into_folded = group && !open && share > 0.3f && share < 0.7f;
    if (into_open || into_folded)
        return DropTarget{top_of_group(row.layer->id), y + height, row.depth + 1};
    if (share < 0.5f) return DropTarget{above(row.layer->id), y, row.depth};
    return DropTarget{below(row.layer->id), y + height, row.depth};
}

void draw_insertion(const Ui& ui, const Rect& list, const DropTarget& target, bool allowed) {
    const ImU32 color = allowed ? theme::kAccent : theme::kDot;
    const float x = list.x0 + ui.px(42 + 16 * static_cast<float>(target.depth));
    fill(ui, {x, target.y - ui.px(1), list.x1 - ui.px(8), target.y + ui.px(1)}, color);
    disc(ui, x, target.y, 4, theme::kPanel);
    ring(ui, x, target.y, 4, color, 2);
}

/// Folded groups open when a drag rests on them.
void open_hovered_group(Ui& ui, const std::vector<Row>& rows, float top, ViewState& view) {
    LayerDrag& drag = view.layer_drag;
    const float at = (ImGui::GetMousePos().y - top) / ui.px(theme::kLayerRow);
    const auto index = static_cast<std::size_t>(std::max(at, 0.0f));
    LayerId over;
    if (at >= 0.0f && index < rows.size()) {
        const Layer& layer = *rows[index].layer;
        if (layer.is_group() && !is_unfolded(layer, view)) over = layer.id;
    }
    if (over != drag.over_group) {
        drag.over_group = over;
        drag.over_since = ImGui::GetTime();
    }
    if (over.value == 0) return;
    const double rested = ImGui::GetTime() - drag.over_since;
    if (rested >= kGroupOpenSeconds) view.unfolded_groups[over] = true;
    ui.wake_in(std::max(kGroupOpenSeconds - rested, 0.0) + 0.01);
}

Requests carry_drag(Ui& ui, const Rect& list, float top, const std::vector<Row>& rows,
                    const Shown& shown, ViewState& view) {
    Requests requests;
    LayerDrag& drag = view.layer_drag;
    const LayerPtr layer = find_layer(*shown.material, drag.layer);
    if (!layer || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) {
        drag = {};
        return requests;
    }
    open_hovered_group(ui, rows, top, view);
    const auto target = drop_target(ui, rows, view, top);
    bool allowed = false;
    Edit move;
    if (target && target->place.anchor != layer->id) {
        move = move_layer(*shown.material, *layer, target->place);
        allowed = move.apply(*shown.document).has_value();
    }
    if (target) draw_insertion(ui, list, *target, allowed);
    draw_ghost(ui, shown.thumbnails->layer(*shown.material, *layer), layer->name);
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        if (allowed) requests.edit(std::move(move));
        drag = {};
    }
    return requests;
}

void start_drag(const Ui& ui, const Press& pressed, const Row& row, ViewState& view) {
    if (pressed.started) view.layer_drag = {.layer = row.layer->id};
    if (!pressed.held || view.layer_drag.layer != row.layer->id) return;
    if (drag_has_begun(ui)) view.layer_drag.moving = true;
}

// --- the panel -----------------------------------------------------------------------------------

Requests draw_row(Ui& ui, const Rect& rect, const Row& row, const Shown& shown, ViewState& view) {
    Requests requests;
    const Layer& layer = *row.layer;
    const Place place(ui, layer.name, layer.id.value);
    const RowParts parts = parts_of(ui, row, rect);
    const bool selected = view.layer == layer.id;
    const ImVec2 mouse = ImGui::GetMousePos();
    const bool under_pointer =
        rect.contains(mouse.x, mouse.y) &&
        ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    row_tint(ui, rect, selected, under_pointer && !view.layer_drag.moving);
    const Faded faded(ui, view.layer_drag.moving && view.layer_drag.layer == layer.id);
    {
        const Faded hidden(ui, row.hidden);
        requests.append(draw_thumbnails(ui, parts, *shown.material, row, shown, view));
    }
    requests.append(draw_eye(ui, parts.eye, *shown.material, row, view));
    draw_clip(ui, parts.clip);
    if (layer.is_group()) {
        const bool open = is_unfolded(layer, view);
        const Press angle = press(
            ui, parts.angle, {.label = "Unfolded", .kind = "angle", .value = open ? "on" : "off"});
        icon_glyph(ui, parts.angle, open ? icon::kAngleDown : icon::kAngleRight, theme::kText2, 14);
        if (angle.clicked) view.unfolded_groups[layer.id] = !open;
    }
    requests.append(draw_name(ui, parts.name, *shown.material, row, view));
    requests.append(draw_details(ui, parts.details, *shown.material, row, view));
    // The parts came first and have taken what is theirs; the row takes the rest.
    if (view.renaming_layer == layer.id) {
        ui.map.add(layer.name, "row", selected ? "selected" : "", visible_part(rect), true);
        return requests;
    }
    const Press pressed =
        press(ui, rect, {.label = layer.name, .kind = "row", .value = selected ? "selected" : ""});
    start_drag(ui, pressed, row, view);
    if (pressed.started || pressed.clicked || pressed.right_clicked) view.layer = layer.id;
    if (pressed.double_clicked) view.renaming_layer = layer.id;
    if (pressed.right_clicked) ImGui::OpenPopup("layer menu");
    draw_row_menu(ui, shown, requests);
    return requests;
}

void draw_group_lines(const Ui& ui, const std::vector<Row>& rows, float x0, float top) {
    const float height = ui.px(theme::kLayerRow);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!rows[i].layer->is_group()) continue;
        std::size_t last = i;
        while (last + 1 < rows.size() && rows[last + 1].depth > rows[i].depth) ++last;
        if (last == i) continue;
        const float x = x0 + ui.px(41 + 16 * static_cast<float>(rows[i].depth));
        fill(ui,
             {x, top + height * static_cast<float>(i + 1) + ui.px(2), x + ui.px(1),
              top + height * static_cast<float>(last + 1) - ui.px(4)},
             theme::kTrack);
    }
}

/// What can be added; of procedurals and adjustments a second menu asks which.
Requests draw_add_menu(Ui& ui, const Rect& anchor) {
    Requests requests;
    constexpr const char* kProcedurals = "add procedural";
    constexpr const char* kAdjustments = "add adjustment";
    const char* next = nullptr;
    place_popup(anchor, ui.px(2));
    if (PopupMenu menu(ui, "add layer", 180); menu.open()) {
        const auto item = [&](Action action, std::string_view label) {
            return menu.item({.icon = info(action).icon, .label = label});
        };
        for (const Action action : {Action::AddValueLayer, Action::AddImageLayer, Action::AddGroup})
            if (item(action, info(action).label)) requests.ask(action);
        if (item(Action::AddNoiseLayer, "Add procedural layer\u2026")) next = kProcedurals;
        if (item(Action::AddAdjustment, "Add adjustment\u2026")) next = kAdjustments;
    }
    if (next != nullptr) ImGui::OpenPopup(next);
    place_popup(anchor, ui.px(2));
    if (const auto kind = procedural_menu(ui, kProcedurals))
        requests.ask(AddNewLayer{procedural_layer(*kind)});
    place_popup(anchor, ui.px(2));
    if (const auto kind = adjustment_menu(ui, kAdjustments))
        requests.ask(AddNewLayer{adjustment_layer(*kind)});
    return requests;
}

Requests draw_title(Ui& ui, Rect title, const Shown& shown, std::size_t count, ViewState& view) {
    Requests requests;
    panel_title(ui, title, "Layers", count > 0 ? std::to_string(count) : "");
    title.cut_right(ui.px(6));
    const bool ready = shown.material != nullptr;
    const Rect plus = title.cut_right(ui.px(34)).centered(ui.px(34), ui.px(26));
    const Tip tip{"Add layer", "A value, a noise, an image or a group, above the selected layer"};
    const Press pressed =
        press(ui, plus, {.label = "Add layer", .kind = "button", .enabled = ready, .tip = &tip});
    fill(ui, plus, pressed.hovered ? theme::kFieldHover : theme::kField, 4);
    {
        const Faded faded(ui, !ready);
        Rect half = plus;
        icon_glyph(ui, half.cut_left(ui.px(20)), icon::kPlus, theme::kText, 12);
        icon_glyph(ui, half, icon::kAngleDown, theme::kText2, 11);
    }
    if (pressed.clicked) ImGui::OpenPopup("add layer");
    requests.append(draw_add_menu(ui, plus));
    const auto button = [&](Action action, std::string_view label) {
        title.cut_right(ui.px(2));
        if (icon_button(ui, title.cut_right(ui.px(26)),
                        {.icon = info(action).icon,
                         .label = label,
                         .key = info(action).key,
                         .enabled = applies(action, shown)}))
            requests.ask(action);
    };
    button(Action::DeleteLayer, "Delete layer");
    button(Action::DuplicateLayer, "Duplicate layer");
    button(Action::AddGroup, "Add group");
    title.cut_right(ui.px(2));
    if (count > 0)
        search_toggle(ui, title.cut_right(ui.px(26)), "Search layers", view.layer_search);
    return requests;
}

void draw_hint(const Ui& ui, Rect rect) {
    rect = rect.inset(ui.px(12), ui.px(8));
    icon_glyph(ui, rect.cut_left(ui.px(14)), icon::kInfo, theme::kText3, 12);
    rect.cut_left(ui.px(6));
    const bool wide = rect.width() > ui.px(230);
    text(ui, rect, ui.fonts.caption11, theme::kText3,
         wide ? "Drop images or presets here to add layers" : "Drop images or presets here");
}

}  // namespace

Requests draw_layers_panel(Ui& ui, const Rect& rect, const Shown& shown, ViewState& view) {
    const Place place(ui, "Layers");
    fill(ui, rect, theme::kPanel, 6);
    Rect rest = rect;
    std::vector<Row> rows;
    if (shown.material) rows = rows_of(*shown.material, view);
    // Those that are folded away count too.
    std::vector<Row> all;
    if (shown.material) flatten(shown.material->stack, {.all = true}, view, all);
    Requests requests =
        draw_title(ui, rest.cut_top(ui.px(theme::kPanelTitle)), shown, all.size(), view);
    if (view.layer_search) name_search(ui, rest, "Search layers", *view.layer_search);
    draw_hint(ui, rest.cut_bottom(ui.px(30)));
    if (!shown.material) return requests;
    if (rows.empty()) {
        const bool searching = view.layer_search && !view.layer_search->empty();
        const std::string words = searching
                                      ? fmt::format("Nothing matches '{}'", *view.layer_search)
                                      : std::string("No layers yet. Add one or drop a preset");
        paragraph(ui, rest.inset(ui.px(12), ui.px(6)), ui.fonts.body13, theme::kText3, words);
        return requests;
    }
    ScrollArea area(ui, "layers", rest);
    Rect row_rect = area.content();
    const float top = row_rect.y0;
    const float height = ui.px(theme::kLayerRow);
    row_rect.y1 = top + height;
    for (const Row& row : rows) {
        requests.append(draw_row(ui, row_rect, row, shown, view));
        row_rect = row_rect.moved(0, height);
    }
    draw_group_lines(ui, rows, rest.x0, top);
    area.set_height(height * static_cast<float>(rows.size()));
    if (view.layer_drag.moving)
        requests.append(carry_drag(ui, rest, top, rows, shown, view));
    else if (!ImGui::IsMouseDown(ImGuiMouseButton_Left))
        view.layer_drag = {};
    return requests;
}

}  // namespace patina::editor
