// SPDX-License-Identifier: MIT
#pragma once

/// The document: an immutable snapshot of all that can be edited and undone. It is a value built of
/// shared nodes, so a copy is cheap and an edit costs what it changes. Camera, exposure, panels and
/// selection are view state and live elsewhere. May include core and scene; knows nothing of GL,
/// files or ImGui.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "document/encoded_image.h"
#include "document/material.h"
#include "scene/image.h"
#include "scene/scene.h"
#include "scene/source_asset.h"

namespace patina {

/// An image that layers use: the encoded bytes, and what is known of the pixels.
/// Pixels themselves are asked of an ImageProvider by hash.
struct ImageAsset {
    Hash128 hash;           ///< content_hash of the decoded pixels
    std::string name;       ///< for people: file name or glTF name
    std::string mime_type;  ///< "image/png", "image/jpeg", ... of `encoded`
    EncodedImage encoded;
    int width = 0;
    int height = 0;
    int channels = 0;
    SampleType type = SampleType::U8;
    /// Of its colours, as the file says or its format implies; what a new layer reads them as.
    ColorSpace color_space = ColorSpace::Srgb;
    std::optional<int> source_image;  ///< index in the glTF file, where it came from there
};
using ImageAssetPtr = std::shared_ptr<const ImageAsset>;

/// Where the sun of the built-in sky stands unless it is moved.
inline constexpr float kSunElevationDegrees = 38.0f;

struct EnvironmentSettings {
    /// A built-in ("studio") or the path of an equirectangular image: relative to the model's
    /// folder (with % as %25) where it lies in it, else absolute.
    std::string name = "studio";
    float rotation_degrees = 0.0f;  ///< about +Y, counter-clockwise from above
    float intensity = 1.0f;         ///< times the radiance of the map, 0 to 100
    /// Of the built-in sky's sun above the horizon, 0 to 90; nothing to other environments.
    float sun_elevation_degrees = kSunElevationDegrees;
    bool operator==(const EnvironmentSettings&) const = default;
};

struct Document;
using DocumentPtr = std::shared_ptr<const Document>;

struct Document {
    SourceAssetPtr source;  ///< as opened; every save splices into this
    /// The document as it was loaded from `source`; its own `opened` is null. A save compares with
    /// it to see what was edited. Edits carry it along; it is neither serialised nor compared.
    DocumentPtr opened;
    ScenePtr scene;
    /// In the order of the file, then those that were added; the default one last.
    std::vector<MaterialPtr> materials;
    /// Parts that are drawn with another material than the file says (document/parts.h).
    std::map<PartRef, MaterialId> assigned;
    std::map<Hash128, ImageAssetPtr> images;
    EnvironmentSettings environment;
    std::vector<Light> lights;  ///< in the world; those of the file to begin with
    std::uint64_t next_id = 1;  ///< the next layer, mask entry or material id; only grows
};

/// The material with that id, or null.
MaterialPtr find_material(const Document& document, MaterialId id);
/// The material that is drawn by that number (Material::source_material, -1 where it is unset), or
/// null if none is.
MaterialPtr material_of(const Document& document, int source_material);
/// The layer with that id anywhere in the stack, groups included, or null.
LayerPtr find_layer(const Material& material, LayerId id);

}  // namespace patina
