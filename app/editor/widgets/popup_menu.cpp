// SPDX-License-Identifier: MIT
#include "editor/widgets/popup_menu.h"

#include <imgui_internal.h>

#include <algorithm>

namespace patina::editor {

PopupMenu::PopupMenu(Ui& ui, const char* id, float min_width) : ui_(ui) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, ui.px(4)));
    ImGui::SetNextWindowSizeConstraints(ImVec2(ui.px(min_width), 0),
                                        ImVec2(ui.px(520), ImGui::GetIO().DisplaySize.y * 0.8f));
    open_ = ImGui::BeginPopup(id, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav);
    if (!open_) {
        ImGui::PopStyleVar();
        return;
    }
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
    ui.map.push_place("Popup");
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) ImGui::CloseCurrentPopup();
    // Wide enough for the widest row of the frame before.
    width_ = std::max(ui.px(min_width), ImGui::GetStateStorage()->GetFloat(ImGui::GetID("width")));
    ImGui::GetStateStorage()->SetFloat(ImGui::GetID("width"), 0.0f);
}

PopupMenu::~PopupMenu() {
    if (!open_) return;
    if (ImGui::GetStateStorage()->GetFloat(ImGui::GetID("width")) > width_) ui_.wake_in(0.0);
    ui_.map.pop_place();
    ImGui::PopStyleVar();
    ImGui::EndPopup();
    ImGui::PopStyleVar();
}

Rect PopupMenu::next_row(float height) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::Dummy(ImVec2(width_, height));
    return {at.x, at.y, at.x + width_, at.y + height};
}

bool PopupMenu::item(const MenuItem& item) {
    const float key_width =
        item.key.empty() ? 0.0f : text_width(ui_.fonts.caption11, item.key) + ui_.px(24);
    const float wanted =
        text_width(ui_.fonts.body13, item.label) + key_width + ui_.px(12 + 22 + 16);
    float& widest = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("width"));
    widest = std::max(widest, wanted);
    const Rect row = next_row(ui_.px(26));
    const Tip tip{std::string(item.label), std::string(item.tooltip), std::string(item.key)};
    const Press pressed = press(ui_, row,
                                {.label = item.label,
                                 .kind = "item",
                                 .value = item.ticked ? "on" : "",
                                 .enabled = item.enabled,
                                 .tip = item.tooltip.empty() ? nullptr : &tip});
    if (pressed.hovered) fill(ui_, row.inset(ui_.px(4), 0), theme::kFieldHover, 4);
    const Faded faded(ui_, !item.enabled);
    Rect rest = row.inset(ui_.px(12), 0);
    const Rect glyph = rest.cut_left(ui_.px(22));
    const char* shape = item.ticked ? icon::kCheck : item.icon;
    if (shape != nullptr)
        icon_glyph(ui_, {glyph.x0, glyph.y0, glyph.x0 + ui_.px(16), glyph.y1}, shape,
                   item.ticked ? theme::kAccentHigh : theme::kText2, 13);
    if (!item.key.empty())
        text(ui_, rest, ui_.fonts.caption11, theme::kText3, item.key, Align::Right);
    text(ui_, rest, ui_.fonts.body13, theme::kText, item.label);
    if (!pressed.clicked) return false;
    ImGui::CloseCurrentPopup();
    return true;
}

void PopupMenu::heading(std::string_view words) {
    const Rect row = next_row(ui_.px(22));
    text(ui_, row.inset(ui_.px(12), 0), ui_.fonts.caption11, theme::kText3, words);
}

void PopupMenu::separator() {
    const Rect row = next_row(ui_.px(9));
    hairline(ui_, {row.x0, row.y0 + ui_.px(4), row.x1, row.y1}, theme::kFieldHover);
}

Rect PopupMenu::field_row() {
    const Rect row = next_row(ui_.px(theme::kFieldHeight + 8));
    return row.inset(ui_.px(8), ui_.px(4));
}

void place_popup(const Rect& anchor, float gap) {
    ImGui::SetNextWindowPos(ImVec2(anchor.x0, anchor.y1 + gap), ImGuiCond_Appearing);
}

}  // namespace patina::editor
