// SPDX-License-Identifier: MIT
#include "render/surface.h"

#include <algorithm>

#include "core/log.h"

namespace patina::render {
namespace {

constexpr std::array<Slot, kSlotCount> kSlots = {Slot::BaseColor, Slot::MetallicRoughness,
                                                 Slot::Normal, Slot::Occlusion, Slot::Emissive};

ImagePtr pixels_or_warning(const ImageSource& source, ImageProvider& images) {
    Result<ImagePtr> pixels = images.pixels(source.image);
    if (pixels) return *pixels;
    log_warning("a texture is left out of the picture: {}", pixels.error().message);
    return nullptr;
}

/// The factors of a slot that shows an image, in the order of the texel's numbers.
glm::vec4 factors_of(Slot slot, const SlotImage& image) {
    const glm::vec3 factor = image.source.multiply;
    switch (slot) {
        case Slot::BaseColor:
            return glm::vec4(factor, image.opacity_factor);
        case Slot::MetallicRoughness:
            return glm::vec4(1.0f, factor.x, image.metalness_factor, 1.0f);
        case Slot::Normal:
            return glm::vec4(factor.x, image.source.directx_normal ? -factor.y : factor.y, factor.z,
                             1.0f);
        case Slot::Occlusion:
        case Slot::Emissive:
            break;
    }
    return glm::vec4(factor, 1.0f);
}

SurfaceSlot constant_slot(Slot slot, const SlotConstant& constant) {
    if (slot == Slot::Normal) return {};
    return {.texture = {}, .multiply = constant.value};
}

SurfaceTexture image_texture(const ImageSource& source, ImageProvider& images) {
    return {.pixels = pixels_or_warning(source, images),
            .srgb = source.color_space == ColorSpace::Srgb,
            .uv_set = source.uv_set,
            .transform = source.transform,
            .wrap_u = source.wrap_u,
            .wrap_v = source.wrap_v,
            .filter = source.filter};
}

SurfaceSlot image_slot(Slot slot, const SlotImage& image, ImageProvider& images) {
    const glm::vec3 add = image.source.add;
    return {.texture = image_texture(image.source, images),
            .multiply = factors_of(slot, image),
            .add = slot == Slot::MetallicRoughness ? glm::vec4(0.0f, add.x, 0.0f, 0.0f)
                                                   : glm::vec4(add, 0.0f)};
}

SurfaceSlot baked_slot(const SlotBaked& baked, const Material& material, const MapSet& maps) {
    const bool srgb = baked.map == BakedMap::BaseColor || baked.map == BakedMap::Emissive;
    return {.texture = {.pixels = maps[baked.map], .srgb = srgb, .uv_set = material.uv_set}};
}

}  // namespace

SurfaceMaterial plain_surface() {
    SurfaceMaterial surface;
    surface[Slot::BaseColor].multiply = glm::vec4(0.5f, 0.5f, 0.5f, 1.0f);
    surface[Slot::MetallicRoughness].multiply = glm::vec4(1.0f, 0.5f, 0.0f, 1.0f);
    surface[Slot::Emissive].multiply = glm::vec4(0.0f);
    return surface;
}

SurfaceMaterial surface_of(const Material& material, const std::array<SlotPlan, kSlotCount>& slots,
                           const MapSet& maps, ImageProvider& images) {
    SurfaceMaterial surface;
    surface.alpha_mode = material.alpha_mode;
    surface.alpha_cutoff = material.alpha_cutoff;
    surface.double_sided = material.double_sided;
    surface.unlit = material.unlit;
    surface.ior = material.ior;
    surface.specular_factor = material.specular_factor;
    surface.specular_color_linear = material.specular_color_linear;
    if (material.specular_map) surface.specular_map = image_texture(*material.specular_map, images);
    if (material.specular_color_map)
        surface.specular_color_map = image_texture(*material.specular_color_map, images);
    surface.emissive_strength = material.emissive_strength;
    for (const Slot slot : kSlots) {
        const SlotPlan& plan = slots[static_cast<std::size_t>(slot)];
        if (const auto* constant = std::get_if<SlotConstant>(&plan))
            surface[slot] = constant_slot(slot, *constant);
        else if (const auto* image = std::get_if<SlotImage>(&plan))
            surface[slot] = image_slot(slot, *image, images);
        else
            surface[slot] = baked_slot(std::get<SlotBaked>(plan), material, maps);
    }
    return surface;
}

std::vector<BakedMap> baked_maps_of(const std::array<SlotPlan, kSlotCount>& slots) {
    std::vector<BakedMap> result;
    for (const SlotPlan& plan : slots) {
        const auto* baked = std::get_if<SlotBaked>(&plan);
        if (baked != nullptr && std::find(result.begin(), result.end(), baked->map) == result.end())
            result.push_back(baked->map);
    }
    return result;
}

}  // namespace patina::render
