// SPDX-License-Identifier: MIT
#pragma once

/// The lamps of a view as the GPU reads them: the uniform block of passes/lights.glsl. Inside
/// engine/render only.

#include <vector>

#include "gl/buffer.h"
#include "gl/pass.h"
#include "scene/scene.h"

namespace patina::render {

/// Uploads only lights that are not those of the frame before.
class LightBlock {
  public:
    LightBlock();
    /// Before the passes of a frame. At most kMaxLights are kept.
    void set(const std::vector<Light>& lights);
    /// Whether one is a sphere or rectangle.
    bool any_has_size() const;
    /// Takes the uniform slot 1.
    void bind(gl::Pass& pass, gl::Program& program) const;

  private:
    std::vector<Light> lights_;
    gl::Buffer buffer_;
};

/// Where the width of a rectangle of that direction and turn lies, unit.
glm::vec3 rectangle_across(const Light& light);

/// Scale and offset of a spot, for cone_window of shaders/shared/lamp.glsl.
glm::vec2 spot_cone(const Light& light);

}  // namespace patina::render
