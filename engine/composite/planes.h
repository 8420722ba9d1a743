// SPDX-License-Identifier: MIT
#pragma once

/// Planes of floats, and stored texels, as kernels read them.

#include <bit>
#include <cstddef>
#include <cstdint>

namespace patina {

/// Texels of a tile, which is what a plane holds; a multiple of the lanes of the widest instruction
/// set. Planes lie in the second-level cache then and no more in the first, which costs less than
/// going through all operations twice as often.
inline constexpr int kTileTexels = 2048;
inline constexpr int kMaxLanes = 16;

/// Blocks of successive texels of a tile, a bit each, the first the lowest.
using TileBlocks = std::uint32_t;
inline constexpr std::size_t kBlockTexels = 64;

/// Those that the first `count` texels of a tile touch.
constexpr TileBlocks all_blocks(int count) {
    const std::size_t blocks = (static_cast<std::size_t>(count) + kBlockTexels - 1) / kBlockTexels;
    return static_cast<TileBlocks>((std::uint64_t{1} << blocks) - 1);
}

/// Texels [begin, end) of a tile.
struct TexelRun {
    std::size_t begin = 0;
    std::size_t end = 0;
};
/// Takes the first blocks that follow each other off `blocks`, of which there are some, and tells
/// which of the `count` texels lie in them.
constexpr TexelRun take_run(TileBlocks& blocks, int count) {
    const auto first = static_cast<std::size_t>(std::countr_zero(blocks));
    const std::size_t past = first + static_cast<std::size_t>(std::countr_one(blocks >> first));
    blocks &= static_cast<TileBlocks>(~std::uint64_t{0} << past);
    const auto last = static_cast<std::size_t>(count);
    const std::size_t end = past * kBlockTexels;
    return {first * kBlockTexels, end < last ? end : last};
}

/// A plane of a tile, or (`step` 0) one value that stands for a whole plane, kept sixteen times.
struct ReadPlane {
    const float* data = nullptr;
    std::size_t step = 1;
};

/// A value kept once for each lane of the widest instruction set.
struct UniformPlane {
    alignas(64) float lanes[16] = {};

    UniformPlane() = default;
    explicit UniformPlane(float value) {
        for (float& lane : lanes) lane = value;
    }
    ReadPlane plane() const { return {.data = lanes, .step = 0}; }
};

/// Successive texels of bytes as an image keeps them: 0..1, whose values are those of the source.
struct StoredTexels {
    const std::byte* texels = nullptr;  ///< null: what is read lies in planes
    std::size_t row_bytes = 0;          ///< from a row of the image to the next
    int channels = 0;                   ///< bytes of a texel
    int first = 0;                      ///< component that is read, or the first of three
    bool decode = false;                ///< sRGB to linear
};

/// What a source gives: three planes of a colour or normal, one of a scalar, and its own coverage.
/// They point into the planes of the tile, or at constants that live as long as the program.
struct FetchedSource {
    ReadPlane components[3] = {};
    ReadPlane coverage = {};
    StoredTexels stored = {};  ///< where given, they stand for the components
};

/// 1 in every texel.
inline ReadPlane uniform_one() {
    static const UniformPlane one(1.0f);
    return one.plane();
}

}  // namespace patina
