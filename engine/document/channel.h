// SPDX-License-Identifier: MIT
#pragma once

/// The eight channels of a material, in the order in which they are stored and shown.

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace patina {

enum class Channel : std::uint8_t {
    BaseColor,
    Metalness,
    Roughness,
    Normal,
    Height,
    Occlusion,
    Emissive,
    Opacity,
};
inline constexpr int kChannelCount = 8;

/// What the numbers of a channel are, which decides how they blend.
enum class ChannelKind : std::uint8_t {
    Color,   ///< RGB, linear light
    Scalar,  ///< one number, 0..1
    Normal,  ///< tangent space, unit, +Y up (OpenGL, as glTF)
    Height,  ///< signed, 0 is the surface
};

struct ChannelInfo {
    Channel channel;
    std::string_view id;     ///< in files and on the command line, such as "base-color"
    std::string_view label;  ///< in the interface, such as "Base colour"
    ChannelKind kind;
    std::string_view tooltip;
};

inline constexpr std::array<ChannelInfo, kChannelCount> kChannels = {{
    {Channel::BaseColor, "base-color", "Base colour", ChannelKind::Color,
     "Colour of the surface: of diffuse light for non-metals, of reflections for metals."},
    {Channel::Metalness, "metalness", "Metalness", ChannelKind::Scalar,
     "1 is bare metal, 0 is everything else."},
    {Channel::Roughness, "roughness", "Roughness", ChannelKind::Scalar,
     "0 is a mirror, 1 is fully matt."},
    {Channel::Normal, "normal", "Normal", ChannelKind::Normal,
     "Fine relief as directions in tangent space, +Y up."},
    {Channel::Height, "height", "Height", ChannelKind::Height,
     "Fine relief as height; 0 is the surface. Becomes part of the normal in the bake."},
    {Channel::Occlusion, "occlusion", "Occlusion", ChannelKind::Scalar,
     "How much ambient light reaches the surface; 1 is all of it."},
    {Channel::Emissive, "emissive", "Emissive", ChannelKind::Color,
     "Light that the surface sends out itself."},
    {Channel::Opacity, "opacity", "Opacity", ChannelKind::Scalar,
     "1 is solid, 0 is clear. Shown when the material's alpha mode is not opaque."},
}};

constexpr const ChannelInfo& info(Channel channel) {
    return kChannels[static_cast<std::size_t>(channel)];
}
constexpr std::optional<Channel> channel_from_id(std::string_view id) {
    for (const ChannelInfo& entry : kChannels)
        if (entry.id == id) return entry.channel;
    return std::nullopt;
}

/// One value for each channel, such as `PerChannel<float>`; index it with `at(values, channel)`.
template <typename T>
using PerChannel = std::array<T, kChannelCount>;

template <typename T>
constexpr T& at(PerChannel<T>& values, Channel channel) {
    return values[static_cast<std::size_t>(channel)];
}
template <typename T>
constexpr const T& at(const PerChannel<T>& values, Channel channel) {
    return values[static_cast<std::size_t>(channel)];
}

}  // namespace patina
