// SPDX-License-Identifier: MIT
#pragma once

/// Transforms, cameras and lights of a glTF file in Patina's terms; not yet placed.

#include <vector>

#include "io/gltf_model.h"
#include "scene/scene.h"

namespace patina::io {

/// From its matrix, or from translation, rotation and scale.
glm::mat4 parent_from_local(const tinygltf::Node& node);
/// A field of view that no perspective has becomes the default one.
SceneCamera camera_of(const tinygltf::Camera& camera);
/// Colours, intensities and cones are brought into the ranges that KHR_lights_punctual allows.
Light light_of(const tinygltf::Light& light);

std::vector<float> as_floats(const std::vector<double>& numbers);

}  // namespace patina::io
