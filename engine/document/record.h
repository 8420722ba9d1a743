// SPDX-License-Identifier: MIT
#pragma once

/// The record: how a stack of layers travels inside a glTF file, as one compact JSON text in
/// material.extras.patina (and the scene's settings in scene.extras.patina). Also the text that
/// documents are compared by.
///
/// The text is exactly reproducible: keys in a fixed order, defaults left out, numbers as short as
/// they can be while they read back to the same float; equal values give equal bytes. Reading
/// checks everything (types, ranges, NaN, depth, counts, ids) and refuses what it does not know,
/// naming the JSON pointer: a key that a newer Patina writes comes with a newer version.

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "document/document.h"

namespace patina {

/// Written into every record.
inline constexpr int kRecordVersion = 1;

/// What is known of an image that layers read, beside its pixels.
struct RecordImage {
    Hash128 hash;           ///< content_hash of the decoded pixels
    std::string name;       ///< as ImageAsset::name
    std::string mime_type;  ///< as ImageAsset::mime_type; may be empty
    int width = 0;
    int height = 0;
    int channels = 0;
    SampleType type = SampleType::U8;
    std::string file;  ///< beside the glTF file, where the image does not fit into it; else empty
    bool operator==(const RecordImage&) const = default;
};
RecordImage record_image(const ImageAsset& asset);

/// What a material says that glTF has no word for.
struct MaterialRecord {
    MaterialId id;
    int resolution = 2048;
    int uv_set = 0;
    float height_scale = 0.02f;
    Padding padding = Padding::Auto;
    std::vector<LayerPtr> stack;      ///< bottom to top
    std::vector<RecordImage> images;  ///< those that the stack reads, each once, by hash
    /// Hashes of the decoded pixels of the maps that were baked, by an id such as "base-color", so
    /// that a map painted over elsewhere is noticed.
    std::map<std::string, Hash128> baked;
    /// hash_bytes of the encoded images that Patina put into the file for this material (baked maps
    /// and images of layers): the next save may replace these, and nothing else.
    std::vector<Hash128> owned_images;
    /// Not 0: this glTF material is no material of the document but the plain copy of that one,
    /// made by a save for primitives without the UV set. The loader gives those primitives the
    /// material itself; `stack` and all the rest are empty.
    MaterialId stands_for;
};
/// The record of a material as it is now, with nothing baked yet.
MaterialRecord material_record(const Document& document, const Material& material);

/// What a scene says that glTF has no word for.
struct SceneRecord {
    EnvironmentSettings environment;
    std::optional<std::vector<Light>> lights;  ///< unset: the lights of the file
    bool operator==(const SceneRecord&) const = default;
};

std::string to_json(const MaterialRecord& record);
std::string to_json(const SceneRecord& record);

/// One light as a record's list of lights has it: {"kind": "sphere", "position": [0, 2, 0] ...}.
/// What is left out has its standard value.
Result<Light> light_from_json(std::string_view text);

/// The `version` of a record of either kind. A number above kRecordVersion is written by a newer
/// Patina: show the baked material and keep the text. Fails on text that is no record.
Result<int> record_version(std::string_view text);

/// Reads a record of version 1 to kRecordVersion. Layers and entries whose ids are missing or
/// repeated get new ones, larger than all others.
Result<MaterialRecord> material_record_from_json(std::string_view text);
Result<SceneRecord> scene_record_from_json(std::string_view text);

/// Hashes of all images that the layers read, groups and masks included, each once, ascending.
std::vector<Hash128> images_of(const std::vector<LayerPtr>& layers);

/// The document with ids that occur twice (a material that another tool copied) issued anew, the
/// first one keeping its own, ids of 0 filled in, and next_id beyond all.
Document with_unique_ids(const Document& document);

/// The whole document as text for comparison: equal documents, equal bytes. Leaves out what is not
/// content: the source file, indices into it, encoded bytes and next_id.
std::string serialise(const Document& document);

}  // namespace patina
