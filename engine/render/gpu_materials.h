// SPDX-License-Identifier: MIT
#pragma once

/// The materials of a scene on the GPU: their textures, each uploaded once, and for each material a
/// uniform block.

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>

#include "core/result.h"
#include "gl/buffer.h"
#include "gl/pass.h"
#include "gl/sampler.h"
#include "gl/texture.h"
#include "render/mip_chain.h"
#include "render/surface.h"

namespace patina::render {

/// Texels on the GPU beside the CPU's copy of their mips.
struct GpuTexture {
    gl::Texture texture;
    MipChain chain;
};
using GpuTexturePtr = std::shared_ptr<GpuTexture>;

/// The slots of glTF's core, then KHR_materials_specular's two.
inline constexpr std::size_t kTextureCount = kSlotCount + 2;

struct GpuMaterial {
    SurfaceMaterial surface;
    std::array<GpuTexturePtr, kTextureCount> textures;       ///< null where a slot has none
    std::array<const gl::Sampler*, kTextureCount> samplers;  ///< of GpuMaterials
    gl::Buffer block;  ///< `MaterialBlock` of passes/material.glsl
};

/// A bit for each of the kTextureCount slots, the first the lowest.
using SlotBits = std::uint32_t;
inline constexpr SlotBits kBaseColorSlot = 1;
inline constexpr SlotBits kAllSlots = (1u << kTextureCount) - 1;
/// Those that have a texture.
SlotBits textured_slots(const GpuMaterial& material);

class GpuMaterials {
  public:
    GpuMaterials();

    Status set(int source_material, const SurfaceMaterial& surface,
               const std::optional<TexelRect>& changed);
    void clear();

    /// The material of primitives with this source_material, or the plain one.
    const GpuMaterial& at(int source_material) const;
    /// Whether any material needs the `surface` target (F90 or unlit).
    bool any_needs_surface_target() const;
    std::size_t texture_bytes() const;

    /// Lets the program of a pass read a material. Takes texture units 0 to 6.
    void bind(gl::Pass& pass, gl::Program& program, const GpuMaterial& material) const;

  private:
    /// The pixels themselves, which are held: the address cannot come back as other content.
    using TextureKey = std::pair<ImagePtr, TexelMeaning>;
    Result<GpuTexturePtr> texture_of(const TextureKey& wanted, const GpuTexturePtr& before,
                                     const ImagePtr& pixels_before, int source_material,
                                     const std::optional<TexelRect>& changed);
    bool used_elsewhere(const ImagePtr& pixels, int source_material) const;
    std::array<const gl::Sampler*, kTextureCount> samplers_of(const SurfaceMaterial& surface) const;
    void forget_unused();

    std::map<std::array<int, 3>, gl::Sampler> samplers_;  // by wrap u, wrap v, filter
    std::map<TextureKey, GpuTexturePtr> textures_;
    std::map<int, GpuMaterial> materials_;
    std::optional<GpuMaterial> plain_;
};

}  // namespace patina::render
