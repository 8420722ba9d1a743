// SPDX-License-Identifier: MIT
#include <array>
#include <optional>

#include "io/gltf_check.h"

namespace patina::io {
namespace {

using Children = std::vector<std::vector<int>>;  // by node

void check_camera(const JsonPlace& place) {
    place.text("name");
    if (place.text("type") == "orthographic")
        place.object("orthographic").number("ymag", 1.0f);
    else
        place.object("perspective").number("yfov", 1.0f);
}

void check_light(const JsonPlace& place) {
    place.text("name");
    const std::string type = place.text("type");
    if (type != "directional" && type != "point" && type != "spot")
        place.fault("type", "is not directional, point or spot");
    std::array<float, 3> color{};
    place.numbers("color", color);
    place.number("intensity", 1.0f);
    place.number("range", 0.0f);
    const JsonPlace spot = place.object("spot");
    spot.number("outerConeAngle", 0.0f);
    spot.number("innerConeAngle", 0.0f);
}

void check_transform(const JsonPlace& place) {
    std::array<float, 16> numbers{};
    const std::span<float> all(numbers);
    place.numbers("matrix", all);
    place.numbers("translation", all.first(3));
    place.numbers("rotation", all.first(4));
    place.numbers("scale", all.first(3));
}

struct Counts {
    std::size_t nodes;
    std::size_t meshes;
    std::size_t skins;
    std::size_t cameras;
    std::size_t lights;
};

/// @return the node's children
std::vector<int> check_node(const JsonPlace& place, const Counts& counts) {
    place.text("name");
    place.index("mesh", counts.meshes);
    place.index("skin", counts.skins);
    place.index("camera", counts.cameras);
    place.object("extensions").object("KHR_lights_punctual").index("light", counts.lights);
    check_transform(place);
    place.numbers("weights");
    return place.indices("children", counts.nodes);
}

/// Each node has one parent at most. Gives the parents, -1 for roots; nothing after a fault.
std::optional<std::vector<int>> check_parents(const JsonPlace& root, const Children& children) {
    std::vector<int> parents(children.size(), -1);
    for (std::size_t i = 0; i < children.size(); ++i) {
        for (const int child : children[i]) {
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
void check_trees(const JsonPlace& root, const Children& children, const std::vector<int>& parents,
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
            const auto& below = children[static_cast<std::size_t>(index)];
            next.insert(next.end(), below.begin(), below.end());
        }
        level = std::move(next);
    }
    if (reached != children.size()) root.fault("nodes", "are their own ancestors (a cycle)");
}

void check_scenes(const JsonPlace& root, const std::vector<int>& parents) {
    std::vector<std::size_t> listed_in(parents.size(), 0);  // number of the scene, from 1
    std::size_t number = 0;
    for (const JsonPlace& place : root.objects("scenes")) {
        ++number;
        place.text("name");
        for (const int node : place.indices("nodes", parents.size())) {
            const auto index = static_cast<std::size_t>(node);
            if (parents[index] >= 0)
                place.fault("nodes", fmt::format("lists node {}, which is a child of node {}", node,
                                                 parents[index]));
            if (listed_in[index] == number)
                place.fault("nodes", fmt::format("lists node {} twice", node));
            listed_in[index] = number;
        }
    }
    root.index("scene", number);
}

}  // namespace

void check_cameras_and_lights(const JsonPlace& root) {
    for (const JsonPlace& place : root.objects("cameras")) check_camera(place);
    const JsonPlace extension = root.object("extensions").object("KHR_lights_punctual");
    for (const JsonPlace& place : extension.objects("lights")) check_light(place);
}

void check_nodes(const JsonPlace& root, const ModelLimits& limits) {
    const Counts counts = {
        .nodes = root.array_size("nodes"),
        .meshes = root.array_size("meshes"),
        .skins = root.array_size("skins"),
        .cameras = root.array_size("cameras"),
        .lights = root.object("extensions").object("KHR_lights_punctual").array_size("lights")};
    if (counts.nodes > static_cast<std::size_t>(limits.nodes))
        return root.fault(
            "nodes", fmt::format("are {}, more than the limit of {}", counts.nodes, limits.nodes));
    Children children;
    for (const JsonPlace& place : root.objects("nodes"))
        children.push_back(check_node(place, counts));
    const auto parents = check_parents(root, children);
    if (!parents) return;
    check_trees(root, children, *parents, limits.node_depth);
    check_scenes(root, *parents);
}

}  // namespace patina::io
