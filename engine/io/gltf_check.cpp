// SPDX-License-Identifier: MIT
#include "io/gltf_check.h"

namespace patina::io {

Result<CheckedGltf> check_gltf(const nlohmann::json& json, const ModelLimits& limits) {
    FirstFault fault;
    const JsonPlace root(json, "", fault);
    CheckedGltf checked;
    check_versions(root, checked);
    check_buffers(root, checked);
    check_accessors(root, checked);
    check_textures(root, checked);
    check_materials(root);
    check_meshes(root, checked);
    check_skins(root, checked);
    check_cameras_and_lights(root);
    check_nodes(root, limits);
    check_animations(root);
    if (const auto status = fault.status(); !status) return passed_on(status);
    return checked;
}

}  // namespace patina::io
