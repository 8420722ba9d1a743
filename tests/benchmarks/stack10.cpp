// SPDX-License-Identifier: MIT
#include "stack10.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "core/parallel.h"

namespace patina::bench {
namespace {

std::uint32_t mixed(std::uint32_t h) {
    h ^= h >> 16;
    h *= 0x7feb352du;
    h ^= h >> 15;
    h *= 0x846ca68bu;
    return h ^ (h >> 16);
}

std::uint32_t hash(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
    return mixed(x * 0x9e3779b1u ^ mixed(y * 0x85ebca77u ^ mixed(seed)));
}

constexpr int kOctaves = 8;
constexpr int kFirstCells = 4;

/// Adds one octave of value noise, 0..`strength`, to a row of 16.16 numbers; bilinear in integers.
void add_octave(int y, int size, int octave, std::uint32_t seed, std::uint32_t strength,
                std::vector<std::uint32_t>& row) {
    const int cells = std::min(kFirstCells << octave, size);
    const int cell = size / cells;
    const auto lattice_row = static_cast<std::uint32_t>(y / cell);
    const std::int64_t down = y % cell;
    const auto knot = [&](int k) {
        const auto column = static_cast<std::uint32_t>(k);
        const std::int64_t upper = hash(column, lattice_row, seed) & 0xffff;
        const std::int64_t lower = hash(column, lattice_row + 1, seed) & 0xffff;
        return upper + (lower - upper) * down / cell;
    };
    std::int64_t left = knot(0);
    for (int k = 0; k < cells; ++k) {
        const std::int64_t right = knot(k + 1);
        for (int i = 0; i < cell; ++i) {
            const std::int64_t value = left + (right - left) * i / cell;
            row[static_cast<std::size_t>(k * cell + i)] +=
                static_cast<std::uint32_t>(value) * strength;
        }
        left = right;
    }
}

/// A row of fractal value noise, 0..65535, with a hump in the middle as sums of octaves have.
std::vector<std::uint32_t> noise_row(int y, int size, std::uint32_t seed) {
    std::vector<std::uint32_t> row(static_cast<std::size_t>(size), 0);
    std::uint32_t total = 0;
    for (int octave = 0; octave < kOctaves; ++octave) {
        const std::uint32_t strength = 256u >> octave;
        add_octave(y, size, octave, seed + static_cast<std::uint32_t>(octave) * 101u, strength,
                   row);
        total += strength;
    }
    for (std::uint32_t& value : row) value /= total;
    return row;
}

/// 3 % of grain on top of a value of 0..65535, as a byte.
std::byte grained(std::int64_t value, int x, int y, std::uint32_t seed) {
    const std::int64_t grain =
        static_cast<std::int64_t>(
            hash(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), seed) & 0xffff) -
        32768;
    return static_cast<std::byte>(
        std::clamp((value + grain * 3 / 100) / 257, std::int64_t{0}, std::int64_t{255}));
}

/// Noise stretched so that much of it is empty and much of it full: `percent` is the slope.
std::int64_t stretched(std::uint32_t value, std::int64_t percent) {
    return std::clamp((static_cast<std::int64_t>(value) - 32768) * percent / 100 + 32768,
                      std::int64_t{0}, std::int64_t{65535});
}

/// Channels of one image: colours from one noise tinted, alpha and grey from their own.
ImagePtr made_image(int size, int channels, std::uint32_t seed, std::int64_t slope) {
    auto image = std::make_shared<Image>();
    image->width = image->height = size;
    image->channels = channels;
    image->data.resize(image->row_bytes() * static_cast<std::size_t>(size));
    parallel_for(0, size, 16, [&](std::int64_t first, std::int64_t last) {
        for (int y = static_cast<int>(first); y < last; ++y) {
            std::byte* out = image->data.data() + static_cast<std::size_t>(y) * image->row_bytes();
            const auto shade = noise_row(y, size, seed);
            const auto alpha = channels == 4 ? noise_row(y, size, seed + 7777) : shade;
            for (int x = 0; x < size; ++x) {
                const auto at = static_cast<std::size_t>(x);
                if (channels == 1) {
                    *out++ = slope > 200 ? static_cast<std::byte>(stretched(shade[at], slope) / 257)
                                         : grained(stretched(shade[at], slope), x, y, seed);
                    continue;
                }
                for (std::uint32_t c = 0; c < 3; ++c) {
                    const std::int64_t tint = 50 + static_cast<std::int64_t>(mixed(seed + c) % 50);
                    *out++ = grained(stretched(shade[at], slope) * tint / 100, x, y, seed + c);
                }
                if (channels == 4) *out++ = static_cast<std::byte>(stretched(alpha[at], 300) / 257);
            }
        }
    });
    return image;
}

class Images final : public ImageProvider {
  public:
    Result<ImagePtr> pixels(const Hash128& image) override { return images.at(image); }
    std::map<Hash128, ImagePtr> images;
};
Images& provider() {
    static Images images;
    return images;
}

/// The hash of the pixels of one image of the last stack10().
Hash128& name_of(int layer, int kind) {
    static std::array<std::array<Hash128, 4>, kLayers + 1> names;
    return names[static_cast<std::size_t>(layer + 1)][static_cast<std::size_t>(kind)];
}

ImagePtr kept(int layer, int kind, ImagePtr image) {
    name_of(layer, kind) = content_hash(*image);
    provider().images[name_of(layer, kind)] = image;
    return image;
}
constexpr int kColorImage = 1;
constexpr int kMaskImage = 2;
constexpr int kRoughnessImage = 3;

template <typename Number>
Number blended(StackMode mode, Number below, Number own) {
    switch (mode) {
        case StackMode::Normal:
            return own;
        case StackMode::Multiply:
            return below * own;
        case StackMode::Screen:
            return below + own - below * own;
        case StackMode::Overlay:
            return below <= Number(0.5) ? 2 * below * own : 1 - 2 * (1 - below) * (1 - own);
        case StackMode::Add:
            return std::min(below + own, Number(1));
        case StackMode::SoftLight: {
            const Number d =
                below <= Number(0.25) ? ((16 * below - 12) * below + 4) * below : std::sqrt(below);
            return own <= Number(0.5) ? below - (1 - 2 * own) * below * (1 - below)
                                      : below + (2 * own - 1) * (d - below);
        }
    }
    return own;
}

/// Kept out of line, or the compiler would hoist the switch out of the pixel loop.
[[gnu::noinline]] float blended_naively(StackMode mode, float below, float own) {
    return blended(mode, below, own);
}

template <typename Number>
std::uint8_t to_byte(Number value) {
    return static_cast<std::uint8_t>(std::clamp(value, Number(0), Number(1)) * 255 + Number(0.5));
}

const std::uint8_t* bytes(const ImagePtr& image) {
    return reinterpret_cast<const std::uint8_t*>(image->data.data());
}

std::vector<const Image*> sources_of(const Stack10& stack) {
    std::vector<const Image*> images = {stack.base.get()};
    for (int i = 0; i < kLayers; ++i) {
        const auto at = static_cast<std::size_t>(i);
        for (const ImagePtr* image : {&stack.color[at], &stack.mask[at], &stack.roughness[at]})
            images.push_back(image->get());
    }
    return images;
}

Source image_source(int layer, int kind, ColorSpace space, ChannelPick pick) {
    return ImageSource{.image = name_of(layer, kind), .color_space = space, .pick = pick};
}

BlendMode document_mode(StackMode mode) {
    switch (mode) {
        case StackMode::Normal:
            return BlendMode::Normal;
        case StackMode::Multiply:
            return BlendMode::Multiply;
        case StackMode::Screen:
            return BlendMode::Screen;
        case StackMode::Overlay:
            return BlendMode::Overlay;
        case StackMode::Add:
            return BlendMode::Add;
        case StackMode::SoftLight:
            return BlendMode::SoftLightW3c;
    }
    return BlendMode::Normal;
}

void set_channel(Layer& layer, Channel channel, Source source) {
    at(layer.channels, channel).enabled = true;
    at(layer.channels, channel).source = std::move(source);
}

}  // namespace

