// SPDX-License-Identifier: MIT
#pragma once

/// Materials of the file as stacks of layers.

#include "document/document.h"
#include "io/material_values.h"

namespace patina::io {

/// The image assets of the file, by its index; every one is there.
using FileImages = std::vector<ImageAssetPtr>;

/// What glTF says of a material, as one with a single layer, "Imported textures": its maps times
/// its factors, and constants where it has no map. Ids are 0: the caller issues them.
Material imported_material(const tinygltf::Model& model, int index, const FileImages& images);

/// The material that glTF gives to primitives without one. Ids are 0.
Material default_material();

}  // namespace patina::io
