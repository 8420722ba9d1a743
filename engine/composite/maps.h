// SPDX-License-Identifier: MIT
#pragma once

/// What a stack composites to: the maps that glTF knows, ready for a texture or a file.

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <string_view>
#include <variant>

#include "document/source.h"
#include "scene/image.h"

namespace patina {

/// The maps that the bake makes.
enum class BakedMap : std::uint8_t {
    BaseColor,                    ///< RGBA8: base colour sRGB-encoded, opacity linear
    OcclusionRoughnessMetalness,  ///< RGBA8, linear, alpha 255: the packing that glTF names
    Normal,                       ///< RGBA8, tangent space, n * 0.5 + 0.5, +Y up, alpha 255
    Emissive,                     ///< RGBA8, sRGB-encoded, alpha 255
};
inline constexpr int kBakedMapCount = 4;
inline constexpr std::array<std::string_view, kBakedMapCount> kBakedMapIds = {
    "base-color", "occlusion-roughness-metalness", "normal", "emissive"};

/// The texture slots of a glTF material.
enum class Slot : std::uint8_t { BaseColor, MetallicRoughness, Normal, Occlusion, Emissive };
inline constexpr int kSlotCount = 5;

/// The baked map that holds a slot's numbers.
constexpr BakedMap baked_map_of(Slot slot) {
    switch (slot) {
        case Slot::BaseColor:
            return BakedMap::BaseColor;
        case Slot::MetallicRoughness:
        case Slot::Occlusion:
            return BakedMap::OcclusionRoughnessMetalness;
        case Slot::Normal:
            return BakedMap::Normal;
        case Slot::Emissive:
            return BakedMap::Emissive;
    }
    return BakedMap::BaseColor;
}

/// The slot needs no texture: glTF factors. BaseColor: linear RGB + alpha; MetallicRoughness: y
/// roughness, z metalness; Occlusion: x; Emissive: linear RGB. Normal: none (flat).
struct SlotConstant {
    glm::vec4 value = glm::vec4(1.0f);
    bool operator==(const SlotConstant&) const = default;
};
/// The slot shows one untouched image with its own UV set, transform, sampler and factors: in
/// MetallicRoughness `source` is the roughness one and `metalness` the other, of the same image.
struct SlotImage {
    ImageSource source;
    float metalness_factor = 1.0f;  ///< MetallicRoughness: what the blue channel is multiplied by
    float opacity_factor = 1.0f;    ///< BaseColor: what alpha is multiplied by
    bool operator==(const SlotImage&) const = default;
};
/// The slot shows (its channels of) a baked map.
struct SlotBaked {
    BakedMap map = BakedMap::BaseColor;
    bool operator==(const SlotBaked&) const = default;
};
using SlotPlan = std::variant<SlotConstant, SlotImage, SlotBaked>;

}  // namespace patina
