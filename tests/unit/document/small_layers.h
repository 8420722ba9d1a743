// SPDX-License-Identifier: MIT
#pragma once

/// Layers put together by hand.

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "document/layer_edits.h"

namespace patina {

inline LayerPtr shared(Layer layer) {
    return std::make_shared<const Layer>(std::move(layer));
}

/// A layer of values, of that name.
inline Layer named_layer(std::uint64_t id, std::string name) {
    Layer layer = value_layer();
    layer.id = {id};
    layer.name = std::move(name);
    return layer;
}

}  // namespace patina
