// SPDX-License-Identifier: MIT
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "io/gltf_read.h"

namespace patina::io::gltf {
namespace {

constexpr float kPi = 3.14159265f;

SceneCamera read_camera(const JsonPlace& place) {
    SceneCamera camera;
    camera.name = place.text("name");
    if (place.text("type") == "orthographic") {
        const float half_height = place.object("orthographic").number("ymag", 1.0f);
        camera.orthographic_height = half_height == 0.0f ? 2.0f : 2.0f * std::abs(half_height);
    } else {
        const float fov_y = place.object("perspective").number("yfov", camera.fov_y_radians);
        if (fov_y > 0.0f && fov_y < kPi) camera.fov_y_radians = fov_y;
    }
    return camera;
}

Light read_light(const JsonPlace& place) {
    Light light;
    light.name = place.text("name");
    const std::string type = place.text("type");
    if (type == "point")
        light.kind = Light::Kind::Point;
    else if (type == "spot")
        light.kind = Light::Kind::Spot;
    else if (type != "directional")
        place.fault("type", "is not directional, point or spot");
    place.numbers("color", std::span(&light.color_linear.x, 3));
    light.color_linear = glm::clamp(light.color_linear, 0.0f, 1.0f);
    light.intensity = std::max(0.0f, place.number("intensity", 1.0f));
    light.range = std::max(0.0f, place.number("range", 0.0f));
    const JsonPlace spot = place.object("spot");
    const float outer = spot.number("outerConeAngle", light.outer_cone_radians);
    light.outer_cone_radians = std::clamp(outer, 1e-3f, kPi / 2.0f);
    light.inner_cone_radians =
        std::clamp(spot.number("innerConeAngle", 0.0f), 0.0f, light.outer_cone_radians);
    return light;
}

glm::mat4 read_transform(const JsonPlace& place) {
    if (place.has("matrix")) {
        glm::mat4 matrix(1.0f);
        place.numbers("matrix", std::span(&matrix[0][0], 16));
        return matrix;
    }
    glm::vec3 translation(0.0f);
    glm::vec3 scale(1.0f);
    glm::vec4 rotation(0.0f, 0.0f, 0.0f, 1.0f);
    place.numbers("translation", std::span(&translation.x, 3));
    place.numbers("rotation", std::span(&rotation.x, 4));
    place.numbers("scale", std::span(&scale.x, 3));
    const float length = glm::length(rotation);
    // A quaternion of zeros turns nothing.
    rotation = length > 0.0f && std::isfinite(length) ? rotation / length : glm::vec4(0, 0, 0, 1);
    const glm::quat turn(rotation.w, rotation.x, rotation.y, rotation.z);
    return glm::scale(glm::translate(glm::mat4(1.0f), translation) * glm::mat4_cast(turn), scale);
}

Node read_node(const JsonPlace& place, std::size_t nodes, const Model& model) {
    Node node;
    node.name = place.text("name");
    node.children = place.indices("children", nodes);
    node.mesh = place.index("mesh", model.meshes.size());
    node.skin = place.index("skin", model.skins.size());
    node.camera = place.index("camera", model.cameras.size());
    node.light = place.object("extensions")
                     .object("KHR_lights_punctual")
                     .index("light", model.lights.size());
    node.parent_from_local = read_transform(place);
    node.weights = place.numbers("weights");
    return node;
}

/// Each node has one parent at most. Gives the parents, -1 for roots; nothing after a fault.
std::optional<std::vector<int>> check_parents(const JsonPlace& root, const Model& model) {
    std::vector<int> parents(model.nodes.size(), -1);
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        for (const int child : model.nodes[i].children) {
            int& parent = parents[static_cast<std::size_t>(child)];
            if (parent >= 0) {
                root.fault("nodes", fmt::format("node {} is a child of both node {} and node {}",
                                                child, parent, i));
                return std::nullopt;
            }
            parent = static_cast<int>(i);
        }
    }
    return parents;
}

/// With one parent each, what cannot be reached from a root is a cycle.
void check_trees(const JsonPlace& root, const Model& model, const std::vector<int>& parents,
                 int depth_limit) {
    std::vector<int> level;
    for (std::size_t i = 0; i < parents.size(); ++i)
        if (parents[i] < 0) level.push_back(static_cast<int>(i));
    std::size_t reached = 0;
    for (int depth = 1; !level.empty(); ++depth) {
        if (depth > depth_limit)
            return root.fault("nodes",
                              fmt::format("are nested deeper than {} levels", depth_limit));
        reached += level.size();
        std::vector<int> next;
        for (const int index : level) {
            const auto& children = model.nodes[static_cast<std::size_t>(index)].children;
            next.insert(next.end(), children.begin(), children.end());
        }
        level = std::move(next);
    }
    if (reached != model.nodes.size()) root.fault("nodes", "are their own ancestors (a cycle)");
}

void read_scenes(const JsonPlace& root, Model& model, const std::vector<int>& parents) {
    std::vector<std::size_t> listed_in(model.nodes.size(), 0);  // number of the scene, from 1
    for (const JsonPlace& place : root.objects("scenes")) {
        SceneRoots scene;
        scene.name = place.text("name");
        scene.nodes = place.indices("nodes", model.nodes.size());
        for (const int node : scene.nodes) {
            const auto index = static_cast<std::size_t>(node);
            if (parents[index] >= 0)
                place.fault("nodes", fmt::format("lists node {}, which is a child of node {}", node,
                                                 parents[index]));
            if (listed_in[index] == model.scenes.size() + 1)
                place.fault("nodes", fmt::format("lists node {} twice", node));
            listed_in[index] = model.scenes.size() + 1;
        }
        scene.record = place.record_text();
        model.scenes.push_back(std::move(scene));
    }
    model.scene = root.index("scene", model.scenes.size());
    if (model.scene < 0 && !model.scenes.empty()) model.scene = 0;
}

}  // namespace

void read_cameras_and_lights(const JsonPlace& root, Model& model) {
    for (const JsonPlace& place : root.objects("cameras"))
        model.cameras.push_back(read_camera(place));
    const JsonPlace extension = root.object("extensions").object("KHR_lights_punctual");
    for (const JsonPlace& place : extension.objects("lights"))
        model.lights.push_back(read_light(place));
}

void read_nodes(const JsonPlace& root, Model& model, const ModelLimits& limits) {
    const std::size_t count = root.array_size("nodes");
    if (count > static_cast<std::size_t>(limits.nodes))
        return root.fault("nodes",
                          fmt::format("are {}, more than the limit of {}", count, limits.nodes));
    for (const JsonPlace& place : root.objects("nodes"))
        model.nodes.push_back(read_node(place, count, model));
    const auto parents = check_parents(root, model);
    if (!parents) return;
    check_trees(root, model, *parents, limits.node_depth);
    read_scenes(root, model, *parents);
}

}  // namespace patina::io::gltf
