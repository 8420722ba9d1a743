// SPDX-License-Identifier: MIT
#include "render/gpu_scene.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scene/uv_density.h"

namespace patina::render {
namespace {

/// As the inputs of shaders/passes/surface.vert.
struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;
    glm::vec4 tangent;
    glm::vec4 uvs;
    glm::vec4 color;
};

std::vector<Vertex> interleaved(const Primitive& primitive) {
    std::vector<Vertex> vertices(primitive.positions.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const auto uv = [&](std::size_t set) {
            return primitive.uvs[set].empty() ? glm::vec2(0.0f) : primitive.uvs[set][i];
        };
        vertices[i] = {
            .position = primitive.positions[i],
            .normal =
                primitive.normals.empty() ? glm::vec3(0.0f, 1.0f, 0.0f) : primitive.normals[i],
            .tangent = primitive.tangents.empty() ? glm::vec4(0.0f) : primitive.tangents[i],
            .uvs = glm::vec4(uv(0), uv(1)),
            .color = primitive.colors.empty() ? glm::vec4(1.0f) : primitive.colors[i]};
    }
    return vertices;
}

gl::VertexArray upload_primitive(const Primitive& primitive, const std::string& label) {
    const std::vector<Vertex> vertices = interleaved(primitive);
    return gl::VertexArray::make(
        {.label = label,
         .vertices = std::as_bytes(std::span(vertices)),
         .stride_bytes = sizeof(Vertex),
         .attributes = {{.location = 0,
                         .components = 3,
                         .offset_bytes = offsetof(Vertex, position)},
                        {.location = 1, .components = 3, .offset_bytes = offsetof(Vertex, normal)},
                        {.location = 2, .components = 4, .offset_bytes = offsetof(Vertex, tangent)},
                        {.location = 3, .components = 4, .offset_bytes = offsetof(Vertex, uvs)},
                        {.location = 4, .components = 4, .offset_bytes = offsetof(Vertex, color)}},
         .indices = primitive.indices});
}

Bounds bounds_of(const Primitive& primitive, const glm::mat4& world_from_local) {
    Bounds bounds;
    for (const glm::vec3& position : primitive.positions)
        bounds.include(glm::vec3(world_from_local * glm::vec4(position, 1.0f)));
    return bounds;
}

/// The first vertex array of each mesh.
std::vector<std::size_t> upload_meshes(GpuScene& gpu) {
    std::vector<std::size_t> first_of_mesh;
    for (const Mesh& mesh : gpu.scene->meshes) {
        first_of_mesh.push_back(gpu.vertex_arrays.size());
        for (const Primitive& primitive : mesh.primitives) {
            gpu.vertex_arrays.push_back(upload_primitive(primitive, "mesh " + mesh.name));
            const auto length = [&](int uv_set) {
                return uv_areas(primitive, glm::mat4(1.0f), uv_set).length_per_uv(0.0f);
            };
            gpu.lengths_per_uv.push_back({length(0), length(1)});
        }
    }
    return first_of_mesh;
}

/// How much longer lengths are in the world, in the mean over all directions.
float mean_scale(const glm::mat4& world_from_local) {
    return std::cbrt(std::abs(glm::determinant(glm::mat3(world_from_local))));
}

}  // namespace

GpuScene upload_scene(ScenePtr scene) {
    GpuScene gpu;
    gpu.scene = std::move(scene);
    const std::vector<std::size_t> first_of_mesh = upload_meshes(gpu);
    gpu.sorted_along_local.assign(gpu.vertex_arrays.size(), glm::vec3(0.0f));
    for (std::size_t i = 0; i < gpu.scene->instances.size(); ++i) {
        const MeshInstance& instance = gpu.scene->instances[i];
        const auto mesh_index = static_cast<std::size_t>(instance.mesh);
        const Mesh& mesh = gpu.scene->meshes[mesh_index];
        for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
            const Primitive& primitive = mesh.primitives[p];
            if (primitive.indices.empty()) continue;
            const Bounds bounds = bounds_of(primitive, instance.world_from_local);
            gpu.bounds_world.include(bounds.low);
            gpu.bounds_world.include(bounds.high);
            gpu.triangles += primitive.indices.size() / 3;
            gpu.items.push_back(
                {.instance = static_cast<int>(i),
                 .primitive = static_cast<int>(p),
                 .vertices = first_of_mesh[mesh_index] + p,
                 .source_material = primitive.source_material,
                 .world_from_local = instance.world_from_local,
                 .mirrored = glm::determinant(glm::mat3(instance.world_from_local)) < 0.0f,
                 .bounds_world = bounds});
        }
    }
    return gpu;
}

float texels_seen(const GpuScene& scene, int source_material, int uv_set, const Camera& camera,
                  int picture_height) {
    float most = 0.0f;
    for (const DrawItem& item : scene.items) {
        if (item.source_material != source_material) continue;
        const glm::vec3 nearest =
            glm::clamp(camera.position, item.bounds_world.low, item.bounds_world.high);
        const float pixels =
            pixels_per_metre(camera, picture_height, glm::distance(camera.position, nearest));
        const float metres = scene.lengths_per_uv[item.vertices][static_cast<std::size_t>(uv_set)] *
                             mean_scale(item.world_from_local);
        most = std::max(most, metres * pixels);
    }
    return most;
}

const Primitive& primitive_of(const GpuScene& scene, const DrawItem& item) {
    const Scene& all = *scene.scene;
    const MeshInstance& instance = all.instances[static_cast<std::size_t>(item.instance)];
    return all.meshes[static_cast<std::size_t>(instance.mesh)]
        .primitives[static_cast<std::size_t>(item.primitive)];
}

std::vector<std::size_t> back_to_front(const std::vector<DrawItem>& items, const Camera& camera) {
    std::vector<std::size_t> order(items.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const glm::vec3 forward = camera.target - camera.position;
    const auto depth = [&](std::size_t i) {
        return glm::dot(items[i].bounds_world.center() - camera.position, forward);
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return depth(a) > depth(b); });
    return order;
}

std::vector<std::size_t> front_to_back(const std::vector<DrawItem>& items, const Camera& camera) {
    std::vector<std::size_t> order = back_to_front(items, camera);
    std::reverse(order.begin(), order.end());
    return order;
}

std::vector<std::uint32_t> triangles_back_to_front(const Primitive& primitive,
                                                   const glm::vec3& along_local) {
    const std::vector<std::uint32_t>& corners = primitive.indices;
    std::vector<std::pair<float, std::uint32_t>> order(corners.size() / 3);
    for (std::size_t i = 0; i < order.size(); ++i) {
        // Three times how far its middle is along: that sorts as well.
        const glm::vec3 sum = primitive.positions[corners[3 * i]] +
                              primitive.positions[corners[3 * i + 1]] +
                              primitive.positions[corners[3 * i + 2]];
        order[i] = {glm::dot(sum, along_local), static_cast<std::uint32_t>(3 * i)};
    }
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<std::uint32_t> result;
    result.reserve(corners.size());
    for (const auto& [along, first] : order)
        result.insert(result.end(), {corners[first], corners[first + 1], corners[first + 2]});
    return result;
}

void sort_triangles(GpuScene& scene, const DrawItem& item, const Camera& camera) {
    const glm::vec3 along_local =
        glm::transpose(glm::mat3(item.world_from_local)) * (camera.target - camera.position);
    if (scene.sorted_along_local[item.vertices] == along_local) return;
    scene.vertex_arrays[item.vertices].reorder(
        triangles_back_to_front(primitive_of(scene, item), along_local));
    scene.sorted_along_local[item.vertices] = along_local;
}

}  // namespace patina::render
