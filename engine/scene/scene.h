// SPDX-License-Identifier: MIT
#pragma once

/// What the file's scene shows, flattened: meshes, and where each stands in the world.
/// Right-handed, +Y up, metres. Skins and morphs have been applied at rest.

#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "scene/mesh.h"

namespace patina {

/// A mesh at a place.
struct MeshInstance {
    int mesh = 0;  ///< index into Scene::meshes
    glm::mat4 world_from_local = glm::mat4(1.0f);
    std::string name;
};

/// A lamp in the world: those of KHR_lights_punctual, and spheres and rectangles, which glTF does
/// not have.
struct Light {
    enum class Kind { Directional, Point, Spot, Sphere, Rectangle };
    Kind kind = Kind::Directional;
    std::string name;
    glm::vec3 color_linear = glm::vec3(1.0f);  ///< 0 to 1
    /// Lux (directional) or candela: of point and sphere to all sides, of spot and rectangle
    /// straight ahead. From far away, a sphere or rectangle is as bright as a point or spot of that
    /// intensity.
    float intensity = 1.0f;
    glm::vec3 position_world = glm::vec3(0.0f);
    glm::vec3 direction_world = glm::vec3(0.0f, 0.0f, -1.0f);  ///< the way the light travels, unit
    float range = 0.0f;                                        ///< metres; 0 reaches everywhere
    /// Of a spot, from its axis: full light within the inner, none beyond the outer one.
    float inner_cone_radians = 0.0f;       ///< 0 to the outer one
    float outer_cone_radians = 0.785398f;  ///< up to pi / 2
    float radius_m = 0.1f;                 ///< of a sphere
    float width_m = 1.0f;  ///< of a rectangle, which shines to one side, along its direction
    float height_m = 1.0f;
    /// -pi to pi, of a rectangle about its direction; 0: its width lies level.
    float turn_radians = 0.0f;
    /// Whether it shines from an area and not from a point.
    bool has_size() const { return kind == Kind::Sphere || kind == Kind::Rectangle; }
    bool operator==(const Light&) const = default;
};
/// The most lights of a document, all of which are drawn.
inline constexpr int kMaxLights = 256;

/// Stands at the matrix's origin and looks along its -Z with +Y up, as glTF cameras do; the matrix
/// may scale.
struct SceneCamera {
    std::string name;
    glm::mat4 world_from_camera = glm::mat4(1.0f);
    float fov_y_radians = 0.8f;        ///< of the whole height, of a perspective camera
    float orthographic_height = 0.0f;  ///< above 0: orthographic, full height in metres
};

struct Scene {
    std::vector<Mesh> meshes;
    std::vector<MeshInstance> instances;
    std::vector<SceneCamera> cameras;
    std::vector<Light> lights;
    Bounds bounds_world;  ///< of all instances
};

using ScenePtr = std::shared_ptr<const Scene>;

}  // namespace patina
