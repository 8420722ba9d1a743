// SPDX-License-Identifier: MIT
#include "io/packed_channels.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include "composite/bake_channels.h"
#include "core/formulae/formulae.h"
#include "core/parallel.h"

namespace patina::io {
namespace {

/// One number of a file: 0..1, but for floats of heights and of bright colours.
float packed_number(const PackedValue& value, float stored) {
    const ChannelKind kind = info(*value.channel).kind;
    if (kind == ChannelKind::Normal || kind == ChannelKind::Height)
        return (value.invert ? -stored : stored) * 0.5f + 0.5f;
    return value.invert ? 1.0f - stored : stored;
}

template <typename Sample>
Sample stored(float number) {
    const float held = std::clamp(number, 0.0f, 1.0f);
    if constexpr (std::is_same_v<Sample, std::uint8_t>)
        return static_cast<Sample>(static_cast<int>(held * 255.0f + 0.5f));
    else if constexpr (std::is_same_v<Sample, std::uint16_t>)
        return static_cast<Sample>(std::lround(held * 65535.0f));
    else
        return number;
}

/// Writes channel c of a span into a map.
template <typename Sample>
void pack(const PackedMap& map, int c, const ChannelSpan& span, Image& image) {
    const PackedValue& value = map.values[static_cast<std::size_t>(c)];
    const float* const numbers =
        value.channel ? span.plane(*value.channel, value.component) : nullptr;
    const bool encodes = map.is_color() && c < 3 && !std::is_same_v<Sample, float>;
    const auto channels = static_cast<std::size_t>(image.channels);
    Sample* out = reinterpret_cast<Sample*>(image.data.data() +
                                            static_cast<std::size_t>(span.y) * image.row_bytes()) +
                  static_cast<std::size_t>(span.x) * channels + static_cast<std::size_t>(c);
    for (int i = 0; i < span.count; ++i, out += channels) {
        float number = numbers ? packed_number(value, numbers[i]) : value.constant;
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

template <typename Sample>
bool all_one(const Image& image) {
    constexpr auto one =
        std::is_same_v<Sample, float> ? Sample{1} : std::numeric_limits<Sample>::max();
    const auto* const samples = reinterpret_cast<const Sample*>(image.data.data());
    const std::size_t count = image.data.size() / sizeof(Sample);
    const auto step = static_cast<std::size_t>(image.channels);
    for (std::size_t i = step - 1; i < count; i += step)
        if (samples[i] < one) return false;
    return true;
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

bool last_is_one(const Image& image) {
    switch (image.type) {
        case SampleType::U8:
            return all_one<std::uint8_t>(image);
        case SampleType::U16:
            return all_one<std::uint16_t>(image);
        case SampleType::F32:
            return all_one<float>(image);
    }
    return false;
}

Image without_last(const Image& image) {
    assert(image.channels > 1);
    Image result{.width = image.width,
                 .height = image.height,
                 .channels = image.channels - 1,
                 .type = image.type,
                 .data = {}};
    const auto texels =
        static_cast<std::int64_t>(image.width) * static_cast<std::int64_t>(image.height);
    const std::size_t from_bytes =
        static_cast<std::size_t>(image.channels) * sample_bytes(image.type);
    const std::size_t to_bytes = from_bytes - sample_bytes(image.type);
    result.data.resize(to_bytes * static_cast<std::size_t>(texels));
    parallel_for(0, texels, 1 << 16, [&](std::int64_t first, std::int64_t last) {
        for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
            std::memcpy(result.data.data() + i * to_bytes, image.data.data() + i * from_bytes,
                        to_bytes);
    });
    return result;
}

}  // namespace patina::io
