// SPDX-License-Identifier: MIT
#include "document/source_edits.h"

#include <algorithm>
#include <cassert>

#include "document/change.h"
#include "document/check.h"
#include "document/scene_edits.h"

namespace patina {
namespace {

SourceUse use_of(const SourcePlace& place) {
    const auto* channel = std::get_if<Channel>(&place.part);
    return channel ? SourceUse(*channel) : std::nullopt;
}

/// Null when the mask has no such entry, or one that is an adjustment.
Source* source_in(Layer& layer, const SourcePlace& place) {
    if (const auto* channel = std::get_if<Channel>(&place.part))
        return &at(layer.channels, *channel).source;
    const auto id = std::get<MaskEntryId>(place.part);
    const auto entry = std::find_if(layer.mask.entries.begin(), layer.mask.entries.end(),
                                    [id](const MaskEntry& each) { return each.id == id; });
    const bool there = entry != layer.mask.entries.end() && !entry->adjustment;
    return there ? &entry->source : nullptr;
}

/// "Contrast of mask entry Drips", "Base colour contrast of Tarnish".
std::string label_of(const SourcePlace& place, std::string_view what) {
    const auto* channel = std::get_if<Channel>(&place.part);
    if (!channel) return fmt::format("{} of {}", what, place.name);
    std::string lower(what);
    if (lower.size() > 1 && (lower[1] < 'A' || lower[1] > 'Z')) lower[0] |= ' ';
    return fmt::format("{} {} of {}", info(*channel).label, lower, place.name);
}

MergeKey key_of(const SourcePlace& place, std::string_view action) {
    if (const auto* channel = std::get_if<Channel>(&place.part))
        return {fmt::format("source.{}/{}", action, info(*channel).id), place.layer.value};
    return {fmt::format("source.{}", action), std::get<MaskEntryId>(place.part).value};
}

using SourceChange = std::function<Status(Source& copy, const Document& before)>;

Edit source_edit(const SourcePlace& place, std::string label, MergeKey merge_key,
                 SourceChange change) {
    return {.label = std::move(label),
            .merge_key = std::move(merge_key),
            .apply = [place, change = std::move(change)](const Document& before) {
                return with_layer(before, place.material, place.layer, OwnLock::Respected,
                                  [&](Layer& copy) -> Status {
                                      Source* source = source_in(copy, place);
                                      if (!source)
                                          return failure(
                                              "the mask of {} has no such source any more",
                                              quoted_for_message(copy.name, 80));
                                      if (Status status = change(*source, before); !status)
                                          return status;
                                      return check_source(use_of(place), *source);
                                  });
            }};
}

template <typename Kind>
constexpr std::string_view kind_name() {
    if constexpr (std::is_same_v<Kind, ImageSource>) return "an image";
    if constexpr (std::is_same_v<Kind, ProceduralSource>) return "a procedural";
    if constexpr (std::is_same_v<Kind, ReliefSource>) return "a relief";
    if constexpr (std::is_same_v<Kind, GeometrySource>) return "a choice of parts";
}

/// An edit of a source of one kind; refused while the source is of another.
template <typename Kind, typename Change>
Edit edit_of(const SourcePlace& place, std::string_view what, MergeKey merge_key, Change change) {
    return source_edit(place, label_of(place, what), std::move(merge_key),
                       [change, place](Source& source, const Document&) -> Status {
                           auto* part = std::get_if<Kind>(&source);
                           if (!part)
                               return failure("the source of {} is not {}",
                                              quoted_for_message(place.name, 80),
                                              kind_name<Kind>());
                           change(*part);
                           return {};
                       });
}

/// A number or a switch of a source. Numbers merge while they are dragged, switches never do.
template <typename Kind, typename Value>
Edit member_edit(const SourcePlace& place, Parameter parameter, Value Kind::*member, Value value) {
    const ParameterInfo& row = info(parameter);
    const bool merges = row.kind == ParameterKind::Number || row.kind == ParameterKind::Integer ||
                        row.kind == ParameterKind::Vector;
    return edit_of<Kind>(place, row.label, merges ? key_of(place, row.id) : MergeKey{},
                         [member, value](Kind& part) { part.*member = value; });
}

Edit transform_edit(const SourcePlace& place, std::string_view what, std::string_view action,
                    std::function<void(UvTransform&)> change) {
    return source_edit(
        place, label_of(place, what), key_of(place, action),
        [place, change = std::move(change)](Source& source, const Document&) -> Status {
            if (auto* image = std::get_if<ImageSource>(&source))
                change(image->transform);
            else if (auto* noise = std::get_if<ProceduralSource>(&source))
                change(noise->transform);
            else
                return failure("the source of {} has no UV transform",
                               quoted_for_message(place.name, 80));
            return {};
        });
}

Source canonical_source(SourceUse use, Source source) {
    if (auto* constant = std::get_if<ConstantSource>(&source))
        constant->value = canonical_value(use, constant->value);
    if (auto* noise = std::get_if<ProceduralSource>(&source))
        for (RampStop& stop : noise->ramp) stop.value = canonical_value(use, stop.value);
    return source;
}

}  // namespace

SourcePlace source_place(const Material& material, const Layer& layer, Channel channel) {
    return {material.id, layer.id, channel, layer.name};
}

SourcePlace source_place(const Material& material, const Layer& layer, const MaskEntry& entry) {
    return {material.id, layer.id, entry.id, "mask entry " + entry.name};
}

const Source* find_source(const Material& material, const SourcePlace& place) {
    const LayerPtr layer = find_layer(material, place.layer);
    if (!layer) return nullptr;
    if (const auto* channel = std::get_if<Channel>(&place.part))
        return &at(layer->channels, *channel).source;
    for (const MaskEntry& entry : layer->mask.entries)
        if (entry.id == std::get<MaskEntryId>(place.part)) return &entry.source;
    return nullptr;
}

Edit at_all(const std::vector<SourcePlace>& places,
            const std::function<Edit(const SourcePlace&)>& edit) {
    assert(!places.empty());
    Edit first = edit(places.front());
    if (places.size() == 1) return first;
    Edits edits;
    for (const SourcePlace& place : places) edits.push_back(edit(place));
    Edit all = in_one_step(fmt::format("{} and {} more", first.label, places.size() - 1),
                           std::move(edits));
    // As many each time, so that a drag of all does not run on into one of fewer.
    all.merge_key = first.merge_key;
    if (!all.merge_key.action.empty())
        all.merge_key.action += fmt::format("/and {} more", places.size() - 1);
    return all;
}

Edit set_source(const SourcePlace& place, Source source) {
    return source_edit(place, label_of(place, "Source"), {},
                       [place, source](Source& copy, const Document& before) -> Status {
                           // Checked before it is made canonical: a normal of length 0 has none.
                           if (Status status = check_source(use_of(place), source); !status)
                               return status;
                           copy = canonical_source(use_of(place), source);
                           return check_images(before, copy);
                       });
}

Edit set_constant(const SourcePlace& place, const glm::vec3& value) {
    const auto* channel = std::get_if<Channel>(&place.part);
    std::string label = channel ? fmt::format("{} of {}", info(*channel).label, place.name)
                                : fmt::format("Value of {}", place.name);
    return source_edit(place, std::move(label), key_of(place, "value"),
                       [place, value](Source& source, const Document&) -> Status {
                           auto* constant = std::get_if<ConstantSource>(&source);
                           if (!constant)
                               return failure("the source of {} is not a value",
                                              quoted_for_message(place.name, 80));
                           if (Status status = check_value(use_of(place), value); !status)
                               return status;
                           constant->value = canonical_value(use_of(place), value);
                           return {};
                       });
}

Edit set_procedural_kind(const SourcePlace& place, ProceduralKind kind) {
    return member_edit(place, Parameter::ProceduralKindChoice, &ProceduralSource::kind, kind);
}
Edit set_procedural_seed(const SourcePlace& place, std::uint32_t seed) {
    return member_edit(place, Parameter::ProceduralSeed, &ProceduralSource::seed, seed);
}
Edit set_procedural_scale(const SourcePlace& place, float scale) {
    return member_edit(place, Parameter::ProceduralScale, &ProceduralSource::scale, scale);
}
Edit set_procedural_octaves(const SourcePlace& place, int octaves) {
    return member_edit(place, Parameter::ProceduralOctaves, &ProceduralSource::octaves, octaves);
}
Edit set_procedural_contrast(const SourcePlace& place, float contrast) {
    return member_edit(place, Parameter::ProceduralContrast, &ProceduralSource::contrast, contrast);
}
Edit set_procedural_balance(const SourcePlace& place, float balance) {
    return member_edit(place, Parameter::ProceduralBalance, &ProceduralSource::balance, balance);
}

Edit set_procedural_width(const SourcePlace& place, float width) {
    return member_edit(place, Parameter::ProceduralWidth, &ProceduralSource::width, width);
}

Edit set_procedural_softness(const SourcePlace& place, float softness) {
    return member_edit(place, Parameter::ProceduralSoftness, &ProceduralSource::softness, softness);
}

Edit set_procedural_variation(const SourcePlace& place, float variation) {
    return member_edit(place, Parameter::ProceduralVariation, &ProceduralSource::variation,
                       variation);
}

Edit set_procedural_aspect(const SourcePlace& place, float aspect) {
    return member_edit(place, Parameter::ProceduralAspect, &ProceduralSource::aspect, aspect);
}

Edit set_procedural_warp(const SourcePlace& place, float warp) {
    return member_edit(place, Parameter::ProceduralWarp, &ProceduralSource::warp, warp);
}

Edit set_ramp(const SourcePlace& place, std::vector<RampStop> stops) {
    return source_edit(
        place, label_of(place, "Ramp"), {},
        [place, stops = std::move(stops)](Source& source, const Document&) -> Status {
            auto* noise = std::get_if<ProceduralSource>(&source);
            if (!noise)
                return failure("the source of {} is not a procedural",
                               quoted_for_message(place.name, 80));
            if (Status status = check_ramp(use_of(place), stops); !status) return status;
            noise->ramp = stops;
            for (RampStop& stop : noise->ramp)
                stop.value = canonical_value(use_of(place), stop.value);
            return {};
        });
}

Edit set_ramp_stop(const SourcePlace& place, int index, const RampStop& stop) {
    return source_edit(place, label_of(place, "Ramp"), key_of(place, fmt::format("ramp.{}", index)),
                       [place, index, stop](Source& source, const Document&) -> Status {
                           auto* noise = std::get_if<ProceduralSource>(&source);
                           if (!noise)
                               return failure("the source of {} is not a procedural",
                                              quoted_for_message(place.name, 80));
                           if (index < 0 || static_cast<std::size_t>(index) >= noise->ramp.size())
                               return failure("the ramp has no stop {}", index);
                           if (Status status = check_value(use_of(place), stop.value); !status)
                               return status;
                           noise->ramp[static_cast<std::size_t>(index)] = {
                               stop.position, canonical_value(use_of(place), stop.value)};
                           return {};
                       });
}

Edit set_relief(const SourcePlace& place, const ReliefSource& relief, Parameter parameter) {
    const ParameterInfo& row = info(parameter);
    const bool merges = row.kind == ParameterKind::Number;
    return edit_of<ReliefSource>(place, row.label, merges ? key_of(place, row.id) : MergeKey{},
                                 [relief](ReliefSource& part) { part = relief; });
}

Edit set_geometry(const SourcePlace& place, const GeometrySource& geometry, Parameter parameter) {
    return edit_of<GeometrySource>(place, info(parameter).label, {},
                                   [geometry](GeometrySource& part) { part = geometry; });
}

Edit set_projection(const SourcePlace& place, const Projection& projection, Parameter parameter) {
    const ParameterInfo& row = info(parameter);
    const bool merges = row.kind == ParameterKind::Number;
    return source_edit(place, label_of(place, row.label),
                       merges ? key_of(place, "projection-" + std::string(row.id)) : MergeKey{},
                       [place, projection](Source& source, const Document&) -> Status {
                           if (auto* image = std::get_if<ImageSource>(&source))
                               image->projection = projection;
                           else if (auto* noise = std::get_if<ProceduralSource>(&source))
                               noise->projection = projection;
                           else
                               return failure("the source of {} is not projected",
                                              quoted_for_message(place.name, 80));
                           return {};
                       });
}

Edit set_image(const SourcePlace& place, const ImageAssetPtr& image) {
    return source_edit(
        place, label_of(place, "Image"), {},
        [place, hash = image->hash](Source& source, const Document& before) -> Status {
            auto* part = std::get_if<ImageSource>(&source);
            if (!part)
                return failure("the source of {} is not an image",
                               quoted_for_message(place.name, 80));
            part->image = hash;
            return check_images(before, source);
        });
}

Edit set_image_color_space(const SourcePlace& place, ColorSpace space) {
    return member_edit(place, Parameter::ImageColorSpace, &ImageSource::color_space, space);
}
Edit set_image_pick(const SourcePlace& place, ChannelPick pick) {
    return member_edit(place, Parameter::ImagePick, &ImageSource::pick, pick);
}
Edit set_image_invert(const SourcePlace& place, bool invert) {
    return member_edit(place, Parameter::ImageInvert, &ImageSource::invert, invert);
}
Edit set_image_directx_normal(const SourcePlace& place, bool directx_normal) {
    return member_edit(place, Parameter::ImageDirectxNormal, &ImageSource::directx_normal,
                       directx_normal);
}
Edit set_image_alpha_is_coverage(const SourcePlace& place, bool alpha_is_coverage) {
    return member_edit(place, Parameter::ImageAlphaIsCoverage, &ImageSource::alpha_is_coverage,
                       alpha_is_coverage);
}
Edit set_image_uv_set(const SourcePlace& place, int uv_set) {
    return member_edit(place, Parameter::ImageUvSet, &ImageSource::uv_set, uv_set);
}
Edit set_image_filter(const SourcePlace& place, Filter filter) {
    return member_edit(place, Parameter::ImageFilter, &ImageSource::filter, filter);
}

Edit set_image_wrap(const SourcePlace& place, Wrap wrap_u, Wrap wrap_v) {
    return edit_of<ImageSource>(place, "Wrap", {}, [wrap_u, wrap_v](ImageSource& image) {
        image.wrap_u = wrap_u;
        image.wrap_v = wrap_v;
    });
}

Edit set_image_range(const SourcePlace& place, const glm::vec3& multiply, const glm::vec3& add) {
    return edit_of<ImageSource>(place, "Range", key_of(place, "range"),
                                [multiply, add](ImageSource& image) {
                                    image.multiply = multiply;
                                    image.add = add;
                                });
}

Edit set_uv_offset(const SourcePlace& place, const glm::vec2& offset) {
    return transform_edit(place, "Offset", "uv.offset",
                          [offset](UvTransform& transform) { transform.offset = offset; });
}
Edit set_uv_scale(const SourcePlace& place, const glm::vec2& scale) {
    return transform_edit(place, "Scale", "uv.scale",
                          [scale](UvTransform& transform) { transform.scale = scale; });
}
Edit set_uv_rotation(const SourcePlace& place, float degrees) {
    return transform_edit(place, "Rotation", "uv.rotation", [degrees](UvTransform& transform) {
        transform.rotation_degrees = degrees;
    });
}
Edit set_uv_transform(const SourcePlace& place, const UvTransform& transform) {
    return transform_edit(place, "UV transform", "uv",
                          [transform](UvTransform& target) { target = transform; });
}

}  // namespace patina
