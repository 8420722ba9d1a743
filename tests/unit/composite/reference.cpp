// SPDX-License-Identifier: MIT
#include "composite/reference.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "composite/published_adjustments.h"
#include "shaders/published_modes.h"

namespace patina {
namespace {

using Vec3 = glm::dvec3;

double decoded(double s) {
    s = std::clamp(s, 0.0, 1.0);
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}
double encoded(double x) {
    x = std::clamp(x, 0.0, 1.0);
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
}
Vec3 decoded(const Vec3& s) {
    return {decoded(s.x), decoded(s.y), decoded(s.z)};
}
Vec3 encoded(const Vec3& x) {
    return {encoded(x.x), encoded(x.y), encoded(x.z)};
}

Vec3 unit(const Vec3& v) {
    const double length = glm::length(v);
    return length > 1e-10 ? v / length : Vec3(0, 0, 1);
}

Vec3 rnm(const Vec3& below, const Vec3& detail) {
    const Vec3 t = below + Vec3(0, 0, 1);
    const Vec3 u = detail * Vec3(-1, -1, 1);
    return t * (glm::dot(t, u) / t.z) - u;
}

Vec3 normal_laid(BlendMode mode, const Vec3& below, const Vec3& source, double weight) {
    const Vec3 faded = unit(glm::mix(Vec3(0, 0, 1), source, weight));
    switch (mode) {
        case BlendMode::NormalRnm:
            return rnm(below, faded);
        case BlendMode::NormalUdn:
            return unit({below.x + faded.x, below.y + faded.y, below.z});
        case BlendMode::NormalWhiteout:
            return unit({below.x + faded.x, below.y + faded.y, below.z * faded.z});
        case BlendMode::NormalPartial: {
            const double bz = std::max(below.z, 1e-3), sz = std::max(faded.z, 1e-3);
            return unit({below.x / bz + faded.x / sz, below.y / bz + faded.y / sz, 1});
        }
        default:
            return unit(glm::mix(below, source, weight));
    }
}

/// What has been accumulated of one channel.
struct Accumulated {
    Vec3 value = Vec3(0);
    double coverage = 0;
    bool encoded = false;
    bool opaque = false;  ///< of the stack itself
};
using Accumulators = PerChannel<Accumulated>;

void put_into_space(Accumulated& accumulated, bool wanted) {
    if (accumulated.encoded == wanted) return;
    accumulated.value = wanted ? encoded(accumulated.value) : decoded(accumulated.value);
    accumulated.encoded = wanted;
}

class Texel {
  public:
    Texel(const Material& material, const ImageTable& images, int size, int x, int y)
        : material_(material), images_(images), u_((x + 0.5) / size), v_((y + 0.5) / size) {}

    Vec3 channel(Channel channel) const {
        Accumulators accumulators;
        for (const ChannelInfo& entry : kChannels)
            at(accumulators, entry.channel) = {Vec3(stack_bottom(entry.channel)), 1.0, false, true};
        composite(material_.stack, accumulators);
        put_into_space(at(accumulators, channel), false);
        return at(accumulators, channel).value;
    }

  private:
    struct Sampled {
        Vec3 value;
        double coverage = 1;
    };

    double coverage(const Layer& layer) const;
    bool lays(const Layer& layer, Channel channel) const;
    bool is_empty_group(const Layer& layer) const;
    double content_coverage(const Layer& layer) const;
    void composite(const std::vector<LayerPtr>& stack, Accumulators& accumulators) const;
    void composite(const Layer& layer, double weight, Accumulators& accumulators) const;
    double share_by_height(const Layer& layer, const Accumulated& below,
                           const Accumulated& children) const;
    static void adjust(const Layer& layer, const AdjustmentSettings& adjustment, Channel channel,
                       double weight, Accumulated& below);
    void lay(const Layer& layer, Channel channel, Sampled source, double weight,
             Accumulators& accumulators) const;
    static void replace(Channel channel, const Sampled& source, double weight, Accumulated& below);
    double mask(const Mask& mask) const;
    Sampled sampled(const Source& source, ChannelKind kind) const;
    Sampled sampled_image(const ImageSource& source, ChannelKind kind) const;

