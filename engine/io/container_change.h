// SPDX-License-Identifier: MIT
#pragma once

/// A .gltf as the .glb that means the same, and back.

#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "scene/source_asset.h"

namespace patina::io {

/// The source as if it had been read from the other container.
/// To GLB: the first buffer becomes the binary chunk and external images are put behind it; further
/// buffers stay external files. To glTF: the binary chunk becomes an external file with a
/// content-hashed name; trailing chunks have no place and are left out.
/// @param stem      for the names of new files
/// @param warnings  gains a line for what was left out
Result<SourceAsset> with_container(const SourceAsset& source, Container container,
                                   std::string_view stem, std::vector<std::string>& warnings);

}  // namespace patina::io
