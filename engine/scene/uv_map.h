// SPDX-License-Identifier: MIT
#pragma once

/// Which triangle of a surface each texel of a map shows. Texels that no triangle touches answer
/// for the nearest one that some triangle does, so that filters and mip-maps find no edge there;
/// the borders of the texture meet.

#include <cstdint>
#include <memory>

#include "core/pixel_memory.h"
#include "scene/uv_surface.h"

namespace patina {

class UvMap {
  public:
    /// Null where the triangles are so large, or so many, that it would take minutes.
    static std::shared_ptr<const UvMap> make(const UvSurface& surface, int size);

    int size() const { return size_; }

    struct Texel {
        std::uint32_t triangle;
        int x;  ///< the texel that is answered for: itself where it is touched
        int y;
    };
    Texel at(int x, int y) const {
        std::size_t index = index_of(x, y);
        if ((texels_[index] & kElsewhere) != 0) {
            index = texels_[index] & ~kElsewhere;
            x = static_cast<int>(index % static_cast<std::size_t>(size_));
            y = static_cast<int>(index / static_cast<std::size_t>(size_));
        }
        return {texels_[index], x, y};
    }
    /// Whether a triangle touches the texel itself.
    bool touched(int x, int y) const { return (texels_[index_of(x, y)] & kElsewhere) == 0; }

  private:
    friend class UvMapMaker;
    static constexpr std::uint32_t kElsewhere = 0x8000'0000u;  ///< the rest is a texel's index

    explicit UvMap(int size) : size_(size) {}
    std::size_t index_of(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_) +
               static_cast<std::size_t>(x);
    }

    int size_;
    PixelVector<std::uint32_t> texels_;
};

using UvMapPtr = std::shared_ptr<const UvMap>;

}  // namespace patina
