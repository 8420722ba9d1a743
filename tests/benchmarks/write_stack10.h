// SPDX-License-Identifier: MIT
#pragma once

/// The work item as files, for whole programs: see peers.sh.

#include <filesystem>

#include "core/result.h"

namespace patina::bench {

/// Writes into `folder`, which must exist:
/// - base.tif, colorN.tif, maskN.tif, roughnessN.tif (N from 0): uncompressed, alpha not
/// associated;
/// - stack10.txt: a line "MODE OPACITY METALNESS" for each layer, bottom to top;
/// - stack10.json: a preset of these images; quad.glb: a model for it with one material.
Status write_stack10(const std::filesystem::path& folder, int size);

}  // namespace patina::bench
