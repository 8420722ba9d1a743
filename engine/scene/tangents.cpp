// SPDX-License-Identifier: MIT
#include "scene/tangents.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cfloat>
#include <cmath>
#include <deque>
#include <tuple>
#include <unordered_map>

#include "scene/normals.h"

namespace patina {
namespace {

constexpr int kNone = -1;

using Corner = std::size_t;  ///< 3 * face + 0, 1 or 2

struct Face {
    glm::vec3 along_u = glm::vec3(0.0f);  ///< unit direction in which u grows; 0 where unknown
    bool keeps_orientation = false;       ///< the UVs run the same way round as the corners
    bool without_area = true;             ///< in UV space: fits any neighbour
    bool degenerate = false;              ///< two corners at one place
    std::array<int, 3> neighbors = {kNone, kNone, kNone};  ///< across the edge from corner i to i+1
    std::array<int, 3> groups = {kNone, kNone, kNone};     ///< of each corner
};

/// The corners around one vertex that share a tangent.
struct Group {
    std::uint32_t point = 0;
    bool keeps_orientation = false;
    glm::vec3 weighted_sum = glm::vec3(0.0f);
};

/// Equal position, normal and UV make one point, whatever the file's indices say.
struct PointKey {
    std::array<std::uint32_t, 8> bits;
    bool operator==(const PointKey&) const = default;
};

struct PointKeyHash {
    std::size_t operator()(const PointKey& key) const {
        std::uint64_t hash = 0x9E3779B97F4A7C15u;
        for (const std::uint32_t word : key.bits) {
            hash = (hash ^ word) * 0xD6E8FEB86659FD93u;
            hash ^= hash >> 32;
        }
        return hash;
    }
};

std::uint32_t float_bits(float value) {
    return std::bit_cast<std::uint32_t>(value == 0.0f ? 0.0f : value);  // -0 is 0
}

glm::vec3 unit_or_zero(const glm::vec3& vector) {
    const float length = glm::length(vector);
    return length > FLT_MIN ? vector / length : glm::vec3(0.0f);
}

glm::vec3 projected(const glm::vec3& vector, const glm::vec3& normal) {
    return unit_or_zero(vector - normal * glm::dot(normal, vector));
}

std::size_t next_corner(std::size_t corner) {
    return corner == 2 ? 0 : corner + 1;
}
std::size_t previous_corner(std::size_t corner) {
    return corner == 0 ? 2 : corner - 1;
}

class TangentBuilder {
  public:
    TangentBuilder(Primitive& primitive, int uv_set)
        : primitive_(primitive),
          uvs_(primitive.uvs[static_cast<std::size_t>(uv_set)]),
          faces_(primitive.indices.size() / 3) {}

    void run() {
        weld_points();
        for (std::size_t face = 0; face < faces_.size(); ++face) measure_face(face);
        connect_faces();
        for (std::size_t face = 0; face < faces_.size(); ++face)
            for (std::size_t corner = 0; corner < 3; ++corner) start_group(face, corner);
        for (std::size_t face = 0; face < faces_.size(); ++face) add_to_groups(face);
        write_tangents();
    }

  private:
    std::uint32_t vertex(std::size_t face, std::size_t corner) const {
        return primitive_.indices[3 * face + corner];
    }
    std::uint32_t point(std::size_t face, std::size_t corner) const {
        return points_[vertex(face, corner)];
    }
    const glm::vec3& position(std::size_t face, std::size_t corner) const {
        return primitive_.positions[vertex(face, corner)];
    }

    void weld_points() {
        std::unordered_map<PointKey, std::uint32_t, PointKeyHash> known;
        known.reserve(primitive_.positions.size());
        points_.resize(primitive_.positions.size());
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const glm::vec3& p = primitive_.positions[i];
            const glm::vec3& n = primitive_.normals[i];
            const PointKey key = {{float_bits(p.x), float_bits(p.y), float_bits(p.z),
                                   float_bits(n.x), float_bits(n.y), float_bits(n.z),
                                   float_bits(uvs_[i].x), float_bits(uvs_[i].y)}};
            points_[i] = known.try_emplace(key, static_cast<std::uint32_t>(i)).first->second;
        }
    }

