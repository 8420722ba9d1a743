// SPDX-License-Identifier: MIT
#pragma once

/// What makes the values of a document valid. Edits and readers of files both ask here, so that no
/// document can be made that could not be read back. Messages say what is wrong with which number;
/// the caller says where.

#include <optional>
#include <string_view>

#include "core/result.h"
#include "document/layer.h"
#include "document/parameters.h"

namespace patina {

/// The channel that a source feeds; unset for the source of a mask entry.
using SourceUse = std::optional<Channel>;

/// Whether values for that use are one number (kept in x) or a colour; else they are normals.
bool feeds_number(SourceUse use);
bool feeds_color(SourceUse use);

/// Whether a source for that use may read that of a layer: normals are read by normals, and all
/// else by all else.
bool reads_result(SourceUse use, LayerResult result);

/// 1 to kMaxNameBytes bytes of UTF-8 without control characters.
Status check_name(std::string_view name);

/// Each component in the parameter's range.
Status check_color(Parameter parameter, const glm::vec3& value);

/// A constant or the value of a ramp's stop.
Status check_value(SourceUse use, const glm::vec3& value);
/// The value as it is kept: single numbers in x alone, normals of unit length.
glm::vec3 canonical_value(SourceUse use, const glm::vec3& value);

Status check_ramp(SourceUse use, const std::vector<RampStop>& stops);
Status check_transform(const UvTransform& transform);
Status check_projection(const Projection& projection);
Status check_source(SourceUse use, const Source& source);
Status check_levels(const Levels& levels);
Status check_adjustment(const AdjustmentSettings& adjustment);
Status check_height_blend(const HeightBlend& blend);
Status check_mask(const Mask& mask);
/// Whether a mask can have the adjustment that an entry is, if it is one, with what is beside it.
Status check_mask_adjustment(const MaskEntry& entry);
/// The layer and all its children, ids apart. The failure names the layer.
Status check_layer(const Layer& layer);
Status check_light(const Light& light);

}  // namespace patina
