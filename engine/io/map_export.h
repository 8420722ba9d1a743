// SPDX-License-Identifier: MIT
#pragma once

/// The maps of a document as image files, for programs that do not read them from glTF.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "composite/image_provider.h"
#include "core/progress.h"
#include "document/document.h"
#include "io/baked_files.h"
#include "io/image_file.h"
#include "io/map_packing.h"

namespace patina::io {

struct MapExportOptions {
    ImageFormat format = ImageFormat::Png;
    /// Of single maps, by PackedMap::id. Maps of normals that are not named are PNG where `format`
    /// is JPEG, which spoils them.
    std::map<std::string, ImageFormat, std::less<>> format_of_map = {};
    int jpeg_quality = ImageEncoding{}.jpeg_quality;
    int png_level = ImageEncoding{}.png_level;
    /// 8, 16 or 32 a channel; unset: 8, for EXR 16. 16 are half floats in EXR, 32 always floats.
    std::optional<int> bits = std::nullopt;
    const MapPacking* packing = &default_packing();
    std::optional<int> size = std::nullopt;  ///< overrides the materials' resolution
    /// What a save has baked (SaveReport::maps) and need not be baked again; null for nothing.
    const std::map<MaterialId, EncodedMaps>* baked = nullptr;
};

/// Whether the formats hold that many bits, and the packing in them; the failure says what does.
Status check_map_options(const MapExportOptions& options);

/// What to be told of maps of normals and JPEG, one line each.
std::vector<std::string> warnings_of(const MapExportOptions& options);

/// Bakes every map of every material in which something varies, whether the glTF file has it baked
/// or as the texture that it came with, and writes MATERIAL_MAP.EXT files into `folder`, which is
/// made if it is missing. Opacity has a file of its own where the format of colours has no place
/// for it: floats, JPEG. Each file is written all or nothing.
/// @return the files, in the order of materials and maps
Result<std::vector<std::filesystem::path>> export_maps(const Document& document,
                                                       ImageProvider& images,
                                                       const std::filesystem::path& folder,
                                                       const MapExportOptions& options = {},
                                                       const Progress& progress = {});

}  // namespace patina::io
