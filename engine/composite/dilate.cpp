// SPDX-License-Identifier: MIT
#include "composite/dilate.h"

#include <cstring>

#include "composite/operations.h"
#include "core/parallel.h"
#include "document/worn_surface.h"

namespace patina {
namespace {

/// Only touched texels are read, and only the others are written: rows need not wait for others.
template <typename Texel>
void dilate_plane(const UvMap& map, Texel* texels) {
    const int size = map.size();
    const auto row = [size](int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size);
    };
    parallel_for(0, size, 16, [&](std::int64_t first, std::int64_t last) {
        for (auto y = static_cast<int>(first); y < static_cast<int>(last); ++y)
            for (int x = 0; x < size; ++x) {
                if (map.touched(x, y)) continue;
                const UvMap::Texel nearest = map.at(x, y);
                std::memcpy(texels + row(y) + x, texels + row(nearest.y) + nearest.x,
                            sizeof(Texel));
            }
    });
}

struct Rgba8 {
    std::byte components[4];
};

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
        dilate_plane(*map, reinterpret_cast<Rgba8*>(own->data.data()));
        image = std::move(own);
    }
}

void dilate(const UvSurface& surface, ChannelPlanes& planes) {
    const UvMapPtr map = surface.map(planes.size);
    if (map == nullptr) return;
    for (auto& channel : planes.planes)
        for (PixelVector<float>& plane : channel)
            if (!plane.empty()) dilate_plane(*map, plane.data());
}

}  // namespace patina
