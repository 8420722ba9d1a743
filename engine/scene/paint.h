// SPDX-License-Identifier: MIT
#pragma once

/// Drawing on a finished picture: notes and lines over what a renderer made. Pictures are RGBA, U8
/// or U16, with straight alpha; what lies outside of them is not drawn.

#include <glm/glm.hpp>

#include "scene/image.h"

namespace patina {

/// Texels from (x0, y0) up to but without (x1, y1), row 0 at the top.
struct TexelBox {
    int x0 = 0;
    int y0 = 0;
    int x1 = 0;
    int y1 = 0;
};

/// Lays a colour over a texel.
/// @param color  encoded as the picture's colours are, and how much it covers; 0 to 1
void lay_over(Image& picture, int x, int y, const glm::vec4& color);
void lay_over(Image& picture, const TexelBox& box, const glm::vec4& color);

/// Puts a picture of the same type into another, which it has to fit into, at its top left texel.
void put(Image& picture, int x, int y, const Image& part);

}  // namespace patina
