// SPDX-License-Identifier: MIT
#include "scene/normals.h"

#include <cmath>
#include <cstddef>

namespace patina {
namespace {

constexpr float kLeastLength = 1e-12f;
const glm::vec3 kUp(0.0f, 1.0f, 0.0f);

/// In double: the products of tiny triangles vanish in float.
glm::dvec3 area_normal(const Primitive& primitive, std::size_t first_corner) {
    const auto corner = [&](std::size_t i) {
        return glm::dvec3(primitive.positions[primitive.indices[first_corner + i]]);
    };
    return glm::cross(corner(1) - corner(0), corner(2) - corner(0));
}

glm::vec3 unit_or(const glm::dvec3& vector, const glm::vec3& fallback) {
    const double length = glm::length(vector);
    return length > 0.0 && std::isfinite(length) ? glm::vec3(vector / length) : fallback;
}

template <typename T>
void unshare(std::vector<T>& values, const std::vector<std::uint32_t>& indices) {
    if (values.empty()) return;
    std::vector<T> corners(indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i) corners[i] = values[indices[i]];
    values = std::move(corners);
}

}  // namespace

glm::vec3 any_perpendicular(const glm::vec3& normal) {
    const glm::vec3 axis =
        std::abs(normal.x) < 0.9f ? glm::vec3(1.0f, 0.0f, 0.0f) : glm::vec3(0.0f, 1.0f, 0.0f);
    return glm::normalize(axis - normal * glm::dot(normal, axis));
}

void make_flat_normals(Primitive& primitive) {
    unshare(primitive.positions, primitive.indices);
    unshare(primitive.colors, primitive.indices);
    for (auto& uvs : primitive.uvs) unshare(uvs, primitive.indices);
    for (std::size_t i = 0; i < primitive.indices.size(); ++i)
        primitive.indices[i] = static_cast<std::uint32_t>(i);
    primitive.normals.resize(primitive.indices.size());
    for (std::size_t i = 0; i < primitive.indices.size(); i += 3) {
        const glm::vec3 normal = unit_or(area_normal(primitive, i), kUp);
        for (std::size_t corner = 0; corner < 3; ++corner) primitive.normals[i + corner] = normal;
    }
}

void repair_normals(Primitive& primitive) {
    std::vector<std::size_t> broken;
    for (std::size_t i = 0; i < primitive.normals.size(); ++i) {
        const float length = glm::length(primitive.normals[i]);
        if (length > kLeastLength && std::isfinite(length))
            primitive.normals[i] /= length;
        else
            broken.push_back(i);
    }
    if (broken.empty()) return;
    std::vector<glm::dvec3> sums(primitive.normals.size(), glm::dvec3(0.0));
    for (std::size_t i = 0; i < primitive.indices.size(); i += 3)
        for (std::size_t corner = 0; corner < 3; ++corner)
            sums[primitive.indices[i + corner]] += area_normal(primitive, i);
    for (const std::size_t i : broken) primitive.normals[i] = unit_or(sums[i], kUp);
}

void repair_tangents(Primitive& primitive) {
    for (std::size_t i = 0; i < primitive.tangents.size(); ++i) {
        const glm::vec4 given = primitive.tangents[i];
        const float length = glm::length(glm::vec3(given));
        const bool usable = length > kLeastLength && std::isfinite(length);
        const glm::vec3 direction =
            usable ? glm::vec3(given) / length : any_perpendicular(primitive.normals[i]);
        primitive.tangents[i] = glm::vec4(direction, given.w < 0.0f ? -1.0f : 1.0f);
    }
}

}  // namespace patina
