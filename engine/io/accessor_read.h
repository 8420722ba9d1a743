// SPDX-License-Identifier: MIT
#pragma once

/// The numbers behind an accessor: any component type, normalised, strided and sparse.

#include <cstdint>
#include <span>
#include <vector>

#include "core/result.h"
#include "io/gltf_model.h"

namespace patina::io {

/// A checked model and the bytes of its buffers, each at least as long as its byteLength says, or
/// empty where the file names no data for it.
struct GltfData {
    const tinygltf::Model& model;
    std::vector<std::span<const std::byte>> buffers;
};

/// count * components numbers. Normalised integers become 0..1 or -1..1, other integers the number
/// itself. Numbers that are not finite become 0 and are counted in `not_finite`.
Result<std::vector<float>> read_floats(const GltfData& data, int accessor, std::size_t& not_finite);
/// Unsigned integers; fails for accessors of other types.
Result<std::vector<std::uint32_t>> read_unsigned(const GltfData& data, int accessor);

}  // namespace patina::io
