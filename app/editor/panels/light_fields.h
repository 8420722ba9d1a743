// SPDX-License-Identifier: MIT
#pragma once

/// Where a lamp stands, where it shines and how large it is: the fields that its kind has.

#include "editor/widgets/ui.h"
#include "scene/scene.h"

namespace patina::editor {

/// Draws them from the top of `rest`, and returns the lamp as they leave it.
Light light_fields(Ui& ui, Rect& rest, const Light& light);

}  // namespace patina::editor
