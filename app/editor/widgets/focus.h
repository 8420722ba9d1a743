// SPDX-License-Identifier: MIT
#pragma once

/// Which control the keyboard is at. Tab and Shift-Tab go through the controls in the order in
/// which they are drawn, Enter and Space press, the arrows move sliders; the outline shows while
/// the keyboard is used and goes with the first press of a mouse button. In a menu or a dialog only
/// its own controls are gone through, and closing it leads back to where it was opened.

#include <imgui.h>

#include <initializer_list>
#include <vector>

#include "editor/widgets/rect.h"

namespace patina::editor {

class Focus {
  public:
    void begin_frame();
    /// Reports a control that can be pressed, in the order of drawing. True when it has the focus.
    bool visit(ImGuiID id, const Rect& rect);
    /// The focused control was drawn here: what of it can be seen.
    void drawn_at(const Rect& visible) { outline_ = visible; }
    /// Enter or Space, for the control that has the focus.
    bool pressed() const { return pressed_; }
    /// -1, 0 or 1: Left or Right (Down or Up), for the control that has the focus.
    int arrow_step() const { return arrow_step_; }
    /// -1, 0 or 1: Up or Down, likewise.
    int row_step() const { return row_step_; }
    /// A control takes keys: they do nothing else in this frame.
    void take(std::initializer_list<ImGuiKey> keys);
    /// @param key  as Dear ImGui's back end numbers them
    bool is_taken(int key) const;
    bool is_shown() const { return shown_ && id_ != 0; }
    /// Takes the focus away.
    void leave() { shown_ = false; }
    /// Draws the outline above everything.
    void end_frame(float scale);

  private:
    void read_keys();
    bool is_reachable() const;
    void follow_popups();

    ImGuiID id_ = 0;
    bool shown_ = false;
    bool pressed_ = false;
    int arrow_step_ = 0;
    int row_step_ = 0;
    std::vector<int> taken_keys_;
    int step_ = 0;  ///< of Tab in this frame, done when the next or the one before is known
    bool take_next_ = false;
    bool reveal_ = false;  ///< the focus has moved: scroll to it
    bool seen_ = false;    ///< the focused control was visited in this frame
    ImGuiID first_ = 0;
    ImGuiID previous_ = 0;
    Rect outline_;
    std::vector<ImGuiID> openers_;  ///< what had the focus when each open popup came
};

}  // namespace patina::editor
