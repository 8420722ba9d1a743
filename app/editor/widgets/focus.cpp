// SPDX-License-Identifier: MIT
#include "editor/widgets/focus.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "editor/widgets/theme.h"

namespace patina::editor {
namespace {

bool key(ImGuiKey which) {
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(which));
}

/// The popup that is on top, or null.
ImGuiWindow* top_popup() {
    const ImVector<ImGuiPopupData>& open = ImGui::GetCurrentContext()->OpenPopupStack;
    return open.empty() ? nullptr : open.back().Window;
}

}  // namespace

void Focus::read_keys() {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantTextInput || io.KeyAlt || io.KeyCtrl) return;
    const ImGuiWindow* popup = top_popup();
    const bool menu = popup != nullptr && (popup->Flags & ImGuiWindowFlags_Modal) == 0;
    if (key(ImGuiKey_Tab)) step_ = io.KeyShift ? -1 : 1;
    // In a menu the arrows go from row to row.
    if (menu && key(ImGuiKey_DownArrow)) step_ = 1;
    if (menu && key(ImGuiKey_UpArrow)) step_ = -1;
    if (step_ != 0) {
        if (!shown_ && menu) id_ = 0;
        shown_ = true;
        return;
    }
    if (!is_shown()) return;
    pressed_ = key(ImGuiKey_Enter) || key(ImGuiKey_KeyPadEnter) || key(ImGuiKey_Space);
    arrow_step_ = (key(ImGuiKey_RightArrow) ? 1 : 0) - (key(ImGuiKey_LeftArrow) ? 1 : 0);
    row_step_ = (key(ImGuiKey_DownArrow) ? 1 : 0) - (key(ImGuiKey_UpArrow) ? 1 : 0);
}

void Focus::take(std::initializer_list<ImGuiKey> keys) {
    for (const ImGuiKey each : keys) taken_keys_.push_back(ImGui::GetKeyIndex(each));
}

bool Focus::is_taken(int key) const {
    return std::find(taken_keys_.begin(), taken_keys_.end(), key) != taken_keys_.end();
}

/// A popup that opened takes the focus to its first row, one that closed gives it back.
void Focus::follow_popups() {
    const auto depth = static_cast<std::size_t>(ImGui::GetCurrentContext()->OpenPopupStack.size());
    while (openers_.size() < depth) {
        openers_.push_back(id_);
        id_ = 0;
    }
    while (openers_.size() > depth) {
        id_ = openers_.back();
        openers_.pop_back();
    }
}

void Focus::begin_frame() {
    pressed_ = false;
    arrow_step_ = 0;
    row_step_ = 0;
    taken_keys_.clear();
    step_ = 0;
    take_next_ = false;
    seen_ = false;
    first_ = 0;
    previous_ = 0;
    outline_ = {};
    follow_popups();
    if (ImGui::IsAnyMouseDown()) shown_ = false;
    read_keys();
}

bool Focus::is_reachable() const {
    const ImGuiWindow* popup = top_popup();
    return popup == nullptr || ImGui::GetCurrentWindow()->RootWindow == popup;
}

bool Focus::visit(ImGuiID id, const Rect& rect) {
    if (!is_reachable()) return false;
    if (first_ == 0) first_ = id;
    if (take_next_) {
        take_next_ = false;
        step_ = 0;
        id_ = id;
        reveal_ = true;
    } else if (id == id_ && step_ > 0) {
        take_next_ = true;
    } else if (id == id_ && step_ < 0 && previous_ != 0) {
        id_ = previous_;
        step_ = 0;
        reveal_ = true;
    }
    previous_ = id;
    if (id != id_) return false;
    seen_ = true;
    if (!is_shown()) return false;
    if (reveal_ && step_ == 0) {
        reveal_ = false;
        const ImRect box(rect.x0, rect.y0, rect.x1, rect.y1);
        if (ImGui::GetCurrentWindow()->ScrollMax.y > 0.0f)
            ImGui::ScrollToBringRectIntoView(ImGui::GetCurrentWindow(), box);
    }
    return true;
}

void Focus::end_frame(float scale) {
    // Past the last comes the first, before the first the last; from nowhere the first.
    if (take_next_ || (step_ > 0 && !seen_)) id_ = first_;
    if (step_ < 0 && !take_next_) id_ = previous_;
    if (take_next_ || step_ != 0) reveal_ = true;
    if (!is_shown() || outline_.empty()) return;
    const float thickness = std::max(1.0f, std::round(2.0f * scale));
    const Rect around = outline_.inset(-std::round(scale));
    ImGui::GetForegroundDrawList()->AddRect(ImVec2(around.x0, around.y0),
                                            ImVec2(around.x1, around.y1), theme::kAccent,
                                            4.0f * scale, 0, thickness);
}

}  // namespace patina::editor