StackMode mode_of(int layer) {
    return static_cast<StackMode>(layer % 6);
}
float opacity_of(int layer) {
    return 0.3f + 0.6f * static_cast<float>((7 * layer) % 10) / 9.0f;
}
float metalness_of(int layer) {
    return static_cast<float>((3 * layer) % 5) / 4.0f;
}

const Stack10& stack10(int size) {
    static Stack10 stack;
    if (stack.size == size) return stack;
    stack = {};
    provider().images.clear();
    stack.size = size;
    stack.base = kept(-1, kColorImage, made_image(size, 3, 1, 150));
    for (int i = 0; i < kLayers; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const auto seed = static_cast<std::uint32_t>(1000 * (i + 1));
        stack.color[at] = kept(i, kColorImage, made_image(size, 4, seed, 150));
        stack.mask[at] = kept(i, kMaskImage, made_image(size, 1, seed + 300, 700));
        stack.roughness[at] = kept(i, kRoughnessImage, made_image(size, 1, seed + 600, 150));
    }
    return stack;
}

ImageProvider& stack10_images() {
    return provider();
}

void touch(const Stack10& stack, StackOutput& out) {
    const std::vector<const Image*> images = sources_of(stack);
    std::uint64_t seen = 0;
    const auto size = static_cast<std::size_t>(stack.size);
    for (std::size_t y = 0; y < size; ++y) {
        for (const Image* image : images) {
            const auto* const words =
                reinterpret_cast<const std::uint64_t*>(image->data.data() + y * image->row_bytes());
            for (std::size_t i = 0; i < image->row_bytes() / 8; ++i) seen += words[i];
        }
        std::fill_n(out.base_color.data() + y * size * 3, size * 3,
                    static_cast<std::uint8_t>(seen));
        std::fill_n(out.packed.data() + y * size * 3, size * 3, static_cast<std::uint8_t>(seen));
    }
}

