// SPDX-License-Identifier: MIT
#pragma once

/// The words of a GLB (glTF 2.0, section 4.4); all numbers are little-endian.

#include <cstddef>
#include <cstdint>

namespace patina::io {

inline constexpr std::uint32_t kGlbMagic = 0x46546C67;      // "glTF"
inline constexpr std::uint32_t kGlbJsonChunk = 0x4E4F534A;  // "JSON"
inline constexpr std::uint32_t kGlbBinChunk = 0x004E4942;   // "BIN\0"
inline constexpr std::size_t kGlbHeaderBytes = 12;
inline constexpr std::size_t kGlbChunkHeaderBytes = 8;

}  // namespace patina::io
