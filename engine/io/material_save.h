// SPDX-License-Identifier: MIT
#pragma once

/// One edited material put into the JSON of a glTF file: its slots by the bake rules, its settings
/// and its record.

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/progress.h"
#include "document/document.h"
#include "io/baked_files.h"
#include "io/gltf_images.h"

namespace patina::io {

/// What the materials of one save share.
struct MaterialSave {
    const Document& document;
    ImageProvider& pixels;
    GltfJson& gltf;
    GltfImages& images;
    /// Where materials that were not in the file stand in it now (io/part_materials.h).
    std::map<MaterialId, int> places;
    /// Those that a part without the UV sets of their maps was assigned to.
    std::set<MaterialId> shown_without_uvs;
    std::optional<int> size;  ///< overrides the resolution of materials
    PngOptions png;           ///< of baked maps
    Progress progress;
    std::vector<std::string> warnings;
};

/// Bakes what has to be baked and states the material. `before` is the material as it stands in the
/// file: what does not differ from it keeps its JSON. Null: nothing of it is there yet.
/// @return the maps that were baked
Result<EncodedMaps> save_material(MaterialSave& save, const Material& material,
                                  const Material* before);

/// Whether two materials say the same, whether or not they share nodes.
bool same_content(const Document& document_a, const Material& a, const Document& document_b,
                  const Material& b);

/// The name of the file beside the glTF file that holds a layer's image which fits into no glTF
/// (float data), or an empty one for an image that does.
std::string file_beside(const ImageAsset& image);

}  // namespace patina::io
