// SPDX-License-Identifier: MIT
#pragma once

/// Edits of a layer's mask. See edits.h for what holds for all edits; an entry's source is edited
/// through source_edits.h.

#include <string>

#include "document/edit.h"
#include "document/parameters.h"

namespace patina {

/// The most entries of one mask.
inline constexpr int kMaxMaskEntries = 64;

Edit set_mask_enabled(const Material& material, const Layer& layer, bool enabled);
Edit set_mask_invert(const Material& material, const Layer& layer, bool invert);
/// 0 to 1: what the mask is before its first entry.
Edit set_mask_base(const Material& material, const Layer& layer, float base);
/// Takes all entries away: the layer covers everything again.
Edit clear_mask(const Material& material, const Layer& layer);

/// What an entry is called that nobody has named: the kind of its source.
std::string kind_name(const Source& source);
/// The same of an entry: of its source or its adjustment.
std::string kind_name(const MaskEntry& entry);

/// New entries for add_mask_entry, named for what they are.
MaskEntry value_mask_entry();
MaskEntry image_mask_entry(const ImageAsset& image);
MaskEntry procedural_mask_entry(ProceduralKind kind);
MaskEntry relief_mask_entry(ReliefKind kind);
/// Of one part of the model.
MaskEntry geometry_mask_entry(const std::string& part);
/// Of what the entries before it make; of a kind that adjusts_masks.
MaskEntry adjustment_mask_entry(AdjustmentKind kind);

/// The id that the next mask entry added to `document` gets.
MaskEntryId next_mask_entry_id(const Document& document);

/// Adds a copy of `entry` with a fresh id after the entries that are there.
Edit add_mask_entry(const Material& material, const Layer& layer, const MaskEntry& entry);
Edit remove_mask_entry(const Material& material, const Layer& layer, const MaskEntry& entry);
/// Adds a copy with a fresh id right after it.
Edit duplicate_mask_entry(const Material& material, const Layer& layer, const MaskEntry& entry);
/// Moves an entry to `index` in the list as it is without that entry; 0 is the first one taken.
Edit move_mask_entry(const Material& material, const Layer& layer, const MaskEntry& entry,
                     int index);

Edit rename_mask_entry(const Material& material, const Layer& layer, const MaskEntry& entry,
                       std::string name);
Edit set_mask_entry_visible(const Material& material, const Layer& layer, const MaskEntry& entry,
                            bool visible);
Edit set_mask_entry_combine(const Material& material, const Layer& layer, const MaskEntry& entry,
                            BlendMode combine);
/// 0 to 1.
Edit set_mask_entry_opacity(const Material& material, const Layer& layer, const MaskEntry& entry,
                            float opacity);
Edit set_mask_entry_invert(const Material& material, const Layer& layer, const MaskEntry& entry,
                           bool invert);
/// Levels: in and out 0 to 1, in_low at most in_high (equal: a threshold), gamma 0.1 to 10. One
/// drag of any of the five is one step.
Edit set_mask_entry_levels(const Material& material, const Layer& layer, const MaskEntry& entry,
                           const Levels& levels);
/// Of an entry that is an adjustment. `parameter`: what is changed, which names the step; drags of
/// one merge, of what is no choice.
Edit set_mask_entry_adjustment(const Material& material, const Layer& layer, const MaskEntry& entry,
                               const AdjustmentSettings& adjustment, Parameter parameter);

}  // namespace patina
