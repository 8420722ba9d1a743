// SPDX-License-Identifier: MIT
#include "composite/dilate.h"

#include <cstring>

#include "composite/operations.h"
#include "core/parallel.h"
#include "document/worn_surface.h"

namespace patina {
namespace {

/// Only touched texels are read, and only the others are written: rows need not wait for others.
void dilate_texels(const UvMap& map, Image& image) {
    const std::size_t texel_bytes = image.row_bytes() / static_cast<std::size_t>(image.width);
    const auto texel_at = [&](int x, int y) {
        return image.data.data() + static_cast<std::size_t>(y) * image.row_bytes() +
               static_cast<std::size_t>(x) * texel_bytes;
    };
    parallel_for(0, map.size(), 16, [&](std::int64_t first, std::int64_t last) {
        for (auto y = static_cast<int>(first); y < static_cast<int>(last); ++y)
            for (int x = 0; x < map.size(); ++x) {
                if (map.touched(x, y)) continue;
                const UvMap::Texel nearest = map.at(x, y);
                std::memcpy(texel_at(x, y), texel_at(nearest.x, nearest.y), texel_bytes);
            }
    });
}

}  // namespace

UvSurfacePtr dilated_by(const Document& document, const Material& material,
                        const Program& program) {
    const bool dilates = material.padding == Padding::Dilate ||
                         (material.padding == Padding::Auto && reads_surface(material));
    if (!dilates) return nullptr;
    UvSurfacePtr surface = worn_surface(document, material, program.data().surface);
    return surface->has_uvs() ? surface : nullptr;
}

void dilate(const UvSurface& surface, MapSet& maps) {
    const UvMapPtr map = surface.map(maps.size);
    if (map == nullptr) return;
    for (ImagePtr& image : maps.maps) {
        if (image == nullptr) continue;
        auto own = image.use_count() == 1 ? std::const_pointer_cast<Image>(image)
                                          : std::make_shared<Image>(*image);
        dilate_texels(*map, *own);
        image = std::move(own);
    }
}

void dilate(const UvSurface& surface, Image& image) {
    if (const UvMapPtr map = surface.map(image.width)) dilate_texels(*map, image);
}

}  // namespace patina
