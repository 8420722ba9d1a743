// SPDX-License-Identifier: MIT
#include "scene/shapes.h"

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/lathe.h"

namespace patina {
namespace {

/// Between charts, so that a 256 map keeps two texels of room.
constexpr float kChartGap = 0.01f;
/// The UV radius of a disc whose rim is as dense as a strip that starts there.
constexpr float kDiscRadius = 1.0f / (2.0f * glm::pi<float>());

/// The point at an angle from the top of a circle about the origin.
glm::vec2 on_circle(float radius, float degrees) {
    return radius * glm::vec2(std::sin(glm::radians(degrees)), std::cos(glm::radians(degrees)));
}

/// A ball's surface with steps cut into it: walls stand square on the ball, their outer edges are
/// rounded, their inner ones sharp.
class BallProfile {
  public:
    BallProfile(float radius, float edge_radius)
        : radius_(radius),
          edge_radius_(edge_radius),
          edge_degrees_(glm::degrees(std::asin(edge_radius / (radius - edge_radius)))) {}

    /// From the depth of `inner_radius` out to the surface.
    BallProfile& step_out(float degrees, float inner_radius) {
        profile_.line(on_circle(inner_radius, degrees), edge_start(degrees));
        profile_.arc(on_circle(radius_ - edge_radius_, degrees + edge_degrees_), edge_radius_,
                     degrees - 90.0f, degrees + edge_degrees_);
        at_degrees_ = degrees + edge_degrees_;
        return *this;
    }
    /// Along the surface to `degrees` and in to the depth of `inner_radius`.
    BallProfile& step_in(float degrees, float inner_radius) {
        surface(degrees - edge_degrees_);
        profile_.arc(on_circle(radius_ - edge_radius_, degrees - edge_degrees_), edge_radius_,
                     degrees - edge_degrees_, degrees + 90.0f);
        profile_.line(edge_start(degrees), on_circle(inner_radius, degrees));
        at_degrees_ = degrees;
        return *this;
    }
    /// Along a sunk floor.
    BallProfile& floor(float inner_radius, float to_degrees) {
        profile_.arc({0.0f, 0.0f}, inner_radius, at_degrees_, to_degrees);
        at_degrees_ = to_degrees;
        return *this;
    }
    /// Along the surface.
    BallProfile& surface(float to_degrees) {
        profile_.arc({0.0f, 0.0f}, radius_, at_degrees_, to_degrees);
        at_degrees_ = to_degrees;
        return *this;
    }
    const Profile& profile() const { return profile_; }

  private:
    /// Where a wall ends and the rounding of its edge begins.
    glm::vec2 edge_start(float degrees) const {
        const float height = (radius_ - edge_radius_) * std::cos(glm::radians(edge_degrees_));
        return on_circle(height, degrees);
    }

