// SPDX-License-Identifier: MIT
#pragma once

/// The camera of a view, and what a hand on the mouse does to it: values and pure functions.
/// World: right-handed, +Y up, metres. View space: right-handed, the camera looks along -Z.

#include <glm/glm.hpp>

#include "scene/mesh.h"
#include "scene/scene.h"

namespace patina::render {

struct Camera {
    glm::vec3 position = glm::vec3(1.6f, 1.1f, 2.4f);  ///< not the target
    glm::vec3 target = glm::vec3(0.0f);                ///< what it looks at and orbits around
    /// Of any length, across the view or not; another axis serves where it lies along the view.
    glm::vec3 up = glm::vec3(0.0f, 1.0f, 0.0f);
    float fov_y_degrees = 30.0f;       ///< of the whole height, 1 to 160; perspective only
    float orthographic_height = 0.0f;  ///< above 0: orthographic, metres from bottom to top
    bool operator==(const Camera&) const = default;
};

/// Where an automatic camera stands, looking at the middle of what it frames.
enum class ViewDirection { ThreeQuarter, Front, Back, Left, Right, Top, Bottom };

/// A camera that shows all of `bounds` at the given width / height, with a margin of a tenth.
/// Empty bounds are framed as a unit ball.
Camera framed(const Bounds& bounds, float aspect,
              ViewDirection direction = ViewDirection::ThreeQuarter, float fov_y_degrees = 30.0f);
/// The same direction and field of view, moved so that `bounds` fill the view again.
Camera framed_from(const Camera& camera, const Bounds& bounds, float aspect);
/// The same direction, target, field of view and up, from as near as `bounds` fit into the view.
Camera framed_around(const Camera& camera, const Bounds& bounds, float aspect);
/// The same field of view or orthographic, from that direction, with `bounds` filling the view.
Camera framed_from_direction(const Camera& camera, const Bounds& bounds, float aspect,
                             ViewDirection direction);
/// Another field of view from as far away as shows the target at the same size.
Camera with_fov(const Camera& camera, float fov_y_degrees);
/// Orthographic where it was in perspective and the other way, with the target at the same size.
Camera with_other_projection(const Camera& camera);
/// A camera that stands where one of the file stands; it orbits around the middle of `bounds`.
Camera camera_of(const SceneCamera& camera, const Bounds& bounds);

/// Turns around the target: `yaw_degrees` about +Y, counter-clockwise from above;
/// `pitch_degrees` up, stopping short of the poles. +Y is up afterwards.
Camera orbited(const Camera& camera, float yaw_degrees, float pitch_degrees);
/// As if the scene stood on a turntable: position and up go about +Y through the target,
/// counter-clockwise from above.
Camera turned(const Camera& camera, float degrees);
/// Moves camera and target along the picture: the point under the hand follows it.
/// @param right, up  shares of the picture's height, positive right and up
Camera panned(const Camera& camera, float right, float up);
/// Moves towards the target (above 0) or away; 1 halves the distance (or the orthographic height).
Camera dollied(const Camera& camera, float steps);

glm::mat4 view_from_world(const Camera& camera);

/// How many pixels of a picture so high a metre takes that lies across the view at a distance.
float pixels_per_metre(const Camera& camera, int picture_height, float distance_m);

/// The depth range that holds `bounds`, for a projection without waste. 0 < near < far, metres.
struct DepthRange {
    float near_m = 0.01f;
    float far_m = 100.0f;
};
DepthRange depth_range(const Camera& camera, const Bounds& bounds);
/// OpenGL clip space, depth -1 to 1.
glm::mat4 clip_from_view(const Camera& camera, float aspect, const DepthRange& range);

}  // namespace patina::render
