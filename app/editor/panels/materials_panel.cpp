// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "document/edits.h"
#include "document/stack_tree.h"
#include "editor/panels/panels.h"
#include "editor/widgets/buttons.h"
#include "editor/widgets/name_search.h"
#include "editor/widgets/number_text.h"
#include "editor/widgets/popup_menu.h"
#include "editor/widgets/text_field.h"

namespace patina::editor {
namespace {

/// How many parts of the model are drawn with the material.
std::size_t part_count(const std::vector<Part>& parts, const MaterialPtr& material) {
    return static_cast<std::size_t>(std::count_if(
        parts.begin(), parts.end(), [&](const Part& part) { return part.material == material; }));
}

Requests draw_menu(Ui& ui, const Shown& shown) {
    Requests requests;
    PopupMenu menu(ui, "materials menu");
    if (!menu.open()) return requests;
    for (const Action action : {Action::AddMaterial, Action::DuplicateMaterial,
                                Action::RenameMaterial, Action::DeleteMaterial, Action::ClearStack})
        if (menu.item({.icon = info(action).icon,
                       .label = info(action).label,
                       .enabled = applies(action, shown),
                       .tooltip = action == Action::DeleteMaterial
                                      ? "Materials of the file stay in it"
                                      : ""}))
            requests.ask(action);
    return requests;
}

std::optional<std::string> renamed(Ui& ui, const Rect& rect, const Material& material,
                                   ViewState& view) {
    if (view.renaming_material != material.id) return std::nullopt;
    bool renaming = true;
    const auto name = rename_field(ui, rect, material.name, renaming);
    if (!renaming) view.renaming_material = {};
    return name;
}

Requests draw_row(Ui& ui, const Rect& rect, const MaterialPtr& material, std::size_t part_count,
                  const Shown& shown, ViewState& view) {
    Requests requests;
    const Place place(ui, material->name, material->id.value);
    const bool selected = view.material == material->id;
    const Tip tip{material->name, "Drag it onto a part of the model to draw that with it"};
    const Press pressed = press(
        ui, rect,
        {.label = material->name, .kind = "row", .value = selected ? "selected" : "", .tip = &tip});
    row_tint(ui, rect, selected, pressed.hovered);
    const bool clicked = clicked_or_dragged(ui, pressed, {.what = material->id}, view);
    if ((clicked || pressed.right_clicked) && !selected) {
        view.material = material->id;
        view.layer = {};
    }
    if (pressed.right_clicked) ImGui::OpenPopup("materials menu");
    requests.append(draw_menu(ui, shown));
    if (pressed.double_clicked) view.renaming_material = material->id;
    Rect rest = rect.inset(ui.px(10), 0);
    const Rect ball = rest.cut_left(ui.px(30)).centered(ui.px(30), ui.px(30));
    const Picture thumbnail = shown.thumbnails->material(*material);
    if (thumbnail.texture == nullptr) disc(ui, ball.center_x(), ball.center_y(), 14, theme::kField);
    picture(ui, ball, thumbnail);
    rest.cut_left(ui.px(10));
    const ImU32 quiet = selected || pressed.hovered ? theme::kText2 : theme::kText3;
    const std::string parts = counted(part_count, "part");
    const Rect right = rest.cut_right(text_width(ui.fonts.caption11, parts) + 1);
    text(ui, right, ui.fonts.caption11, quiet, parts, Align::Right);
    rest.cut_right(ui.px(8));
    Rect lines = rest.inset(0, ui.px(4));
    const Rect name_line = lines.cut_top(ui.px(17));
    if (const auto name = renamed(ui, name_line, *material, view))
        requests.edit(rename_material(*material, *name));
    else if (view.renaming_material != material->id)
        text(ui, name_line, selected ? ui.fonts.medium13 : ui.fonts.body13, theme::kText,
             material->name);
    text(ui, lines, ui.fonts.caption11, quiet,
         fmt::format("{} \u00b7 {} px",
                     counted(static_cast<std::size_t>(layer_count(material->stack)), "layer"),
                     material->resolution));
    return requests;
}

}  // namespace

Requests draw_materials_panel(Ui& ui, const Rect& rect, const Shown& shown, ViewState& view) {
    Requests requests;
    const Place place(ui, "Materials");
    fill(ui, rect, theme::kPanel, 6);
    Rect rest = rect;
    Rect title = rest.cut_top(ui.px(theme::kPanelTitle));
    const std::size_t count = shown.document ? shown.document->materials.size() : 0;
    panel_title(ui, title, "Materials", count > 0 ? std::to_string(count) : "");
    title.cut_right(ui.px(6));
    const Rect more = title.cut_right(ui.px(26));
    title.cut_right(ui.px(2));
    if (icon_button(ui, more, {.icon = icon::kEllipsis, .label = "More for materials"}))
        ImGui::OpenPopup("materials menu");
    place_popup(more, 0);
    requests.append(draw_menu(ui, shown));
    if (icon_button(ui, title.cut_right(ui.px(26)),
                    {.icon = icon::kPlus,
                     .label = "Add material",
                     .tooltip = "Without layers yet; drag it onto a part of the model",
                     .enabled = applies(Action::AddMaterial, shown)}))
        requests.ask(Action::AddMaterial);
    title.cut_right(ui.px(2));
    if (count > 0)
        search_toggle(ui, title.cut_right(ui.px(26)), "Search materials", view.material_search);
    if (!shown.document) {
        text(ui, rest.inset(ui.px(12), ui.px(4)), ui.fonts.caption11, theme::kText3,
             "No model is open");
        return requests;
    }
    if (view.material_search) name_search(ui, rest, "Search materials", *view.material_search);
    rest.cut_bottom(ui.px(6));
    ScrollArea area(ui, "materials", rest);
    Rect row = area.content();
    row.y1 = row.y0 + ui.px(theme::kMaterialRow);
    float height = 0.0f;
    const std::vector<Part> parts = parts_of(*shown.document);
    for (const MaterialPtr& material : shown.document->materials) {
        if (view.material_search && !name_matches(material->name, *view.material_search)) continue;
        requests.append(draw_row(ui, row, material, part_count(parts, material), shown, view));
        row = row.moved(0, row.height());
        height += row.height();
    }
    area.set_height(height);
    return requests;
}

}  // namespace patina::editor
