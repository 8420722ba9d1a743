// SPDX-License-Identifier: MIT
#pragma once

/// Inter in the sizes of the interface, with the icons of Font Awesome merged into each. Sizes are
/// named by the height of the letters' em in logical pixels.

#include <imgui.h>

#include "core/result.h"

namespace patina::editor {

struct Fonts {
    ImFont* name15 = nullptr;    ///< semibold: names of what is shown
    ImFont* title13 = nullptr;   ///< semibold
    ImFont* medium13 = nullptr;  ///< what is selected
    ImFont* body13 = nullptr;
    ImFont* value12 = nullptr;
    ImFont* medium12 = nullptr;
    ImFont* caption11 = nullptr;  ///< the least
    ImFont* medium11 = nullptr;
};

/// Replaces the fonts of the current ImGui context by those for `scale` (1 to 2.5). The back end
/// has to upload the texture again afterwards.
Result<Fonts> load_fonts(float scale);

}  // namespace patina::editor
