// SPDX-License-Identifier: MIT
#include "scene/uv_surface.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "scene/uv_density.h"
#include "scene/uv_map.h"

namespace patina {
namespace {

/// A thumbnail's, a preview's and the full one's.
constexpr std::size_t kMapsKept = 3;

using Weights = std::array<double, 3>;

/// How much of each corner is at (u, v); negative outside.
Weights weights_at(const UvCorners& corners, double u, double v) {
    const auto du = [&](std::size_t k) { return static_cast<double>(corners[k].x) - u; };
    const auto dv = [&](std::size_t k) { return static_cast<double>(corners[k].y) - v; };
    const auto area = [&](std::size_t a, std::size_t b) { return du(a) * dv(b) - du(b) * dv(a); };
    const Weights parts = {area(1, 2), area(2, 0), area(0, 1)};
    const double whole = parts[0] + parts[1] + parts[2];
    if (whole == 0.0) return {1.0, 0.0, 0.0};
    return {parts[0] / whole, parts[1] / whole, parts[2] / whole};
}

double least(const Weights& weights) {
    return std::min({weights[0], weights[1], weights[2]});
}

/// Those of the tile in which the place lies inside the triangle, or least far outside.
Weights weights_in_best_tile(const UvCorners& corners, double u, double v) {
    const auto tiles = [&](int axis, double at) {
        const auto [low, high] =
            std::minmax({corners[0][axis], corners[1][axis], corners[2][axis]});
        const double reach = static_cast<double>(std::min(high, low + kMostUvTiles));
        return std::pair(std::floor(static_cast<double>(low) - at), std::ceil(reach - at));
    };
    const auto [first_u, last_u] = tiles(0, u);
    const auto [first_v, last_v] = tiles(1, v);
    Weights best = weights_at(corners, u, v);
    for (double j = first_v; j <= last_v && least(best) < 0.0; ++j)
        for (double i = first_u; i <= last_u && least(best) < 0.0; ++i)
            if (const Weights here = weights_at(corners, u + i, v + j); least(here) > least(best))
                best = here;
    return best;
}

/// A place within the triangle: none of the corners counts less than nothing.
Weights held_inside(Weights weights) {
    double sum = 0.0;
    for (double& weight : weights) sum += weight = std::max(weight, 0.0);
    for (double& weight : weights) weight /= sum;
    return weights;
}

glm::vec3 mixed(const std::array<glm::vec3, 3>& values, const Weights& weights) {
    glm::dvec3 sum(0.0);
    for (std::size_t k = 0; k < 3; ++k) sum += weights[k] * glm::dvec3(values[k]);
    return glm::vec3(sum);
}

/// `v` at unit length; `otherwise` where it has none.
glm::vec3 unit_or(const glm::vec3& v, const glm::vec3& otherwise) {
    const float squared = glm::dot(v, v);
    return squared > 1e-20f ? v / std::sqrt(squared) : otherwise;
}

/// Some direction at right angles to a unit one.
glm::vec3 across(const glm::vec3& normal) {
    const glm::vec3 other =
        std::abs(normal.y) < 0.9f ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::vec3(1.0f, 0.0f, 0.0f);
    return unit_or(glm::cross(other, normal), glm::vec3(1.0f, 0.0f, 0.0f));
}

template <typename T>
void add_all(Hasher& hasher, const std::vector<T>& values) {
    hasher.add_bytes(std::as_bytes(std::span(values)));
}

}  // namespace

/// Takes a part to model space.
struct UvSurface::Frames {
    glm::mat4 model_from_local;
    glm::mat3 normal_from_local;
    float handedness;  ///< -1 where the part is mirrored
};

UvSurface::~UvSurface() = default;

UvSurface::UvSurface(ScenePtr scene, std::vector<SurfacePart> parts, int uv_set)
    : scene_(std::move(scene)), parts_(std::move(parts)), uv_set_(uv_set) {
    const Bounds& bounds = scene_->bounds_world;
    const glm::vec3 sides = bounds.empty() ? glm::vec3(1.0f) : bounds.high - bounds.low;
    const float longest = std::max({sides.x, sides.y, sides.z});
    const float scale = longest > 1e-30f && longest < 1e30f ? 1.0f / longest : 1.0f;
    const glm::vec3 center = bounds.empty() ? glm::vec3(0.0f) : bounds.center();
    Hasher hasher;
    hasher.add(uv_set_).add(scale).add(center.x).add(center.y).add(center.z);
    for (const SurfacePart& part : parts_) {
        const Primitive& primitive = *part.primitive;
        first_triangles_.push_back(first_triangles_.back() +
                                   static_cast<std::uint32_t>(primitive.indices.size() / 3));
        glm::mat4 model_from_local = part.world_from_local;
        model_from_local[3] -= glm::vec4(center, 0.0f);
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 3; ++row) model_from_local[column][row] *= scale;
        model_from_local[3] += glm::vec4(glm::vec3(0.5f), 0.0f);
        const glm::mat3 turn(part.world_from_local);
        const float determinant = glm::determinant(turn);
        frames_.push_back({.model_from_local = model_from_local,
                           .normal_from_local = determinant != 0.0f
                                                    ? glm::transpose(glm::inverse(turn))
                                                    : glm::mat3(1.0f),
                           .handedness = determinant < 0.0f ? -1.0f : 1.0f});
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row) hasher.add(part.world_from_local[column][row]);
        add_all(hasher, primitive.positions);
        add_all(hasher, primitive.normals);
        add_all(hasher, primitive.tangents);
        add_all(hasher, primitive.uvs[static_cast<std::size_t>(uv_set_)]);
        add_all(hasher, primitive.indices);
    }
    hash_ = hasher.finish();
    measure();
}

