// SPDX-License-Identifier: MIT
#include "io/material_read.h"

#include <algorithm>
#include <bit>

namespace patina::io {
namespace {

using tinygltf::Model;

/// The asset that a use of a texture shows, or null.
ImageAssetPtr image_of(const Model& model, const TextureUse& use, const FileImages& images) {
    const int image = image_index(model, use);
    return image < 0 ? nullptr : images[static_cast<std::size_t>(image)];
}

Wrap wrap_of(int mode) {
    if (mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT) return Wrap::Mirror;
    return mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE ? Wrap::Clamp : Wrap::Repeat;
}

struct Reading {
    ColorSpace color_space = ColorSpace::Linear;
    ChannelPick pick = ChannelPick::Rgb;
    glm::vec3 multiply = glm::vec3(1.0f);
    glm::vec3 add = glm::vec3(0.0f);
};

ImageSource image_source(const Model& model, const TextureUse& use, const ImageAsset& image,
                         const Reading& reading) {
    ImageSource source;
    source.image = image.hash;
    source.color_space = reading.color_space;
    source.pick = reading.pick;
    source.multiply = reading.multiply;
    source.add = reading.add;
    source.uv_set = use.uv_set;
    source.transform = use.transform;
    const int sampler = model.textures[static_cast<std::size_t>(use.texture)].sampler;
    if (sampler < 0) return source;
    const tinygltf::Sampler& settings = model.samplers[static_cast<std::size_t>(sampler)];
    source.wrap_u = wrap_of(settings.wrapS);
    source.wrap_v = wrap_of(settings.wrapT);
    if (settings.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST) source.filter = Filter::Nearest;
    return source;
}

/// What a use of a texture shows, where it shows an image.
std::optional<ImageSource> shown_image(const Model& model, const TextureUse& use,
                                       const FileImages& images, const Reading& reading) {
    const ImageAssetPtr image = image_of(model, use, images);
    if (!image) return std::nullopt;
    return image_source(model, use, *image, reading);
}

/// Builds the layer "Imported textures" of one material.
class ImportedLayer {
  public:
    ImportedLayer(const Model& model, const MaterialValues& source, const FileImages& images)
        : model_(model), source_(source), images_(images) {
        layer_.name = "Imported textures";
    }

    LayerPtr make() {
        const glm::vec3 base_factor(source_.base_color_factor);
        set(Channel::BaseColor, source_.base_color,
            {.color_space = ColorSpace::Srgb, .multiply = base_factor}, base_factor);
        set_scalar(Channel::Metalness, source_.metallic_roughness, ChannelPick::Blue,
                   source_.metallic_factor);
        set_scalar(Channel::Roughness, source_.metallic_roughness, ChannelPick::Green,
                   source_.roughness_factor);
        set_surface();
        set_emissive();
        if (source_.alpha_mode != AlphaMode::Opaque) set_opacity();
        return std::make_shared<const Layer>(std::move(layer_));
    }

  private:
    /// Feeds a channel from a map, or from a constant where there is none.
    void set(Channel channel, const TextureUse& use, const Reading& reading,
             const glm::vec3& constant) {
        ChannelSettings& settings = at(layer_.channels, channel);
        settings.enabled = true;
        if (const auto image = shown_image(model_, use, images_, reading))
            settings.source = *image;
        else
            settings.source = ConstantSource{constant};
    }

    void set_scalar(Channel channel, const TextureUse& use, ChannelPick pick, float factor) {
        set(channel, use, {.pick = pick, .multiply = glm::vec3(factor)}, glm::vec3(factor));
    }

    void set_surface() {
        if (image_of(model_, source_.normal, images_)) {
            const float scale = source_.normal_scale;
            set(Channel::Normal, source_.normal, {.multiply = glm::vec3(scale, scale, 1.0f)},
                glm::vec3(0.0f, 0.0f, 1.0f));
        }
        if (image_of(model_, source_.occlusion, images_)) {
            // glTF 2.0: 1 + strength * (value - 1).
            const float strength = source_.occlusion_strength;
            set(Channel::Occlusion, source_.occlusion,
                {.pick = ChannelPick::Red,
                 .multiply = glm::vec3(strength),
                 .add = glm::vec3(1.0f - strength)},
                glm::vec3(1.0f));
        }
    }

    void set_emissive() {
        const bool has_map = image_of(model_, source_.emissive, images_) != nullptr;
        if (!has_map && source_.emissive_factor == glm::vec3(0.0f)) return;
        set(Channel::Emissive, source_.emissive,
            {.color_space = ColorSpace::Srgb, .multiply = source_.emissive_factor},
            source_.emissive_factor);
    }

    void set_opacity() {
        const float factor = source_.base_color_factor.a;
        const ImageAssetPtr image = image_of(model_, source_.base_color, images_);
        const bool has_alpha = image && (image->channels == 2 || image->channels == 4);
        set_scalar(Channel::Opacity, has_alpha ? source_.base_color : TextureUse(),
                   ChannelPick::Alpha, factor);
    }

    const Model& model_;
    const MaterialValues& source_;
    const FileImages& images_;
    Layer layer_;
};

/// The side of the largest map, as a power of two.
int resolution_of(const Model& model, const MaterialValues& source, const FileImages& images) {
    int largest = 0;
    for (const TextureUse* use : source.slots())
        if (const auto image = image_of(model, *use, images))
            largest = std::max({largest, image->width, image->height});
    if (largest == 0) return Material().resolution;
    const auto power = static_cast<int>(std::bit_ceil(static_cast<unsigned>(largest)));
    return std::clamp(power, kMinResolution, kMaxResolution);
}

/// The UV set of the base map, or of the first map there is.
int uv_set_of(const MaterialValues& source) {
    for (const TextureUse* use : source.slots())
        if (use->texture >= 0) return use->uv_set;
    return 0;
}

}  // namespace

Material imported_material(const Model& model, int index, const FileImages& images) {
    const tinygltf::Material& parsed = model.materials[static_cast<std::size_t>(index)];
    const MaterialValues source = material_values(parsed);
    Material material;
    material.name = parsed.name.empty() ? fmt::format("Material {}", index + 1) : parsed.name;
    material.stack = {ImportedLayer(model, source, images).make()};
    material.resolution = resolution_of(model, source, images);
    material.uv_set = uv_set_of(source);
    material.alpha_mode = source.alpha_mode;
    material.alpha_cutoff = source.alpha_cutoff;
    material.double_sided = source.double_sided;
    material.unlit = source.unlit;
    material.ior = source.ior;
    material.specular_factor = source.specular_factor;
    material.specular_color_linear = source.specular_color_factor;
    material.specular_map =
        shown_image(model, source.specular, images, {.pick = ChannelPick::Alpha});
    material.specular_color_map =
        shown_image(model, source.specular_color, images, {.color_space = ColorSpace::Srgb});
    material.emissive_strength = source.emissive_strength;
    material.source_material = index;
    return material;
}

Material default_material() {
    Model model;
    model.materials.emplace_back().name = "Default material";
    Material material = imported_material(model, 0, {});
    material.source_material.reset();
    return material;
}

}  // namespace patina::io
