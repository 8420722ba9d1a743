// SPDX-License-Identifier: MIT
#pragma once

/// Surfaces of revolution about +Y with exact normals, tangents and angle-preserving UVs.
///
/// A profile lies in the half plane (r, y), r >= 0, and is walked so that the outside is on its
/// left: from the top of a ball down its outer side. It is made of lines and arcs; where two of
/// them meet at an angle the edge is hard, where they are tangent it is smooth.

#include <glm/glm.hpp>
#include <vector>

#include "scene/mesh.h"

namespace patina {

struct ProfileSample {
    glm::vec2 point;   ///< (r, y), metres
    glm::vec2 normal;  ///< unit, to the outside
};

/// Lines and arcs, end to end; each is a run of samples that are smooth among themselves.
class Profile {
  public:
    /// A straight piece of `steps` segments.
    Profile& line(glm::vec2 from, glm::vec2 to, int steps = 1);
    /// The piece of a circle whose points are center + radius * (sin a, cos a), a from
    /// `from_degrees` to `to_degrees`: 0 is the top, 90 the outermost point, 180 the bottom. Walked
    /// with rising angle its outside is away from the center, with falling angle towards it.
    Profile& arc(glm::vec2 center, float radius, float from_degrees, float to_degrees);

    const std::vector<std::vector<ProfileSample>>& pieces() const { return pieces_; }
    /// Where the last piece ended.
    glm::vec2 end() const { return pieces_.back().back().point; }

  private:
    void add(std::vector<ProfileSample> piece);

    std::vector<std::vector<ProfileSample>> pieces_;
};

/// Where the surface lies in UV space. Both kinds keep angles (they are conformal), so a texture is
/// scaled from place to place but never sheared or stretched one way.
struct LatheChart {
    enum class Kind {
        Strip,      ///< u runs once around, 0 to 1, and so joins itself; v runs down from `top`
        TopDisc,    ///< a cap seen from above, walked from its middle; `radius` at its end
        BottomDisc  ///< a cap seen from below, walked to its middle; `radius` at its beginning
    };
    Kind kind = Kind::Strip;
    float top = 0.0f;                    ///< of a strip
    glm::vec2 center = glm::vec2(0.5f);  ///< of a disc
    float radius = 0.5f;                 ///< of a disc
};

/// The surface that `profile` sweeps, added to `primitive` with tangents and TEXCOORD_0.
/// @param segments  around the axis; the seam lies at the back, towards -Z
void add_lathe(Primitive& primitive, const Profile& profile, const LatheChart& chart,
               int segments = 96);

/// The height in v that a strip of this profile takes.
float strip_height(const Profile& profile);

}  // namespace patina
