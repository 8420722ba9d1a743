// SPDX-License-Identifier: MIT
#include "io/packed_bytes.h"

#include <algorithm>

#include "core/parallel.h"

namespace patina::io {
namespace {

/// Where a channel lies in the baked maps.
struct BakedPlace {
    BakedMap map;
    int component;
};

std::optional<BakedPlace> place_of(Channel channel, int component) {
    switch (channel) {
        case Channel::BaseColor:
            return BakedPlace{BakedMap::BaseColor, component};
        case Channel::Opacity:
            return BakedPlace{BakedMap::BaseColor, 3};
        case Channel::Occlusion:
            return BakedPlace{BakedMap::OcclusionRoughnessMetalness, 0};
        case Channel::Roughness:
            return BakedPlace{BakedMap::OcclusionRoughnessMetalness, 1};
        case Channel::Metalness:
            return BakedPlace{BakedMap::OcclusionRoughnessMetalness, 2};
        case Channel::Normal:
            return BakedPlace{BakedMap::Normal, component};
        case Channel::Emissive:
            return BakedPlace{BakedMap::Emissive, component};
        case Channel::Height:
            return std::nullopt;
    }
    return std::nullopt;
}

/// One channel of a file: bytes of an image, or `constant`.
struct Plane {
    const Image* image = nullptr;
    int component = 0;
    std::byte constant = std::byte{255};
};

/// The bytes of colours are sRGB-encoded; by itself a component of one is a plain number.
bool is_lone_component(const PackedMap& map, int c) {
    const PackedValue& value = map.values[static_cast<std::size_t>(c)];
    return info(*value.channel).kind == ChannelKind::Color && !(map.is_color() && c < 3);
}

std::optional<Plane> plane_of(const PackedMap& map, int c, const MapSet& baked, int size) {
    const PackedValue& value = map.values[static_cast<std::size_t>(c)];
    if (!value.channel)
        return Plane{.constant =
                         static_cast<std::byte>(static_cast<int>(value.constant * 255.0f + 0.5f))};
    const auto place = place_of(*value.channel, value.component);
    if (!place || is_lone_component(map, c)) return std::nullopt;
    const ImagePtr& image = baked[place->map];
    if (!image || image->width != size || image->type != SampleType::U8) return std::nullopt;
    // An alpha channel that is opaque everywhere was left out.
    if (place->component >= image->channels)
        return Plane{.constant = value.invert ? std::byte{0} : std::byte{255}};
    // The middle of a byte rounds upwards, that of an inverted number too: bytes do not tell which.
    if (value.invert) return std::nullopt;
    return Plane{.image = image.get(), .component = place->component};
}

bool is_same_map(const PackedMap& map, const Image& image, const MapSet& baked, int size) {
    if (map.channels < image.channels) return false;
    for (int c = 0; c < map.channels; ++c) {
        const auto plane = plane_of(map, c, baked, size);
        if (!plane) return false;
        const bool left_out = c >= image.channels && map.has_opacity() && plane->image == nullptr;
        if (!left_out && (plane->image != &image || plane->component != c)) return false;
    }
    return true;
}

}  // namespace

std::optional<std::vector<BakedMap>> baked_maps_of(const PackedMap& map) {
    std::vector<BakedMap> needed;
    for (int c = 0; c < map.channels; ++c) {
        const PackedValue& value = map.values[static_cast<std::size_t>(c)];
        if (!value.channel) continue;
        const auto place = place_of(*value.channel, value.component);
        if (!place || value.invert || is_lone_component(map, c)) return std::nullopt;
        if (std::find(needed.begin(), needed.end(), place->map) == needed.end())
            needed.push_back(place->map);
    }
    return needed;
}

std::optional<BakedMap> same_map(const PackedMap& map, const MapSet& baked, int size) {
    for (int i = 0; i < kBakedMapCount; ++i) {
        const ImagePtr& image = baked[static_cast<BakedMap>(i)];
        if (image && is_same_map(map, *image, baked, size)) return static_cast<BakedMap>(i);
    }
    return std::nullopt;
}

std::optional<Image> packed_bytes(const PackedMap& map, const MapSet& baked, int size) {
    std::array<Plane, 4> planes;
    for (int c = 0; c < map.channels; ++c) {
        const auto plane = plane_of(map, c, baked, size);
        if (!plane) return std::nullopt;
        planes[static_cast<std::size_t>(c)] = *plane;
    }
    const bool drops_opacity = map.has_opacity() && planes[3].image == nullptr;
    Image image{.width = size, .height = size, .channels = drops_opacity ? 3 : map.channels};
    image.data.resize(image.row_bytes() * static_cast<std::size_t>(size));
    const auto channels = static_cast<std::size_t>(image.channels);
    parallel_for(0, std::int64_t{size} * size, 1 << 16, [&](std::int64_t first, std::int64_t last) {
        for (std::size_t c = 0; c < channels; ++c) {
            const Plane& plane = planes[c];
            for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last);
                 ++i) {
                std::byte byte = plane.constant;
                if (plane.image != nullptr)
                    byte = plane.image->data[i * static_cast<std::size_t>(plane.image->channels) +
                                             static_cast<std::size_t>(plane.component)];
                image.data[i * channels + c] = byte;
            }
        }
    });
    return image;
}

}  // namespace patina::io
