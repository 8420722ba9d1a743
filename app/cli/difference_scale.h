// SPDX-License-Identifier: MIT
#pragma once

#include "cli/lettering.h"

namespace patina::cli {

/// Writes into the lower left corner of a heat map what its colours stand for.
/// @param range  the difference of luminance that the brightest one does
void draw_difference_scale(Image& picture, float range, const Lettering& lettering);

}  // namespace patina::cli
