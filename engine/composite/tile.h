// SPDX-License-Identifier: MIT
#pragma once

/// The unit of work: a run of texels of one row, with the planes of floats that all operations on
/// it share. It stays in the caches of one core from the first operation to the last.

#include <array>
#include <map>
#include <memory>
#include <vector>

#include "composite/operations.h"
#include "core/pixel_memory.h"

namespace patina {

/// Texels [x, x + count) of row y in a square map of `size` texels a side; 1 <= count <=
/// kTileTexels. What is computed for a texel depends on its place and on `size` alone.
struct TileSpan {
    int x = 0;
    int y = 0;
    int count = 0;
    int size = 0;
    bool operator==(const TileSpan&) const = default;
};

/// Where the texels of a tile begin in an image that lies on those of the map.
inline const std::byte* texels_at(const TileSpan& span, const std::byte* image,
                                  std::size_t row_bytes, std::size_t texel_bytes) {
    return image + row_bytes * static_cast<std::size_t>(span.y) +
           texel_bytes * static_cast<std::size_t>(span.x);
}
/// The same of texels that are given from the first of the image on.
inline const std::byte* texels_at(const TileSpan& span, const StoredTexels& image) {
    return texels_at(span, image.texels, image.row_bytes, static_cast<std::size_t>(image.channels));
}

/// A column or row, beyond the border too, of a map that repeats.
inline int wrapped(int index, int size) {
    const int rest = index % size;
    return rest < 0 ? rest + size : rest;
}

/// What lies of the model at the texels of a tile, in model space (scene/uv_surface.h); `weight` to
/// `sum` are scratch of one projection.
struct SurfacePlanes {
    const void* surface = nullptr;  ///< address of the UvMap that `position` to `bitangent` are of
    TileSpan span = {};             ///< and where
    alignas(64) float position[3][kTileTexels];
    alignas(64) float normal[3][kTileTexels];
    alignas(64) float tangent[3][kTileTexels];
    alignas(64) float bitangent[3][kTileTexels];
    alignas(64) float weight[3][kTileTexels];
    alignas(64) float u[kTileTexels];
    alignas(64) float v[kTileTexels];
    alignas(64) float value[3][kTileTexels];
    alignas(64) float sum[4][kTileTexels];
};

/// Patterns of procedural sources that are wanted again: by other sources of the same tile, and by
/// those of the next row, whose heights are composited before its other channels.
class PatternPlanes {
  public:
    /// The plane of a pattern, by its number, at a tile: kTileTexels floats, 64-byte aligned.
    /// @param is_filled  becomes whether it is the pattern already, and not to be written yet
    float* at(std::int32_t pattern, const TileSpan& span, bool& is_filled) {
        Kept& kept = kept_[{pattern, span.x, span.y & 1}];
        is_filled = kept.span == span;
        kept.span = span;
        kept.plane.resize(kTileTexels);
        return kept.plane.data();
    }

  private:
    struct Kept {
        TileSpan span = {};
        PixelVector<float> plane;
    };
    /// By pattern, column and whether the row is odd.
    std::map<std::array<std::int32_t, 3>, Kept> kept_;
};

/// The planes of one thread, kTileTexels floats each, 64-byte aligned. Lanes beyond `count` of the
/// span hold anything.
class TilePlanes {
  public:
    explicit TilePlanes(int depths)
        : memory_(static_cast<std::size_t>(depths * kPlanesPerDepth + kScratchPlanes) *
                  kPlaneStride),
          masked_blocks_(static_cast<std::size_t>(depths)) {}

    float* channel(int depth, Channel channel, int component = 0) {
        return plane(depth * kPlanesPerDepth + first_plane(channel) + component);
    }
    /// Of the channel inside a group; depth 0 is opaque.
    float* coverage(int depth, Channel channel) {
        return plane(depth * kPlanesPerDepth + kComponents + static_cast<int>(channel));
    }
    float* mask(int depth) { return plane(depth * kPlanesPerDepth + kPlanesPerDepth - 1); }
    /// The blocks outside of which the mask of this depth is 0.
    TileBlocks& masked_blocks(int depth) { return masked_blocks_[static_cast<std::size_t>(depth)]; }
    /// The mask that MaskKeep keeps.
    float* kept_mask(int depth) { return plane(depth * kPlanesPerDepth + kPlanesPerDepth - 2); }
    /// Of the source that an operation reads: up to three components, its coverage, its weight.
    float* source(int component) { return plane(scratch() + component); }
    float* source_coverage() { return plane(scratch() + 3); }
    float* weight() { return plane(scratch() + 4); }
    PatternPlanes& patterns() { return patterns_; }
    /// Made when first asked for, and kept from tile to tile.
    SurfacePlanes& surface() {
        if (surface_ == nullptr) surface_ = std::make_unique<SurfacePlanes>();
        return *surface_;
    }

  private:
    static constexpr int kComponents = 14;  ///< of the eight channels
    static constexpr int kPlanesPerDepth = kComponents + kChannelCount + 2;
    static constexpr int kScratchPlanes = 5;
    /// From plane to plane. A power of two would put the same texel of all planes into the same few
    /// sets of the first-level cache.
    static constexpr int kPlaneStride = kTileTexels + 48;

    static constexpr int first_plane(Channel channel) {
        int first = 0;
        for (const ChannelInfo& entry : kChannels) {
            if (entry.channel == channel) break;
            first += component_count(entry.channel);
        }
        return first;
    }
    int scratch() const { return static_cast<int>(memory_.size()) / kPlaneStride - kScratchPlanes; }
    float* plane(int index) { return memory_.data() + std::ptrdiff_t{index} * kPlaneStride; }

    PixelVector<float> memory_;
    std::vector<TileBlocks> masked_blocks_;
    std::unique_ptr<SurfacePlanes> surface_;
    PatternPlanes patterns_;
};

}  // namespace patina
