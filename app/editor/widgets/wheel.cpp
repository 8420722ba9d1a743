// SPDX-License-Identifier: MIT
#include "editor/widgets/wheel.h"

#include <imgui_internal.h>

namespace patina::editor {

int ctrl_wheel_step(const Press& pressed) {
    const ImGuiIO& io = ImGui::GetIO();
    if (!pressed.hovered || !io.KeyCtrl) return 0;
    // Dear ImGui scrolls before controls are drawn: it goes by what the frame before said.
    ImGui::GetCurrentContext()->HoveredIdUsingMouseWheel = true;
    if (io.MouseWheel == 0.0f) return 0;
    return io.MouseWheel > 0.0f ? 1 : -1;
}

}  // namespace patina::editor
