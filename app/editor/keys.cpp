// SPDX-License-Identifier: MIT
#include "editor/keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <array>

namespace patina::editor {
namespace {

struct Binding {
    int key;  ///< of GLFW, as its back end hands them to Dear ImGui
    bool control;
    bool shift;
    bool alt;
    Action action;
};

constexpr std::array kBindings = {
    Binding{GLFW_KEY_O, true, false, false, Action::Open},
    Binding{GLFW_KEY_S, true, false, false, Action::Save},
    Binding{GLFW_KEY_S, true, true, false, Action::SaveAs},
    Binding{GLFW_KEY_E, true, false, false, Action::Export},
    Binding{GLFW_KEY_Q, true, false, false, Action::Quit},
    Binding{GLFW_KEY_Z, true, false, false, Action::Undo},
    Binding{GLFW_KEY_Z, true, true, false, Action::Redo},
    Binding{GLFW_KEY_Y, true, false, false, Action::Redo},
    Binding{GLFW_KEY_C, true, false, false, Action::Copy},
    Binding{GLFW_KEY_V, true, false, false, Action::Paste},
    Binding{GLFW_KEY_K, true, false, false, Action::FindAction},
    Binding{GLFW_KEY_D, true, false, false, Action::DuplicateLayer},
    Binding{GLFW_KEY_G, true, false, false, Action::GroupLayer},
    Binding{GLFW_KEY_G, true, true, false, Action::UngroupLayer},
    Binding{GLFW_KEY_F2, false, false, false, Action::RenameLayer},
    Binding{GLFW_KEY_DELETE, false, false, false, Action::DeleteLayer},
    Binding{GLFW_KEY_H, false, false, false, Action::HideLayer},
    Binding{GLFW_KEY_UP, false, false, true, Action::MoveLayerUp},
    Binding{GLFW_KEY_DOWN, false, false, true, Action::MoveLayerDown},
    Binding{GLFW_KEY_UP, false, false, false, Action::SelectLayerAbove},
    Binding{GLFW_KEY_DOWN, false, false, false, Action::SelectLayerBelow},
    Binding{GLFW_KEY_V, false, false, false, Action::NextCompareMode},
    Binding{GLFW_KEY_X, false, false, false, Action::SwapSides},
    Binding{GLFW_KEY_P, false, false, false, Action::ShadePbr},
    Binding{GLFW_KEY_O, false, false, false, Action::ShadePhong},
    Binding{GLFW_KEY_C, false, false, false, Action::NextChannel},
    Binding{GLFW_KEY_C, false, true, false, Action::PreviousChannel},
    Binding{GLFW_KEY_RIGHT_BRACKET, false, false, false, Action::BrighterExposure},
    Binding{GLFW_KEY_LEFT_BRACKET, false, false, false, Action::DarkerExposure},
    Binding{GLFW_KEY_F, false, false, false, Action::FrameModel},
    Binding{GLFW_KEY_F, false, true, false, Action::FrameMaterial},
    Binding{GLFW_KEY_I, false, false, false, Action::ProbeTool},
    Binding{GLFW_KEY_U, false, false, false, Action::ShowUv},
    Binding{GLFW_KEY_W, false, false, false, Action::ShowWires},
    Binding{GLFW_KEY_F10, false, false, false, Action::HidePanels},
    Binding{GLFW_KEY_F1, false, false, false, Action::Keys},
    Binding{GLFW_KEY_EQUAL, true, false, false, Action::LargerInterface},
    Binding{GLFW_KEY_KP_ADD, true, false, false, Action::LargerInterface},
    Binding{GLFW_KEY_MINUS, true, false, false, Action::SmallerInterface},
    Binding{GLFW_KEY_KP_SUBTRACT, true, false, false, Action::SmallerInterface},
};

}  // namespace

std::optional<Action> pressed_action(const Focus& focus) {
    const ImGuiIO& io = ImGui::GetIO();
    for (const Binding& binding : kBindings)
        if (io.KeyCtrl == binding.control && io.KeyShift == binding.shift &&
            io.KeyAlt == binding.alt && ImGui::IsKeyPressed(binding.key) &&
            !focus.is_taken(binding.key))
            return binding.action;
    return std::nullopt;
}

std::optional<render::ChannelView> pressed_channel() {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyCtrl || io.KeyAlt || io.KeyShift) return std::nullopt;
    for (int digit = 0; digit < render::kStripChannelCount; ++digit)
        if (ImGui::IsKeyPressed(GLFW_KEY_0 + digit, false) ||
            ImGui::IsKeyPressed(GLFW_KEY_KP_0 + digit, false))
            return static_cast<render::ChannelView>(digit);
    return std::nullopt;
}

int pressed_divider_step(const Focus& focus) {
    const auto pressed = [&focus](int key) {
        return ImGui::IsKeyPressed(key) && !focus.is_taken(key) ? 1 : 0;
    };
    return pressed(GLFW_KEY_RIGHT) - pressed(GLFW_KEY_LEFT);
}

bool pressed_escape() {
    return ImGui::IsKeyPressed(GLFW_KEY_ESCAPE);
}

}  // namespace patina::editor
