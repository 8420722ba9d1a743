// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "composite/composite_rect.h"
#include "core/free_memory.h"

namespace patina {

std::vector<BakedMap> maps_of(const Program& program) {
    std::array<bool, kBakedMapCount> read = {};
    for (int slot = 0; slot < kSlotCount; ++slot)
        if (!std::holds_alternative<SlotConstant>(program.slots()[static_cast<std::size_t>(slot)]))
            read[static_cast<std::size_t>(baked_map_of(static_cast<Slot>(slot)))] = true;
    std::vector<BakedMap> maps;
    for (int map = 0; map < kBakedMapCount; ++map)
        if (read[static_cast<std::size_t>(map)]) maps.push_back(static_cast<BakedMap>(map));
    return maps;
}

Result<MapSet> bake_maps(const Program& program, ImageProvider& images, int size,
                         const std::vector<BakedMap>& wanted, const Progress& progress) {
    ChannelBits channels = 0;
    for (const BakedMap map : wanted) channels |= channels_of(map);
    const Result<BoundImages> bound = images_for_bake(program.data(), channels, size, images);
    if (!bound) return passed_on(bound);

    const auto side = static_cast<std::uint64_t>(size);
    const Status fits = check_free_memory(side * side * 4 * wanted.size(),
                                          fmt::format("maps of {} texels a side", size));
    if (!fits) return passed_on(fits);
    CompositeJob job{
        .program = &program.data(), .images = &*bound, .size = size, .rect = {0, 0, size, size}};
    MapSet result{.size = size};
    for (const BakedMap map : wanted) {
        auto image = std::make_shared<Image>(Image{.width = size, .height = size, .channels = 4});
        image->data.resize(image->row_bytes() * static_cast<std::size_t>(size));
        job.targets[static_cast<std::size_t>(map)] = image->data.data();
        result.maps[static_cast<std::size_t>(map)] = std::move(image);
    }
    if (!composite_rect(job, progress)) return failure("baking was cancelled");
    return result;
}

}  // namespace patina