void UvSurface::measure() {
    UvAreas areas;
    for (std::size_t part = 0; part < parts_.size(); ++part)
        areas += uv_areas(*parts_[part].primitive, frames_[part].model_from_local, uv_set_);
    has_uvs_ = areas.has_uvs;
    length_per_uv_ = areas.length_per_uv(1.0f);
}

std::size_t UvSurface::part_of(std::uint32_t triangle) const {
    const auto after = std::upper_bound(first_triangles_.begin(), first_triangles_.end(), triangle);
    return static_cast<std::size_t>(after - first_triangles_.begin()) - 1;
}

const std::uint32_t* UvSurface::indices_of(std::uint32_t triangle, std::size_t& part) const {
    part = part_of(triangle);
    return parts_[part].primitive->indices.data() +
           std::size_t{3} * (triangle - first_triangles_[part]);
}

std::optional<UvCorners> UvSurface::corners_of(std::uint32_t triangle) const {
    std::size_t part = 0;
    const std::uint32_t* const indices = indices_of(triangle, part);
    const auto& uvs = parts_[part].primitive->uvs[static_cast<std::size_t>(uv_set_)];
    if (uvs.empty()) return std::nullopt;
    const UvCorners corners = {uvs[indices[0]], uvs[indices[1]], uvs[indices[2]]};
    if (!has_texels(corners)) return std::nullopt;
    return corners;
}

SurfacePoint UvSurface::point_at(std::uint32_t triangle, double u, double v) const {
    std::size_t part = 0;
    const std::uint32_t* const indices = indices_of(triangle, part);
    const Primitive& primitive = *parts_[part].primitive;
    const Frames& frames = frames_[part];
    const UvCorners corners = *corners_of(triangle);
    const Weights weights = held_inside(weights_in_best_tile(corners, u, v));
    std::array<glm::vec3, 3> places, normals, tangents;
    for (std::size_t k = 0; k < 3; ++k)
        places[k] =
            glm::vec3(frames.model_from_local * glm::vec4(primitive.positions[indices[k]], 1.0f));
    const glm::vec3 face =
        frames.handedness * unit_or(glm::cross(places[1] - places[0], places[2] - places[0]),
                                    glm::vec3(0.0f, 0.0f, 1.0f));
    SurfacePoint point{.position = mixed(places, weights), .normal = face};
    if (!primitive.normals.empty()) {
        for (std::size_t k = 0; k < 3; ++k)
            normals[k] = unit_or(frames.normal_from_local * primitive.normals[indices[k]], face);
        point.normal = unit_or(mixed(normals, weights), face);
    }
    float turn = 1.0f;
    if (!primitive.tangents.empty()) {
        for (std::size_t k = 0; k < 3; ++k)
            tangents[k] = unit_or(
                glm::mat3(frames.model_from_local) * glm::vec3(primitive.tangents[indices[k]]),
                glm::vec3(0.0f));
        point.tangent = mixed(tangents, weights);
        turn = primitive.tangents[indices[0]].w * frames.handedness;
    } else {
        // The way in which u grows over the triangle.
        const glm::vec2 a = corners[1] - corners[0], b = corners[2] - corners[0];
        const float area = a.x * b.y - a.y * b.x;
        point.tangent = ((places[1] - places[0]) * b.y - (places[2] - places[0]) * a.y) *
                        (area < 0.0f ? -1.0f : 1.0f);
        // v runs down: what turns as u to v does lies mirrored as seen from the front.
        turn = area < 0.0f ? 1.0f : -1.0f;
        turn *= frames.handedness;
    }
    point.tangent -= glm::dot(point.tangent, point.normal) * point.normal;
    point.tangent = unit_or(point.tangent, across(point.normal));
    point.bitangent = (turn < 0.0f ? -1.0f : 1.0f) * glm::cross(point.normal, point.tangent);
    return point;
}

UvMapPtr UvSurface::map(int size) const {
    // What was asked for last is kept longest.
    const auto find = [&]() -> UvMapPtr {
        const auto found = std::find_if(maps_.begin(), maps_.end(),
                                        [&](const UvMapPtr& made) { return made->size() == size; });
        if (found == maps_.end()) return nullptr;
        std::rotate(found, found + 1, maps_.end());
        return maps_.back();
    };
    {
        const std::lock_guard lock(mutex_);
        if (sizes_without_map_.contains(size)) return nullptr;
        if (UvMapPtr made = find()) return made;
    }
    // Not under the lock: a thread that waits for its parallel loops may come to ask here again.
    UvMapPtr made = UvMap::make(*this, size);
    const std::lock_guard lock(mutex_);
    if (made == nullptr) {
        sizes_without_map_.insert(size);
        return nullptr;
    }
    if (UvMapPtr other = find()) return other;
    if (maps_.size() == kMapsKept) maps_.erase(maps_.begin());
    maps_.push_back(made);
    return made;
}

}  // namespace patina
