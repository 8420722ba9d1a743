// SPDX-License-Identifier: MIT
#pragma once

/// How a side of the view is shaded: the terms of the physically based model, and what the
/// traditional ones do not take from the material. View state: neither saved nor undone.

#include "editor/widgets/ui.h"
#include "render/view.h"

namespace patina::editor {

/// Draws them from the top of `rest`.
void term_fields(Ui& ui, Rect& rest, render::PbrTerms& terms);

/// The same for Phong and Blinn-Phong, of both sides: each number and colour is the material's
/// until its box is ticked.
void phong_fields(Ui& ui, Rect& rest, render::View& view);

}  // namespace patina::editor
