// SPDX-License-Identifier: MIT
#pragma once

/// Where a source lies on the model: projection, UV set and transform. Several sources that lie
/// alike can be moved in one.

#include <optional>
#include <vector>

#include "document/source_edits.h"
#include "editor/state/requests.h"
#include "editor/widgets/ui.h"

namespace patina::editor {

struct PlacedSource {
    SourcePlace place;
    const Source* source = nullptr;  ///< an image or a procedural
};

/// The transform of an image or a procedural; null for other kinds.
const UvTransform* transform_of(const Source& source);

/// Whether two sources have equal projections, UV sets and transforms, as far as they have them.
bool lie_alike(const Source& a, const Source& b);

/// Which of the model's UV sets; a newly chosen one.
/// @param parameter  that names and explains it
std::optional<int> uv_set_combo(Ui& ui, const Rect& rect, Parameter parameter, int uv_set);

/// The projection, cut off the top of `rest`. What is shown is the first one's.
/// @param sources  one or more, all changed together
Requests draw_projection(Ui& ui, Rect& rest, const std::vector<PlacedSource>& sources);

/// UV set (of images), scale, offset and rotation, likewise.
/// @param scales_linked  both scales change together; switched here
Requests draw_transform(Ui& ui, Rect& rest, const std::vector<PlacedSource>& sources,
                        bool& scales_linked);

/// Puts the transforms back to none.
Edit reset_transform(const std::vector<PlacedSource>& sources);

}  // namespace patina::editor
