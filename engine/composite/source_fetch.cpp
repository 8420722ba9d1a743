// SPDX-License-Identifier: MIT
#include "composite/source_fetch.h"

#include <cassert>

#include "composite/fetch_kernels.h"
#include "composite/image_sampling.h"
#include "composite/mask_kernels.h"
#include "composite/procedural.h"

namespace patina {
namespace {

/// The first texel of a tile in an image that lies on the texels of the map.
const std::byte* first_texel(const Image& image, const TileSpan& span) {
    const std::size_t texel_bytes =
        static_cast<std::size_t>(image.channels) * sample_bytes(image.type);
    return texels_at(span, image.data.data(), image.row_bytes(), texel_bytes);
}

/// The texels of an image, from the first on, if they are all that a source gives and `accepts`
/// takes them as they are; else none.
StoredTexels stored_texels(const BoundImage& bound, const AcceptsStored& accepts) {
    if (!bound.reading.as_stored || accepts == nullptr) return {};
    const StoredTexels stored{.texels = bound.image->data.data(),
                              .row_bytes = bound.image->row_bytes(),
                              .channels = bound.image->channels,
                              .first = bound.reading.components.index[0],
                              .decode = bound.reading.decode};
    return accepts(stored) ? stored : StoredTexels{};
}

FetchedSource fetch_constant(const SourceRecord& record) {
    const auto& [x, y, z] = record.constant;
    return {{x.plane(), y.plane(), z.plane()}, uniform_one()};
}

/// What is read of an image's texels.
struct ReadComponents {
    Components components = {};
    bool invert = false;  ///< each tap, where the image is filtered
    bool decode = false;  ///< sRGB to linear: each tap, or bytes that are read texel for texel
};

void read_components(const SourceRecord& record, const BoundImage& bound,
                     const ReadComponents& read, const TileSpan& span, const TileCoordinates& at,
                     float* const planes[3]) {
    const Image& image = *bound.image;
    if (read.components.index[0] < 0) {
        fill_tile(planes[0], read.invert ? 0.0f : 1.0f, span.count);
        return;
    }
    if (bound.texel_for_texel) {
        read_tile({.texels = first_texel(image, span),
                   .row_bytes = image.row_bytes(),
                   .type = image.type,
                   .channels = image.channels,
                   .components = read.components,
                   .decode = read.decode,
                   .count = span.count,
                   .planes = {planes[0], planes[1], planes[2]}});
        return;
    }
    sample_tile({.image = &image,
                 .record = &record,
                 .components = read.components,
                 .invert = read.invert,
                 .decode = read.decode,
                 .at = at,
                 .planes = {planes[0], planes[1], planes[2]}},
                span);
}

/// The image's alpha as it lies in the file, filtered like its colour.
ReadPlane fetch_coverage(const SourceRecord& record, const BoundImage& bound, const TileSpan& span,
                         const TileCoordinates& at, TilePlanes& planes) {
    const Components alpha = picked_components(ChannelPick::Alpha, bound.image->channels);
    if (alpha.index[0] < 0) return uniform_one();
    float* const target[3] = {planes.source_coverage(), nullptr, nullptr};
    read_components(record, bound, {.components = alpha}, span, at, target);
    return {.data = target[0]};
}

/// The components in planes. Grey fills all three of a colour or normal.
FetchedSource fetch_components(const SourceRecord& record, const BoundImage& bound,
                               const TileSpan& span, const TileCoordinates& at,
                               const FetchTarget& target) {
    const ImageReading& reading = bound.reading;
    read_components(
        record, bound,
        {reading.components, std::get<ImageSource>(record.source).invert, reading.decode}, span, at,
        target.data());
    int count = reading.components.count;
    if (count == 1 && is_vector(record.reading)) {
        for (std::size_t k = 1; k < 3; ++k) copy_tile(target[0], target[k], span.count);
        count = 3;
    }
    if (!reading.adjustment.is_identity())
        adjust_tile(reading.adjustment, count, target.data(), span.count);
    return {.components = {{target[0]}, {target[1]}, {target[2]}}};
}

FetchedSource fetch_image(const SourceFetch& from, const TileSpan& span, const TileCoordinates& at,
                          const FetchTarget& target, TilePlanes& planes) {
    const SourceRecord& record = *from.record;
    const BoundImage& bound = *from.image;
    FetchedSource fetched{.stored = stored_texels(bound, from.accepts)};
    if (fetched.stored.texels != nullptr)
        fetched.stored.texels = texels_at(span, fetched.stored);
    else
        fetched = fetch_components(record, bound, span, at, target);
    const bool covers = !std::get<ImageSource>(record.source).alpha_is_coverage;
    fetched.coverage = covers ? uniform_one() : fetch_coverage(record, bound, span, at, planes);
    return fetched;
}

/// An image or procedural, at its UVs or at coordinates that a projection gives.
FetchedSource fetch_at(const SourceFetch& from, const TileSpan& span, const TileCoordinates& at,
                       const FetchTarget& target, TilePlanes& planes) {
    if (std::holds_alternative<ImageSource>(from.record->source))
        return fetch_image(from, span, at, target, planes);
    procedural_tile(*from.record, span, at, target.data(), planes.patterns());
    return {{{target[0]}, {target[1]}, {target[2]}}, uniform_one()};
}

}  // namespace

std::optional<FetchedSource> steady_source(const SourceRecord& record, const BoundImage& bound,
                                           const AcceptsStored& accepts) {
    if (std::holds_alternative<ConstantSource>(record.source)) return fetch_constant(record);
    const auto* const image = std::get_if<ImageSource>(&record.source);
    if (image == nullptr || image->alpha_is_coverage) return std::nullopt;
    const StoredTexels stored = stored_texels(bound, accepts);
    if (stored.texels == nullptr) return std::nullopt;
    return FetchedSource{.coverage = uniform_one(), .stored = stored};
}

FetchedSource fetch_source(const SourceFetch& from, const TileSpan& span, const FetchTarget& target,
                           TilePlanes& planes) {
    const SourceRecord& record = *from.record;
    if (std::holds_alternative<ConstantSource>(record.source)) return fetch_constant(record);
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
    return fetch_projected(record, from.texels, span, target.data(), planes,
                           [&](const TileCoordinates& at, float* const to[3]) {
                               return fetch_at(from, span, at, {to[0], to[1], to[2]}, planes);
                           });
}

}  // namespace patina
