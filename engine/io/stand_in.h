// SPDX-License-Identifier: MIT
#pragma once

/// Primitives that lack the UV set which a material's maps use: they are given a plain copy of the
/// material, its stand-in.

#include <set>

#include "document/material.h"
#include "io/gltf_json.h"

namespace patina::io {

/// The index of the glTF material that stands in for that one (MaterialRecord::stands_for), or -1.
int find_stand_in(const Json& materials, MaterialId id);

/// Whether some primitive that shows one of these materials lacks one of the UV sets.
bool some_primitive_lacks(const Json& meshes, const std::set<int>& shown,
                          const std::set<int>& uv_sets);

/// Of the primitives, and of their variants, that show `material` or `stand_in`: gives `stand_in`
/// to those that lack one of the UV sets, and `material` to the others.
void share_out(Json& meshes, int material, int stand_in, const std::set<int>& uv_sets);

}  // namespace patina::io
