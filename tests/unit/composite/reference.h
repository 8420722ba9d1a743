// SPDX-License-Identifier: MIT
#pragma once

/// The composite of one texel in double precision, written from the published definitions alone:
/// W3C Compositing and Blending, IEC 61966-2-1, "Blending in Detail", glTF 2.0. Knows nothing of
/// programs, tiles or lanes. Procedurals are left out; they have their own tests.

#include <glm/glm.hpp>

#include "composite/image_table.h"
#include "composite/maps.h"
#include "document/material.h"

namespace patina {

/// RGBA of a baked map, 0..1 before it is rounded to bytes.
glm::dvec4 reference_texel(const Material& material, const ImageTable& images, BakedMap map,
                           int size, int x, int y);

}  // namespace patina
