// SPDX-License-Identifier: MIT
#include "io/packed_channels.h"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>

#include "composite/bake_channels.h"
#include "core/formulae/formulae.h"
#include "core/free_memory.h"

namespace patina::io {
namespace {

/// From a channel's number to that of a file, which is 0..1 but for floats of heights and of bright
/// colours: number * scale + offset.
struct Recoding {
    float scale = 1.0f;
    float offset = 0.0f;
};

Recoding recoding_of(const PackedValue& value) {
    if (!value.channel) return {};
    const ChannelKind kind = info(*value.channel).kind;
    if (kind == ChannelKind::Normal || kind == ChannelKind::Height)
        return {.scale = value.invert ? -0.5f : 0.5f, .offset = 0.5f};
    if (value.invert) return {.scale = -1.0f, .offset = 1.0f};
    return {};
}

template <typename Sample>
Sample stored(float number) {
    const float held = std::clamp(number, 0.0f, 1.0f);
    if constexpr (std::is_same_v<Sample, std::uint8_t>)
        return static_cast<Sample>(static_cast<int>(held * 255.0f + 0.5f));
    else if constexpr (std::is_same_v<Sample, std::uint16_t>)
        return static_cast<Sample>(static_cast<int>(held * 65535.0f + 0.5f));
    else
        return number;
}

/// Writes channel c of a span into a map.
template <typename Sample>
void pack(const PackedMap& map, int c, const ChannelSpan& span, Image& image) {
    const PackedValue& value = map.values[static_cast<std::size_t>(c)];
    const float* const numbers =
        value.channel ? span.plane(*value.channel, value.component) : nullptr;
    const Recoding recoding = recoding_of(value);
    const bool encodes = map.is_color() && c < 3 && !std::is_same_v<Sample, float>;
    const auto channels = static_cast<std::size_t>(image.channels);
    Sample* out = reinterpret_cast<Sample*>(image.data.data() +
                                            static_cast<std::size_t>(span.y) * image.row_bytes()) +
                  static_cast<std::size_t>(span.x) * channels + static_cast<std::size_t>(c);
    for (int i = 0; i < span.count; ++i, out += channels) {
        float number = numbers ? numbers[i] * recoding.scale + recoding.offset : value.constant;
        if (encodes) number = formulae::srgb_from_linear(std::clamp(number, 0.0f, 1.0f));
        *out = stored<Sample>(number);
    }
}

void pack(const PackedMap& map, const ChannelSpan& span, Image& image) {
    for (int c = 0; c < image.channels; ++c) {
        if (image.type == SampleType::U8) pack<std::uint8_t>(map, c, span, image);
        if (image.type == SampleType::U16) pack<std::uint16_t>(map, c, span, image);
        if (image.type == SampleType::F32) pack<float>(map, c, span, image);
    }
}

}  // namespace

std::vector<Channel> channels_of(const std::vector<PackedMap>& maps) {
    std::vector<Channel> channels;
    for (const PackedMap& map : maps)
        for (int i = 0; i < map.channels; ++i)
            if (const auto& channel = map.values[static_cast<std::size_t>(i)].channel)
                if (std::find(channels.begin(), channels.end(), *channel) == channels.end())
                    channels.push_back(*channel);
    return channels;
}

Result<std::vector<Image>> packed_channels(const Program& program, ImageProvider& images, int size,
                                           const std::vector<PackedMap>& maps, SampleType type,
                                           const Progress& progress) {
    std::vector<Image> packed;
    for (const PackedMap& map : maps) {
        Image image{
            .width = size, .height = size, .channels = map.channels, .type = type, .data = {}};
        const Status fits = check_free_memory(image.row_bytes() * static_cast<std::uint64_t>(size),
                                              fmt::format("maps of {} texels a side", size));
        if (!fits) return passed_on(fits);
        image.data.resize(image.row_bytes() * static_cast<std::size_t>(size));
        packed.push_back(std::move(image));
    }
    const Status done = composite_channels(
        program, images, size, channels_of(maps),
        [&](const ChannelSpan& span) {
            for (std::size_t i = 0; i < maps.size(); ++i) pack(maps[i], span, packed[i]);
        },
        progress);
    if (!done) return passed_on(done);
    return packed;
}

}  // namespace patina::io
