// SPDX-License-Identifier: MIT
#pragma once

/// Baked maps filled past the borders of UV islands.

#include "composite/composite.h"
#include "scene/uv_map.h"

namespace patina {

/// The surface whose islands the baked maps of a material are to be dilated by; null where they
/// hold what the layers make everywhere.
/// @param program  of the material; the surface that it reads is shared
UvSurfacePtr dilated_by(const Document& document, const Material& material, const Program& program);

/// Gives each texel that no triangle touches what the nearest touched one has; those that are
/// touched stay as they are. Maps of another size than `surface` has a map for are left alone.
void dilate(const UvSurface& surface, MapSet& maps);
/// Of a square map, whatever its texels are.
void dilate(const UvSurface& surface, Image& image);

}  // namespace patina
