// SPDX-License-Identifier: MIT
#include "scene/lathe.h"

#include <cassert>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace patina {
namespace {

constexpr float kPi = glm::pi<float>();
/// Arcs are split so that no segment turns by more.
constexpr float kArcStepDegrees = 3.75f;
/// cos of the angle between normals up to which two pieces join smoothly: 2 degrees.
constexpr float kSmoothCosine = 0.99939f;

glm::vec2 left_of(glm::vec2 direction) {
    return {-direction.y, direction.x};
}

/// The integral of ds / r along a segment of the profile: what the angle-preserving map grows by.
float conformal_length(glm::vec2 from, glm::vec2 to) {
    const float length = glm::distance(from, to);
    const float difference = to.x - from.x;
    if (std::abs(difference) < 1e-6f) return length / from.x;
    return length * std::log(to.x / from.x) / difference;
}

/// A sample of the whole profile with its place along the chart.
struct Row {
    ProfileSample sample;
    float along = 0.0f;      ///< the integral of ds / r from the reference; infinite on the axis
    bool joins_next = true;  ///< the surface goes on to the next row
};

std::vector<Row> rows_of(const Profile& profile) {
    std::vector<Row> rows;
    for (const auto& piece : profile.pieces()) {
        const bool smooth = !rows.empty() && glm::dot(rows.back().sample.normal,
                                                      piece.front().normal) > kSmoothCosine;
        if (!rows.empty()) rows.back().joins_next = smooth;
        for (std::size_t i = smooth ? 1 : 0; i < piece.size(); ++i)
            rows.push_back({.sample = piece[i]});
    }
    rows.back().joins_next = false;
    return rows;
}

/// Measures `along` from the first row that is off the axis.
void measure(std::vector<Row>& rows) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const auto on_axis = [](const Row& row) { return row.sample.point.x <= 0.0f; };
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const bool first_off_axis = on_axis(rows[i - 1]) && !on_axis(rows[i]);
        if (on_axis(rows[i]))
            rows[i].along = kInfinity;
        else if (!first_off_axis)
            rows[i].along = rows[i - 1].along +
                            conformal_length(rows[i - 1].sample.point, rows[i].sample.point);
    }
    if (on_axis(rows.front())) rows.front().along = -kInfinity;
}

/// One turn of the surface: position, normal, UV and tangent at an angle of a row.
class ChartMap {
  public:
    ChartMap(const LatheChart& chart, const std::vector<Row>& rows)
        : chart_(chart), first_(rows.front().along), last_(rows.back().along) {}

    glm::vec2 uv(const Row& row, float turn) const {
        const float angle = 2.0f * kPi * turn + kPi;
        switch (chart_.kind) {
            case LatheChart::Kind::Strip:
                return {turn, chart_.top + (row.along - first_) / (2.0f * kPi)};
            case LatheChart::Kind::TopDisc:
                return chart_.center + chart_.radius * std::exp(row.along - last_) *
                                           glm::vec2(std::sin(angle), std::cos(angle));
            case LatheChart::Kind::BottomDisc:
                return chart_.center + chart_.radius * std::exp(first_ - row.along) *
                                           glm::vec2(std::sin(angle), -std::cos(angle));
        }
        return {};
    }

    /// The direction in which u grows; `along` and `around` are the unit directions of the surface
    /// down the profile and about the axis.
    glm::vec3 tangent(glm::vec3 along, glm::vec3 around, float turn) const {
        const float angle = 2.0f * kPi * turn + kPi;
        switch (chart_.kind) {
            case LatheChart::Kind::Strip:
                return around;
            case LatheChart::Kind::TopDisc:
                return around * std::cos(angle) + along * std::sin(angle);
            case LatheChart::Kind::BottomDisc:
                return around * std::cos(angle) - along * std::sin(angle);
        }
        return around;
    }

  private:
    const LatheChart& chart_;
    float first_;
    float last_;
};

