// SPDX-License-Identifier: MIT
#pragma once

/// The blend modes as one table, from which menus, files, the command line and tests are fed. The
/// formulae are in shaders/shared (blend, blend_color, normal_blend, height) under the name
/// `formula`. To add a mode: one enumerator, one row, one function there.

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "document/channel.h"

namespace patina {

enum class BlendMode : std::uint8_t {
    Normal,
    Replace,
    Darken,
    Multiply,
    ColorBurn,
    LinearBurn,
    Lighten,
    Screen,
    ColorDodge,
    Add,
    Overlay,
    SoftLightW3c,
    SoftLightPegtop,
    HardLight,
    VividLight,
    LinearLight,
    PinLight,
    HardMix,
    Difference,
    Exclusion,
    Subtract,
    InverseSubtract,
    Divide,
    InverseDivide,
    SignedAdd,
    Average,
    HueW3c,
    SaturationW3c,
    ColorW3c,
    LuminosityW3c,
    TintHsv,
    SaturationHsv,
    ColorHsv,
    ValueHsv,
    NormalRnm,
    NormalUdn,
    NormalWhiteout,
    NormalPartial,
    HeightAdd,
    HeightMax,
    HeightMin,
    HeightSubtract,
    PassThrough,
};

/// For which kinds of channel a mode means something; bits of `1 << ChannelKind`.
using ChannelKinds = std::uint8_t;
constexpr ChannelKinds kind_bit(ChannelKind kind) {
    return static_cast<ChannelKinds>(1u << static_cast<unsigned>(kind));
}
inline constexpr ChannelKinds kColorOrScalar =
    kind_bit(ChannelKind::Color) | kind_bit(ChannelKind::Scalar);
inline constexpr ChannelKinds kColorOnly = kind_bit(ChannelKind::Color);
inline constexpr ChannelKinds kNormalOnly = kind_bit(ChannelKind::Normal);
inline constexpr ChannelKinds kHeightOnly = kind_bit(ChannelKind::Height);
/// Of a group alone: see blends_layer.
inline constexpr ChannelKinds kNoKind = 0;
inline constexpr ChannelKinds kAnyKind =
    kColorOrScalar | kind_bit(ChannelKind::Normal) | kind_bit(ChannelKind::Height);

struct BlendModeInfo {
    BlendMode mode;
    std::string_view id;       ///< in files and on the command line
    std::string_view label;    ///< in menus
    std::string_view group;    ///< heading in menus
    std::string_view formula;  ///< function in shaders/shared
    ChannelKinds kinds;
    std::string_view tooltip;  ///< one sentence or two
};

// The formatter would spread each row over several lines.
// clang-format off
inline constexpr std::array kBlendModes = {
    BlendModeInfo{BlendMode::Normal, "normal", "Normal", "Basic", "blend_normal", kAnyKind,
        "The layer covers what lies below."},
    BlendModeInfo{BlendMode::Replace, "replace", "Replace", "Basic", "blend_normal", kAnyKind,
        "Takes the place of what lies below; where the layer itself is clear, that is cleared too."},
    BlendModeInfo{BlendMode::Darken, "darken", "Darken", "Darker", "blend_darken", kColorOrScalar,
        "The darker of the two."},
    BlendModeInfo{BlendMode::Multiply, "multiply", "Multiply", "Darker", "blend_multiply", kColorOrScalar,
        "Both multiplied: always darker. White changes nothing."},
    BlendModeInfo{BlendMode::ColorBurn, "color-burn", "Colour burn", "Darker", "blend_color_burn", kColorOrScalar,
        "Darkens with more contrast. White changes nothing."},
    BlendModeInfo{BlendMode::LinearBurn, "linear-burn", "Linear burn", "Darker", "blend_linear_burn", kColorOrScalar,
        "The sum less 1. White changes nothing."},
    BlendModeInfo{BlendMode::Lighten, "lighten", "Lighten", "Lighter", "blend_lighten", kColorOrScalar,
        "The lighter of the two."},
    BlendModeInfo{BlendMode::Screen, "screen", "Screen", "Lighter", "blend_screen", kColorOrScalar,
        "Multiplies the complements: always lighter. Black changes nothing."},
    BlendModeInfo{BlendMode::ColorDodge, "color-dodge", "Colour dodge", "Lighter", "blend_color_dodge", kColorOrScalar,
        "Lightens with more contrast. Black changes nothing."},
    BlendModeInfo{BlendMode::Add, "add", "Add (linear dodge)", "Lighter", "blend_add", kColorOrScalar,
        "The sum, at most 1. Black changes nothing."},
    BlendModeInfo{BlendMode::Overlay, "overlay", "Overlay", "Contrast", "blend_overlay", kColorOrScalar,
        "Multiplies where it is dark below, screens where it is light. Middle grey changes nothing."},
    BlendModeInfo{BlendMode::SoftLightW3c, "soft-light-w3c", "Soft light (W3C)", "Contrast", "blend_soft_light_w3c", kColorOrScalar,
        "Gentle darkening and lightening, as W3C and PDF define it. Middle grey changes nothing."},
    BlendModeInfo{BlendMode::SoftLightPegtop, "soft-light-pegtop", "Soft light (Pegtop)", "Contrast", "blend_soft_light_pegtop", kColorOrScalar,
        "Gentle darkening and lightening without a break. Middle grey changes nothing."},
    BlendModeInfo{BlendMode::HardLight, "hard-light", "Hard light", "Contrast", "blend_hard_light", kColorOrScalar,
        "Multiplies by dark sources, screens with light ones. Middle grey changes nothing."},
    BlendModeInfo{BlendMode::VividLight, "vivid-light", "Vivid light", "Contrast", "blend_vivid_light", kColorOrScalar,
        "Burns by dark sources, dodges by light ones. Middle grey changes nothing."},
    BlendModeInfo{BlendMode::LinearLight, "linear-light", "Linear light", "Contrast", "blend_linear_light", kColorOrScalar,
        "Adds twice the distance from middle grey, which changes nothing."},
    BlendModeInfo{BlendMode::PinLight, "pin-light", "Pin light", "Contrast", "blend_pin_light", kColorOrScalar,
        "Darkens with dark sources, lightens with light ones."},
    BlendModeInfo{BlendMode::HardMix, "hard-mix", "Hard mix", "Contrast", "blend_hard_mix", kColorOrScalar,
        "Each component 1 where the sum reaches 1, else 0."},
    BlendModeInfo{BlendMode::Difference, "difference", "Difference", "Inversion", "blend_difference", kColorOrScalar,
        "How far the two are apart. Black changes nothing."},
    BlendModeInfo{BlendMode::Exclusion, "exclusion", "Exclusion", "Inversion", "blend_exclusion", kColorOrScalar,
        "Difference with less contrast. Black changes nothing, white inverts."},
    BlendModeInfo{BlendMode::Subtract, "subtract", "Subtract", "Arithmetic", "blend_subtract", kColorOrScalar,
        "What lies below less the layer, at least 0. Black changes nothing."},
    BlendModeInfo{BlendMode::InverseSubtract, "inverse-subtract", "Inverse subtract", "Arithmetic", "blend_inverse_subtract", kColorOrScalar,
        "The layer less what lies below, at least 0."},
    BlendModeInfo{BlendMode::Divide, "divide", "Divide", "Arithmetic", "blend_divide", kColorOrScalar,
        "What lies below over the layer, at most 1. White changes nothing."},
    BlendModeInfo{BlendMode::InverseDivide, "inverse-divide", "Inverse divide", "Arithmetic", "blend_inverse_divide", kColorOrScalar,
        "The layer over what lies below, at most 1."},
    BlendModeInfo{BlendMode::SignedAdd, "signed-add", "Signed add", "Arithmetic", "blend_signed_add", kColorOrScalar,
        "Adds the distance from middle grey, which changes nothing."},
    BlendModeInfo{BlendMode::Average, "average", "Average", "Arithmetic", "blend_average", kColorOrScalar,
        "Half of each."},
    BlendModeInfo{BlendMode::HueW3c, "hue-w3c", "Hue (W3C)", "Colour (luminosity)", "blend_hue_w3c", kColorOnly,
        "The layer's hue, the saturation and luminosity below; as raster editors have it."},
    BlendModeInfo{BlendMode::SaturationW3c, "saturation-w3c", "Saturation (W3C)", "Colour (luminosity)", "blend_saturation_w3c", kColorOnly,
        "The layer's saturation, the hue and luminosity below; as raster editors have it."},
    BlendModeInfo{BlendMode::ColorW3c, "color-w3c", "Colour (W3C)", "Colour (luminosity)", "blend_color_w3c", kColorOnly,
        "The layer's hue and saturation, the luminosity below; as raster editors have it."},
    BlendModeInfo{BlendMode::LuminosityW3c, "luminosity-w3c", "Luminosity (W3C)", "Colour (luminosity)", "blend_luminosity_w3c", kColorOnly,
        "The layer's luminosity, the hue and saturation below; as raster editors have it."},
    BlendModeInfo{BlendMode::TintHsv, "tint-hsv", "Tint (HSV hue)", "Colour (HSV)", "blend_tint_hsv", kColorOnly,
        "The layer's hue, the saturation and value below; HSV, as painting programs have it."},
    BlendModeInfo{BlendMode::SaturationHsv, "saturation-hsv", "Saturation (HSV)", "Colour (HSV)", "blend_saturation_hsv", kColorOnly,
        "The layer's saturation, the hue and value below; HSV, as painting programs have it."},
    BlendModeInfo{BlendMode::ColorHsv, "color-hsv", "Colour (HSV)", "Colour (HSV)", "blend_color_hsv", kColorOnly,
        "The layer's hue and saturation, the value below; HSV, as painting programs have it."},
    BlendModeInfo{BlendMode::ValueHsv, "value-hsv", "Value (HSV)", "Colour (HSV)", "blend_value_hsv", kColorOnly,
        "The layer's value, the hue and saturation below; HSV, as painting programs have it."},
    BlendModeInfo{BlendMode::NormalRnm, "nrm-rnm", "RNM", "Normal", "normal_blend_rnm", kNormalOnly,
        "Lays the relief on that below with both at full strength. The best for detail."},
    BlendModeInfo{BlendMode::NormalUdn, "nrm-udn", "UDN", "Normal", "normal_blend_udn", kNormalOnly,
        "Adds the slopes and keeps the flatness below: soft, and cheap in games."},
    BlendModeInfo{BlendMode::NormalWhiteout, "nrm-whiteout", "Whiteout", "Normal", "normal_blend_whiteout", kNormalOnly,
        "Adds the slopes and multiplies the flatness: stronger than UDN."},
    BlendModeInfo{BlendMode::NormalPartial, "nrm-partial-derivative", "Partial derivative", "Normal", "normal_blend_partial_derivative", kNormalOnly,
        "Adds the slopes of the two reliefs as heights would add."},
    BlendModeInfo{BlendMode::HeightAdd, "h-add", "Add", "Height", "height_add", kHeightOnly,
        "The sum; 0 changes nothing."},
    BlendModeInfo{BlendMode::HeightMax, "h-max", "Highest", "Height", "height_max", kHeightOnly,
        "The higher of the two."},
    BlendModeInfo{BlendMode::HeightMin, "h-min", "Lowest", "Height", "height_min", kHeightOnly,
        "The lower of the two."},
    BlendModeInfo{BlendMode::HeightSubtract, "h-subtract", "Subtract", "Height", "height_subtract", kHeightOnly,
        "What lies below less the layer; 0 changes nothing."},
    BlendModeInfo{BlendMode::PassThrough, "pass-through", "Pass through", "Group", "replaced_premultiplied", kNoKind,
        "The layers of the group see what lies below it, as if there were no group."},
};
// clang-format on

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

/// Whether entries of a mask can join by the mode. Of the two that leave the source alone, which
/// are the same where all is covered, it is Replace.
constexpr bool combines_masks(BlendMode mode) {
    return (info(mode).kinds & kind_bit(ChannelKind::Scalar)) != 0 && mode != BlendMode::Normal;
}

/// Whether a layer can have the mode for its colours: pass-through is one of groups.
constexpr bool blends_layer(BlendMode mode, bool group) {
    return mode == BlendMode::PassThrough ? group : applies_to(mode, Channel::BaseColor);
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
