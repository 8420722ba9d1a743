// SPDX-License-Identifier: MIT
#pragma once

/// Meshes made by code, to look at materials without a file: unit-sized (about 1 m across), resting
/// on y = 0, with exact normals, tangents and TEXCOORD_0 within 0..1 that overlaps nowhere.

#include <array>
#include <cstdint>
#include <string_view>

#include "scene/mesh.h"

namespace patina {

enum class Shape : std::uint8_t { ShaderBall, Sphere, RoundedCube, Plane, Cylinder, Torus };

struct ShapeInfo {
    Shape shape;
    std::string_view id;     ///< on the command line
    std::string_view label;  ///< in menus
};

inline constexpr std::array kShapes = {
    ShapeInfo{Shape::ShaderBall, "shader-ball", "Shader ball"},
    ShapeInfo{Shape::Sphere, "sphere", "Sphere"},
    ShapeInfo{Shape::RoundedCube, "rounded-cube", "Rounded cube"},
    ShapeInfo{Shape::Plane, "plane", "Plane"},
    ShapeInfo{Shape::Cylinder, "cylinder", "Cylinder"},
    ShapeInfo{Shape::Torus, "torus", "Torus"},
};

/// The mesh of a shape. Its primitives have source_material 0, 1 ... : the shader ball's are the
/// ball, which materials are judged on, and the stand with the core that shows through the ball's
/// gap; all others have one.
Mesh shape_mesh(Shape shape);

}  // namespace patina
