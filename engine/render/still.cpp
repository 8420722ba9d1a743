// SPDX-License-Identifier: MIT

/// Stills: the mean of many draws with sub-pixel offsets.

#include <array>
#include <cassert>
#include <cstring>
#include <limits>

#include "core/formulae/formulae.h"
#include "core/parallel.h"
#include "render/accumulation.h"
#include "render/renderer.h"

namespace patina::render {
namespace {

constexpr int kMaxSamples = 65536;

Status check_still(const RendererState& state, PictureSize size, int samples) {
    if (Status ready = require_content(state); !ready) return ready;
    if (samples < 1 || samples > kMaxSamples)
        return failure("{} samples cannot be averaged: give 1 to {}", samples, kMaxSamples);
    if (size.width < 1 || size.height < 1 || size.width > kMaxPictureSide ||
        size.height > kMaxPictureSide)
        return failure("a picture of {} x {} cannot be drawn: its sides are 1 to {} pixels",
                       size.width, size.height, kMaxPictureSide);
    return {};
}

/// With fewer draws the filtered environment is nearer to the truth than samples of it are.
constexpr int kLeastSampledDraws = 64;

/// Whether each draw samples the environment, so that many draws converge to the integral. What is
/// sampled is averaged as radiance: a tone map of each draw would not have the same mean.
bool samples_environment(const View& view, int samples, OutputMode output) {
    if (samples < kLeastSampledDraws) return false;
    if (shows_difference_beside(view)) return false;
    if (!shows_pbr(view)) return false;
    return output == OutputMode::Radiance || view.channel == ChannelView::Final;
}

/// Whether both sides are summed apart: the mean of differences of noise is not the difference of
/// the means.
bool sums_both_sides(const View& view, int samples, OutputMode output) {
    return view.compare == CompareMode::Difference && samples_environment(view, samples, output);
}

/// Adds sample i of `samples` to the sum; the first clears it.
Status add_sample(RendererState& state, const View& view, PictureSize size, int i, int samples,
                  OutputMode output) {
    const Result<gl::Framebuffer*> sum = sum_for(state.accumulation, size, i);
    if (!sum) return passed_on(sum);
    const bool sampled = samples_environment(view, samples, output);
    if (sums_both_sides(view, samples, output)) {
        const Result<gl::Framebuffer*> right = sum_for(state.accumulation_right, size, i);
        if (!right) return passed_on(right);
        return add_radiance(state, view, size, **sum, {i, StillDraw{i, samples}, *right});
    }
    if (sampled && output != OutputMode::Radiance)
        return add_radiance(state, view, size, **sum, {i, StillDraw{i, samples}});
    FrameTarget target{.framebuffer = *sum,
                       .output = output,
                       .add = true,
                       .jitter_pixels = sample_offset(i),
                       .draw_index = i};
    if (sampled) {
        if (Status ready = ready_to_sample(state); !ready) return ready;
        target.still = StillDraw{i, samples};
    }
    return draw_frame(state, view, {size.width, size.height}, target);
}

std::vector<float> mean_of(const gl::Framebuffer& sum, PictureSize size, int samples) {
    std::vector<float> mean = sum.read_color(0, {0, 0}, {size.width, size.height});
    const float share = 1.0f / static_cast<float>(samples);
    for (float& value : mean) value *= share;
    return mean;
}

OutputMode output_of(const Still& still) {
    return still.linear ? OutputMode::Radiance : OutputMode::Display;
}

/// The difference of what both sides came to: RGBA, bottom row first.
Result<std::vector<float>> difference_of_means(RendererState& state, const Still& still) {
    const glm::ivec2 pixels(still.size.width, still.size.height);
    const Result<gl::Framebuffer*> target = state.still.at(pixels);
    if (!target) return passed_on(target);
    if (Status drawn = draw_difference(
            state, still.view,
            {state.accumulation.get(), state.accumulation_right.get(), still.drawn},
            {.framebuffer = *target, .area = {{0, 0}, pixels}, .output = output_of(still)});
        !drawn)
        return passed_on(drawn);
    return (*target)->read_color(0, {0, 0}, pixels);
}

/// Display light of what was averaged as radiance, over the background.
Result<std::vector<float>> shown_radiance(RendererState& state, const Still& still) {
    const glm::ivec2 pixels(still.size.width, still.size.height);
    const Result<gl::Framebuffer*> target = state.still.at(pixels);
    if (!target) return passed_on(target);
    if (Status drawn =
            draw_averaged(state, still.view, pixels, *state.accumulation.get(), still.drawn,
                          {.framebuffer = *target, .output = OutputMode::Display});
        !drawn)
        return passed_on(drawn);
    return (*target)->read_color(0, {0, 0}, pixels);
}

/// What the draws so far come to: RGBA, premultiplied, bottom row first.
Result<std::vector<float>> averaged(RendererState& state, const Still& still) {
    const OutputMode output = output_of(still);
    if (sums_both_sides(still.view, still.samples, output))
        return difference_of_means(state, still);
    if (!still.linear && samples_environment(still.view, still.samples, output))
        return shown_radiance(state, still);
    return mean_of(*state.accumulation.get(), still.size, still.drawn);
}

Image empty_image(PictureSize size, SampleType type) {
    Image image{
        .width = size.width, .height = size.height, .channels = 4, .type = type, .data = {}};
    image.data.resize(image.row_bytes() * static_cast<std::size_t>(size.height));
    return image;
}

/// As dither() of passes/output.glsl, so that a still shows no banding either: in steps of a
/// sample.
float dither(int x, int y_from_bottom) {
    return formulae::interleaved_gradient_noise(
               {static_cast<float>(x), static_cast<float>(y_from_bottom)}) -
           0.5f;
}

/// 0 to 1 as the nearest of all values of Sample, after `noise` of their steps.
template <typename Sample>
Sample rounded(float encoded, float noise) {
    constexpr auto most = static_cast<float>(std::numeric_limits<Sample>::max());
    return static_cast<Sample>(std::clamp(encoded * most + noise, 0.0f, most) + 0.5f);
}

/// One pixel of premultiplied linear light to straight sRGB.
template <typename Sample>
void encode_pixel(const float* rgba, float noise, std::byte* out) {
    const float alpha = std::clamp(rgba[3], 0.0f, 1.0f);
    std::array<Sample, 4> pixel;
    for (int c = 0; c < 3; ++c) {
        const float linear = alpha > 0.0f ? std::clamp(rgba[c] / alpha, 0.0f, 1.0f) : 0.0f;
        pixel[static_cast<std::size_t>(c)] =
            rounded<Sample>(formulae::srgb_from_linear(linear), noise);
    }
    pixel[3] = rounded<Sample>(alpha, 0.0f);
    std::memcpy(out, pixel.data(), sizeof pixel);
}

}  // namespace

Image srgb_image(const StillMean& still, SampleType type) {
    assert(type == SampleType::U8 || type == SampleType::U16);
    const PictureSize size = still.size;
    Image image = empty_image(size, type);
    const bool bytes = type == SampleType::U8;
    const std::size_t step = image.row_bytes() / static_cast<std::size_t>(size.width);
    parallel_for(0, size.height, 16, [&](std::int64_t first, std::int64_t last) {
        for (int y = static_cast<int>(first); y < static_cast<int>(last); ++y) {
            const int from_bottom = size.height - 1 - y;
            const float* row = still.rgba_premultiplied.data() +
                               std::size_t{4} * static_cast<std::size_t>(from_bottom) *
                                   static_cast<std::size_t>(size.width);
            std::byte* out = image.data.data() + static_cast<std::size_t>(y) * image.row_bytes();
            for (int x = 0; x < size.width; ++x, row += 4, out += step) {
                const float noise = still.dithered ? dither(x, from_bottom) : 0.0f;
                bytes ? encode_pixel<std::uint8_t>(row, noise, out)
                      : encode_pixel<std::uint16_t>(row, noise, out);
            }
        }
    });
    return image;
}

Image linear_image(const StillMean& still) {
    Image image = empty_image(still.size, SampleType::F32);
    const std::size_t row_bytes = image.row_bytes();
    const auto* rows = reinterpret_cast<const std::byte*>(still.rgba_premultiplied.data());
    const auto height = static_cast<std::size_t>(still.size.height);
    for (std::size_t y = 0; y < height; ++y)
        std::memcpy(image.data.data() + y * row_bytes, rows + (height - 1 - y) * row_bytes,
                    row_bytes);
    return image;
}

Status Renderer::draw_sample(Still& still) {
    if (Status fits = check_still(*state_, still.size, still.samples); !fits) return fits;
    if (Status drawn = add_sample(*state_, still.view, still.size, still.drawn, still.samples,
                                  output_of(still));
        !drawn)
        return drawn;
    ++still.drawn;
    return {};
}

Result<StillMean> Renderer::mean(const Still& still) {
    assert(still.drawn > 0);
    Result<std::vector<float>> rgba = averaged(*state_, still);
    if (!rgba) return passed_on(rgba);
    // Channels hold exact numbers: noise would change them.
    return StillMean{.size = still.size,
                     .rgba_premultiplied = std::move(*rgba),
                     .dithered = info(still.view.channel).display == ChannelDisplay::Picture};
}

/// All draws of a still.
Result<StillMean> Renderer::finished_still(Still still) {
    do {
        if (const Status drawn = draw_sample(still); !drawn) return passed_on(drawn);
    } while (!still.is_finished());
    return mean(still);
}

Result<Image> Renderer::still_srgb(const View& view, PictureSize size, int samples,
                                   SampleType type) {
    const auto made = finished_still({.view = view, .size = size, .samples = samples});
    if (!made) return passed_on(made);
    return srgb_image(*made, type);
}

Result<Image> Renderer::still_linear(const View& view, PictureSize size, int samples) {
    const auto made =
        finished_still({.view = view, .size = size, .samples = samples, .linear = true});
    if (!made) return passed_on(made);
    return linear_image(*made);
}

}  // namespace patina::render
