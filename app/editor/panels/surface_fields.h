// SPDX-License-Identifier: MIT
#pragma once

/// Controls of what sources read of the model.

#include <string>
#include <vector>

#include "document/edits.h"
#include "editor/state/requests.h"
#include "editor/state/shown.h"

namespace patina::editor {

/// The names of the parts of the model that wear the material.
std::vector<std::string> worn_parts(const Document& document, MaterialId material);

/// Boxes to tick: the parts that wear the material, the materials that the file gave them where
/// these differ, and all else that is picked.
Requests draw_geometry(Ui& ui, Rect& rest, const SourcePlace& place, const GeometrySource& now,
                       const Shown& shown);

}  // namespace patina::editor
