// SPDX-License-Identifier: MIT
#include "document/mask_edits.h"

#include <algorithm>

#include "document/change.h"
#include "document/check.h"

namespace patina {
namespace {

using MaskChange = std::function<Status(Mask& copy, std::uint64_t& next_id)>;

Edit mask_edit(const Material& material, const Layer& layer, std::string label, MergeKey merge_key,
               MaskChange change) {
    return {.label = std::move(label),
            .merge_key = std::move(merge_key),
            .apply = [material_id = material.id, layer_id = layer.id,
                      change = std::move(change)](const Document& before) {
                std::uint64_t next_id = before.next_id;
                Result<Document> after = with_layer(
                    before, material_id, layer_id, OwnLock::Respected, [&](Layer& copy) -> Status {
                        if (Status status = change(copy.mask, next_id); !status) return status;
                        return check_mask(copy.mask);
                    });
                if (after) after->next_id = next_id;
                return after;
            }};
}

/// A change to the list of entries at the place of one of them.
using EntryChange = std::function<Status(std::vector<MaskEntry>& entries, std::size_t index,
                                         std::uint64_t& next_id)>;

Edit entry_list_edit(const Material& material, const Layer& layer, const MaskEntry& entry,
                     std::string label, MergeKey merge_key, EntryChange change) {
    return mask_edit(
        material, layer, std::move(label), std::move(merge_key),
        [id = entry.id, change = std::move(change)](Mask& mask, std::uint64_t& next_id) -> Status {
            for (std::size_t i = 0; i < mask.entries.size(); ++i)
                if (mask.entries[i].id == id) return change(mask.entries, i, next_id);
            return failure("there is no mask entry {} any more", id.value);
        });
}

/// One member of one entry.
template <typename Value>
Edit entry_edit(const Material& material, const Layer& layer, const MaskEntry& entry,
                std::string_view what, MergeKey merge_key, Value MaskEntry::*member, Value value) {
    return entry_list_edit(material, layer, entry,
                           fmt::format("{} of mask entry {}", what, entry.name),
                           std::move(merge_key),
                           [member, value](std::vector<MaskEntry>& entries, std::size_t index,
                                           std::uint64_t&) -> Status {
                               entries[index].*member = value;
                               return {};
                           });
}

MaskEntry entry_of(Source source) {
    MaskEntry entry;
    entry.name = kind_name(source);
    entry.source = std::move(source);
    return entry;
}

struct KindName {
    std::string_view operator()(const ConstantSource&) const { return "Value"; }
    std::string_view operator()(const ImageSource&) const { return "Image"; }
    std::string_view operator()(const ProceduralSource& source) const {
        return choice(source.kind).label;
    }
    std::string_view operator()(const ReliefSource& source) const {
        return choice(source.kind).label;
    }
    std::string_view operator()(const ReferenceSource&) const { return "Layer"; }
    std::string_view operator()(const GeometrySource&) const { return "Parts"; }
};

}  // namespace

Edit set_mask_enabled(const Material& material, const Layer& layer, bool enabled) {
    return mask_edit(material, layer,
                     fmt::format("Mask {} of {}", enabled ? "on" : "off", layer.name), {},
                     [enabled](Mask& mask, std::uint64_t&) -> Status {
                         mask.enabled = enabled;
                         return {};
                     });
}

Edit set_mask_invert(const Material& material, const Layer& layer, bool invert) {
    return mask_edit(material, layer, "Invert mask of " + layer.name, {},
                     [invert](Mask& mask, std::uint64_t&) -> Status {
                         mask.invert = invert;
                         return {};
                     });
}

Edit set_mask_base(const Material& material, const Layer& layer, float base) {
    return mask_edit(material, layer, "Mask base of " + layer.name, {"mask.base", layer.id.value},
                     [base](Mask& mask, std::uint64_t&) -> Status {
                         mask.base = base;
                         return {};
                     });
}

Edit clear_mask(const Material& material, const Layer& layer) {
    return mask_edit(material, layer, "Clear mask of " + layer.name, {},
                     [](Mask& mask, std::uint64_t&) -> Status {
                         mask = Mask{};
                         return {};
                     });
}

std::string kind_name(const Source& source) {
    return std::string(std::visit(KindName(), source));
}

std::string kind_name(const MaskEntry& entry) {
    if (entry.adjustment) return std::string(choice(entry.adjustment->kind).label);
    return kind_name(entry.source);
}

MaskEntry value_mask_entry() {
    return entry_of(ConstantSource{{1.0f, 0.0f, 0.0f}});
}

MaskEntry image_mask_entry(const ImageAsset& image) {
    ImageSource source;
    source.image = image.hash;
    MaskEntry entry = entry_of(source);
    if (check_name(image.name)) entry.name = image.name;
    return entry;
}

MaskEntry procedural_mask_entry(ProceduralKind kind) {
    ProceduralSource source;
    source.kind = kind;
    return entry_of(source);
}

MaskEntry relief_mask_entry(ReliefKind kind) {
    return entry_of(ReliefSource{.kind = kind});
}

MaskEntry geometry_mask_entry(const std::string& part) {
    MaskEntry entry = entry_of(GeometrySource{.meshes = {part}});
    entry.name = part;
    return entry;
}

MaskEntry adjustment_mask_entry(AdjustmentKind kind) {
    MaskEntry entry;
    entry.name = choice(kind).label;
    entry.adjustment = AdjustmentSettings{.kind = kind};
    entry.combine = BlendMode::Replace;
    return entry;
}

MaskEntryId next_mask_entry_id(const Document& document) {
    return MaskEntryId{document.next_id};
}

Edit add_mask_entry(const Material& material, const Layer& layer, const MaskEntry& entry) {
    Edit edit = mask_edit(material, layer, "Add mask entry " + entry.name, {},
                          [entry](Mask& mask, std::uint64_t& next_id) -> Status {
                              mask.entries.push_back(entry);
                              mask.entries.back().id = MaskEntryId{next_id++};
                              return {};
                          });
    edit.apply = [entry, add = std::move(edit.apply)](const Document& before) -> Result<Document> {
        if (Status status = check_images(before, entry.source); !status) return passed_on(status);
        return add(before);
    };
    return edit;
}

Edit remove_mask_entry(const Material& material, const Layer& layer, const MaskEntry& entry) {
    return entry_list_edit(
        material, layer, entry, "Delete mask entry " + entry.name, {},
        [](std::vector<MaskEntry>& entries, std::size_t index, std::uint64_t&) -> Status {
            entries.erase(entries.begin() + static_cast<std::ptrdiff_t>(index));
            return {};
        });
}

Edit duplicate_mask_entry(const Material& material, const Layer& layer, const MaskEntry& entry) {
    return entry_list_edit(
        material, layer, entry, "Duplicate mask entry " + entry.name, {},
        [](std::vector<MaskEntry>& entries, std::size_t index, std::uint64_t& next_id) -> Status {
            MaskEntry copy = entries[index];
            copy.id = MaskEntryId{next_id++};
            entries.insert(entries.begin() + static_cast<std::ptrdiff_t>(index) + 1,
                           std::move(copy));
            return {};
        });
}

Edit move_mask_entry(const Material& material, const Layer& layer, const MaskEntry& entry,
                     int index) {
    return entry_list_edit(
        material, layer, entry, "Move mask entry " + entry.name, {},
        [index](std::vector<MaskEntry>& entries, std::size_t from, std::uint64_t&) -> Status {
            if (index < 0 || static_cast<std::size_t>(index) >= entries.size())
                return failure("the mask has no place {}: it has {} entries", index,
                               entries.size());
            MaskEntry moved = std::move(entries[from]);
            entries.erase(entries.begin() + static_cast<std::ptrdiff_t>(from));
            entries.insert(entries.begin() + index, std::move(moved));
            return {};
        });
}

Edit rename_mask_entry(const Material& material, const Layer& layer, const MaskEntry& entry,
                       std::string name) {
    Edit edit = entry_edit(material, layer, entry, "Name", {}, &MaskEntry::name, name);
    edit.label = "Rename mask entry to " + name;
    return edit;
}

Edit set_mask_entry_visible(const Material& material, const Layer& layer, const MaskEntry& entry,
                            bool visible) {
    Edit edit = entry_edit(material, layer, entry, "", {}, &MaskEntry::visible, visible);
    edit.label = fmt::format("{} mask entry {}", visible ? "Show" : "Hide", entry.name);
    return edit;
}

Edit set_mask_entry_combine(const Material& material, const Layer& layer, const MaskEntry& entry,
                            BlendMode combine) {
    return entry_edit(material, layer, entry, info(Parameter::MaskEntryCombine).label, {},
                      &MaskEntry::combine, combine);
}

Edit set_mask_entry_opacity(const Material& material, const Layer& layer, const MaskEntry& entry,
                            float opacity) {
    return entry_edit(material, layer, entry, "Opacity", {"mask-entry.opacity", entry.id.value},
                      &MaskEntry::opacity, opacity);
}

Edit set_mask_entry_invert(const Material& material, const Layer& layer, const MaskEntry& entry,
                           bool invert) {
    Edit edit = entry_edit(material, layer, entry, "", {}, &MaskEntry::invert, invert);
    edit.label = "Invert mask entry " + entry.name;
    return edit;
}

Edit set_mask_entry_levels(const Material& material, const Layer& layer, const MaskEntry& entry,
                           const Levels& levels) {
    return entry_edit(material, layer, entry, "Levels", {"mask-entry.levels", entry.id.value},
                      &MaskEntry::levels, levels);
}

Edit set_mask_entry_adjustment(const Material& material, const Layer& layer, const MaskEntry& entry,
                               const AdjustmentSettings& adjustment, Parameter parameter) {
    const ParameterInfo& row = info(parameter);
    const bool merges = row.kind != ParameterKind::Choice;
    return entry_list_edit(
        material, layer, entry, fmt::format("{} of mask entry {}", row.label, entry.name),
        merges ? MergeKey{fmt::format("mask-entry.{}", row.id), entry.id.value} : MergeKey{},
        [adjustment](std::vector<MaskEntry>& entries, std::size_t index, std::uint64_t&) -> Status {
            MaskEntry& changed = entries[index];
            if (!changed.adjustment)
                return failure("mask entry {} is not an adjustment",
                               quoted_for_message(changed.name, 80));
            changed.adjustment = adjustment;
            return {};
        });
}

}  // namespace patina
