// SPDX-License-Identifier: MIT
#include "render/gpu_materials.h"

#include <algorithm>

#include "document/uv_rows.h"

namespace patina::render {
namespace {

constexpr int kMaterialBlockSlot = 0;
constexpr std::array<const char*, kTextureCount> kSamplerNames = {
    "base_color_map", "metallic_roughness_map", "normal_map",        "occlusion_map",
    "emissive_map",   "specular_map",           "specular_color_map"};

/// All that has a texture, in the order of kSamplerNames.
std::array<SurfaceSlot, kTextureCount> slots_of(const SurfaceMaterial& surface) {
    std::array<SurfaceSlot, kTextureCount> slots;
    std::copy(surface.slots.begin(), surface.slots.end(), slots.begin());
    slots[kSlotCount] = {.texture = surface.specular_map,
                         .multiply = {1.0f, 1.0f, 1.0f, surface.specular_factor}};
    slots[kSlotCount + 1] = {.texture = surface.specular_color_map,
                             .multiply = {surface.specular_color_linear, 1.0f}};
    return slots;
}

/// Laid out as `MaterialBlock` in passes/material.glsl (std140: everything is four floats).
struct SlotBlock {
    glm::vec4 multiply;
    glm::vec4 add;
    glm::vec4 uv_row_u;  ///< u' = dot(xyz, (u, v, 1)); w: the UV set
    glm::vec4 uv_row_v;  ///< v' likewise
};
struct MaterialBlock {
    std::array<SlotBlock, kTextureCount> slots;
    glm::vec4 alpha;         ///< x: AlphaMode, y: cutoff, z: 1 when double-sided, w: 1 when unlit
    glm::vec4 ior_emissive;  ///< x: IOR, y: emissive strength
};
static_assert(sizeof(MaterialBlock) == sizeof(glm::vec4) * (4 * kTextureCount + 2));

SlotBlock slot_block(const SurfaceSlot& slot) {
    const UvRows rows = uv_rows(slot.texture.transform);
    return {.multiply = slot.multiply,
            .add = slot.add,
            .uv_row_u = {rows.u, static_cast<float>(slot.texture.uv_set)},
            .uv_row_v = {rows.v, 0.0f}};
}

MaterialBlock material_block(const SurfaceMaterial& surface) {
    MaterialBlock block = {};
    const auto slots = slots_of(surface);
    std::transform(slots.begin(), slots.end(), block.slots.begin(), slot_block);
    block.alpha = {static_cast<float>(surface.alpha_mode), surface.alpha_cutoff,
                   surface.double_sided ? 1.0f : 0.0f, surface.unlit ? 1.0f : 0.0f};
    block.ior_emissive = {surface.ior, surface.emissive_strength, 0.0f, 0.0f};
    return block;
}

gl::Buffer block_buffer(const SurfaceMaterial& surface) {
    const MaterialBlock block = material_block(surface);
    return gl::Buffer::make({.label = "material",
                             .kind = gl::BufferKind::Uniforms,
                             .use = gl::BufferUse::Dynamic,
                             .content = std::as_bytes(std::span(&block, 1))});
}

gl::Wrap gl_wrap(Wrap wrap) {
    switch (wrap) {
        case Wrap::Repeat:
            return gl::Wrap::Repeat;
        case Wrap::Mirror:
            return gl::Wrap::MirroredRepeat;
        case Wrap::Clamp:
            return gl::Wrap::ClampToEdge;
    }
    return gl::Wrap::Repeat;
}

/// Anisotropy keeps sharp what is seen at a slant; more than that is hardly seen.
constexpr float kAnisotropy = 8.0f;

gl::Sampler make_sampler(Wrap u, Wrap v, Filter filter) {
    const bool nearest = filter == Filter::Nearest;
    return gl::Sampler::make({.label = "material map",
                              .wrap_u = gl_wrap(u),
                              .wrap_v = gl_wrap(v),
                              .magnify = nearest ? gl::Filter::Nearest : gl::Filter::Linear,
                              .minify = nearest ? gl::Filter::Nearest : gl::Filter::Linear,
                              .mip = nearest ? gl::MipFilter::Nearest : gl::MipFilter::Linear,
                              .anisotropy = nearest ? 1.0f : kAnisotropy});
}

std::array<int, 3> sampler_key(Wrap u, Wrap v, Filter filter) {
    return {static_cast<int>(u), static_cast<int>(v), static_cast<int>(filter)};
}

void upload(GpuTexture& gpu, int level, const TexelRect& rect) {
    const MipLevel& texels = gpu.chain.levels[static_cast<std::size_t>(level)];
    const std::size_t first =
        4 * (static_cast<std::size_t>(rect.y0) * static_cast<std::size_t>(texels.width) +
             static_cast<std::size_t>(rect.x0));
    const gl::TextureRegion region{.offset = {rect.x0, rect.y0},
                                   .size = {rect.x1 - rect.x0, rect.y1 - rect.y0},
                                   .level = level,
                                   .row_texels = texels.width};
    if (gpu.chain.storage == TexelStorage::Rgba8)
        gpu.texture.upload(region, std::span(texels.bytes).subspan(first));
    else
        gpu.texture.upload(region, std::span(texels.floats).subspan(first));
}

gl::Format texture_format(const MipChain& chain) {
    if (chain.storage == TexelStorage::RgbaFloat) return gl::Format::Rgba16F;
    return chain.meaning == TexelMeaning::Srgb ? gl::Format::Srgb8Alpha8 : gl::Format::Rgba8;
}

TexelMeaning meaning_of(const SurfaceTexture& texture, std::size_t slot) {
    if (slot == static_cast<std::size_t>(Slot::Normal)) return TexelMeaning::Normals;
    return texture.srgb ? TexelMeaning::Srgb : TexelMeaning::Linear;
}

Result<GpuTexturePtr> upload_new(const Image& image, TexelMeaning meaning) {
    MipChain chain = mip_chain(image, meaning);
    Result<gl::Texture> texture =
        gl::Texture::make({.label = "material map",
                           .size = {image.width, image.height},
                           .format = texture_format(chain),
                           .levels = static_cast<int>(chain.levels.size())});
    if (!texture) return passed_on(texture);
    auto gpu = std::make_shared<GpuTexture>(GpuTexture{std::move(*texture), std::move(chain)});
    for (std::size_t level = 0; level < gpu->chain.levels.size(); ++level) {
        const MipLevel& texels = gpu->chain.levels[level];
        upload(*gpu, static_cast<int>(level), {0, 0, texels.width, texels.height});
    }
    return gpu;
}

bool same_layout(const Image& a, const Image& b) {
    return a.width == b.width && a.height == b.height && a.channels == b.channels &&
           a.type == b.type;
}

}  // namespace

GpuMaterials::GpuMaterials() {
    for (const Wrap u : {Wrap::Repeat, Wrap::Mirror, Wrap::Clamp})
        for (const Wrap v : {Wrap::Repeat, Wrap::Mirror, Wrap::Clamp})
            for (const Filter filter : {Filter::Linear, Filter::Nearest})
                samplers_.emplace(sampler_key(u, v, filter), make_sampler(u, v, filter));
    const SurfaceMaterial surface = plain_surface();
    plain_.emplace(GpuMaterial{surface, {}, samplers_of(surface), block_buffer(surface)});
}

SlotBits textured_slots(const GpuMaterial& material) {
    SlotBits bits = 0;
    for (std::size_t i = 0; i < material.textures.size(); ++i)
        if (material.textures[i]) bits |= 1u << i;
    return bits;
}

bool GpuMaterials::used_elsewhere(const ImagePtr& pixels, int source_material) const {
    return std::any_of(materials_.begin(), materials_.end(), [&](const auto& entry) {
        const auto slots = slots_of(entry.second.surface);
        return entry.first != source_material &&
               std::any_of(slots.begin(), slots.end(),
                           [&](const SurfaceSlot& slot) { return slot.texture.pixels == pixels; });
    });
}

Result<GpuTexturePtr> GpuMaterials::texture_of(const TextureKey& wanted,
                                               const GpuTexturePtr& before,
                                               const ImagePtr& pixels_before, int source_material,
                                               const std::optional<TexelRect>& changed) {
    const auto& [pixels, meaning] = wanted;
    if (!pixels) return GpuTexturePtr();
    if (const auto found = textures_.find(wanted); found != textures_.end()) return found->second;

    const bool in_place = changed && before && before->chain.meaning == meaning &&
                          same_layout(*pixels_before, *pixels) &&
                          !used_elsewhere(pixels_before, source_material);
    if (!in_place) {
        Result<GpuTexturePtr> made = upload_new(*pixels, meaning);
        if (made) textures_[wanted] = *made;
        return made;
    }
    if (!changed->empty()) {
        const std::vector<TexelRect> rects = update_mip_chain(before->chain, *pixels, *changed);
        for (std::size_t level = 0; level < rects.size(); ++level)
            upload(*before, static_cast<int>(level), rects[level]);
    }
    textures_.erase({pixels_before, meaning});
    textures_[wanted] = before;
    return before;
}

Status GpuMaterials::set(int source_material, const SurfaceMaterial& surface,
                         const std::optional<TexelRect>& changed) {
    const auto before = materials_.find(source_material);
    const bool known = before != materials_.end();
    const auto slots = slots_of(surface);
    const auto slots_before = known ? slots_of(before->second.surface) : slots;
    std::array<GpuTexturePtr, kTextureCount> textures;
    for (std::size_t i = 0; i < textures.size(); ++i) {
        Result<GpuTexturePtr> texture =
            texture_of({slots[i].texture.pixels, meaning_of(slots[i].texture, i)},
                       known ? before->second.textures[i] : nullptr,
                       known ? slots_before[i].texture.pixels : nullptr, source_material, changed);
        if (!texture) return passed_on(texture);
        textures[i] = *texture;
    }
    if (!known) {
        materials_.emplace(
            source_material,
            GpuMaterial{surface, std::move(textures), samplers_of(surface), block_buffer(surface)});
    } else {
        const MaterialBlock block = material_block(surface);
        before->second.surface = surface;
        before->second.textures = std::move(textures);
        before->second.samplers = samplers_of(surface);
        before->second.block.write(std::as_bytes(std::span(&block, 1)));
    }
    forget_unused();
    return {};
}

void GpuMaterials::forget_unused() {
    std::erase_if(textures_, [](const auto& entry) { return entry.second.use_count() == 1; });
}

void GpuMaterials::clear() {
    materials_.clear();
    textures_.clear();
}

const GpuMaterial& GpuMaterials::at(int source_material) const {
    const auto found = materials_.find(source_material);
    return found == materials_.end() ? *plain_ : found->second;
}

bool GpuMaterials::any_needs_surface_target() const {
    return std::any_of(materials_.begin(), materials_.end(), [](const auto& entry) {
        const SurfaceMaterial& surface = entry.second.surface;
        return surface.unlit || surface.specular_factor != 1.0f || surface.specular_map.pixels;
    });
}

std::size_t GpuMaterials::texture_bytes() const {
    std::size_t bytes = 0;
    for (const auto& [key, gpu] : textures_) bytes += gpu->texture.bytes();
    return bytes;
}

std::array<const gl::Sampler*, kTextureCount> GpuMaterials::samplers_of(
    const SurfaceMaterial& surface) const {
    const auto slots = slots_of(surface);
    std::array<const gl::Sampler*, kTextureCount> samplers;
    std::transform(slots.begin(), slots.end(), samplers.begin(), [&](const SurfaceSlot& slot) {
        const SurfaceTexture& texture = slot.texture;
        return &samplers_.at(sampler_key(texture.wrap_u, texture.wrap_v, texture.filter));
    });
    return samplers;
}

void GpuMaterials::bind(gl::Pass& pass, gl::Program& program, const GpuMaterial& material) const {
    program.set_block("MaterialBlock", kMaterialBlockSlot);
    pass.bind_block(kMaterialBlockSlot, material.block);
    for (std::size_t i = 0; i < material.textures.size(); ++i)
        if (material.textures[i])
            pass.bind_texture(program, kSamplerNames[i], static_cast<int>(i),
                              material.textures[i]->texture, material.samplers[i]);
}

}  // namespace patina::render
