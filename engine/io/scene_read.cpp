// SPDX-License-Identifier: MIT
#include "io/scene_read.h"

#include <cmath>

#include "io/scene_values.h"

namespace patina::io {
namespace {

using tinygltf::Model;
using tinygltf::Node;

const Node& node_at(const Model& model, int index) {
    return model.nodes[static_cast<std::size_t>(index)];
}

bool is_finite(const glm::mat4& matrix) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(matrix[column][row])) return false;
    return true;
}

struct WorldTransforms {
    std::vector<int> order;                   ///< nodes of the scene, parents first
    std::vector<glm::mat4> world_from_local;  ///< of every node of the file
};

/// Joints may lie outside the scene, so every node gets its place.
Result<WorldTransforms> place_nodes(const Model& model) {
    WorldTransforms placed;
    placed.world_from_local.assign(model.nodes.size(), glm::mat4(1.0f));
    std::vector<bool> is_child(model.nodes.size(), false);
    for (const Node& node : model.nodes)
        for (const int child : node.children) is_child[static_cast<std::size_t>(child)] = true;
    std::vector<int> open;
    for (std::size_t i = model.nodes.size(); i-- > 0;)
        if (!is_child[i]) open.push_back(static_cast<int>(i));
    for (const int root : open)
        placed.world_from_local[static_cast<std::size_t>(root)] =
            parent_from_local(node_at(model, root));
    while (!open.empty()) {
        const int index = open.back();
        open.pop_back();
        const glm::mat4& world = placed.world_from_local[static_cast<std::size_t>(index)];
        if (!is_finite(world))
            return failure("/nodes/{}: its transforms multiply to infinity", index);
        for (const int child : node_at(model, index).children) {
            placed.world_from_local[static_cast<std::size_t>(child)] =
                world * parent_from_local(node_at(model, child));
            open.push_back(child);
        }
    }
    return placed;
}

/// Nodes of the shown scene in depth-first order, as they are listed.
std::vector<int> nodes_of_scene(const Model& model) {
    std::vector<int> order;
    if (model.defaultScene < 0) {
        // Without a scene there is nothing to choose by: everything is shown.
        for (std::size_t i = 0; i < model.nodes.size(); ++i) order.push_back(static_cast<int>(i));
        return order;
    }
    const auto& roots = model.scenes[static_cast<std::size_t>(model.defaultScene)].nodes;
    std::vector<int> open(roots.rbegin(), roots.rend());
    while (!open.empty()) {
        const int index = open.back();
        open.pop_back();
        order.push_back(index);
        const auto& children = node_at(model, index).children;
        open.insert(open.end(), children.rbegin(), children.rend());
    }
    return order;
}

class SceneReader {
  public:
    SceneReader(const GltfData& data, WorldTransforms placed, std::uint64_t geometry_bytes,
                std::vector<std::string>& warnings)
        : data_(data),
          placed_(std::move(placed)),
          budget_(geometry_bytes),
          warnings_(warnings),
          mesh_of_source_(data.model.meshes.size(), -1) {}

    Result<Scene> read(const Progress& progress) {
        for (std::size_t i = 0; i < placed_.order.size(); ++i) {
            if (progress.cancelled()) return failure("cancelled");
            if (const auto status = read_node(placed_.order[i]); !status) return passed_on(status);
        }
        if (data_.model.nodes.empty())
            if (const auto status = show_all_meshes(); !status) return passed_on(status);
        include_instances();
        return std::move(scene_);
    }

  private:
    Status read_node(int index) {
        const Node& node = node_at(data_.model, index);
        const glm::mat4& world = placed_.world_from_local[static_cast<std::size_t>(index)];
        if (node.camera >= 0) add_camera(node, world);
        add_light(node, world);
        if (node.mesh < 0) return {};
        if (node.skin >= 0 || !node.weights.empty()) return add_posed_instance(node, world);
        return add_plain_instance(node, world);
    }

    Status show_all_meshes() {
        Node node;
        for (std::size_t i = 0; i < data_.model.meshes.size(); ++i) {
            node.mesh = static_cast<int>(i);
            if (const auto status = add_plain_instance(node, glm::mat4(1.0f)); !status)
                return status;
        }
        return {};
    }

    void add_camera(const Node& node, const glm::mat4& world) {
        SceneCamera camera = camera_of(data_.model.cameras[static_cast<std::size_t>(node.camera)]);
        camera.world_from_camera = world;
        if (camera.name.empty()) camera.name = node.name;
        scene_.cameras.push_back(std::move(camera));
    }

    /// A light shines along -z of its node.
    void add_light(const Node& node, const glm::mat4& world) {
        const int index = index_in(extension_of(node.extensions, "KHR_lights_punctual"), "light");
        if (index < 0) return;
        Light light = light_of(data_.model.lights[static_cast<std::size_t>(index)]);
        light.position_world = glm::vec3(world[3]);
        const glm::vec3 direction = -glm::vec3(world[2]);
        const float length = glm::length(direction);
        if (length > 0.0f && std::isfinite(length)) light.direction_world = direction / length;
        if (light.name.empty()) light.name = node.name;
        scene_.lights.push_back(std::move(light));
    }

