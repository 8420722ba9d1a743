// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "editor/state/actions.h"
#include "editor/widgets/focus.h"
#include "render/channel_view.h"

namespace patina::editor {

/// The action whose keys were pressed in this frame, unless a control has taken them.
std::optional<Action> pressed_action(const Focus& focus);
/// The channel whose digit was pressed: 0 the picture, 1 to 9 the others of the strip.
std::optional<render::ChannelView> pressed_channel();
/// -1, 0 or 1: the arrow keys that move the divider.
int pressed_divider_step(const Focus& focus);
bool pressed_escape();

}  // namespace patina::editor
