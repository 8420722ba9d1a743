// SPDX-License-Identifier: MIT
#pragma once

/// What whoever bakes a material should be told of it: it is no fault, but may not be meant.

#include <string>
#include <vector>

#include "document/document.h"
#include "scene/uv_surface.h"

namespace patina {

/// One line each, with the material's name: what its layers read of the model and is not there
/// (missing_of_surface), opacity that its alpha mode does not show.
/// @param last  as in worn_surface
std::vector<std::string> warnings_of(const Document& document, const Material& material,
                                     const UvSurfacePtr& last = nullptr);

}  // namespace patina
