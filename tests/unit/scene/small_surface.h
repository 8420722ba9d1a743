// SPDX-License-Identifier: MIT
#pragma once

/// Surfaces of a few triangles.

#include <memory>
#include <vector>

#include "scene/uv_surface.h"

namespace patina {

/// Corners three by three, with a place and a UV each.
struct FlatPart {
    std::string name = {};
    std::vector<glm::vec3> places = {};
    std::vector<glm::vec2> uvs = {};
    std::string material = {};
    glm::mat4 world_from_local = glm::mat4(1.0f);
};

inline UvSurfacePtr surface_of(const std::vector<FlatPart>& parts, int uv_set = 0) {
    auto scene = std::make_shared<Scene>();
    scene->meshes.emplace_back();
    for (const FlatPart& part : parts) {
        Primitive primitive;
        primitive.positions = part.places;
        primitive.positions.resize(part.uvs.size());
        primitive.uvs[0] = part.uvs;
        for (std::uint32_t i = 0; i < part.uvs.size(); ++i) primitive.indices.push_back(i);
        scene->meshes[0].primitives.push_back(std::move(primitive));
        for (const glm::vec3& place : scene->meshes[0].primitives.back().positions)
            scene->bounds_world.include(glm::vec3(part.world_from_local * glm::vec4(place, 1.0f)));
    }
    std::vector<SurfacePart> worn;
    for (std::size_t i = 0; i < parts.size(); ++i)
        worn.push_back({.primitive = &scene->meshes[0].primitives[i],
                        .world_from_local = parts[i].world_from_local,
                        .names = {parts[i].name},
                        .material = parts[i].material});
    return std::make_shared<const UvSurface>(scene, std::move(worn), uv_set);
}

/// Two triangles, turning as x turns to y.
inline std::vector<glm::vec2> uv_quad(const glm::vec2& low, const glm::vec2& high) {
    return {low, {high.x, low.y}, high, low, high, {low.x, high.y}};
}

/// A quad that faces the viewer in front, from `low` to `high` at depth z, with the UVs of its
/// picture upright: v runs down.
inline FlatPart front_quad(const glm::vec2& low, const glm::vec2& high, float z,
                           const glm::vec2& uv_low, const glm::vec2& uv_high) {
    const auto corner = [&](float x, float y) { return glm::vec3(x, y, z); };
    return {.places = {corner(low.x, low.y), corner(high.x, low.y), corner(high.x, high.y),
                       corner(low.x, low.y), corner(high.x, high.y), corner(low.x, high.y)},
            .uvs = {{uv_low.x, uv_high.y},
                    {uv_high.x, uv_high.y},
                    {uv_high.x, uv_low.y},
                    {uv_low.x, uv_high.y},
                    {uv_high.x, uv_low.y},
                    {uv_low.x, uv_low.y}}};
}

}  // namespace patina
