// SPDX-License-Identifier: MIT
#pragma once

/// The blend modes as one table, from which menus, files, the command line and tests are fed. The
/// formulae are in shaders/shared/blend.glsl and normal_blend.glsl under the name `formula`.
/// To add a mode: one enumerator, one row, one function there.

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "document/channel.h"

namespace patina {

enum class BlendMode : std::uint8_t {
    Normal,
    Darken,
    Multiply,
    Lighten,
    Screen,
    Add,
    Overlay,
    SoftLightW3c,
    Difference,
    Subtract,
    NormalRnm,
    NormalUdn,
    NormalWhiteout,
    HeightAdd,
    HeightMax,
};

/// For which kinds of channel a mode means something; bits of `1 << ChannelKind`.
using ChannelKinds = std::uint8_t;
constexpr ChannelKinds kind_bit(ChannelKind kind) {
    return static_cast<ChannelKinds>(1u << static_cast<unsigned>(kind));
}
inline constexpr ChannelKinds kColorOrScalar =
    kind_bit(ChannelKind::Color) | kind_bit(ChannelKind::Scalar);
inline constexpr ChannelKinds kAnyKind =
    kColorOrScalar | kind_bit(ChannelKind::Normal) | kind_bit(ChannelKind::Height);

struct BlendModeInfo {
    BlendMode mode;
    std::string_view id;       ///< in files and on the command line
    std::string_view label;    ///< in menus
    std::string_view group;    ///< heading in menus
    std::string_view formula;  ///< function in shaders/shared
    ChannelKinds kinds;
};

inline constexpr std::array kBlendModes = {
    BlendModeInfo{BlendMode::Normal, "normal", "Normal", "Basic", "blend_normal", kAnyKind},
    BlendModeInfo{BlendMode::Darken, "darken", "Darken", "Darker", "blend_darken", kColorOrScalar},
    BlendModeInfo{BlendMode::Multiply, "multiply", "Multiply", "Darker", "blend_multiply",
                  kColorOrScalar},
    BlendModeInfo{BlendMode::Lighten, "lighten", "Lighten", "Lighter", "blend_lighten",
                  kColorOrScalar},
    BlendModeInfo{BlendMode::Screen, "screen", "Screen", "Lighter", "blend_screen", kColorOrScalar},
    BlendModeInfo{BlendMode::Add, "add", "Add (linear dodge)", "Lighter", "blend_add",
                  kColorOrScalar},
    BlendModeInfo{BlendMode::Overlay, "overlay", "Overlay", "Contrast", "blend_overlay",
                  kColorOrScalar},
    BlendModeInfo{BlendMode::SoftLightW3c, "soft-light-w3c", "Soft light (W3C)", "Contrast",
                  "blend_soft_light_w3c", kColorOrScalar},
    BlendModeInfo{BlendMode::Difference, "difference", "Difference", "Inversion",
                  "blend_difference", kColorOrScalar},
    BlendModeInfo{BlendMode::Subtract, "subtract", "Subtract", "Inversion", "blend_subtract",
                  kColorOrScalar},
    BlendModeInfo{BlendMode::NormalRnm, "nrm-rnm", "RNM", "Normal", "normal_blend_rnm",
                  kind_bit(ChannelKind::Normal)},
    BlendModeInfo{BlendMode::NormalUdn, "nrm-udn", "UDN", "Normal", "normal_blend_udn",
                  kind_bit(ChannelKind::Normal)},
    BlendModeInfo{BlendMode::NormalWhiteout, "nrm-whiteout", "Whiteout", "Normal",
                  "normal_blend_whiteout", kind_bit(ChannelKind::Normal)},
    BlendModeInfo{BlendMode::HeightAdd, "h-add", "Add", "Height", "height_add",
                  kind_bit(ChannelKind::Height)},
    BlendModeInfo{BlendMode::HeightMax, "h-max", "Highest", "Height", "height_max",
                  kind_bit(ChannelKind::Height)},
};

constexpr const BlendModeInfo& info(BlendMode mode) {
    return kBlendModes[static_cast<std::size_t>(mode)];
}
constexpr std::optional<BlendMode> blend_mode_from_id(std::string_view id) {
    for (const BlendModeInfo& entry : kBlendModes)
        if (entry.id == id) return entry.mode;
    return std::nullopt;
}
constexpr bool applies_to(BlendMode mode, Channel channel) {
    return (info(mode).kinds & kind_bit(info(channel).kind)) != 0;
}

/// The mode of a channel that states none and has no layer mode that fits: normal for colours,
/// metalness, roughness and opacity; RNM; height add; multiply for occlusion (missing is 1).
constexpr BlendMode default_blend_mode(Channel channel) {
    switch (channel) {
        case Channel::Normal:
            return BlendMode::NormalRnm;
        case Channel::Height:
            return BlendMode::HeightAdd;
        case Channel::Occlusion:
            return BlendMode::Multiply;
        case Channel::BaseColor:
        case Channel::Metalness:
        case Channel::Roughness:
        case Channel::Emissive:
        case Channel::Opacity:
            return BlendMode::Normal;
    }
    return BlendMode::Normal;
}

}  // namespace patina
