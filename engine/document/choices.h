// SPDX-License-Identifier: MIT
#pragma once

/// The closed sets that a document picks from, each as one table in the order of its enumerators:
/// the id in files and on the command line, and the label in menus. Blend modes, which say more of
/// themselves, are in blend_mode.h.

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>

#include "document/layer.h"
#include "document/material.h"
#include "document/source.h"
#include "scene/image.h"
#include "scene/scene.h"

namespace patina {

struct Choice {
    std::string_view id;
    std::string_view label;
};

inline constexpr std::array kBlendSpaces = {Choice{"linear", "Linear light"},
                                            Choice{"srgb-encoded", "sRGB-encoded"}};
inline constexpr std::array kAlphaModes = {Choice{"opaque", "Opaque"}, Choice{"mask", "Mask"},
                                           Choice{"blend", "Blend"}};
inline constexpr std::array kPaddings = {Choice{"auto", "Automatic"},
                                         Choice{"layers", "As layered"},
                                         Choice{"dilate", "Dilate islands"}};
inline constexpr std::array kWraps = {Choice{"repeat", "Repeat"}, Choice{"mirror", "Mirror"},
                                      Choice{"clamp", "Clamp"}};
inline constexpr std::array kProjectionKinds = {Choice{"uv", "UV"}, Choice{"planar", "Planar"},
                                                Choice{"tri-planar", "Tri-planar"}};
inline constexpr std::array kProjectionAxes = {Choice{"x", "X, from the right"},
                                               Choice{"y", "Y, from above"},
                                               Choice{"z", "Z, from the front"}};
inline constexpr std::array kFilters = {Choice{"linear", "Smooth"}, Choice{"nearest", "Pixels"}};
inline constexpr std::array kColorSpaces = {Choice{"srgb", "sRGB"}, Choice{"linear", "Linear"}};
inline constexpr std::array kChannelPicks = {Choice{"rgb", "RGB"}, Choice{"red", "Red"},
                                             Choice{"green", "Green"}, Choice{"blue", "Blue"},
                                             Choice{"alpha", "Alpha"}};
inline constexpr std::array kProceduralKinds = {
    Choice{"value-noise", "Value noise"},
    Choice{"perlin-noise", "Perlin noise"},
    Choice{"worley-noise", "Worley noise (F1)"},
    Choice{"simplex-noise", "Simplex noise"},
    Choice{"ridged-noise", "Ridged noise"},
    Choice{"turbulence", "Turbulence"},
    Choice{"worley-f2", "Worley noise (F2)"},
    Choice{"worley-edges", "Worley noise (F2 - F1)"},
    Choice{"cells", "Random cells"},
    Choice{"gradient-linear", "Linear gradient"},
    Choice{"gradient-radial", "Radial gradient"},
    Choice{"gradient-angular", "Angular gradient"},
    Choice{"checker", "Checker"},
    Choice{"stripes", "Stripes"},
    Choice{"bricks", "Bricks"},
    Choice{"tiles", "Tiles"},
    Choice{"hexagons", "Hexagons"},
    Choice{"weave", "Weave"},
    Choice{"spots", "Spots"},
    Choice{"scratches", "Scratches"},
    Choice{"cracks", "Cracks"},
    Choice{"wood-rings", "Wood rings"},
    Choice{"marble", "Marble"},
    Choice{"grunge", "Grunge"},
};
inline constexpr std::array kReliefKinds = {
    Choice{"relief-height", "Height below"}, Choice{"relief-cavity", "Cavities below"},
    Choice{"relief-edge", "Edges below"}, Choice{"relief-curvature", "Curvature below"}};
inline constexpr std::array kLayerResults = {
    Choice{"mask", "Mask"},           Choice{"base-color", "Base colour"},
    Choice{"metalness", "Metalness"}, Choice{"roughness", "Roughness"},
    Choice{"normal", "Normal"},       Choice{"height", "Height"},
    Choice{"occlusion", "Occlusion"}, Choice{"emissive", "Emissive"},
    Choice{"opacity", "Opacity"}};
inline constexpr std::array kAdjustmentKinds = {
    Choice{"levels", "Levels"},
    Choice{"curves", "Curves"},
    Choice{"hue-saturation", "Hue and saturation"},
    Choice{"brightness-contrast", "Brightness and contrast"},
    Choice{"invert", "Invert"},
    Choice{"posterise", "Posterise"},
    Choice{"gradient-map", "Gradient map"},
    Choice{"clamp", "Clamp"},
    Choice{"blur", "Blur"},
    Choice{"sharpen", "Sharpen"},
    Choice{"warp", "Warp"},
};
inline constexpr std::array kLightKinds = {
    Choice{"directional", "Directional"}, Choice{"point", "Point"}, Choice{"spot", "Spot"},
    Choice{"sphere", "Sphere"}, Choice{"rectangle", "Rectangle"}};
inline constexpr std::array kSampleTypes = {Choice{"u8", "8 bit"}, Choice{"u16", "16 bit"},
                                            Choice{"f32", "32 bit float"}};

/// The table of an enumeration, indexed by its enumerators.
template <typename Enumeration>
constexpr std::span<const Choice> choices() {
    if constexpr (std::is_same_v<Enumeration, BlendSpace>) return kBlendSpaces;
    if constexpr (std::is_same_v<Enumeration, AlphaMode>) return kAlphaModes;
    if constexpr (std::is_same_v<Enumeration, Padding>) return kPaddings;
    if constexpr (std::is_same_v<Enumeration, Wrap>) return kWraps;
    if constexpr (std::is_same_v<Enumeration, ProjectionKind>) return kProjectionKinds;
    if constexpr (std::is_same_v<Enumeration, ProjectionAxis>) return kProjectionAxes;
    if constexpr (std::is_same_v<Enumeration, Filter>) return kFilters;
    if constexpr (std::is_same_v<Enumeration, ColorSpace>) return kColorSpaces;
    if constexpr (std::is_same_v<Enumeration, ChannelPick>) return kChannelPicks;
    if constexpr (std::is_same_v<Enumeration, ProceduralKind>) return kProceduralKinds;
    if constexpr (std::is_same_v<Enumeration, ReliefKind>) return kReliefKinds;
    if constexpr (std::is_same_v<Enumeration, LayerResult>) return kLayerResults;
    if constexpr (std::is_same_v<Enumeration, AdjustmentKind>) return kAdjustmentKinds;
    if constexpr (std::is_same_v<Enumeration, Light::Kind>) return kLightKinds;
    if constexpr (std::is_same_v<Enumeration, SampleType>) return kSampleTypes;
}

template <typename Enumeration>
constexpr const Choice& choice(Enumeration value) {
    return choices<Enumeration>()[static_cast<std::size_t>(value)];
}
template <typename Enumeration>
constexpr std::optional<Enumeration> choice_from_id(std::string_view id) {
    const std::span<const Choice> table = choices<Enumeration>();
    for (std::size_t i = 0; i < table.size(); ++i)
        if (table[i].id == id) return static_cast<Enumeration>(i);
    return std::nullopt;
}

}  // namespace patina
