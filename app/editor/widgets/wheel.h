// SPDX-License-Identifier: MIT
#pragma once

#include "editor/widgets/ui.h"

namespace patina::editor {

/// -1, 0 or 1: where Ctrl and the wheel over a control lead, up being 1. With Ctrl down what is
/// around the control does not scroll.
int ctrl_wheel_step(const Press& pressed);

}  // namespace patina::editor
