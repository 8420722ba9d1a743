// SPDX-License-Identifier: MIT
#pragma once

/// A material in the words of glTF: what one slot shows, and the settings beside the slots. Members
/// that these functions do not name are left alone.

#include <glm/glm.hpp>
#include <optional>

#include "composite/maps.h"
#include "document/material.h"
#include "io/gltf_json.h"

namespace patina::io {

/// A texture info, as a slot is to say it.
struct StatedTexture {
    int texture = 0;
    int uv_set = 0;
    UvTransform transform;
};

/// What a slot says.
struct SlotStatement {
    std::optional<StatedTexture> texture;
    /// BaseColor: linear RGB and alpha; MetallicRoughness: y roughness, z metalness; Normal: x
    /// scale; Occlusion: x strength; Emissive: linear RGB. Times the texture, where there is one.
    glm::vec4 factor = glm::vec4(1.0f);
};

/// Makes the slot of a glTF material say that. Members at their default that are not there stay
/// away. A texture info keeps its unknown members.
void state_slot(Json& material, Slot slot, const SlotStatement& statement);

/// The texture that the slot shows now, or -1.
int slot_texture(const Json& material, Slot slot);

/// Makes name, alpha mode, cutoff, double-sidedness, unlit, IOR, specular and emissive strength
/// those of `now` where they differ from `before` (glTF's defaults where that is null).
void state_settings(Json& material, const Material& now, const Material* before);

/// Lists in extensionsUsed what the functions above have put into the material.
void list_extensions(GltfJson& gltf, const Json& material);

}  // namespace patina::io
