// SPDX-License-Identifier: MIT
#include "io/gltf_model.h"

#include <nlohmann/json.hpp>

#include "io/gltf_read.h"

namespace patina::io::gltf {

std::size_t component_bytes(ComponentType type) {
    switch (type) {
        case ComponentType::I8:
        case ComponentType::U8:
            return 1;
        case ComponentType::I16:
        case ComponentType::U16:
            return 2;
        case ComponentType::U32:
        case ComponentType::F32:
            return 4;
    }
    return 4;
}

std::size_t Accessor::column_bytes() const {
    const std::size_t bytes = component_bytes(type) * static_cast<std::size_t>(rows);
    return columns == 1 ? bytes : (bytes + 3) / 4 * 4;
}

Result<Model> read_gltf_model(const nlohmann::json& json, const ModelLimits& limits) {
    FirstFault fault;
    const JsonPlace root(json, "", fault);
    Model model;
    check_versions(root, model);
    read_buffers(root, model);
    read_accessors(root, model);
    read_textures(root, model);
    read_materials(root, model);
    read_meshes(root, model);
    read_skins(root, model);
    read_cameras_and_lights(root, model);
    read_nodes(root, model, limits);
    check_animations(root);
    if (const auto status = fault.status(); !status) return passed_on(status);
    return model;
}

}  // namespace patina::io::gltf
