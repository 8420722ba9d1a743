// SPDX-License-Identifier: MIT
#pragma once

/// What the edit functions are made of: a document with one material or one layer changed, all
/// other nodes shared, and the old node kept where the change changed nothing.

#include <functional>

#include "document/document.h"
#include "document/stack_tree.h"

namespace patina {

using MaterialChange = std::function<Status(Material& copy)>;
Result<Document> with_material(const Document& before, MaterialId id, const MaterialChange& change);

/// Changes the stack of a material; `next_id` is the document's.
using StackChange =
    std::function<Result<LayerList>(const LayerList& stack, std::uint64_t& next_id)>;
Result<Document> with_stack(const Document& before, MaterialId id, const StackChange& change);

using LayerChange = std::function<Status(Layer& copy)>;
Result<Document> with_layer(const Document& before, MaterialId material, LayerId id, OwnLock lock,
                            const LayerChange& change);

/// Fails, naming the image, when a source reads an image that the document has not.
Status check_images(const Document& document, const Source& source);
/// The same for all that a layer reads, its mask and children included.
Status check_images(const Document& document, const Layer& layer);

}  // namespace patina
