// SPDX-License-Identifier: MIT
#pragma once

/// Which material the primitives of a glTF file name while a save edits it: places for those that
/// the file has not, and the parts that were assigned others.

#include <map>
#include <set>
#include <vector>

#include "document/document.h"
#include "io/gltf_json.h"

namespace patina::io {

/// Appends an item to "materials" for each of these that the file has none for, in their order: a
/// copy begins as the one that it was made of, without its record.
/// @return where they stand
std::map<MaterialId, int> place_new_materials(const std::vector<MaterialPtr>& edited,
                                              GltfJson& gltf);

/// Makes primitives name the materials that they were assigned, and those without any the default
/// one where that has a place. Variants (KHR_materials_variants) keep theirs.
void give_parts_their_materials(const Document& document, const std::map<MaterialId, int>& places,
                                GltfJson& gltf);

/// Materials that were assigned to a part which lacks a UV set of their maps.
std::set<MaterialId> shown_without_uvs(const Document& document);

}  // namespace patina::io
