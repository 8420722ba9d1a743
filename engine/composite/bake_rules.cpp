// SPDX-License-Identifier: MIT
#include "composite/bake_rules.h"

#include <cmath>

#include "composite/uniform_channel.h"

namespace patina {
namespace {

struct Channels {
    const Material& material;
    const StackTerms& terms;
    const ProgramData& program;

    /// The value of a channel that no image or procedural decides.
    std::optional<glm::vec3> uniform(Channel channel) const {
        if (!is_uniform(terms, channel)) return std::nullopt;
        return uniform_channel(program, channel);
    }

    /// The image that is all of the channel.
    const ImageSource* image(Channel channel) const {
        const auto layers = layers_of_channel(terms, channel);
        if (layers.size() != 1) return nullptr;
        const Contribution& contribution = *at(layers.front()->channels, channel);
        if (!contribution.covers || contribution.source == nullptr) return nullptr;
        return std::get_if<ImageSource>(contribution.source);
    }
};

bool is_factor(float value) {
    return value >= 0.0f && value <= 1.0f;
}
bool is_plain(const ImageSource& image) {
    return !image.invert && !image.alpha_is_coverage && image.projection.kind == ProjectionKind::Uv;
}

bool same_texture(const ImageSource& a, const ImageSource& b) {
    return a.image == b.image && a.uv_set == b.uv_set && a.transform == b.transform &&
           a.wrap_u == b.wrap_u && a.wrap_v == b.wrap_v && a.filter == b.filter;
}

/// Whether glTF reads the image as the stack does: this component, times a factor of 0..1.
bool is_component(const ImageSource* image, ChannelPick pick) {
    return image != nullptr && is_plain(*image) && image->pick == pick &&
           (image->color_space == ColorSpace::Linear || pick == ChannelPick::Alpha) &&
           image->add.x == 0.0f && is_factor(image->multiply.x);
}

bool is_color_image(const ImageSource* image) {
    return image != nullptr && is_plain(*image) && image->pick == ChannelPick::Rgb &&
           image->color_space == ColorSpace::Srgb && image->add == glm::vec3(0.0f) &&
           is_factor(image->multiply.r) && is_factor(image->multiply.g) &&
           is_factor(image->multiply.b);
}

SlotPlan base_color_plan(const Channels& channels) {
    const bool opaque = channels.material.alpha_mode == AlphaMode::Opaque;
    const auto color = channels.uniform(Channel::BaseColor);
    const auto opacity = channels.uniform(Channel::Opacity);
    const float alpha = opacity ? glm::clamp(opacity->x, 0.0f, 1.0f) : 1.0f;
    if (color && (opacity || opaque))
        return SlotConstant{glm::vec4(glm::clamp(*color, 0.0f, 1.0f), alpha)};
    const ImageSource* const image = channels.image(Channel::BaseColor);
    if (!is_color_image(image)) return SlotBaked{BakedMap::BaseColor};
    if (opaque) return SlotImage{.source = *image, .opacity_factor = alpha};
    const ImageSource* const coverage = channels.image(Channel::Opacity);
    if (is_component(coverage, ChannelPick::Alpha) && same_texture(*image, *coverage))
        return SlotImage{.source = *image, .opacity_factor = coverage->multiply.x};
    return SlotBaked{BakedMap::BaseColor};
}

SlotPlan metallic_roughness_plan(const Channels& channels) {
    const auto metalness = channels.uniform(Channel::Metalness);
    const auto roughness = channels.uniform(Channel::Roughness);
    if (metalness && roughness)
        return SlotConstant{glm::vec4(0.0f, glm::clamp(roughness->x, 0.0f, 1.0f),
                                      glm::clamp(metalness->x, 0.0f, 1.0f), 0.0f)};
    const ImageSource* const rough = channels.image(Channel::Roughness);
    const ImageSource* const metal = channels.image(Channel::Metalness);
    if (is_component(rough, ChannelPick::Green)) {
        if (metalness && metalness->x == 0.0f)
            return SlotImage{.source = *rough, .metalness_factor = 0.0f};
        if (is_component(metal, ChannelPick::Blue) && same_texture(*rough, *metal))
            return SlotImage{.source = *rough, .metalness_factor = metal->multiply.x};
    }
    return SlotBaked{BakedMap::OcclusionRoughnessMetalness};
}

/// glTF's normal scale multiplies x and y alone.
bool is_normal_map(const ImageSource* image) {
    return image != nullptr && is_plain(*image) && image->pick == ChannelPick::Rgb &&
           image->color_space == ColorSpace::Linear && !image->directx_normal &&
           image->add == glm::vec3(0.0f) && image->multiply.x == image->multiply.y &&
           image->multiply.z == 1.0f;
}

SlotPlan normal_plan(const Channels& channels) {
    if (!is_uniform(channels.terms, Channel::Height)) return SlotBaked{BakedMap::Normal};
    const auto normal = channels.uniform(Channel::Normal);
    if (normal && *normal == glm::vec3(0.0f, 0.0f, 1.0f)) return SlotConstant{};
    const ImageSource* const image = channels.image(Channel::Normal);
    if (is_normal_map(image)) return SlotImage{.source = *image};
    return SlotBaked{BakedMap::Normal};
}

/// glTF: 1 + strength (value - 1); it has no factor without a texture, so that a constant other
/// than 1 is baked.
SlotPlan occlusion_plan(const Channels& channels) {
    const auto uniform = channels.uniform(Channel::Occlusion);
    if (uniform && uniform->x == 1.0f) return SlotConstant{};
    const ImageSource* const image = channels.image(Channel::Occlusion);
    if (image != nullptr && is_plain(*image) && image->pick == ChannelPick::Red &&
        image->color_space == ColorSpace::Linear && is_factor(image->multiply.x) &&
        std::abs(image->add.x - (1.0f - image->multiply.x)) < 1e-6f)
        return SlotImage{.source = *image};
    return SlotBaked{BakedMap::OcclusionRoughnessMetalness};
}

SlotPlan emissive_plan(const Channels& channels) {
    if (const auto color = channels.uniform(Channel::Emissive))
        return SlotConstant{glm::vec4(glm::clamp(*color, 0.0f, 1.0f), 1.0f)};
    const ImageSource* const image = channels.image(Channel::Emissive);
    if (is_color_image(image)) return SlotImage{.source = *image};
    return SlotBaked{BakedMap::Emissive};
}

}  // namespace

std::array<SlotPlan, kSlotCount> planned_slots(const Material& material, const StackTerms& terms,
                                               const ProgramData& program) {
    const Channels channels{material, terms, program};
    return {base_color_plan(channels), metallic_roughness_plan(channels), normal_plan(channels),
            occlusion_plan(channels), emissive_plan(channels)};
}

}  // namespace patina