    float radius_;
    float edge_radius_;
    float edge_degrees_;  ///< the angle at the ball's middle that a rounding takes
    float at_degrees_ = 0.0f;
    Profile profile_;
};

void transform(Primitive& primitive, const glm::mat4& to_from_local) {
    const glm::mat3 rotation(to_from_local);  // rigid: directions turn as points do
    for (glm::vec3& position : primitive.positions)
        position = glm::vec3(to_from_local * glm::vec4(position, 1.0f));
    for (glm::vec3& normal : primitive.normals) normal = glm::normalize(rotation * normal);
    for (glm::vec4& tangent : primitive.tangents)
        tangent = glm::vec4(glm::normalize(rotation * glm::vec3(tangent)), tangent.w);
}

void append(Primitive& primitive, const Primitive& other) {
    const auto offset = static_cast<std::uint32_t>(primitive.positions.size());
    const auto extend = [](auto& to, const auto& from) {
        to.insert(to.end(), from.begin(), from.end());
    };
    extend(primitive.positions, other.positions);
    extend(primitive.normals, other.normals);
    extend(primitive.tangents, other.tangents);
    extend(primitive.uvs[0], other.uvs[0]);
    for (const std::uint32_t index : other.indices) primitive.indices.push_back(offset + index);
}

constexpr float kBallRadius = 0.5f;
constexpr float kBallHeight = 0.85f;  ///< of its middle

/// The ball leans, so that its dimple and gap face whoever stands before it.
glm::mat4 stand_from_ball() {
    const auto lifted = glm::translate(glm::mat4(1.0f), {0.0f, kBallHeight, 0.0f});
    const auto turned = glm::rotate(lifted, glm::radians(-18.0f), {0.0f, 1.0f, 0.0f});
    return glm::rotate(turned, glm::radians(26.0f), {1.0f, 0.0f, 0.0f});
}

/// From the top: a dimple, the cap, a gap down to the core, the body with a groove below its
/// middle. The bottom rests in the cup of the stand.
Primitive shader_ball_ball() {
    constexpr float kEdge = 0.012f;
    constexpr float kSunk = 0.475f;
    constexpr float kBelowCore = 0.41f;
    constexpr float kBodyEnd = 150.0f;
    const auto cap = BallProfile(kBallRadius, kEdge)
                         .floor(kSunk, 12.0f)
                         .step_out(12.0f, kSunk)
                         .step_in(46.0f, kBelowCore);
    const auto body = BallProfile(kBallRadius, kEdge)
                          .step_out(57.0f, kBelowCore)
                          .step_in(98.0f, kSunk)
                          .floor(kSunk, 102.0f)
                          .step_out(102.0f, kSunk)
                          .surface(kBodyEnd);
    Profile bottom;
    bottom.arc({0.0f, 0.0f}, kBallRadius, kBodyEnd, 180.0f);

    constexpr float kCapRadius = 0.21f;
    constexpr float kBottomRadius = 0.09f;  // hidden in the cup
    Primitive ball;
    add_lathe(ball, body.profile(), {.kind = LatheChart::Kind::Strip, .top = kChartGap});
    const float discs_top = kChartGap + strip_height(body.profile()) + kChartGap;
    add_lathe(ball, cap.profile(),
              {.kind = LatheChart::Kind::TopDisc,
               .center = glm::vec2(kChartGap + kCapRadius, discs_top + kCapRadius),
               .radius = kCapRadius});
    add_lathe(ball, bottom,
              {.kind = LatheChart::Kind::BottomDisc,
               .center = glm::vec2(3.0f * kChartGap + 2.0f * kCapRadius + kBottomRadius,
                                   discs_top + kBottomRadius),
               .radius = kBottomRadius});
    transform(ball, stand_from_ball());
    ball.source_material = 0;
    return ball;
}

/// The part of the core that can be seen through the gap, with what its edges hide.
Profile core_profile() {
    Profile core;
    core.arc({0.0f, 0.0f}, 0.425f, 44.0f, 59.0f);
    return core;
}

/// From inside the cup over its lip, down the bowl and the waist to the foot. About the ball's
/// middle.
Profile bowl_profile() {
    constexpr float kInner = 0.507f;
    constexpr float kLip = 0.016f;
    constexpr float kOuter = kInner + 2.0f * kLip;
    constexpr float kLipDegrees = 136.0f;
    constexpr float kBowlEnd = 160.0f;
    constexpr float kWaist = 0.12f;
    const glm::vec2 waist_center = on_circle(kOuter + kWaist, kBowlEnd);
    Profile bowl;
    bowl.arc({0.0f, 0.0f}, kInner, 145.0f, kLipDegrees);
    bowl.arc(on_circle(kInner + kLip, kLipDegrees), kLip, kLipDegrees - 180.0f, kLipDegrees);
    bowl.arc({0.0f, 0.0f}, kOuter, kLipDegrees, kBowlEnd);
    bowl.arc(waist_center, kWaist, kBowlEnd - 180.0f, -180.0f);
    return bowl;
}

/// A stepped foot that begins where the waist ends and reaches the ground.
struct FootProfiles {
    Profile top;
    Profile side;
    Profile bottom;
};

FootProfiles foot_profiles(glm::vec2 waist_end) {
    constexpr float kEdge = 0.012f;
    constexpr float kStepRadius = 0.36f;
    constexpr float kStepHeight = 0.03f;
    constexpr float kFootRadius = 0.47f;
    const float upper = waist_end.y;
    const float lower = upper - kStepHeight;
    const float ground = -kBallHeight;
    FootProfiles foot;
    foot.top.line(waist_end, {kStepRadius - kEdge, upper}, 4);
    foot.top.arc({kStepRadius - kEdge, upper - kEdge}, kEdge, 0.0f, 90.0f);
    foot.top.line(foot.top.end(), {kStepRadius, lower});
    foot.top.line(foot.top.end(), {kFootRadius - kEdge, lower}, 2);
    foot.top.arc({kFootRadius - kEdge, lower - kEdge}, kEdge, 0.0f, 90.0f);
    foot.side.line(foot.top.end(), {kFootRadius, ground + kEdge});
    foot.side.arc({kFootRadius - kEdge, ground + kEdge}, kEdge, 90.0f, 180.0f);
    foot.bottom.line(foot.side.end(), {0.0f, ground}, 4);
    return foot;
}

/// Bowl, foot and the core of the ball: one material, one UV square.
Primitive shader_ball_stand() {
    const Profile core = core_profile();
    const Profile bowl = bowl_profile();
    const FootProfiles foot = foot_profiles(bowl.end());
    Primitive stand;
    float top = kChartGap;
    const auto add_strip = [&](Primitive& to, const Profile& profile) {
        add_lathe(to, profile, {.kind = LatheChart::Kind::Strip, .top = top});
        top += strip_height(profile) + kChartGap;
    };
    Primitive tilted_core;
    add_strip(tilted_core, core);
    transform(tilted_core, stand_from_ball());

    add_strip(stand, bowl);
    add_strip(stand, foot.side);
    const float radius = 0.5f * (1.0f - kChartGap - top);
    add_lathe(stand, foot.top,
              {.kind = LatheChart::Kind::TopDisc,
               .center = glm::vec2(kChartGap + radius, top + radius),
               .radius = radius});
    add_lathe(stand, foot.bottom,
              {.kind = LatheChart::Kind::BottomDisc,
               .center = glm::vec2(3.0f * kChartGap + 3.0f * radius, top + radius),
               .radius = radius});
    transform(stand, glm::translate(glm::mat4(1.0f), {0.0f, kBallHeight, 0.0f}));
    append(stand, tilted_core);
    stand.source_material = 1;
    return stand;
}

/// A strip with a disc above and one below: the charts of the sphere and the cylinder.
Primitive capped_lathe(const Profile& top, const Profile& side, const Profile& bottom) {
    Primitive primitive;
    add_lathe(primitive, side, {.kind = LatheChart::Kind::Strip, .top = kChartGap});
    const float discs = 2.0f * kChartGap + strip_height(side) + kDiscRadius;
    add_lathe(primitive, top,
              {.kind = LatheChart::Kind::TopDisc,
               .center = glm::vec2(kChartGap + kDiscRadius, discs),
               .radius = kDiscRadius});
    add_lathe(primitive, bottom,
              {.kind = LatheChart::Kind::BottomDisc,
               .center = glm::vec2(2.0f * kChartGap + 3.0f * kDiscRadius, discs),
               .radius = kDiscRadius});
    primitive.source_material = 0;
    return primitive;
}

Primitive sphere() {
    constexpr float kCapDegrees = 40.0f;
    const glm::vec2 center(0.0f, 0.5f);
    Profile top;
    Profile side;
    Profile bottom;
    top.arc(center, 0.5f, 0.0f, kCapDegrees);
    side.arc(center, 0.5f, kCapDegrees, 180.0f - kCapDegrees);
    bottom.arc(center, 0.5f, 180.0f - kCapDegrees, 180.0f);
    return capped_lathe(top, side, bottom);
}

Primitive cylinder() {
    constexpr float kRadius = 0.4f;
    constexpr float kEdge = 0.02f;
    Profile top;
    Profile side;
    Profile bottom;
    top.line({0.0f, 1.0f}, {kRadius - kEdge, 1.0f}, 4);
    side.arc({kRadius - kEdge, 1.0f - kEdge}, kEdge, 0.0f, 90.0f);
    side.line(side.end(), {kRadius, kEdge}, 8);
    side.arc({kRadius - kEdge, kEdge}, kEdge, 90.0f, 180.0f);
    bottom.line(side.end(), {0.0f, 0.0f}, 4);
    return capped_lathe(top, side, bottom);
}

/// The tube is so thick that its strip is half as high as wide.
Primitive torus() {
    constexpr float kRing = 0.345f;
    const float tube = kRing / std::sqrt(5.0f);
    Profile around;
    around.arc({kRing, tube}, tube, -90.0f, 270.0f);
    Primitive primitive;
    add_lathe(primitive, around, {.kind = LatheChart::Kind::Strip, .top = kChartGap});
    primitive.source_material = 0;
    return primitive;
}

Primitive plane() {
    Primitive primitive;
    for (const glm::vec2 uv :
         {glm::vec2(0, 0), glm::vec2(0, 1), glm::vec2(1, 0), glm::vec2(1, 1)}) {
        primitive.positions.emplace_back(uv.x - 0.5f, 0.0f, uv.y - 0.5f);
        primitive.normals.emplace_back(0.0f, 1.0f, 0.0f);
        primitive.tangents.emplace_back(1.0f, 0.0f, 0.0f, 1.0f);
        primitive.uvs[0].push_back(uv);
    }
    primitive.indices = {0, 1, 2, 2, 1, 3};
    primitive.source_material = 0;
    return primitive;
}

/// One side of the rounded cube: its outward normal, and the axes of u and of v (down).
struct CubeSide {
    glm::vec3 normal;
    glm::vec3 right;
    glm::vec3 down;
};

/// Along one axis of a side: where on the flat it is, and how far it has turned round the edge.
struct CubeStep {
    float flat;          ///< metres from the middle
    float turn_radians;  ///< -45 to 45 degrees; 0 on the flat
    float arc_length;    ///< metres from the middle, over the surface
};

std::vector<CubeStep> cube_steps(float flat, float edge_radius) {
    constexpr int kEdgeSteps = 8;
    std::vector<CubeStep> steps;
    const auto add = [&](float side, int step) {
        const float turn = glm::radians(45.0f) * static_cast<float>(step) / kEdgeSteps;
        steps.push_back({.flat = side * flat,
                         .turn_radians = side * turn,
                         .arc_length = side * (flat + edge_radius * turn)});
    };
    for (int step = kEdgeSteps; step >= 0; --step) add(-1.0f, step);
    for (int step = 0; step <= kEdgeSteps; ++step) add(1.0f, step);
    return steps;
}

void add_cube_side(Primitive& primitive, const CubeSide& side, glm::vec2 uv_center,
                   float uv_half_width) {
    constexpr float kEdge = 0.08f;
    constexpr float kFlat = 0.5f - kEdge;
    const std::vector<CubeStep> steps = cube_steps(kFlat, kEdge);
    const auto columns = static_cast<std::uint32_t>(steps.size());
    const auto first = static_cast<std::uint32_t>(primitive.positions.size());
    const float uv_per_metre = uv_half_width / steps.back().arc_length;
    for (const CubeStep& down : steps)
        for (const CubeStep& right : steps) {
            const glm::vec3 normal =
                glm::normalize(side.normal + side.right * std::tan(right.turn_radians) +
                               side.down * std::tan(down.turn_radians));
            const glm::vec3 tangent =
                glm::normalize(side.right - normal * glm::dot(normal, side.right));
            primitive.positions.push_back(side.normal * kFlat + side.right * right.flat +
                                          side.down * down.flat + normal * kEdge +
                                          glm::vec3(0.0f, 0.5f, 0.0f));
            primitive.normals.push_back(normal);
            primitive.tangents.emplace_back(tangent, 1.0f);
            primitive.uvs[0].push_back(uv_center +
                                       uv_per_metre * glm::vec2(right.arc_length, down.arc_length));
        }
    for (std::uint32_t row = 0; row + 1 < columns; ++row)
        for (std::uint32_t column = 0; column + 1 < columns; ++column) {
            const std::uint32_t upper = first + row * columns + column;
            const std::uint32_t lower = upper + columns;
            primitive.indices.insert(primitive.indices.end(),
                                     {upper, lower, upper + 1, upper + 1, lower, lower + 1});
        }
}

Primitive rounded_cube() {
    constexpr float kCell = 1.0f / 3.0f;
    const glm::vec3 x(1.0f, 0.0f, 0.0f);
    const glm::vec3 y(0.0f, 1.0f, 0.0f);
    const glm::vec3 z(0.0f, 0.0f, 1.0f);
    const std::array sides = {CubeSide{z, x, -y},  CubeSide{x, -z, -y}, CubeSide{-z, -x, -y},
                              CubeSide{-x, z, -y}, CubeSide{y, x, z},   CubeSide{-y, x, -z}};
    Primitive primitive;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const std::size_t row = i / 3;
        const glm::vec2 cell(static_cast<float>(i % 3), static_cast<float>(row));
        add_cube_side(primitive, sides[i], (cell + 0.5f) * kCell, 0.5f * kCell - kChartGap);
    }
    primitive.source_material = 0;
    return primitive;
}

}  // namespace

Mesh shape_mesh(Shape shape) {
    switch (shape) {
        case Shape::ShaderBall:
            return {"Shader ball", {shader_ball_ball(), shader_ball_stand()}};
        case Shape::Sphere:
            return {"Sphere", {sphere()}};
        case Shape::RoundedCube:
            return {"Rounded cube", {rounded_cube()}};
        case Shape::Plane:
            return {"Plane", {plane()}};
        case Shape::Cylinder:
            return {"Cylinder", {cylinder()}};
        case Shape::Torus:
            return {"Torus", {torus()}};
    }
    return {};
}

}  // namespace patina
