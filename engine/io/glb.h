// SPDX-License-Identifier: MIT
#pragma once

/// The two containers of glTF, told apart by content and taken into their parts.

#include "core/result.h"
#include "scene/source_asset.h"

namespace patina::io {

/// Whether the bytes begin as a GLB does.
bool is_glb(std::span<const std::byte> file);

/// Fills json_text, binary_chunk, trailing_chunks and container from `file`. Every length is
/// checked: the header's total, each chunk, their order (JSON first, BIN second). The message does
/// not name the file.
Status split_container(SourceAsset& asset);

}  // namespace patina::io
