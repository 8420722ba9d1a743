// SPDX-License-Identifier: MIT
#include "io/baked_files.h"

#include "composite/dilate.h"
#include "core/formulae/formulae.h"
#include "core/parallel.h"
#include "io/png_writer.h"

namespace patina::io {
namespace {

bool alpha_is_opaque(const Image& rgba) {
    for (std::size_t i = 3; i < rgba.data.size(); i += 4)
        if (rgba.data[i] != std::byte{0xff}) return false;
    return true;
}

/// The same RGBA8 map as RGB8 where its alpha says nothing.
ImagePtr without_opaque_alpha(const ImagePtr& map) {
    const bool rgba8 = map->channels == 4 && map->type == SampleType::U8;
    if (!rgba8 || !alpha_is_opaque(*map)) return map;
    auto rgb = std::make_shared<Image>();
    rgb->width = map->width;
    rgb->height = map->height;
    rgb->channels = 3;
    rgb->data.resize(rgb->row_bytes() * static_cast<std::size_t>(rgb->height));
    const std::byte* const in = map->data.data();
    std::byte* const out = rgb->data.data();
    parallel_for(0, static_cast<std::int64_t>(rgb->data.size() / 3), 1 << 16,
                 [&](std::int64_t first, std::int64_t last) {
                     for (std::int64_t i = first; i < last; ++i)
                         for (std::int64_t c = 0; c < 3; ++c) out[i * 3 + c] = in[i * 4 + c];
                 });
    return rgb;
}

/// What each byte stands for: itself as 0..1, or the linear light of an sRGB-encoded value.
std::array<double, 256> byte_values(bool srgb) {
    std::array<double, 256> values = {};
    for (std::size_t i = 0; i < values.size(); ++i) {
        const float encoded = static_cast<float>(i) / 255.0f;
        values[i] = srgb ? formulae::linear_from_srgb(encoded) : encoded;
    }
    return values;
}

}  // namespace

Result<EncodedMaps> bake_and_encode(const Program& program, const UvSurfacePtr& islands,
                                    ImageProvider& images, int size,
                                    const std::vector<BakedMap>& wanted, const Progress& progress) {
    EncodedMaps encoded;
    if (wanted.empty()) return encoded;
    auto maps = bake_maps(program, images, size, wanted, progress);
    if (!maps) return passed_on(maps);
    if (islands != nullptr) dilate(*islands, *maps);
    for (const BakedMap map : wanted) {
        auto file = std::make_shared<EncodedMap>();
        file->image = without_opaque_alpha((*maps)[map]);
        auto png = encode_png(*file->image, {}, progress);
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