    Status add_plain_instance(const Node& node, const glm::mat4& world) {
        int& mesh = mesh_of_source_[static_cast<std::size_t>(node.mesh)];
        if (mesh < 0) {
            const auto& source = data_.model.meshes[static_cast<std::size_t>(node.mesh)];
            const std::vector<float> weights = as_floats(source.weights);
            const auto added = add_mesh(node.mesh, {.morph_weights = weights, .joints_world = {}});
            if (!added) return passed_on(added);
            mesh = *added;
        }
        add_instance(mesh, node, world);
        return {};
    }

    Status add_posed_instance(const Node& node, const glm::mat4& world) {
        const auto& source = data_.model.meshes[static_cast<std::size_t>(node.mesh)];
        std::vector<glm::mat4> joints;
        if (node.skin >= 0) {
            auto matrices = joint_matrices(node.skin);
            if (!matrices) return passed_on(matrices);
            joints = std::move(*matrices);
        }
        const std::vector<float> weights =
            as_floats(node.weights.empty() ? source.weights : node.weights);
        const auto mesh = add_mesh(node.mesh, {.morph_weights = weights, .joints_world = joints});
        if (!mesh) return passed_on(mesh);
        // A skin places its mesh in the world; the node's own transform does not count.
        add_instance(*mesh, node, joints.empty() ? world : glm::mat4(1.0f));
        return {};
    }

    Result<std::vector<glm::mat4>> joint_matrices(int index) {
        const tinygltf::Skin& skin = data_.model.skins[static_cast<std::size_t>(index)];
        std::vector<glm::mat4> matrices;
        matrices.reserve(skin.joints.size());
        for (const int joint : skin.joints)
            matrices.push_back(placed_.world_from_local[static_cast<std::size_t>(joint)]);
        if (skin.inverseBindMatrices < 0) return matrices;
        std::size_t not_finite = 0;
        const auto inverse_bind = read_floats(data_, skin.inverseBindMatrices, not_finite);
        if (!inverse_bind) return passed_on(inverse_bind);
        for (std::size_t i = 0; i < matrices.size(); ++i) {
            glm::mat4 joint_from_mesh;
            std::copy_n(inverse_bind->begin() + static_cast<std::ptrdiff_t>(16 * i), 16,
                        &joint_from_mesh[0][0]);
            matrices[i] = matrices[i] * joint_from_mesh;
        }
        return matrices;
    }

    Result<int> add_mesh(int source, const MeshPose& pose) {
        auto mesh = read_mesh(data_, source, pose, budget_, warnings_);
        if (!mesh) return passed_on(mesh);
        scene_.meshes.push_back(std::move(*mesh));
        return static_cast<int>(scene_.meshes.size()) - 1;
    }

    void add_instance(int mesh, const Node& node, const glm::mat4& world) {
        const std::string& mesh_name = scene_.meshes[static_cast<std::size_t>(mesh)].name;
        scene_.instances.push_back({.mesh = mesh,
                                    .world_from_local = world,
                                    .name = node.name.empty() ? mesh_name : node.name});
    }

    void include_instances() {
        std::vector<Bounds> bounds_local(scene_.meshes.size());
        for (std::size_t i = 0; i < scene_.meshes.size(); ++i)
            for (const Primitive& primitive : scene_.meshes[i].primitives)
                for (const std::uint32_t index : primitive.indices)
                    bounds_local[i].include(primitive.positions[index]);
        for (const MeshInstance& instance : scene_.instances) {
            const Bounds& local = bounds_local[static_cast<std::size_t>(instance.mesh)];
            if (local.empty()) continue;
            for (int corner = 0; corner < 8; ++corner) {
                const glm::vec3 point((corner & 1) != 0 ? local.high.x : local.low.x,
                                      (corner & 2) != 0 ? local.high.y : local.low.y,
                                      (corner & 4) != 0 ? local.high.z : local.low.z);
                scene_.bounds_world.include(
                    glm::vec3(instance.world_from_local * glm::vec4(point, 1.0f)));
            }
        }
    }

    const GltfData& data_;
    WorldTransforms placed_;
    GeometryBudget budget_;
    std::vector<std::string>& warnings_;
    std::vector<int> mesh_of_source_;  ///< by mesh of the file: as it is without a pose of its own
    Scene scene_;
};

}  // namespace

Result<Scene> read_scene(const GltfData& data, std::uint64_t geometry_bytes,
                         std::vector<std::string>& warnings, const Progress& progress) {
    auto placed = place_nodes(data.model);
    if (!placed) return passed_on(placed);
    placed->order = nodes_of_scene(data.model);
    return SceneReader(data, std::move(*placed), geometry_bytes, warnings).read(progress);
}

}  // namespace patina::io
