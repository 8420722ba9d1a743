// SPDX-License-Identifier: MIT
#include "document/document.h"

namespace patina {
namespace {

LayerPtr find_in(const std::vector<LayerPtr>& layers, LayerId id) {
    for (const LayerPtr& layer : layers) {
        if (layer->id == id) return layer;
        if (const auto* group = std::get_if<GroupContent>(&layer->content))
            if (LayerPtr found = find_in(group->children, id)) return found;
    }
    return nullptr;
}

}  // namespace

MaterialPtr find_material(const Document& document, MaterialId id) {
    for (const MaterialPtr& material : document.materials)
        if (material->id == id) return material;
    return nullptr;
}

MaterialPtr material_of(const Document& document, int source_material) {
    for (const MaterialPtr& material : document.materials)
        if (material->source_material.value_or(-1) == source_material) return material;
    return nullptr;
}

LayerPtr find_layer(const Material& material, LayerId id) {
    return find_in(material.stack, id);
}

}  // namespace patina
