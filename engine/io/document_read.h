// SPDX-License-Identifier: MIT
#pragma once

/// From a file's parts to a document: images decoded, records opened, stacks made.

#include "core/progress.h"
#include "io/gltf_files.h"
#include "io/image_store.h"
#include "io/material_read.h"

namespace patina::io {

/// Decodes the images that materials show, side by side (all of them where a record may name them),
/// each once. One that is missing or damaged is a placeholder and a warning; one that is too large,
/// or all together, a failure. Images that nothing shows are null.
Result<FileImages> decode_images(const tinygltf::Model& model, const GltfFiles& files,
                                 ImageStore& store, const ImageLimits& limits,
                                 const Progress& progress, std::vector<std::string>& warnings);

/// What documents are made of, apart from their scene.
struct DocumentParts {
    const tinygltf::Model& model;
    const SourceAsset& asset;
    const FileImages& images;
    ImageStore& store;
    std::vector<std::string>& warnings;
};

/// The materials of the file, each from its record if it has a good one, else as imported; where
/// primitives have no material the default one follows. Primitives of `scene` that show a stand-in
/// show the material that it stands for. Fills materials, images, environment and lights; ids are
/// unique.
Document read_document(const DocumentParts& parts, Scene scene);

}  // namespace patina::io
