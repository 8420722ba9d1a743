// SPDX-License-Identifier: MIT
#pragma once

/// Edits of a source, be it of a layer's channel or of a mask entry. See edits.h for what holds for
/// all edits. An edit of a kind of source that is not there (the octaves of an image) is refused.

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "document/edit.h"
#include "document/parameters.h"

namespace patina {

/// Where a source is, with the words for it in labels.
struct SourcePlace {
    MaterialId material;
    LayerId layer;
    std::variant<Channel, MaskEntryId> part;
    std::string name;  ///< "base colour of Tarnish", "mask entry Drips"
};
SourcePlace source_place(const Material& material, const Layer& layer, Channel channel);
SourcePlace source_place(const Material& material, const Layer& layer, const MaskEntry& entry);

/// The source there, or null when the layer or the entry is gone.
const Source* find_source(const Material& material, const SourcePlace& place);

/// The same edit of several sources in one step; a drag of all is one step as a drag of one is.
/// @param places  one or more; the label names the first
Edit at_all(const std::vector<SourcePlace>& places,
            const std::function<Edit(const SourcePlace&)>& edit);

/// Puts a whole source there, such as one of another kind. An image has to be in the document.
Edit set_source(const SourcePlace& place, Source source);

/// Colours and emissive: each component 0 to 1, linear; metalness, roughness, occlusion, opacity
/// and masks: x, 0 to 1; height: x, -1 to 1; normal: -1 to 1 each and not zero (kept as a unit
/// vector).
Edit set_constant(const SourcePlace& place, const glm::vec3& value);

Edit set_procedural_kind(const SourcePlace& place, ProceduralKind kind);
Edit set_procedural_seed(const SourcePlace& place, std::uint32_t seed);
Edit set_procedural_scale(const SourcePlace& place, float scale);
Edit set_procedural_octaves(const SourcePlace& place, int octaves);
Edit set_procedural_contrast(const SourcePlace& place, float contrast);
Edit set_procedural_balance(const SourcePlace& place, float balance);
Edit set_procedural_width(const SourcePlace& place, float width);
Edit set_procedural_softness(const SourcePlace& place, float softness);
Edit set_procedural_variation(const SourcePlace& place, float variation);
Edit set_procedural_aspect(const SourcePlace& place, float aspect);
Edit set_procedural_warp(const SourcePlace& place, float warp);
/// All stops at once: 1 to kMaxRampStops, positions 0 to 1 and ascending, values as in
/// set_constant.
Edit set_ramp(const SourcePlace& place, std::vector<RampStop> stops);
/// Moves or recolours one stop; its position has to stay between its neighbours'.
Edit set_ramp_stop(const SourcePlace& place, int index, const RampStop& stop);

/// `parameter`: what is being changed, for the label; drags of one parameter merge.
Edit set_relief(const SourcePlace& place, const ReliefSource& relief, Parameter parameter);

/// All that it picks, at once.
Edit set_geometry(const SourcePlace& place, const GeometrySource& geometry, Parameter parameter);

Edit set_image(const SourcePlace& place, const ImageAssetPtr& image);  ///< in the document already
Edit set_image_color_space(const SourcePlace& place, ColorSpace space);
Edit set_image_pick(const SourcePlace& place, ChannelPick pick);
Edit set_image_invert(const SourcePlace& place, bool invert);
Edit set_image_directx_normal(const SourcePlace& place, bool directx_normal);
Edit set_image_alpha_is_coverage(const SourcePlace& place, bool alpha_is_coverage);
Edit set_image_uv_set(const SourcePlace& place, int uv_set);  ///< 0 or 1
Edit set_image_wrap(const SourcePlace& place, Wrap wrap_u, Wrap wrap_v);
Edit set_image_filter(const SourcePlace& place, Filter filter);
/// value = decoded * multiply + add; each component -1000 to 1000.
Edit set_image_range(const SourcePlace& place, const glm::vec3& multiply, const glm::vec3& add);

/// Of an image or a procedural.
Edit set_projection(const SourcePlace& place, const Projection& projection, Parameter parameter);
/// Of an image or a procedural. Scale may be negative (mirrored) but not zero.
Edit set_uv_offset(const SourcePlace& place, const glm::vec2& offset);
Edit set_uv_scale(const SourcePlace& place, const glm::vec2& scale);
Edit set_uv_rotation(const SourcePlace& place, float degrees);
/// All of it at once, as a handle in the viewport or "Reset" does.
Edit set_uv_transform(const SourcePlace& place, const UvTransform& transform);

}  // namespace patina