void composite_naively(const Stack10& stack, StackOutput& out) {
    std::vector<float> canvas(stack.texels() * 5);
    for (std::size_t i = 0; i < stack.texels(); ++i) {
        for (std::size_t c = 0; c < 3; ++c)
            canvas[5 * i + c] = static_cast<float>(bytes(stack.base)[3 * i + c]) / 255.0f;
        canvas[5 * i + 3] = 128.0f / 255.0f;
        canvas[5 * i + 4] = 0.0f;
    }
    for (int layer = 0; layer < kLayers; ++layer) {
        const auto at = static_cast<std::size_t>(layer);
        const std::uint8_t* const color = bytes(stack.color[at]);
        for (std::size_t i = 0; i < stack.texels(); ++i) {
            const float coverage = static_cast<float>(color[4 * i + 3]) / 255.0f *
                                   static_cast<float>(bytes(stack.mask[at])[i]) / 255.0f *
                                   opacity_of(layer);
            for (std::size_t c = 0; c < 3; ++c) {
                const float own = static_cast<float>(color[4 * i + c]) / 255.0f;
                float& below = canvas[5 * i + c];
                below += coverage * (blended_naively(mode_of(layer), below, own) - below);
            }
            const float rough = static_cast<float>(bytes(stack.roughness[at])[i]) / 255.0f;
            canvas[5 * i + 3] += coverage * (rough - canvas[5 * i + 3]);
            canvas[5 * i + 4] += coverage * (metalness_of(layer) - canvas[5 * i + 4]);
        }
    }
    for (std::size_t i = 0; i < stack.texels(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) out.base_color[3 * i + c] = to_byte(canvas[5 * i + c]);
        out.packed[3 * i] = 255;
        out.packed[3 * i + 1] = to_byte(canvas[5 * i + 3]);
        out.packed[3 * i + 2] = to_byte(canvas[5 * i + 4]);
    }
}

void composite_reference(const Stack10& stack, int stride, StackOutput& out) {
    const auto size = static_cast<std::size_t>(stack.size);
    for (std::size_t i = 0; i < stack.texels(); ++i) {
        if ((i / size) % static_cast<std::size_t>(stride) != 0) continue;
        double value[5] = {0, 0, 0, 128.0 / 255.0, 0.0};
        for (std::size_t c = 0; c < 3; ++c) value[c] = bytes(stack.base)[3 * i + c] / 255.0;
        for (int layer = 0; layer < kLayers; ++layer) {
            const auto at = static_cast<std::size_t>(layer);
            const std::uint8_t* const color = bytes(stack.color[at]) + 4 * i;
            const double coverage = color[3] / 255.0 * bytes(stack.mask[at])[i] / 255.0 *
                                    (0.3 + 0.6 * ((7 * layer) % 10) / 9.0);
            for (std::size_t c = 0; c < 3; ++c)
                value[c] +=
                    coverage * (blended(mode_of(layer), value[c], color[c] / 255.0) - value[c]);
            value[3] += coverage * (bytes(stack.roughness[at])[i] / 255.0 - value[3]);
            value[4] += coverage * (((3 * layer) % 5) / 4.0 - value[4]);
        }
        for (std::size_t c = 0; c < 3; ++c) out.base_color[3 * i + c] = to_byte(value[c]);
        out.packed[3 * i] = 255;
        out.packed[3 * i + 1] = to_byte(value[3]);
        out.packed[3 * i + 2] = to_byte(value[4]);
    }
}

Material stack10_material(BlendSpace space) {
    Material material;
    Layer bottom{.id = {1}, .name = "Base", .blend_space = space};
    set_channel(bottom, Channel::BaseColor,
                image_source(-1, kColorImage, ColorSpace::Srgb, ChannelPick::Rgb));
    set_channel(bottom, Channel::Roughness, ConstantSource{glm::vec3(128.0f / 255.0f)});
    set_channel(bottom, Channel::Metalness, ConstantSource{glm::vec3(0.0f)});
    material.stack.push_back(std::make_shared<const Layer>(std::move(bottom)));
    for (int i = 0; i < kLayers; ++i) {
        Layer layer{.id = {static_cast<std::uint64_t>(i + 2)},
                    .name = "Layer",
                    .opacity = opacity_of(i),
                    .mode = document_mode(mode_of(i)),
                    .blend_space = space};
        layer.mask.entries = {
            {.id = {static_cast<std::uint64_t>(100 + i)},
             .name = "Mask",
             .source = image_source(i, kMaskImage, ColorSpace::Linear, ChannelPick::Red)},
            {.id = {static_cast<std::uint64_t>(200 + i)},
             .name = "Alpha",
             .source = image_source(i, kColorImage, ColorSpace::Linear, ChannelPick::Alpha)}};
        set_channel(layer, Channel::BaseColor,
                    image_source(i, kColorImage, ColorSpace::Srgb, ChannelPick::Rgb));
        set_channel(layer, Channel::Roughness,
                    image_source(i, kRoughnessImage, ColorSpace::Linear, ChannelPick::Red));
        set_channel(layer, Channel::Metalness, ConstantSource{glm::vec3(metalness_of(i))});
        material.stack.push_back(std::make_shared<const Layer>(std::move(layer)));
    }
    return material;
}

}  // namespace patina::bench
