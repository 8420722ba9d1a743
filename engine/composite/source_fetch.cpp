// SPDX-License-Identifier: MIT
#include "composite/source_fetch.h"

#include <cassert>

#include "composite/fetch_kernels.h"
#include "composite/image_sampling.h"
#include "composite/mask_kernels.h"
#include "composite/procedural.h"

namespace patina {
namespace {

/// What is done to the numbers of an image once they lie in planes. `filtered`: invert and decode
/// were done to each tap.
Adjustment adjustment_of(const SourceRecord& record, const Image& image,
                         const Components& components, bool filtered) {
    const auto& source = std::get<ImageSource>(record.source);
    const bool normal = record.reading == Reading::Normal;
    const bool encoded =
        source.color_space == ColorSpace::Srgb && source.pick != ChannelPick::Alpha;
    Adjustment adjustment{.invert = source.invert && !filtered,
                          .decode = encoded && !normal && !filtered,
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

/// Components as planes; grey fills all three where a colour or normal is read with factors that
/// differ, and is shared by them where not.
/// @param decode  sRGB to linear, of bytes that are read texel for texel
void read_components(const SourceRecord& record, const BoundImage& bound,
                     const Components& components, const TileSpan& span, const TileCoordinates& at,
                     bool decode, float* const planes[3]) {
    const auto& source = std::get<ImageSource>(record.source);
    const Image& image = *bound.image;
    if (components.index[0] < 0) {
        fill_tile(planes[0], source.invert ? 0.0f : 1.0f, span.count);
        return;
    }
    if (bound.texel_for_texel && at.u == nullptr) {
        const std::size_t texel_bytes =
            static_cast<std::size_t>(image.channels) * sample_bytes(image.type);
        read_tile({.texels = image.data.data() +
                             image.row_bytes() * static_cast<std::size_t>(span.y) +
                             texel_bytes * static_cast<std::size_t>(span.x),
                   .type = image.type,
                   .channels = image.channels,
                   .components = components,
                   .decode = decode,
                   .count = span.count,
                   .planes = {planes[0], planes[1], planes[2]}});
        return;
    }
    const bool color = record.reading != Reading::Normal && source.pick != ChannelPick::Alpha;
    sample_tile({.image = &image,
                 .record = &record,
                 .components = components,
                 .invert = source.invert,
                 .decode = color && source.color_space == ColorSpace::Srgb,
                 .at = at,
                 .planes = {planes[0], planes[1], planes[2]}},
                span);
}

/// The image's alpha as it lies in the file, filtered like its colour.
ReadPlane fetch_coverage(const SourceRecord& record, const BoundImage& bound, const TileSpan& span,
                         const TileCoordinates& at, TilePlanes& planes) {
    const Components alpha = picked_components(ChannelPick::Alpha, bound.image->channels);
    if (alpha.index[0] < 0) return uniform_one();
    SourceRecord plain = record;
    auto& source = std::get<ImageSource>(plain.source);
    source.pick = ChannelPick::Alpha;
    source.invert = false;
    float* const target[3] = {planes.source_coverage(), nullptr, nullptr};
    read_components(plain, bound, alpha, span, at, false, target);
    return {.data = target[0]};
}

FetchedSource fetch_image(const SourceRecord& record, const BoundImage& bound, const TileSpan& span,
                          const TileCoordinates& at, float* const target[3], TilePlanes& planes) {
    const auto& source = std::get<ImageSource>(record.source);
    const Components components = picked_components(source.pick, bound.image->channels);
    const bool filtered = at.u != nullptr || !bound.texel_for_texel || components.index[0] < 0;
    Adjustment adjustment = adjustment_of(record, *bound.image, components, filtered);
    const bool decodes_bytes =
        bound.image->type == SampleType::U8 && adjustment.decode && !adjustment.invert;
    if (decodes_bytes) adjustment.decode = false;
    read_components(record, bound, components, span, at, decodes_bytes, target);
    int count = components.count;
    if (count == 1 && is_vector(record.reading)) {
        for (int k = 1; k < 3; ++k) copy_tile(target[0], target[k], span.count);
        count = 3;
    }
    if (!adjustment.is_identity()) adjust_tile(adjustment, count, target, span.count);
    FetchedSource fetched{{{target[0]}, {target[1]}, {target[2]}}, uniform_one()};
    if (source.alpha_is_coverage)
        fetched.coverage = fetch_coverage(record, bound, span, at, planes);
    return fetched;
}

/// An image or procedural, at its UVs or at coordinates that a projection gives.
FetchedSource fetch_at(const SourceFetch& from, const TileSpan& span, const TileCoordinates& at,
                       float* const target[3], TilePlanes& planes) {
    if (std::holds_alternative<ImageSource>(from.record->source))
        return fetch_image(*from.record, *from.image, span, at, target, planes);
    procedural_tile(*from.record, span, at, target);
    return {{{target[0]}, {target[1]}, {target[2]}}, uniform_one()};
}

}  // namespace

FetchedSource fetch_source(const SourceFetch& from, const TileSpan& span, float* const target[3],
                           TilePlanes& planes) {
    const SourceRecord& record = *from.record;
    if (std::holds_alternative<ConstantSource>(record.source))
        return {
            {record.constant[0].plane(), record.constant[1].plane(), record.constant[2].plane()},
            uniform_one()};
    const bool has_map = from.texels.map != nullptr;
    if (from.chosen_parts != nullptr) {
        if (has_map)
            fetch_chosen_parts(from.texels, *from.chosen_parts, span, target[0]);
        else
            fill_tile(target[0], 1.0f, span.count);
        return {{{target[0]}, {}, {}}, uniform_one()};
    }
    if (!has_map || record.projection.kind == ProjectionKind::Uv)
        return fetch_at(from, span, {}, target, planes);
    return fetch_projected(record, from.texels, span, target, planes,
                           [&](const TileCoordinates& at, float* const to[3]) {
                               return fetch_at(from, span, at, to, planes);
                           });
}

}  // namespace patina
