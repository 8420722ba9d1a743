// SPDX-License-Identifier: MIT
#include "io/baked_files.h"

#include "composite/dilate.h"
#include "core/stored_values.h"
#include "io/last_channel.h"

namespace patina::io {
namespace {

/// The same RGBA8 map as RGB8 where its alpha says nothing.
ImagePtr without_opaque_alpha(const ImagePtr& map) {
    const bool rgba8 = map->channels == 4 && map->type == SampleType::U8;
    if (!rgba8 || !last_is_one(*map)) return map;
    return std::make_shared<const Image>(without_last(*map));
}

/// What each byte stands for: itself as 0..1, or the linear light of an sRGB-encoded value.
std::array<double, 256> byte_values(bool srgb) {
    std::array<double, 256> values = {};
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = srgb ? linear_of_bytes()[i] : unit_value(static_cast<std::uint8_t>(i));
    }
    return values;
}

}  // namespace

Result<MapSet> bake_for_files(const Program& program, const UvSurfacePtr& islands,
                              ImageProvider& images, int size, const std::vector<BakedMap>& wanted,
                              const Progress& progress) {
    if (wanted.empty()) return MapSet{};
    auto baked = bake_maps(program, images, size, wanted, progress);
    if (!baked) return baked;
    if (islands != nullptr) dilate(*islands, *baked);
    for (ImagePtr& map : baked->maps)
        if (map) map = without_opaque_alpha(map);
    return baked;
}

Result<EncodedMaps> bake_and_encode(const Program& program, const UvSurfacePtr& islands,
                                    ImageProvider& images, int size,
                                    const std::vector<BakedMap>& wanted, const PngOptions& options,
                                    const Progress& progress) {
    const auto baked = bake_for_files(program, islands, images, size, wanted, progress);
    if (!baked) return passed_on(baked);
    EncodedMaps encoded;
    for (const BakedMap map : wanted) {
        auto file = std::make_shared<EncodedMap>();
        file->image = (*baked)[map];
        auto png = encode_png(*file->image, options, progress);
        if (!png) return passed_on(png);
        file->png = std::make_shared<const Bytes>(std::move(*png));
        file->pixels = content_hash(*file->image);
        encoded[static_cast<std::size_t>(map)] = std::move(file);
    }
    return encoded;
}

glm::vec4 mean_factor(const Image& map, Slot slot) {
    if (slot == Slot::Normal || slot == Slot::Occlusion) return glm::vec4(1.0f);
    const bool color = slot == Slot::BaseColor || slot == Slot::Emissive;
    const auto of_color = byte_values(color);
    const auto of_alpha = byte_values(false);
    const auto channels = static_cast<std::size_t>(map.channels);
    std::array<double, 4> sums = {};
    for (std::size_t i = 0; i < map.data.size(); ++i) {
        const std::size_t channel = i % channels;
        sums[channel] +=
            (channel == 3 ? of_alpha : of_color)[static_cast<std::size_t>(map.data[i])];
    }
    glm::vec4 mean(1.0f);
    const double texels = static_cast<double>(map.width) * map.height;
    for (std::size_t c = 0; c < channels; ++c)
        mean[static_cast<int>(c)] = static_cast<float>(sums[c] / texels);
    return mean;
}

}  // namespace patina::io