    void measure_face(std::size_t index) {
        Face& face = faces_[index];
        const glm::vec3 edge1 = position(index, 1) - position(index, 0);
        const glm::vec3 edge2 = position(index, 2) - position(index, 0);
        face.degenerate = edge1 == glm::vec3(0.0f) || edge2 == glm::vec3(0.0f) || edge1 == edge2;
        const glm::vec2 uv0 = uvs_[vertex(index, 0)];
        const glm::vec2 uv1 = uvs_[vertex(index, 1)] - uv0;
        const glm::vec2 uv2 = uvs_[vertex(index, 2)] - uv0;
        const float area = uv1.x * uv2.y - uv1.y * uv2.x;
        face.keeps_orientation = area > 0.0f;
        if (!(std::abs(area) > FLT_MIN)) return;
        const glm::vec3 along_u = unit_or_zero(uv2.y * edge1 - uv1.y * edge2);
        const glm::vec3 along_v = unit_or_zero(uv1.x * edge2 - uv2.x * edge1);
        face.along_u = face.keeps_orientation ? along_u : -along_u;
        face.without_area = along_u == glm::vec3(0.0f) || along_v == glm::vec3(0.0f);
    }

    /// Pairs faces that run along an edge in opposite directions, first come first served.
    void connect_faces() {
        struct Edge {
            std::uint32_t low;
            std::uint32_t high;
            bool ascending;
            Corner start;
        };
        std::vector<Edge> edges;
        edges.reserve(primitive_.indices.size());
        for (std::size_t face = 0; face < faces_.size(); ++face) {
            if (faces_[face].degenerate) continue;
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const std::uint32_t from = point(face, corner);
                const std::uint32_t to = point(face, next_corner(corner));
                edges.push_back(
                    {std::min(from, to), std::max(from, to), from < to, 3 * face + corner});
            }
        }
        std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
            return std::tie(a.low, a.high, a.start) < std::tie(b.low, b.high, b.start);
        });
        std::array<std::deque<Corner>, 2> waiting;  // by direction
        for (std::size_t i = 0; i < edges.size(); ++i) {
            if (i > 0 && (edges[i].low != edges[i - 1].low || edges[i].high != edges[i - 1].high))
                for (auto& queue : waiting) queue.clear();
            auto& opposite = waiting[edges[i].ascending ? 0 : 1];
            if (opposite.empty()) {
                waiting[edges[i].ascending ? 1 : 0].push_back(edges[i].start);
                continue;
            }
            const Corner other = opposite.front();
            opposite.pop_front();
            faces_[other / 3].neighbors[other % 3] = static_cast<int>(edges[i].start / 3);
            faces_[edges[i].start / 3].neighbors[edges[i].start % 3] = static_cast<int>(other / 3);
        }
    }

    void start_group(std::size_t index, std::size_t corner) {
        const Face& face = faces_[index];
        if (face.degenerate || face.without_area || face.groups[corner] != kNone) return;
        const int group = static_cast<int>(groups_.size());
        groups_.push_back({.point = point(index, corner),
                           .keeps_orientation = face.keeps_orientation,
                           .weighted_sum = glm::vec3(0.0f)});
        open_.assign(1, static_cast<int>(index));
        while (!open_.empty()) {
            const auto next = static_cast<std::size_t>(open_.back());
            open_.pop_back();
            join_group(next, group);
        }
    }

    /// Takes a face into a group if it may, and remembers the faces beside it at the point.
    void join_group(std::size_t index, int group_index) {
        const Group& group = groups_[static_cast<std::size_t>(group_index)];
        Face& face = faces_[index];
        std::size_t corner = 0;
        while (corner < 2 && point(index, corner) != group.point) ++corner;
        if (face.groups[corner] != kNone) return;
        const bool is_free = face.groups == std::array{kNone, kNone, kNone};
        if (face.without_area && is_free) face.keeps_orientation = group.keeps_orientation;
        if (face.keeps_orientation != group.keeps_orientation) return;
        face.groups[corner] = group_index;
        for (const std::size_t edge : {previous_corner(corner), corner})
            if (face.neighbors[edge] != kNone) open_.push_back(face.neighbors[edge]);
    }

    /// Adds the face's direction to the groups of its corners, weighted by the angle there.
    void add_to_groups(std::size_t index) {
        const Face& face = faces_[index];
        if (face.without_area) return;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            if (face.groups[corner] == kNone) continue;
            const glm::vec3& normal = primitive_.normals[vertex(index, corner)];
            const glm::vec3& here = position(index, corner);
            const glm::vec3 before =
                projected(position(index, previous_corner(corner)) - here, normal);
            const glm::vec3 after = projected(position(index, next_corner(corner)) - here, normal);
            const float angle = std::acos(std::clamp(glm::dot(before, after), -1.0f, 1.0f));
            groups_[static_cast<std::size_t>(face.groups[corner])].weighted_sum +=
                angle * projected(face.along_u, normal);
        }
    }

    glm::vec4 tangent_of(const Group& group, const glm::vec3& normal) const {
        const glm::vec3 sum = unit_or_zero(group.weighted_sum);
        const glm::vec3 direction = sum == glm::vec3(0.0f) ? any_perpendicular(normal) : sum;
        // v runs down in glTF, where MikkTSpace has it run up.
        return glm::vec4(direction, group.keeps_orientation ? -1.0f : 1.0f);
    }

    /// The group that corners without one of their own take: that of their point, if any.
    std::vector<int> groups_by_point() const {
        std::vector<int> by_point(points_.size(), kNone);
        for (std::size_t i = groups_.size(); i-- > 0;)
            by_point[groups_[i].point] = static_cast<int>(i);
        return by_point;
    }

    void write_tangents() {
        const std::vector<int> by_point = groups_by_point();
        std::vector<int> group_of_vertex(points_.size(), kNone);
        std::unordered_map<std::uint64_t, std::uint32_t> copies;
        primitive_.tangents.assign(points_.size(), glm::vec4(0.0f));
        for (std::size_t face = 0; face < faces_.size(); ++face) {
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const int own = faces_[face].groups[corner];
                const int group = own != kNone ? own : by_point[point(face, corner)];
                if (group == kNone) continue;
                std::uint32_t& index = primitive_.indices[3 * face + corner];
                int& holder = group_of_vertex[index];
                if (holder != kNone && holder != group) {
                    const std::uint64_t key =
                        std::uint64_t{index} << 32 | static_cast<unsigned>(group);
                    const auto [copy, is_new] = copies.try_emplace(key, 0u);
                    if (is_new) copy->second = append_copy(index);
                    index = copy->second;
                } else {
                    holder = group;
                }
                primitive_.tangents[index] =
                    tangent_of(groups_[static_cast<std::size_t>(group)], primitive_.normals[index]);
            }
        }
        for (std::size_t i = 0; i < primitive_.tangents.size(); ++i)
            if (primitive_.tangents[i].w == 0.0f)
                primitive_.tangents[i] = glm::vec4(any_perpendicular(primitive_.normals[i]), 1.0f);
    }

    std::uint32_t append_copy(std::uint32_t vertex) {
        const auto copy = [&](auto& values) {
            if (values.empty()) return;
            const auto value = values[vertex];  // push_back may move what it would copy
            values.push_back(value);
        };
        copy(primitive_.positions);
        copy(primitive_.normals);
        copy(primitive_.tangents);
        copy(primitive_.colors);
        for (auto& uvs : primitive_.uvs) copy(uvs);
        return static_cast<std::uint32_t>(primitive_.positions.size() - 1);
    }

    Primitive& primitive_;
    std::vector<glm::vec2>& uvs_;
    std::vector<std::uint32_t> points_;  ///< by vertex: the first vertex that is equal
    std::vector<Face> faces_;
    std::vector<Group> groups_;
    std::vector<int> open_;  ///< faces still to be asked to join a group
};

}  // namespace

void generate_tangents(Primitive& primitive, int uv_set) {
    assert(primitive.normals.size() == primitive.positions.size());
    assert(primitive.uvs[static_cast<std::size_t>(uv_set)].size() == primitive.positions.size());
    TangentBuilder(primitive, uv_set).run();
}

}  // namespace patina
