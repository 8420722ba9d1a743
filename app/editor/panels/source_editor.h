// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "document/edits.h"
#include "editor/state/requests.h"
#include "editor/state/shown.h"

namespace patina::editor {

/// What feeds a channel of a layer or a mask entry, and where it is.
struct EditedSource {
    const SourcePlace& place;
    const Source& source;
    std::optional<Channel> channel;  ///< unset: a mask
    LayerId layer;
    MaskEntryId entry;  ///< of a mask
};

/// Kind (value, image, procedural, relief, layer) and all that this kind has, cut off the top of
/// `rest`.
Requests draw_source_editor(Ui& ui, Rect& rest, const EditedSource& edited, const Shown& shown);

/// The value of a constant as one field: a colour, a number, or a direction.
Requests draw_constant(Ui& ui, const Rect& rect, const EditedSource& edited, bool with_label);

/// In words: "#61766F", "0.82", "crust.png", "Perlin noise".
std::string source_name(const Source& source, std::optional<Channel> channel,
                        const Document& document);

}  // namespace patina::editor
