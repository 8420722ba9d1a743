// SPDX-License-Identifier: MIT
#pragma once

/// The meshes of a scene on the GPU, and what is drawn of them in which order.

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "gl/buffer.h"
#include "render/camera.h"
#include "scene/scene.h"

namespace patina::render {

/// One primitive at one place.
struct DrawItem {
    int instance = 0;
    int primitive = 0;         ///< within its mesh
    std::size_t vertices = 0;  ///< index into GpuScene::vertex_arrays
    int source_material = -1;
    glm::mat4 world_from_local = glm::mat4(1.0f);
    bool mirrored = false;  ///< world_from_local turns the winding round
    Bounds bounds_world;
};

struct GpuScene {
    ScenePtr scene;
    std::vector<gl::VertexArray> vertex_arrays;
    /// See UvAreas: of each vertex array and UV set in its own space, 0 without UVs.
    std::vector<std::array<float, 2>> lengths_per_uv;
    /// Which way the triangles of each vertex array are sorted, see sort_triangles; 0: not at all.
    std::vector<glm::vec3> sorted_along_local;
    std::vector<DrawItem> items;
    std::size_t triangles = 0;
    Bounds bounds_world;  ///< of what is drawn
};

/// Uploads every primitive once, however many instances show it.
GpuScene upload_scene(ScenePtr scene);

/// The mesh that an item shows.
const Primitive& primitive_of(const GpuScene& scene, const DrawItem& item);

/// How many texels a map of that material needs along one UV for none to be wider than a pixel on
/// the part that is nearest to the camera; 0 where no part with UVs wears it.
float texels_seen(const GpuScene& scene, int source_material, int uv_set, const Camera& camera,
                  int picture_height);

/// The indices of `items`, farthest from the camera first.
std::vector<std::size_t> back_to_front(const std::vector<DrawItem>& items, const Camera& camera);
/// The other way round.
std::vector<std::size_t> front_to_back(const std::vector<DrawItem>& items, const Camera& camera);

/// The corners of a primitive's triangles, those first that lie farthest along a direction.
std::vector<std::uint32_t> triangles_back_to_front(const Primitive& primitive,
                                                   const glm::vec3& along_local);
/// Puts the triangles of an item into that order as the camera sees them. It costs nothing where
/// they are in it already.
void sort_triangles(GpuScene& scene, const DrawItem& item, const Camera& camera);

}  // namespace patina::render
