// SPDX-License-Identifier: MIT
#include "composite/reduced_images.h"

#include "core/formulae/formulae.h"
#include "core/parallel.h"
#include "scene/sample_values.h"

namespace patina {
namespace {

/// Which texels of a longer line make one of a shorter one, and how much of each.
struct Share {
    int first = 0;
    int count = 0;
    float weights[3] = {};
};

/// The texel covers [index, index + 1) x longer / shorter, which is at most two texels long and so
/// touches at most three.
Share share_of(int index, int longer, int shorter) {
    const double scale = static_cast<double>(longer) / shorter;
    const double begin = index * scale;
    const double end = std::min((index + 1) * scale, static_cast<double>(longer));
    Share share{.first = static_cast<int>(begin)};
    for (int at = share.first; at < end && share.count < 3; ++at) {
        const double overlap = std::min(end, at + 1.0) - std::max(begin, static_cast<double>(at));
        share.weights[share.count++] = static_cast<float>(overlap / scale);
    }
    return share;
}

bool is_alpha(const Image& image, int channel) {
    return (image.channels == 2 || image.channels == 4) && channel == image.channels - 1;
}

float mean_value(const Image& image, const Share& across, const Share& down, int channel,
                 bool encoded) {
    float sum = 0.0f;
    for (int j = 0; j < down.count; ++j)
        for (int i = 0; i < across.count; ++i) {
            const int x = across.first + i;
            const int y = down.first + j;
            sum +=
                across.weights[i] * down.weights[j] *
                (encoded ? linear_value(image, x, y, channel) : stored_value(image, x, y, channel));
        }
    return encoded ? formulae::srgb_from_linear(sum) : sum;
}

}  // namespace

Image half_size_image(const Image& image, ColorSpace color_space) {
    Image half{.width = (image.width + 1) / 2,
               .height = (image.height + 1) / 2,
               .channels = image.channels,
               .type = image.type};
    half.data.resize(half.row_bytes() * static_cast<std::size_t>(half.height));
    parallel_for(0, half.height, 8, [&](std::int64_t first, std::int64_t last) {
        for (int y = static_cast<int>(first); y < last; ++y) {
            const Share down = share_of(y, image.height, half.height);
            for (int x = 0; x < half.width; ++x) {
                const Share across = share_of(x, image.width, half.width);
                for (int c = 0; c < image.channels; ++c) {
                    const bool encoded = color_space == ColorSpace::Srgb && !is_alpha(image, c);
                    store_value(half, x, y, c, mean_value(image, across, down, c, encoded));
                }
            }
        }
    });
    return half;
}

ImagePtr ReducedImages::reduced(const Hash128& hash, const ImagePtr& image, ColorSpace color_space,
                                int halvings) {
    if (halvings == 0) return image;
    ImagePtr& copy = copies_[{hash, color_space, halvings}];
    if (copy == nullptr) {
        const ImagePtr larger = reduced(hash, image, color_space, halvings - 1);
        copy = std::make_shared<const Image>(half_size_image(*larger, color_space));
        size_bytes_ += copy->data.size();
    }
    return copy;
}

}  // namespace patina
