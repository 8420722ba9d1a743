// SPDX-License-Identifier: MIT
#pragma once

/// What the renderer draws a material with: for each texture slot of glTF a texture or none, and
/// the factors. A value; made from a material, its compiled slots and the maps baked from it.

#include <array>
#include <glm/glm.hpp>

#include "composite/composite.h"
#include "composite/image_provider.h"
#include "composite/maps.h"
#include "composite/program.h"
#include "document/material.h"

namespace patina::render {

/// Pixels and how they are read. Shared pixels are uploaded once, however many slots show them.
struct SurfaceTexture {
    ImagePtr pixels;  ///< null: no texture, every texel is 1 (a flat normal in the normal slot)
    bool srgb = false;
    int uv_set = 0;
    UvTransform transform = {};
    Wrap wrap_u = Wrap::Repeat;
    Wrap wrap_v = Wrap::Repeat;
    Filter filter = Filter::Linear;
    bool operator==(const SurfaceTexture&) const = default;
};

/// value = texel * multiply + add, where the texel is linear (normals: -1 to 1).
struct SurfaceSlot {
    SurfaceTexture texture;
    glm::vec4 multiply = glm::vec4(1.0f);
    glm::vec4 add = glm::vec4(0.0f);
    bool operator==(const SurfaceSlot&) const = default;
};

struct SurfaceMaterial {
    /// By Slot. MetallicRoughness: roughness in y, metalness in z; Occlusion: x.
    std::array<SurfaceSlot, kSlotCount> slots;
    AlphaMode alpha_mode = AlphaMode::Opaque;
    float alpha_cutoff = 0.5f;
    bool double_sided = false;
    bool unlit = false;
    float ior = 1.5f;
    float specular_factor = 1.0f;  ///< times the alpha of specular_map
    glm::vec3 specular_color_linear = glm::vec3(1.0f);
    SurfaceTexture specular_map = {};
    SurfaceTexture specular_color_map = {};
    float emissive_strength = 1.0f;

    SurfaceSlot& operator[](Slot slot) { return slots[static_cast<std::size_t>(slot)]; }
    const SurfaceSlot& operator[](Slot slot) const { return slots[static_cast<std::size_t>(slot)]; }
    bool operator==(const SurfaceMaterial&) const = default;
};

/// Base colour 0.5, metalness 0, roughness 0.5: what the bottom of every stack shows.
SurfaceMaterial plain_surface();

/// The surface of a material whose slots are planned as `slots`.
/// @param maps    holds every map that a SlotBaked of `slots` names
/// @param images  asked for the images that SlotImage names; it waits for their decoding. One that
///                cannot be decoded is left out, with a warning in the log.
SurfaceMaterial surface_of(const Material& material, const std::array<SlotPlan, kSlotCount>& slots,
                           const MapSet& maps, ImageProvider& images);

/// The baked maps that `slots` ask for, each once.
std::vector<BakedMap> baked_maps_of(const std::array<SlotPlan, kSlotCount>& slots);

}  // namespace patina::render
