// SPDX-License-Identifier: MIT
#pragma once

#include "editor/panels/source_editor.h"

namespace patina::editor {

/// What an image's numbers are multiplied by, and what is added to them. Of normals only how strong
/// they are; a height is stretched about the level that is the surface.
Requests draw_image_range(Ui& ui, Rect& rest, const EditedSource& edited,
                          const ImageSource& source);

}  // namespace patina::editor
