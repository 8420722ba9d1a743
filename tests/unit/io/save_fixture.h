// SPDX-License-Identifier: MIT
#pragma once

/// Documents to save, and a folder to save them in.

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "document/edit.h"
#include "io/load.h"
#include "io/mesh_to_glb.h"
#include "io/save.h"

namespace patina::io {

namespace fs = std::filesystem;

/// The models of ../shared/assets; none where there are no assets.
std::vector<fs::path> asset_models();

/// These throw what went wrong, which fails the test.
LoadedDocument loaded(const fs::path& path);
Document with(const Document& before, const Edit& edit);

inline const Material& material_at(const Document& document, std::size_t index) {
    return *document.materials.at(index);
}

ProceduralSource noise(std::uint32_t seed);

/// The document with another material in the place of one.
Document with_material(const Document& document, std::size_t index, Material material);
/// A layer of noise in base colour and roughness on top of a material, which becomes 256 a side.
Document with_noise_layer(const Document& document, std::size_t index, std::uint32_t seed = 1);

struct Glb {
    std::string json;
    Bytes binary;
};
Glb parts_of(const Bytes& file);
/// Of a .gltf or a .glb.
std::string json_of(const fs::path& file);

class Save : public testing::Test {
  protected:
    Save();
    ~Save() override;

    /// A copy of the model, with what lies beside it, in a folder of its own.
    fs::path copied(const fs::path& model);
    SaveReport saved(const Document& document, ImageProvider& images, const fs::path& path,
                     const SaveOptions& options = {});
    static std::size_t files_in(const fs::path& folder);
    /// A quad; `uvs` says whether it has UV coordinates.
    static LoadedDocument quad(bool uvs,
                               const std::vector<PlainMaterial>& materials = {{.name = "Quad"}});

    fs::path folder_;
};

#define SKIP_WITHOUT(models) \
    if ((models).empty()) GTEST_SKIP() << "no models in ../shared/assets"

}  // namespace patina::io