void add_row(Primitive& primitive, const Row& row, const ChartMap& map, int segments) {
    const auto [point, normal] = row.sample;
    for (int i = 0; i <= segments; ++i) {
        const float turn = static_cast<float>(i) / static_cast<float>(segments);
        // The last column repeats the first to the bit, so that no crack shows at the seam.
        const float angle = i == segments ? kPi : 2.0f * kPi * turn + kPi;
        const glm::vec3 outward(std::sin(angle), 0.0f, std::cos(angle));
        const glm::vec3 around(std::cos(angle), 0.0f, -std::sin(angle));
        const glm::vec3 along = outward * normal.y - glm::vec3(0.0f, normal.x, 0.0f);
        primitive.positions.push_back(outward * point.x + glm::vec3(0.0f, point.y, 0.0f));
        primitive.normals.push_back(outward * normal.x + glm::vec3(0.0f, normal.y, 0.0f));
        primitive.tangents.emplace_back(glm::normalize(map.tangent(along, around, turn)), 1.0f);
        primitive.uvs[0].push_back(map.uv(row, turn));
    }
}

void add_quads(Primitive& primitive, std::uint32_t upper, std::uint32_t lower, int segments,
               bool upper_on_axis, bool lower_on_axis) {
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(segments); ++i) {
        if (!upper_on_axis)
            primitive.indices.insert(primitive.indices.end(),
                                     {upper + i, lower + i, upper + i + 1});
        if (!lower_on_axis)
            primitive.indices.insert(primitive.indices.end(),
                                     {upper + i + 1, lower + i, lower + i + 1});
    }
}

}  // namespace

void Profile::add(std::vector<ProfileSample> piece) {
    assert(pieces_.empty() || glm::distance(end(), piece.front().point) < 1e-4f);
    pieces_.push_back(std::move(piece));
}

Profile& Profile::line(glm::vec2 from, glm::vec2 to, int steps) {
    assert(steps >= 1);
    const glm::vec2 normal = left_of(glm::normalize(to - from));
    std::vector<ProfileSample> piece;
    for (int i = 0; i <= steps; ++i)
        piece.push_back(
            {glm::mix(from, to, static_cast<float>(i) / static_cast<float>(steps)), normal});
    add(std::move(piece));
    return *this;
}

Profile& Profile::arc(glm::vec2 center, float radius, float from_degrees, float to_degrees) {
    const float turn = to_degrees - from_degrees;
    const int steps = std::max(2, static_cast<int>(std::ceil(std::abs(turn) / kArcStepDegrees)));
    const float side = turn > 0.0f ? 1.0f : -1.0f;
    std::vector<ProfileSample> piece;
    for (int i = 0; i <= steps; ++i) {
        const float degrees =
            from_degrees + turn * static_cast<float>(i) / static_cast<float>(steps);
        const glm::vec2 direction(std::sin(glm::radians(degrees)), std::cos(glm::radians(degrees)));
        glm::vec2 point = center + radius * direction;
        // sin(180 degrees) is not quite 0 in floats: a pole lies on the axis.
        if (std::abs(point.x) < 1e-6f) point.x = 0.0f;
        piece.push_back({point, side * direction});
    }
    add(std::move(piece));
    return *this;
}

void add_lathe(Primitive& primitive, const Profile& profile, const LatheChart& chart,
               int segments) {
    assert(segments >= 3 && !profile.pieces().empty());
    std::vector<Row> rows = rows_of(profile);
    measure(rows);
    const ChartMap map(chart, rows);
    const auto on_axis = [](const Row& row) { return row.sample.point.x <= 0.0f; };
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto first = static_cast<std::uint32_t>(primitive.positions.size());
        add_row(primitive, rows[i], map, segments);
        if (rows[i].joins_next)
            add_quads(primitive, first, first + static_cast<std::uint32_t>(segments) + 1, segments,
                      on_axis(rows[i]), on_axis(rows[i + 1]));
    }
}

float strip_height(const Profile& profile) {
    std::vector<Row> rows = rows_of(profile);
    measure(rows);
    return (rows.back().along - rows.front().along) / (2.0f * kPi);
}

}  // namespace patina
