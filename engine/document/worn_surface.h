// SPDX-License-Identifier: MIT
#pragma once

/// The surface that a material lies on in the document: what its layers can read of the model.

#include <optional>
#include <string>
#include <vector>

#include "document/document.h"
#include "scene/uv_surface.h"

namespace patina {

/// All parts that are drawn with the material, in the order of the scene; none for a document
/// without a scene. Never null.
/// @param last  what was returned before: given back where it still is that
UvSurfacePtr worn_surface(const Document& document, const Material& material,
                          const UvSurfacePtr& last = nullptr);

/// The same where a source of the stack reads it, else null.
UvSurfacePtr surface_read(const Document& document, const Material& material,
                          const UvSurfacePtr& last = nullptr);

/// The projection of an image or procedural; unset of what follows the UVs, and of other kinds.
std::optional<Projection> projection_of(const Source& source);

/// Whether a source of the stack, on or off, reads the model.
bool reads_surface(const Material& material);

/// What of it is not there, one line each: no part with UVs, names that no part has.
std::vector<std::string> missing_of_surface(const Material& material, const UvSurface& surface);

}  // namespace patina
