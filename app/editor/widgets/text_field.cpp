// SPDX-License-Identifier: MIT
#include "editor/widgets/text_field.h"

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <utility>

namespace patina::editor {
namespace {

constexpr double kCaretSeconds = 0.4;  // it blinks

/// Whether the keyboard came to a text field that is not being typed into and pressed Enter there.
bool entered_by_keyboard(Ui& ui, std::string_view label, const Rect& rect) {
    const ImGuiID id = ImGui::GetCurrentWindow()->GetID(label.data(), label.data() + label.size());
    if (!ui.focus.visit(id, rect)) return false;
    ui.focus.drawn_at(visible_part(rect));
    return ui.focus.pressed();
}

/// An InputText that sits in the middle of `rect` with the given font and no frame of its own.
class BareInput {
  public:
    BareInput(Ui& ui, const Rect& rect, const ImFont* font, float padding) : ui_(ui) {
        ImGui::PushFont(const_cast<ImFont*>(font));
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                            ImVec2(padding, 0.5f * (rect.height() - font->FontSize)));
        for (const ImGuiCol color :
             {ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive})
            ImGui::PushStyleColor(color, IM_COL32(0, 0, 0, 0));
        ImGui::PushStyleColor(ImGuiCol_TextDisabled, theme::kText3);
        ImGui::SetCursorScreenPos(ImVec2(rect.x0, rect.y0));
        ImGui::SetNextItemWidth(rect.width());
    }
    ~BareInput() {
        if (ImGui::IsItemActive()) ui_.wake_in(kCaretSeconds);
        ImGui::PopStyleColor(4);
        ImGui::PopStyleVar();
        ImGui::PopFont();
    }
    BareInput(const BareInput&) = delete;
    BareInput& operator=(const BareInput&) = delete;

  private:
    Ui& ui_;
};

}  // namespace

void start_typing(Ui& ui, ImGuiID id, std::string text) {
    ui.typing = {.id = id, .text = std::move(text), .fresh = true};
    ui.wake_in(0.0);
}

std::optional<std::string> typed(Ui& ui, ImGuiID id, const Rect& rect, const ImFont* font) {
    if (ui.typing.id != id) return std::nullopt;
    outline(ui, rect, theme::kAccent, 4, 1);
    const BareInput input(ui, rect, font, ui.px(8));
    if (ui.typing.fresh) ImGui::SetKeyboardFocusHere();
    ImGui::PushID(static_cast<int>(id));
    const bool entered =
        ImGui::InputText("##typed", &ui.typing.text,
                         ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    const bool was_fresh = std::exchange(ui.typing.fresh, false);
    const bool ended = !was_fresh && ImGui::IsItemDeactivated();
    const bool escaped = ended && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    ImGui::PopID();
    if (!entered && !ended) return std::nullopt;
    ui.typing.id = 0;
    if (escaped) return std::nullopt;
    return ui.typing.text;
}

std::optional<std::string> rename_field(Ui& ui, const Rect& rect, const std::string& name,
                                        bool& renaming) {
    const ImGuiID id = ImGui::GetID("rename");
    if (ui.typing.id != id) start_typing(ui, id, name);
    fill(ui, rect, theme::kFieldHover, 4);
    std::optional<std::string> words = typed(ui, id, rect, ui.fonts.body13);
    renaming = ui.typing.id != 0;
    if (words && words->empty()) words.reset();
    return words;
}

bool search_field(Ui& ui, const Rect& rect, const SearchField& field, std::string& words) {
    fill(ui, rect, field.color, 4);
    ui.map.add(field.label, "search", words, visible_part(rect), true);
    Rect rest = rect;
    rest.cut_left(ui.px(8));
    icon_glyph(ui, rest.cut_left(ui.px(16)), icon::kSearch, theme::kText3, 12);
    const BareInput input(ui, rest, ui.fonts.body13, ui.px(6));
    const std::string id = "##" + std::string(field.label);
    if (entered_by_keyboard(ui, field.label, rect) || field.focus) ImGui::SetKeyboardFocusHere();
    return ImGui::InputTextWithHint(id.c_str(), std::string(field.hint).c_str(), &words);
}

bool line_field(Ui& ui, const Rect& rect, std::string_view label, std::string& words, bool focus) {
    fill(ui, rect, theme::kField, 4);
    ui.map.add(label, "text", words, visible_part(rect), true);
    const BareInput input(ui, rect, ui.fonts.body13, ui.px(8));
    const std::string id = "##" + std::string(label);
    if (entered_by_keyboard(ui, label, rect) || focus) ImGui::SetKeyboardFocusHere();
    const bool entered = ImGui::InputText(id.c_str(), &words, ImGuiInputTextFlags_EnterReturnsTrue);
    if (ImGui::IsItemActive()) outline(ui, rect, theme::kAccent, 4, 1);
    return entered;
}

}  // namespace patina::editor
