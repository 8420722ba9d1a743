// SPDX-License-Identifier: MIT
#pragma once

/// The blend modes in double precision, written from their published definitions alone (W3C
/// Compositing and Blending Level 1; "Photoshop blend modes" by PEGTOP; HSV after Smith 1978), in
/// the form in which those state them. Knows nothing of shaders/shared.

#include <glm/glm.hpp>

#include "document/blend_mode.h"

namespace patina::test_support {

/// B(cb, cs) of a mode that takes each component by itself, height modes included.
double published_blend(BlendMode mode, double cb, double cs);

/// B(Cb, Cs) of any mode of colours.
glm::dvec3 published_blend(BlendMode mode, const glm::dvec3& cb, const glm::dvec3& cs);

/// Whether the mode looks at a colour as a whole.
bool is_non_separable(BlendMode mode);

}  // namespace patina::test_support
