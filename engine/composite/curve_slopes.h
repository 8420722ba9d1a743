// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "document/adjustment.h"

namespace patina {

/// The slope of a curve at each of its points, so that cubic pieces between them neither overshoot
/// nor turn back where the points do not.
/// F. N. Fritsch and J. Butland, "A method for constructing local monotone piecewise cubic
/// interpolants", SIAM J. Sci. Stat. Comput. 5, 1984.
/// @param points  two or more, x strictly ascending
std::vector<float> curve_slopes(const std::vector<CurvePoint>& points);

}  // namespace patina
