// SPDX-License-Identifier: MIT
#pragma once

/// Triangle meshes ready to draw: values without files or GL. Points, lines and strips of the file
/// have become triangles or are left out (with a warning) by the importer.

#include <array>
#include <compare>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace patina {

/// Where a primitive stands in the glTF file: one part of the model, however many nodes show it.
struct PartRef {
    int mesh = -1;       ///< index in the file, -1: from no file
    int primitive = -1;  ///< index within that mesh
    auto operator<=>(const PartRef&) const = default;
};

/// One triangle list with one material. All filled attribute arrays are `positions.size()` long;
/// an empty one is absent.
struct Primitive {
    std::vector<glm::vec3> positions;           ///< metres, local space
    std::vector<glm::vec3> normals;             ///< unit, local space; never empty once loaded
    std::vector<glm::vec4> tangents;            ///< xyz unit, local; bitangent = w * cross(n, t)
    std::array<std::vector<glm::vec2>, 2> uvs;  ///< TEXCOORD_0 and _1, v down
    std::vector<glm::vec4> colors;              ///< COLOR_0, linear, multiplies base colour
    std::vector<std::uint32_t> indices;  ///< three a triangle, counter-clockwise is the front
    int source_material = -1;            ///< index in the glTF file, -1 for none
    PartRef source;
};

struct Mesh {
    std::string name;
    std::vector<Primitive> primitives;
};

/// An axis-aligned box; empty while `low.x > high.x`.
struct Bounds {
    glm::vec3 low = glm::vec3(1e30f);
    glm::vec3 high = glm::vec3(-1e30f);

    bool empty() const { return low.x > high.x; }
    void include(const glm::vec3& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    glm::vec3 center() const { return 0.5f * (low + high); }
    /// Half the diagonal: the radius of the ball around the box.
    float radius() const { return empty() ? 0.0f : 0.5f * glm::length(high - low); }
};

}  // namespace patina
