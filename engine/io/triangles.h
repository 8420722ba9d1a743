// SPDX-License-Identifier: MIT
#pragma once

/// Strips and fans as lists of triangles.

#include <cstdint>
#include <vector>

#include "io/gltf_model.h"

namespace patina::io {

/// Three corners a triangle, in the order of glTF 2.0 section 3.7.2.1, counter-clockwise kept.
/// Corners that complete no triangle are dropped, and so is every triangle with a corner twice.
/// @param mode  TINYGLTF_MODE_TRIANGLES, _TRIANGLE_STRIP or _TRIANGLE_FAN
std::vector<std::uint32_t> triangle_list(int mode, std::vector<std::uint32_t> corners);

}  // namespace patina::io
