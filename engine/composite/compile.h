// SPDX-License-Identifier: MIT
#pragma once

/// From a material to the operations that composite it.

#include "composite/operations.h"
#include "composite/stack_terms.h"

namespace patina {

/// @param surface  what sources read of the model; null where no mesh is at hand
/// @param covered  whether layers that another one hides are kept, as `explain` wants to see them;
///                 the result is the same
ProgramData compile_material(const Material& material, const UvSurfacePtr& surface,
                             CoveredLayers covered);

}  // namespace patina
