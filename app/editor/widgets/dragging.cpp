// SPDX-License-Identifier: MIT
#include "editor/widgets/dragging.h"

#include <cmath>

#include "editor/widgets/theme.h"

namespace patina::editor {
namespace {

constexpr float kDragStart = 4.0f;  // logical pixels before a press becomes a drag

}  // namespace

bool drag_has_begun(const Ui& ui) {
    const ImVec2 moved = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, 0.0f);
    return std::hypot(moved.x, moved.y) > kDragStart * ui.scale;
}

void draw_ghost(const Ui& ui, const Picture& thumbnail, const std::string& name) {
    const ImVec2 mouse = ImGui::GetMousePos();
    const float width = text_width(ui.fonts.body13, name) + ui.px(58);
    const Rect box{mouse.x + ui.px(14), mouse.y + ui.px(8), mouse.x + ui.px(14) + width,
                   mouse.y + ui.px(48)};
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    list.AddRectFilled(ImVec2(box.x0, box.y0), ImVec2(box.x1, box.y1), theme::kPopup, ui.px(4));
    list.AddRect(ImVec2(box.x0, box.y0), ImVec2(box.x1, box.y1), theme::kBorder, ui.px(4));
    if (thumbnail.texture != nullptr)
        list.AddImageRounded(thumbnail.texture, ImVec2(box.x0 + ui.px(4), box.y0 + ui.px(4)),
                             ImVec2(box.x0 + ui.px(36), box.y0 + ui.px(36)), thumbnail.uv0,
                             thumbnail.uv1, IM_COL32_WHITE, ui.px(3));
    const ImFont* font = ui.fonts.body13;
    list.AddText(font, font->FontSize,
                 ImVec2(box.x0 + ui.px(44), box.center_y() - 0.5f * font->FontSize), theme::kText,
                 name.c_str());
}

}  // namespace patina::editor
