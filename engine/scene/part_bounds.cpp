// SPDX-License-Identifier: MIT
#include "scene/part_bounds.h"

namespace patina {

Bounds bounds_world_of(const Scene& scene, const std::set<PartRef>& parts) {
    Bounds bounds;
    for (const MeshInstance& instance : scene.instances)
        for (const Primitive& primitive :
             scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives) {
            if (!parts.contains(primitive.source)) continue;
            for (const std::uint32_t index : primitive.indices)
                bounds.include(glm::vec3(instance.world_from_local *
                                         glm::vec4(primitive.positions[index], 1.0f)));
        }
    return bounds;
}

}  // namespace patina
