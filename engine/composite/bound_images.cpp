// SPDX-License-Identifier: MIT
#include "composite/bound_images.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"

namespace patina {
namespace {

/// Grey checks of 1/16 of the image: what stands for pixels that are not there.
ImagePtr placeholder_image() {
    static const ImagePtr image = [] {
        Image checker{.width = 16, .height = 16, .channels = 1};
        checker.data.resize(256);
        for (std::size_t i = 0; i < 256; ++i)
            checker.data[i] = static_cast<std::byte>((i + i / 16) % 2 == 0 ? 110 : 140);
        return std::make_shared<const Image>(std::move(checker));
    }();
    return image;
}

/// The index of the source that an operation reads; -1 where it reads none.
std::int32_t source_read_by(const ProgramData& program, const Operation& operation) {
    if (operation.code == OpCode::Blend || operation.code == OpCode::MaskEntry)
        return operation.source;
    if (operation.code == OpCode::MaskHeight)
        return program.height_blends[static_cast<std::size_t>(operation.source)].source;
    return -1;
}

/// Bits, one for each image, of those that an operation on `wanted` reads.
std::vector<bool> needed_images(const ProgramData& program, ChannelBits wanted) {
    std::vector<bool> needed(program.images.size(), false);
    std::size_t referred_until = 0;  // whatever a wanted reference goes through is needed
    for (std::size_t i = 0; i < program.operations.size(); ++i) {
        const Operation& operation = program.operations[i];
        const bool runs = i < referred_until || (operation.channels & wanted) != 0;
        const bool refers = operation.code == OpCode::Reference;
        const auto past = static_cast<std::size_t>(refers ? operation.jump : 0);
        if (runs) referred_until = std::max(referred_until, past);
        if (!runs && refers) i = past - 1;
        if (!runs) continue;
        const std::int32_t source = source_read_by(program, operation);
        if (source < 0) continue;
        const int image = program.sources[static_cast<std::size_t>(source)].image;
        if (image >= 0) needed[static_cast<std::size_t>(image)] = true;
    }
    return needed;
}

std::vector<Result<ImagePtr>> fetched_images(const ProgramData& program, ChannelBits wanted,
                                             ImageProvider& images) {
    const std::vector<bool> needed = needed_images(program, wanted);
    std::vector<Result<ImagePtr>> fetched(program.images.size(), ImagePtr());
    parallel_for(0, static_cast<std::int64_t>(needed.size()), 1,
                 [&](std::int64_t first, std::int64_t last) {
                     for (std::size_t i = static_cast<std::size_t>(first);
                          i < static_cast<std::size_t>(last); ++i)
                         if (needed[i]) fetched[i] = images.pixels(program.images[i]);
                 });
    return fetched;
}

/// How many texels of the image one texel of the map spans, along the longer way.
double footprint(const SourceRecord& record, const Image& image, int size) {
    const auto span = [&](float u, float v) {
        return std::hypot(static_cast<double>(u) * image.width,
                          static_cast<double>(v) * image.height) /
               size;
    };
    return record.length_per_uv *
           std::max(span(record.to_u.x, record.to_v.x), span(record.to_u.y, record.to_v.y));
}

/// Halvings that leave a span between 0.75 and 1.5 texels.
int halvings_for(double texels) {
    int halvings = 0;
    for (; texels >= 1.5 && halvings < 14; texels /= 2) ++halvings;
    return halvings;
}

/// Whether what is read is an sRGB-encoded colour.
bool is_encoded(const SourceRecord& record) {
    const auto& source = std::get<ImageSource>(record.source);
    return source.color_space == ColorSpace::Srgb && source.pick != ChannelPick::Alpha &&
           record.reading != Reading::Normal;
}

/// What is done to the numbers of an image once they lie in planes. `filtered`: invert and decode
/// were done to each tap.
Adjustment adjustment_of(const SourceRecord& record, const Image& image,
                         const Components& components, bool filtered) {
    const auto& source = std::get<ImageSource>(record.source);
    const bool normal = record.reading == Reading::Normal;
    Adjustment adjustment{.invert = source.invert && !filtered,
                          .decode = is_encoded(record) && !filtered,
                          .unpack = normal,
                          .flip_y = normal && source.directx_normal,
                          .normalise = normal,
                          .luminance = !is_vector(record.reading) && components.count == 3,
                          .encode = record.reading == Reading::EncodedColor,
                          .multiply = source.multiply,
                          .add = source.add};
    adjustment.scale = source.multiply != glm::vec3(1.0f) || source.add != glm::vec3(0.0f);
    const bool within = image.type != SampleType::F32 && !adjustment.scale;
    adjustment.hold = !within && !normal && record.reading != Reading::Height;
    // What is stored sRGB-encoded and blends so needs no way there and back.
    if (adjustment.decode && adjustment.encode && !adjustment.scale)
        adjustment.decode = adjustment.encode = false;
    return adjustment;
}

ImageReading image_reading(const SourceRecord& record, const BoundImage& bound) {
    const auto& source = std::get<ImageSource>(record.source);
    const bool bytes = bound.image->type == SampleType::U8;
    ImageReading reading{.components = picked_components(source.pick, bound.image->channels)};
    const bool there = reading.components.index[0] >= 0;
    const bool filtered = !bound.texel_for_texel || !there;
    reading.adjustment = adjustment_of(record, *bound.image, reading.components, filtered);
    if (filtered) {
        reading.decode = is_encoded(record);
        return reading;
    }
    reading.decode = bytes && reading.adjustment.decode && !reading.adjustment.invert;
    if (reading.decode) reading.adjustment.decode = false;
    const bool alike = is_vector(record.reading) == (reading.components.count == 3);
    reading.as_stored = bytes && alike && reading.adjustment.is_identity();
    return reading;
}

BoundImage bound_image(const SourceRecord& record, const Hash128& hash, const ImagePtr& image,
                       int size, ReducedImages& reduced) {
    const auto& source = std::get<ImageSource>(record.source);
    BoundImage bound;
    bound.image = reduced.reduced(hash, image, source.color_space,
                                  halvings_for(footprint(record, *image, size)));
    bound.texel_for_texel = source.transform == UvTransform{} &&
                            record.projection.kind == ProjectionKind::Uv &&
                            bound.image->width == size && bound.image->height == size;
    bound.reading = image_reading(record, bound);
    return bound;
}

BoundImage bound_placeholder(const SourceRecord& record) {
    BoundImage bound{.image = placeholder_image(), .placeholder = true};
    bound.reading = image_reading(record, bound);
    return bound;
}

}  // namespace

BoundImages bind_images(const ProgramData& program, ChannelBits wanted, int size,
                        ImageProvider& images, ReducedImages& reduced) {
    wanted = program.with_needed(wanted);
    BoundImages bound;
    if (program.surface != nullptr) bound.surface_map = program.surface->map(size);
    const auto fetched = fetched_images(program, wanted, images);
    for (const auto& image : fetched)
        if (!image) bound.failures.push_back(image.error().message);
    for (const SourceRecord& record : program.sources) {
        bound.sources.emplace_back();
        if (record.image < 0) continue;
        const auto index = static_cast<std::size_t>(record.image);
        const bool there = fetched[index].has_value() && *fetched[index] != nullptr;
        bound.sources.back() =
            there ? bound_image(record, program.images[index], *fetched[index], size, reduced)
                  : bound_placeholder(record);
    }
    return bound;
}

Result<BoundImages> images_for_bake(const ProgramData& program, ChannelBits wanted, int size,
                                    ImageProvider& images) {
    constexpr int kLargestSide = 16384;
    if (size < 1 || size > kLargestSide)
        return failure("maps of {} texels a side cannot be baked: 1 to {} can", size, kLargestSide);
    ReducedImages reduced;
    BoundImages bound = bind_images(program, wanted, size, images, reduced);
    if (!bound.failures.empty()) return failure("{}", bound.failures.front());
    return bound;
}

}  // namespace patina
