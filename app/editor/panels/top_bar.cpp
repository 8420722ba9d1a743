// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>

#include "editor/panels/panels.h"
#include "editor/widgets/buttons.h"
#include "editor/widgets/popup_menu.h"

namespace patina::editor {
namespace {

/// Patina on copper: the mark of the program, 22 px.
void draw_mark(const Ui& ui, const Rect& rect) {
    const float x = rect.x0 + ui.px(11);
    const float y = rect.center_y();
    const float r = 10 * ui.scale;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto at = [&](float px, float py) {
        return ImVec2(x + (px - 11) * ui.scale, y + (py - 11) * ui.scale);
    };
    list.AddCircleFilled(ImVec2(x, y), r, rgb(0x2A6B60), 48);
    // The right half, bounded at the left by a flatter arc.
    list.PathArcTo(ImVec2(x, y), r, -1.5707963f, 1.5707963f, 32);
    list.PathBezierQuadraticCurveTo(at(6, 11), at(11, 1), 24);
    list.PathFillConvex(rgb(0x45BFA9));
    // The copper crescent at the upper left.
    list.PathLineTo(at(11, 1));
    list.PathBezierQuadraticCurveTo(at(3.4f, 2.4f), at(1.3f, 9.6f), 16);
    list.PathBezierQuadraticCurveTo(at(1.0f, 13.0f), at(2.4f, 16), 12);
    list.PathBezierQuadraticCurveTo(at(9.2f, 10.5f), at(11, 1), 20);
    list.PathFillConvex(rgb(0xB8744A));
}

Requests draw_menu(Ui& ui, Menu menu, const Shown& shown) {
    Requests requests;
    PopupMenu popup(ui, "menu", 230);
    if (!popup.open()) return requests;
    for (const ActionInfo& row : actions()) {
        if (row.menu != menu) continue;
        if (row.separator_before) popup.separator();
        if (popup.item({.icon = row.icon,
                        .label = row.label,
                        .key = row.key,
                        .enabled = applies(row.action, shown),
                        .ticked = row.action == Action::KeepPrevious && shown.keeps_previous}))
            requests.ask(row.action);
    }
    return requests;
}

/// Menu titles; with one open, moving over another opens that.
Requests draw_menus(Ui& ui, Rect& rest, const Shown& shown) {
    Requests requests;
    for (std::size_t i = 0; i < static_cast<std::size_t>(kBarMenuCount); ++i) {
        const std::string_view name = kMenuNames[i];
        const float width = std::ceil(text_width(ui.fonts.body13, name)) + ui.px(16);
        const Rect title = rest.cut_left(width).centered(width, ui.px(26));
        ImGui::PushID(static_cast<int>(i));
        const bool open = ImGui::IsPopupOpen("menu");
        const Press pressed = press(ui, title, {.label = name, .kind = "menu"});
        if (open || pressed.hovered) fill(ui, title, open ? theme::kFieldHover : theme::kField, 4);
        text(ui, title, ui.fonts.body13, theme::kText, name, Align::Center);
        const bool other_open =
            ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
        const ImVec2 mouse = ImGui::GetMousePos();
        const bool slid_here = !open && other_open && title.contains(mouse.x, mouse.y);
        if (pressed.clicked || pressed.started || slid_here) ImGui::OpenPopup("menu");
        place_popup(title, ui.px(2));
        requests.append(draw_menu(ui, static_cast<Menu>(i), shown));
        ImGui::PopID();
    }
    return requests;
}

void draw_document_name(Ui& ui, const Rect& bar, const Shown& shown) {
    if (!shown.document) return;
    const float name = std::min(text_width(ui.fonts.medium13, shown.file_name), ui.px(360));
    const float state = shown.edited ? text_width(ui.fonts.body13, "edited") + ui.px(8) : 0;
    const float dot = shown.edited ? ui.px(15) : 0;
    Rect rest = bar.centered(std::ceil(name + state + dot) + 2, bar.height());
    note(ui, rest, {.label = "Document", .kind = "label", .value = shown.file_name});
    if (shown.edited) {
        const Rect mark = rest.cut_left(dot);
        disc(ui, mark.x0 + ui.px(4), mark.center_y(), 3.5f, theme::kWarning);
    }
    text(ui, rest.cut_left(std::ceil(name) + 1), ui.fonts.medium13, theme::kText, shown.file_name);
    rest.cut_left(ui.px(8));
    if (shown.edited) text(ui, rest, ui.fonts.body13, theme::kText3, "edited");
}

bool draw_find_field(Ui& ui, const Rect& rect) {
    const Press pressed = press(ui, rect, {.label = "Find an action", .kind = "button"});
    fill(ui, rect, pressed.hovered ? theme::kFieldHover : theme::kSearchField, 4);
    Rect rest = rect.inset(ui.px(8), 0);
    icon_glyph(ui, rest.cut_left(ui.px(16)), icon::kSearch, theme::kText3, 12);
    rest.cut_left(ui.px(6));
    const float chip = text_width(ui.fonts.caption11, "Ctrl K") + ui.px(8);
    key_chip(ui, rest.cut_right(chip), "Ctrl K");
    text(ui, rest, ui.fonts.body13, theme::kText3, "Find an action");
    return pressed.clicked;
}

bool action_button(Ui& ui, const Rect& rect, Action action, std::string_view label,
                   const Shown& shown) {
    const ActionInfo& row = info(action);
    return icon_button(
        ui, rect,
        {.icon = row.icon, .label = label, .key = row.key, .enabled = applies(action, shown)});
}

}  // namespace

Requests draw_top_bar(Ui& ui, const Rect& rect, const Shown& shown, ViewState&) {
    const Place place(ui, "Top bar");
    fill(ui, rect, theme::kBar);
    draw_document_name(ui, rect, shown);
    Rect rest = rect;
    rest.cut_left(ui.px(12));
    rest.cut_right(ui.px(8));
    draw_mark(ui, rest.cut_left(ui.px(22)));
    rest.cut_left(ui.px(6));
    Requests requests = draw_menus(ui, rest, shown);
    const Rect line_box = rest.cut_left(ui.px(17)).centered(ui.px(1), ui.px(16));
    fill(ui, line_box, theme::kBorder);
    if (action_button(ui, rest.cut_left(ui.px(26)), Action::Undo, "Undo", shown))
        requests.ask(Action::Undo);
    if (action_button(ui, rest.cut_left(ui.px(26)), Action::Redo, "Redo", shown))
        requests.ask(Action::Redo);

    const TextButton export_button{.label = "Export",
                                   .icon = icon::kExport,
                                   .tooltip = "Write the baked maps as files",
                                   .key = "Ctrl E",
                                   .main = true,
                                   .enabled = shown.document != nullptr};
    const TextButton save_button{.label = "Save",
                                 .icon = icon::kSave,
                                 .tooltip = "Bake and write the glTF file",
                                 .key = "Ctrl S",
                                 .enabled = shown.document != nullptr};
    const auto cut_button = [&](const TextButton& button) {
        const float width = text_button_width(ui, button);
        return rest.cut_right(width).centered(width, ui.px(26));
    };
    if (text_button(ui, cut_button(export_button), export_button)) requests.ask(Action::Export);
    rest.cut_right(ui.px(6));
    if (text_button(ui, cut_button(save_button), save_button)) requests.ask(Action::Save);
    rest.cut_right(ui.px(6));
    const bool wide = rect.width() / ui.scale >= 1600;
    const float find = ui.px(wide ? 220 : 26);
    const Rect find_box = rest.cut_right(find).centered(find, ui.px(26));
    if (wide ? draw_find_field(ui, find_box)
             : icon_button(ui, find_box,
                           {.icon = icon::kSearch, .label = "Find an action", .key = "Ctrl K"}))
        requests.ask(Action::FindAction);
    return requests;
}

}  // namespace patina::editor
