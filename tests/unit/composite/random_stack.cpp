// SPDX-License-Identifier: MIT
#include "composite/random_stack.h"

#include <algorithm>
#include <cstring>

#include "document/choices.h"

namespace patina {
namespace {

/// Whether a mode never makes much of little, as those do that divide or have a step: there the
/// last digit of a float decides.
bool is_continuous(BlendMode mode) {
    switch (mode) {
        case BlendMode::Replace:
        case BlendMode::ColorBurn:
        case BlendMode::ColorDodge:
        case BlendMode::VividLight:
        case BlendMode::HardMix:
        case BlendMode::Divide:
        case BlendMode::InverseDivide:
        case BlendMode::HueW3c:
        case BlendMode::SaturationW3c:
        case BlendMode::TintHsv:
        case BlendMode::SaturationHsv:
        case BlendMode::ColorHsv:
        case BlendMode::ValueHsv:
            return false;
        default:
            return true;
    }
}

/// The same of adjustments, of those that one texel is enough for.
bool is_continuous(AdjustmentKind kind) {
    return kind != AdjustmentKind::Posterise && kind != AdjustmentKind::HueSaturation &&
           !looks_around(kind);
}

}  // namespace

RandomStack::RandomStack(std::uint32_t seed, int size, RandomSources sources)
    : random_(seed), size_(size), sources_(sources) {}

Hash128 RandomStack::image(int channels) {
    Image image{.type = static_cast<SampleType>(index(3))};
    const bool fits = chance(50);
    image.width = fits ? size_ : std::max(1, size_ - index(4));
    image.height = fits ? size_ : std::max(1, size_ - index(4));
    image.channels = channels;
    image.data.resize(image.row_bytes() * static_cast<std::size_t>(image.height));
    const std::size_t count = image.data.size() / sample_bytes(image.type);
    for (std::size_t i = 0; i < count; ++i) {
        // Zeros in runs, so that whole tiles of masks are empty.
        const bool empty = (i / 700) % 3 == 2;
        const auto bits = static_cast<std::uint16_t>(empty ? 0 : random_() & 0xffff);
        const auto byte = static_cast<std::uint8_t>(bits >> 8);
        const float unit = static_cast<float>(bits) / 65535.0f;
        std::byte* const at = image.data.data() + i * sample_bytes(image.type);
        if (image.type == SampleType::U8) std::memcpy(at, &byte, 1);
        if (image.type == SampleType::U16) std::memcpy(at, &bits, 2);
        if (image.type == SampleType::F32) std::memcpy(at, &unit, 4);
    }
    return images.add(std::move(image));
}

ImageSource RandomStack::image_source(Channel channel) {
    const ChannelKind kind = info(channel).kind;
    ImageSource source{.image = image(1 + index(4)),
                       .color_space = chance(50) && kind == ChannelKind::Color ? ColorSpace::Srgb
                                                                               : ColorSpace::Linear,
                       .pick = static_cast<ChannelPick>(index(5)),
                       .invert = chance(20),
                       .directx_normal = chance(20),
                       .alpha_is_coverage = chance(30)};
    if (kind == ChannelKind::Normal) {
        // Directions above the surface: opposed ones have no meaning, and no stable blend.
        source.pick = ChannelPick::Rgb;
        source.multiply = glm::vec3(0.4f);
        source.add = glm::vec3(0.0f, 0.0f, 0.6f);
    }
    if (chance(40)) {
        source.transform.offset = {number(-2, 2), number(-2, 2)};
        source.transform.scale = {number(0.3f, 1.2f), number(0.3f, 1.2f)};
        source.transform.rotation_degrees = number(-180, 180);
    }
    source.wrap_u = static_cast<Wrap>(index(3));
    source.wrap_v = static_cast<Wrap>(index(3));
    if (chance(30) && kind != ChannelKind::Normal) {
        source.multiply = {number(), number(), number()};  // in braces: in order
        source.add = glm::vec3(number(0, 0.3f));
    }
    return source;
}

ProceduralSource RandomStack::procedural() {
    ProceduralSource source{
        .kind = static_cast<ProceduralKind>(index(int{kProceduralKinds.size()})),
        .seed = static_cast<std::uint32_t>(index(1000)),
        .scale = number(1, 40),
        .octaves = 1 + index(4),
        .width = number(),
        .softness = number(),
        .variation = number(),
        .aspect = number(0.25f, 4),
        .warp = chance(50) ? 0.0f : number(),
        .contrast = number(-1, 1),
        .balance = number()};
    for (RampStop& stop : source.ramp) stop.value = {number(), number(), number(0.2f, 1.0f)};
    return source;
}

Source RandomStack::source(Channel channel) {
    if (sources_ == RandomSources::All && chance(25)) return procedural();
    const bool scalar = info(channel).kind == ChannelKind::Scalar;
    if (sources_ == RandomSources::All && scalar && chance(12))
        return ReliefSource{.kind = static_cast<ReliefKind>(index(4)),
                            .radius_permille = number(1, 50),
                            .strength = number(1, 20)};
    if (sources_ == RandomSources::All && !finished_.empty() && chance(12)) {
        const LayerId of =
            finished_[static_cast<std::size_t>(index(static_cast<int>(finished_.size())))];
        if (channel == Channel::Normal) return ReferenceSource{of, LayerResult::Normal};
        const auto result = static_cast<LayerResult>(index(9));
        if (result != LayerResult::Normal) return ReferenceSource{of, result};
    }
    if (chance(50)) return image_source(channel);
    if (channel == Channel::Normal)
        return ConstantSource{{number(-0.5f, 0.5f), number(-0.5f, 0.5f), 1.0f}};
    return ConstantSource{{number(), number(), number()}};
}

Mask RandomStack::mask() {
    Mask mask{.enabled = chance(90), .invert = chance(20), .base = chance(70) ? 1.0f : number()};
    for (int i = index(4); i > 0; --i) {
        MaskEntry entry{.id = {next_id_++},
                        .visible = chance(90),
                        .combine = combine(),
                        .opacity = chance(60) ? 1.0f : number(),
                        .invert = chance(20)};
        if (chance(25))
            entry.adjustment = mask_adjustment();
        else
            entry.source = source(Channel::Roughness);
        if (!entry.adjustment && chance(30))
            entry.levels = {0.1f, 0.8f, number(0.4f, 1.0f), number(), number()};
        mask.entries.push_back(entry);
    }
    return mask;
}

BlendMode RandomStack::mode(Channel channel) {
    for (;;) {
        const BlendMode mode =
            kBlendModes[static_cast<std::size_t>(index(static_cast<int>(kBlendModes.size())))].mode;
        const bool wanted = sources_ == RandomSources::All || is_continuous(mode);
        if (wanted && applies_to(mode, channel)) return mode;
    }
}

BlendMode RandomStack::combine() {
    for (;;) {
        const BlendMode chosen = chance(20) ? BlendMode::Replace : mode(Channel::Roughness);
        if (combines_masks(chosen)) return chosen;
    }
}

AdjustmentSettings RandomStack::mask_adjustment() {
    for (;;) {
        const AdjustmentSettings settings = adjustment();
        if (adjusts_masks(settings.kind)) return settings;
    }
}

AdjustmentSettings RandomStack::adjustment() {
    AdjustmentSettings settings;
    do {
        settings.kind = static_cast<AdjustmentKind>(index(int{kAdjustmentKinds.size()}));
    } while (sources_ == RandomSources::ConstantsAndImages && !is_continuous(settings.kind));
    settings.levels = {0.1f, 0.9f, number(0.5f, 2), number(), number()};
    settings.curve = {{0.0f, number()}, {0.25f, number()}, {0.7f, number()}, {1.0f, number()}};
    settings.hue_degrees = number(-180, 180);
    settings.saturation = number(-1, 1);
    settings.lightness = number(-1, 1);
    settings.brightness = number(-1, 1);
    settings.contrast = number(-1, 0.5f);
    settings.steps = 2 + index(10);
    settings.gradient = {{0.1f, {number(), number(), number()}},
                         {0.6f, {number(), number(), number()}}};
    settings.low = number(0, 0.4f);
    settings.high = number(0.5f, 1);
    settings.radius_permille = number(1, 50);
    settings.amount = number(0, 3);
    settings.distance_permille = number(0, 100);
    settings.scale = number(1, 9);
    settings.octaves = 1 + index(3);
    settings.seed = static_cast<std::uint32_t>(index(1000));
    return settings;
}

Layer RandomStack::layer(int depth) {
    Layer layer{.id = {next_id_++},
                .name = "layer",
                .visible = chance(90),
                .opacity = chance(40) ? 1.0f : number(),
                .mode = mode(Channel::BaseColor),
                .blend_space = chance(50) ? BlendSpace::Linear : BlendSpace::SrgbEncoded};
    if (chance(60)) layer.mask = mask();
    for (const ChannelInfo& entry : kChannels) {
        ChannelSettings& settings = at(layer.channels, entry.channel);
        settings.enabled = chance(50);
        settings.source = source(entry.channel);
        if (chance(60)) settings.mode = mode(entry.channel);
        settings.opacity = chance(60) ? 1.0f : number();
    }
    if (depth < 2 && chance(25))
        layer.content = GroupContent{.children = stack(1 + index(3), depth + 1)};
    layer.clipped = chance(15);
    // A narrow radius or a high contrast has steps that the last digit of a float decides.
    const bool steep = sources_ == RandomSources::All;
    layer.height_blend = {.enabled = chance(25),
                          .offset = number(-1, 1),
                          .radius = number(steep ? 0.0f : 0.2f, 1),
                          .contrast = number(0, steep ? 1.0f : 0.5f)};
    if (layer.is_group() && chance(35)) layer.mode = BlendMode::PassThrough;
    if (!layer.is_group() && chance(15)) {
        const AdjustmentSettings settings = adjustment();
        layer.content = AdjustmentContent{settings};
        if (!adjusts(settings.kind, Channel::Normal))
            at(layer.channels, Channel::Normal).enabled = false;
    }
    finished_.push_back(layer.id);
    return layer;
}

std::vector<LayerPtr> RandomStack::stack(int layers, int depth) {
    std::vector<LayerPtr> stack;
    for (int i = 0; i < layers; ++i) stack.push_back(std::make_shared<const Layer>(layer(depth)));
    return stack;
}

Material RandomStack::material() {
    Material material;
    material.height_scale = 0.5f / static_cast<float>(size_);
    material.stack = stack(2 + index(4), 0);
    return material;
}

Material RandomStack::edited(const Material& material) {
    finished_.clear();  // a lower layer that refers to a higher one could make a cycle
    Material copy = material;
    const auto at_layer = static_cast<std::size_t>(index(static_cast<int>(copy.stack.size())));
    Layer changed = *copy.stack[at_layer];
    auto* const group = std::get_if<GroupContent>(&changed.content);
    if (group != nullptr && chance(60)) {
        const auto at_child =
            static_cast<std::size_t>(index(static_cast<int>(group->children.size())));
        Layer child = *group->children[at_child];
        child.opacity = number();
        group->children[at_child] = std::make_shared<const Layer>(std::move(child));
    } else if (chance(10)) {
        changed.visible = !changed.visible;
    } else if (chance(20)) {
        at(changed.channels, Channel::BaseColor).source = source(Channel::BaseColor);
    } else {
        changed.opacity = number();
    }
    copy.stack[at_layer] = std::make_shared<const Layer>(std::move(changed));
    return copy;
}

}  // namespace patina
