// SPDX-License-Identifier: MIT
#include "editor/dialogs/modal.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace patina::editor {

Modal::Modal(Ui& ui, const Description& description, std::function<bool()> still_open)
    : ui_(ui), still_open_(std::move(still_open)) {
    const char* name = description.name;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float w = std::min(ui.px(description.width), screen.x - ui.px(24));
    const float h = std::min(ui.px(description.height), screen.y - ui.px(24));
    const float x = std::floor(0.5f * (screen.x - w));
    const float y = std::floor(description.top_share < 0.0f ? 0.5f * (screen.y - h)
                                                            : description.top_share * screen.y);
    ImGui::SetNextWindowPos(ImVec2(x, y));
    ImGui::SetNextWindowSize(ImVec2(w, h));
    ImGui::PushStyleColor(ImGuiCol_PopupBg, theme::kPopup);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.px(6));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0f);
    // Dear ImGui would dim what is behind over many frames; nothing here animates.
    ImGui::GetCurrentContext()->DimBgRatio = 1.0f;
    if (!ImGui::IsPopupOpen(name)) ImGui::OpenPopup(name);
    ImGui::BeginPopupModal(name, nullptr,
                           ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                               ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav);
    ui.map.push_place(name);
    content_ = {x, y, x + w, y + h};
}

Modal::~Modal() {
    ui_.map.pop_place();
    // Dear ImGui keeps a popup that is no longer drawn in its list of open ones.
    if (!still_open_()) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor();
}

bool Modal::dismissed() const {
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
}

bool dialog_button(Ui& ui, Rect& row, const TextButton& button) {
    const bool clicked = text_button(ui, row.cut_right(text_button_width(ui, button)), button);
    row.cut_right(ui.px(6));
    return clicked;
}

}  // namespace patina::editor
