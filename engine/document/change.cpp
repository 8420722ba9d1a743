// SPDX-License-Identifier: MIT
#include "document/change.h"

#include "document/references.h"

namespace patina {

Result<Document> with_material(const Document& before, MaterialId id,
                               const MaterialChange& change) {
    for (std::size_t i = 0; i < before.materials.size(); ++i) {
        const Material& old = *before.materials[i];
        if (old.id != id) continue;
        Material copy = old;
        if (Status status = change(copy); !status) return passed_on(status);
        if (copy.stack != old.stack)
            if (Status status = check_references(copy.stack); !status) return passed_on(status);
        Document after = before;
        if (copy != old) after.materials[i] = std::make_shared<const Material>(std::move(copy));
        return after;
    }
    return failure("there is no material {}", id.value);
}

Result<Document> with_stack(const Document& before, MaterialId id, const StackChange& change) {
    std::uint64_t next_id = before.next_id;
    Result<Document> after = with_material(before, id, [&](Material& copy) -> Status {
        Result<LayerList> stack = change(copy.stack, next_id);
        if (!stack) return passed_on(stack);
        copy.stack = std::move(*stack);
        return {};
    });
    if (after) after->next_id = next_id;
    return after;
}

Result<Document> with_layer(const Document& before, MaterialId material, LayerId id, OwnLock lock,
                            const LayerChange& change) {
    return with_material(before, material, [&](Material& copy) -> Status {
        const std::optional<LayerPath> path = path_of(copy.stack, id);
        if (!path)
            return failure("there is no layer {} in {}", id.value,
                           quoted_for_message(copy.name, 80));
        if (Status status = check_unlocked(copy.stack, *path, lock); !status) return status;

        const std::span<const std::size_t> whole = *path;
        const std::span<const std::size_t> parents = whole.first(whole.size() - 1);
        Layer changed = *layer_at(copy.stack, whole);
        if (Status status = change(changed); !status) return status;
        copy.stack = with_list_at(copy.stack, parents, [&](LayerList& list) {
            LayerPtr& layer = list[whole.back()];
            if (changed != *layer) layer = std::make_shared<const Layer>(std::move(changed));
        });
        return {};
    });
}

Status check_images(const Document& document, const Source& source) {
    const auto* image = std::get_if<ImageSource>(&source);
    if (!image || document.images.contains(image->image)) return {};
    return failure("the document has no image {}: add it first", to_hex(image->image));
}

Status check_images(const Document& document, const Layer& layer) {
    for (const ChannelSettings& settings : layer.channels)
        if (Status status = check_images(document, settings.source); !status) return status;
    for (const MaskEntry& entry : layer.mask.entries)
        if (Status status = check_images(document, entry.source); !status) return status;
    if (const auto* group = std::get_if<GroupContent>(&layer.content))
        for (const LayerPtr& child : group->children)
            if (Status status = check_images(document, *child); !status) return status;
    return {};
}

}  // namespace patina
