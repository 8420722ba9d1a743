// SPDX-License-Identifier: MIT
#pragma once

/// A folder of textures as a layer: what `bake --textures DIR` and dropping a folder do.

#include <filesystem>
#include <string>
#include <vector>

#include "core/progress.h"
#include "document/layer.h"
#include "io/image_store.h"
#include "io/texture_names.h"

namespace patina::io {

/// What became of one image file of the folder.
struct TextureUseOfFile {
    std::filesystem::path file;
    TextureGuess guess;
    std::vector<TextureChannel> used;  ///< of the guess: those that no better file feeds
    /// One line for people: "wood_rough.png: roughness (from "rough")".
    std::string described;
};

struct TextureFolder {
    Layer layer;  ///< a fill named for the folder, without an id; hand it to add_layer
    /// The images that the layer reads: put them into Document::images before it is added.
    std::vector<ImageAssetPtr> images;
    std::vector<TextureUseOfFile> files;  ///< every image file there, in the order of names
};

/// Guesses what each image file is for and decodes the used ones side by side. Colours are read as
/// the file says, else as sRGB (EXR, HDR and other floats as linear); all else is data. Grey 0.5 is
/// the surface of a height map. Opacity is the alpha of the base colour where no file is for it and
/// that alpha is not 1 everywhere. Fails when there is no folder, no image in it says what it is,
/// its files are of several materials (whose names differ before the word that says what each is),
/// or one that is used cannot be read.
/// @param folder  or, of a folder with several materials, the one that is meant: DIR/metal_plate
Result<TextureFolder> read_texture_folder(const std::filesystem::path& folder, ImageStore& store,
                                          const Progress& progress = {});

/// Whether a path is a folder that a drop should hand to read_texture_folder.
bool is_texture_folder(const std::filesystem::path& path);

}  // namespace patina::io
