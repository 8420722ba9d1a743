// SPDX-License-Identifier: MIT
#pragma once

/// What an adjustment layer does to the channels below it, or an entry of a mask to those before
/// it. The formulae are in shaders/shared/adjust.glsl and, of those that look around,
/// neighbourhood.glsl. Colours and scalars are taken as 0..1 in the layer's blend space, heights of
/// -1..1 as 0..1; normals can only be blurred, sharpened and warped.

#include <cstdint>
#include <vector>

#include "document/channel.h"
#include "document/levels.h"
#include "document/source.h"

namespace patina {

enum class AdjustmentKind : std::uint8_t {
    Levels,
    Curves,
    HueSaturation,
    BrightnessContrast,
    Invert,
    Posterise,
    GradientMap,
    Clamp,
    Blur,
    Sharpen,
    Warp,
};

/// Whether a texel's result depends on its neighbours; the borders of the texture meet.
constexpr bool looks_around(AdjustmentKind kind) {
    return kind == AdjustmentKind::Blur || kind == AdjustmentKind::Sharpen ||
           kind == AdjustmentKind::Warp;
}
/// Whether the channel can be adjusted so: a direction is no number that has levels or contrast.
constexpr bool adjusts(AdjustmentKind kind, Channel channel) {
    return channel != Channel::Normal || looks_around(kind);
}
/// Whether a mask can be adjusted so: it has no colours.
constexpr bool adjusts_masks(AdjustmentKind kind) {
    return kind != AdjustmentKind::HueSaturation && kind != AdjustmentKind::GradientMap;
}

struct CurvePoint {
    float x = 0.0f;
    float y = 0.0f;
    bool operator==(const CurvePoint&) const = default;
};
inline constexpr int kMaxCurvePoints = 8;

/// One kind is in force; the numbers of the others are kept for when it is chosen again.
struct AdjustmentSettings {
    AdjustmentKind kind = AdjustmentKind::Levels;
    Levels levels = {};
    /// 2 to kMaxCurvePoints, each 0 to 1, x ascending.
    std::vector<CurvePoint> curve = {{0.0f, 0.0f}, {1.0f, 1.0f}};
    float hue_degrees = 0.0f;  ///< -180 to 180
    float saturation = 0.0f;   ///< -1 to 1
    float lightness = 0.0f;    ///< -1 to 1
    float brightness = 0.0f;   ///< -1 to 1
    float contrast = 0.0f;     ///< -1 to 1
    int steps = 4;             ///< 2 to 64
    /// What the luminance of a colour (or a scalar) from 0 to 1 becomes: linear colours, of which a
    /// scalar takes the red. 1 to kMaxRampStops, ascending.
    std::vector<RampStop> gradient = {{0.0f, glm::vec3(0.0f)}, {1.0f, glm::vec3(1.0f)}};
    float low = 0.0f;   ///< 0 to 1, at most `high`
    float high = 1.0f;  ///< 0 to 1
    /// How far a blur, or the one that sharpening takes away, reaches; 0.1 to 50 thousandths of the
    /// texture's side.
    float radius_permille = 5.0f;
    float amount = 1.0f;              ///< 0 to 5: how strongly to sharpen
    float distance_permille = 10.0f;  ///< 0 to 100 thousandths of the side: the farthest of a warp
    float scale = 8.0f;               ///< 1 to 128: cells of a warp's noise across the texture
    int octaves = 3;                  ///< 1 to 10: of a warp's noise
    std::uint32_t seed = 0;           ///< of a warp's noise
    bool operator==(const AdjustmentSettings&) const = default;
};

}  // namespace patina