    const Material& material_;
    const ImageTable& images_;
    double u_;
    double v_;
};

/// What the layer covers at this texel, before its channels are asked.
double Texel::coverage(const Layer& layer) const {
    if (!layer.visible) return 0;
    return static_cast<double>(layer.opacity) * mask(layer.mask);
}

/// Whether the layer may lay something on the channel, at whatever texel.
bool Texel::lays(const Layer& layer, Channel channel) const {
    const ChannelSettings& settings = at(layer.channels, channel);
    if (!settings.enabled || settings.opacity == 0.0f) return false;
    const auto* const group = std::get_if<GroupContent>(&layer.content);
    if (group == nullptr) return true;
    const Layer* base = nullptr;
    bool found = false;
    const auto shows = [&](const Layer& child) {
        const bool varies = std::any_of(
            child.mask.entries.begin(), child.mask.entries.end(), [](const MaskEntry& entry) {
                return entry.visible && entry.opacity > 0.0f &&
                       !std::holds_alternative<ConstantSource>(entry.source);
            });
        return child.visible && child.opacity > 0.0f &&
               ((child.mask.enabled && varies) || mask(child.mask) > 0.0);
    };
    for (const LayerPtr& child : group->children) {
        const bool clipped = child->clipped && base != nullptr;
        const bool hidden = clipped && (!shows(*base) || is_empty_group(*base));
        if (!child->clipped) base = child.get();
        if (!hidden && !child->is_adjustment() && shows(*child)) found |= lays(*child, channel);
    }
    return found;
}

bool Texel::is_empty_group(const Layer& layer) const {
    return layer.is_group() &&
           std::none_of(kChannels.begin(), kChannels.end(),
                        [&](const ChannelInfo& entry) { return lays(layer, entry.channel); });
}

/// What the layer's content covers here, of the first channel that it lays on.
double Texel::content_coverage(const Layer& layer) const {
    if (layer.is_adjustment()) return 1;
    const auto first =
        std::find_if(kChannels.begin(), kChannels.end(),
                     [&](const ChannelInfo& entry) { return lays(layer, entry.channel); });
    if (first == kChannels.end()) return layer.is_group() ? 0 : 1;
    if (const auto* const group = std::get_if<GroupContent>(&layer.content)) {
        Accumulators children;
        composite(group->children, children);
        return at(children, first->channel).coverage;
    }
    return sampled(at(layer.channels, first->channel).source, first->kind).coverage;
}

void Texel::composite(const std::vector<LayerPtr>& stack, Accumulators& accumulators) const {
    const Layer* base = nullptr;
    for (const LayerPtr& layer : stack) {
        double weight = coverage(*layer);
        if (layer->clipped && base != nullptr) weight *= coverage(*base) * content_coverage(*base);
        if (!layer->clipped) base = layer.get();
        composite(*layer, weight, accumulators);
    }
}

void Texel::composite(const Layer& layer, double weight, Accumulators& accumulators) const {
    const bool passes = layer.is_pass_through();
    Accumulators children;
    if (passes) {
        children = accumulators;
        for (Accumulated& child : children) child.opaque = false;
    }
    if (layer.is_group()) composite(std::get<GroupContent>(layer.content).children, children);
    if (layer.height_blend.enabled)
        weight *= share_by_height(layer, at(accumulators, Channel::Height),
                                  at(children, Channel::Height));
    for (const ChannelInfo& entry : kChannels) {
        const ChannelSettings& settings = at(layer.channels, entry.channel);
        if (!settings.enabled || settings.opacity == 0.0f) continue;
        Accumulated& below = at(accumulators, entry.channel);
        const bool wants_encoded =
            entry.kind == ChannelKind::Color && layer.blend_space == BlendSpace::SrgbEncoded;
        const double own_weight = weight * static_cast<double>(settings.opacity);
        Accumulated& child = at(children, entry.channel);
        put_into_space(below, wants_encoded);
        if (passes) {
            put_into_space(child, wants_encoded);
            replace(entry.channel, {child.value, child.coverage}, own_weight, below);
            continue;
        }
        if (const auto* content = std::get_if<AdjustmentContent>(&layer.content)) {
            adjust(layer, content->adjustment, entry.channel, own_weight, below);
            continue;
        }
        Sampled source;
        if (layer.is_group()) {
            const bool clears = effective_blend_mode(layer, entry.channel) == BlendMode::Replace;
            if (child.coverage == 0 && !clears) continue;
            put_into_space(child, wants_encoded);
            source = {child.value, child.coverage};
        } else {
            source = sampled(settings.source, entry.kind);
            if (wants_encoded) source.value = encoded(source.value);
        }
        lay(layer, entry.channel, source, own_weight, accumulators);
    }
}

/// Mishkinis's blend by depth, its share made harder about a half.
double Texel::share_by_height(const Layer& layer, const Accumulated& below,
                              const Accumulated& children) const {
    double own = 0;
    const ChannelSettings& settings = at(layer.channels, Channel::Height);
    if (layer.is_group()) {
        own = children.value.x * children.coverage;
    } else if (!layer.is_adjustment() && settings.enabled) {
        const Sampled height = sampled(settings.source, ChannelKind::Height);
        own = height.value.x * height.coverage;
    }
    own += static_cast<double>(layer.height_blend.offset);
    const double backdrop = below.value.x * below.coverage;
    const double radius = static_cast<double>(layer.height_blend.radius);
    const double line = std::max(own, backdrop) - radius;
    const double above = std::max(own - line, 0.0), under = std::max(backdrop - line, 0.0);
    const double share = above / (above + under);
    const double slope = 1 / (1 - static_cast<double>(layer.height_blend.contrast));
    return std::clamp((share - 0.5) * slope + 0.5, 0.0, 1.0);
}

/// The channel goes over to its adjusted self; what covers stays.
void Texel::adjust(const Layer& layer, const AdjustmentSettings& adjustment, Channel channel,
                   double weight, Accumulated& below) {
    const Vec3 changed = test_support::adjusted(adjustment, channel, below.value, below.encoded);
    const Vec3 blended =
        test_support::published_blend(effective_blend_mode(layer, channel), below.value, changed);
    below.value = glm::mix(below.value, blended, weight);
}

/// GIMP's replace: both colour and coverage go over to the source's by the weight. The bottom of
/// the stack stays opaque.
void Texel::replace(Channel channel, const Sampled& source, double weight, Accumulated& below) {
    const double left = (1 - weight) * below.coverage + weight * source.coverage;
    if (left > 0)
        below.value = ((1 - weight) * below.coverage * below.value +
                       weight * source.coverage * source.value) /
                      left;
    if (info(channel).kind == ChannelKind::Normal) below.value = unit(below.value);
    if (!below.opaque) below.coverage = left;
}

/// W3C: co = as (1 - ab) Cs + as ab B + (1 - as) ab Cb, ao = as + ab - as ab, colour co / ao.
void Texel::lay(const Layer& layer, Channel channel, Sampled source, double weight,
                Accumulators& accumulators) const {
    Accumulated& below = at(accumulators, channel);
    const BlendMode mode = effective_blend_mode(layer, channel);
    if (mode == BlendMode::Replace) return replace(channel, source, weight, below);
    weight *= source.coverage;
    const double ab = below.coverage;
    const double ao = weight + ab - weight * ab;
    if (ao <= 0) return;
    if (info(channel).kind == ChannelKind::Normal) {
        const Vec3 laid = ab > 0 ? normal_laid(mode, below.value, source.value, weight) : Vec3(0);
        below.value = unit(laid * ab + source.value * (weight * (1 - ab)));
    } else {
        const Vec3 blended = test_support::published_blend(mode, below.value, source.value);
        below.value = (weight * (1 - ab) * source.value + weight * ab * blended +
                       (1 - weight) * ab * below.value) /
                      ao;
    }
    below.coverage = ao;
}

double Texel::mask(const Mask& mask) const {
    if (!mask.enabled) return 1;
    double value = static_cast<double>(mask.base);
    for (const MaskEntry& entry : mask.entries) {
        if (!entry.visible) continue;
        double own =
            entry.adjustment
                ? test_support::adjusted(*entry.adjustment, Channel::Opacity, Vec3(value), false).x
                : sampled(entry.source, ChannelKind::Scalar).value.x;
        if (entry.invert) own = 1 - own;
        own = test_support::leveled(entry.levels, own);
        const double joined = entry.combine == BlendMode::Replace
                                  ? own
                                  : test_support::published_blend(entry.combine, value, own);
        value = glm::mix(value, joined, static_cast<double>(entry.opacity));
    }
    value = std::clamp(value, 0.0, 1.0);
    return mask.invert ? 1 - value : value;
}

Texel::Sampled Texel::sampled(const Source& source, ChannelKind kind) const {
    if (const auto* const constant = std::get_if<ConstantSource>(&source)) {
        const Vec3 value(constant->value);
        return {kind == ChannelKind::Normal ? unit(value) : value};
    }
    return sampled_image(std::get<ImageSource>(source), kind);
}

double stored(const Image& image, int x, int y, int channel) {
    const auto index = static_cast<std::size_t>((y * image.width + x) * image.channels + channel);
    if (image.type == SampleType::U8) return static_cast<double>(image.data[index]) / 255.0;
    if (image.type == SampleType::U16)
        return reinterpret_cast<const std::uint16_t*>(image.data.data())[index] / 65535.0;
    return static_cast<double>(reinterpret_cast<const float*>(image.data.data())[index]);
}

int wrapped(int index, int side, Wrap wrap) {
    switch (wrap) {
        case Wrap::Repeat:
            return ((index % side) + side) % side;
        case Wrap::Mirror: {
            const int twice = ((index % (2 * side)) + 2 * side) % (2 * side);
            return twice < side ? twice : 2 * side - 1 - twice;
        }
        case Wrap::Clamp:
            return std::clamp(index, 0, side - 1);
    }
    return index;
}

/// The components of one texel, alpha in w: grey stands for all colours, a missing alpha is 1.
glm::dvec4 texel_of(const Image& image, const ImageSource& source, int x, int y) {
    glm::dvec4 value(0, 0, 0, 1);
    const bool has_alpha = image.channels == 2 || image.channels == 4;
    for (int k = 0; k < 3; ++k) {
        value[k] = stored(image, x, y, image.channels <= 2 ? 0 : k);
        if (source.invert) value[k] = 1 - value[k];
    }
    if (has_alpha) value.w = stored(image, x, y, image.channels - 1);
    return value;
}

Texel::Sampled Texel::sampled_image(const ImageSource& source, ChannelKind kind) const {
    const Image& image = *images_.images.at(source.image);
    const double turn =
        static_cast<double>(source.transform.rotation_degrees) * std::numbers::pi / 180.0;
    const double su = static_cast<double>(source.transform.scale.x) * u_;
    const double sv = static_cast<double>(source.transform.scale.y) * v_;
    const double u =
        static_cast<double>(source.transform.offset.x) + std::cos(turn) * su + std::sin(turn) * sv;
    const double v =
        static_cast<double>(source.transform.offset.y) - std::sin(turn) * su + std::cos(turn) * sv;
    const bool nearest = source.filter == Filter::Nearest;
    const double px = u * image.width - (nearest ? 0.0 : 0.5);
    const double py = v * image.height - (nearest ? 0.0 : 0.5);
    const int x0 = static_cast<int>(std::floor(px));
    const int y0 = static_cast<int>(std::floor(py));
    const double fx = nearest ? 0 : px - x0;
    const double fy = nearest ? 0 : py - y0;
    const bool decode = source.color_space == ColorSpace::Srgb && kind != ChannelKind::Normal;

    glm::dvec4 sum(0);
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) {
            glm::dvec4 tap = texel_of(image, source, wrapped(x0 + i, image.width, source.wrap_u),
                                      wrapped(y0 + j, image.height, source.wrap_v));
            if (decode) tap = glm::dvec4(decoded(Vec3(tap)), tap.w);
            sum += tap * ((i == 0 ? 1 - fx : fx) * (j == 0 ? 1 - fy : fy));
        }
    Sampled result{Vec3(sum), source.alpha_is_coverage ? sum.w : 1.0};
    switch (source.pick) {
        case ChannelPick::Rgb:
            break;
        case ChannelPick::Red:
            result.value = Vec3(sum.x);
            break;
        case ChannelPick::Green:
            result.value = Vec3(sum.y);
            break;
        case ChannelPick::Blue:
            result.value = Vec3(sum.z);
            break;
        case ChannelPick::Alpha:
            result.value = Vec3(source.invert ? 1 - sum.w : sum.w);
            break;
    }
    if (kind == ChannelKind::Normal) {
        result.value = result.value * 2.0 - 1.0;
        if (source.directx_normal) result.value.y = -result.value.y;
    }
    result.value = result.value * Vec3(source.multiply) + Vec3(source.add);
    if (kind == ChannelKind::Normal) result.value = unit(result.value);
    const bool scalar = kind == ChannelKind::Scalar || kind == ChannelKind::Height;
    if (scalar && source.pick == ChannelPick::Rgb && image.channels >= 3)
        result.value =
            Vec3(0.2126 * result.value.x + 0.7152 * result.value.y + 0.0722 * result.value.z);
    // Colours and scalars have no meaning beyond 0..1; heights and directions do.
    if (kind == ChannelKind::Color || kind == ChannelKind::Scalar)
        result.value = glm::clamp(result.value, 0.0, 1.0);
    return result;
}

/// The normal of the height field (Sobel's slopes, borders meet) with the normal channel on top.
Vec3 relief_normal(const Material& material, const ImageTable& images, int size, int x, int y) {
    const auto height = [&](int dx, int dy) {
        return Texel(material, images, size, (x + dx + size) % size, (y + dy + size) % size)
            .channel(Channel::Height)
            .x;
    };
    const double depth = static_cast<double>(material.height_scale) * size;
    const double right = (height(1, -1) - height(-1, -1) + 2 * (height(1, 0) - height(-1, 0)) +
                          height(1, 1) - height(-1, 1)) /
                         8 * depth;
    const double up = (height(-1, -1) - height(-1, 1) + 2 * (height(0, -1) - height(0, 1)) +
                       height(1, -1) - height(1, 1)) /
                      8 * depth;
    return rnm(unit({-right, -up, 1}),
               Texel(material, images, size, x, y).channel(Channel::Normal));
}

}  // namespace

glm::dvec4 reference_texel(const Material& material, const ImageTable& images, BakedMap map,
                           int size, int x, int y) {
    const Texel texel(material, images, size, x, y);
    switch (map) {
        case BakedMap::BaseColor:
            return {encoded(texel.channel(Channel::BaseColor)), texel.channel(Channel::Opacity).x};
        case BakedMap::OcclusionRoughnessMetalness:
            return {texel.channel(Channel::Occlusion).x, texel.channel(Channel::Roughness).x,
                    texel.channel(Channel::Metalness).x, 1};
        case BakedMap::Normal:
            return {relief_normal(material, images, size, x, y) * 0.5 + 0.5, 1};
        case BakedMap::Emissive:
            return {encoded(texel.channel(Channel::Emissive)), 1};
    }
    return {};
}

}  // namespace patina
