// SPDX-License-Identifier: MIT
#pragma once

/// What Patina reads of a glTF file, as plain values whose every index, size and count has been
/// checked. Made by read_gltf_model; what a save needs of the rest is in the text itself.

#include <array>
#include <glm/glm.hpp>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "document/material.h"
#include "scene/scene.h"

namespace patina::io::gltf {

enum class ComponentType { I8 = 5120, U8, I16, U16, U32 = 5125, F32 };
std::size_t component_bytes(ComponentType type);

struct Buffer {
    std::optional<std::string> uri;  ///< unset: the binary chunk of a GLB
    std::uint64_t length = 0;
};

struct BufferView {
    int buffer = 0;
    std::uint64_t offset = 0;
    std::uint64_t length = 0;
    int stride = 0;  ///< 0: packed
};

/// Replaces some elements of an accessor.
struct Sparse {
    std::int64_t count = 0;
    int index_view = 0;
    std::uint64_t index_offset = 0;
    ComponentType index_type = ComponentType::U32;
    int value_view = 0;
    std::uint64_t value_offset = 0;
};

struct Accessor {
    int view = -1;  ///< -1: zeros
    std::uint64_t offset = 0;
    ComponentType type = ComponentType::F32;
    std::int64_t count = 0;
    int rows = 1;
    int columns = 1;  ///< above 1 for matrices
    bool normalized = false;
    std::optional<Sparse> sparse;

    int components() const { return rows * columns; }
    /// Columns of matrices start at multiples of four bytes.
    std::size_t column_bytes() const;
    std::size_t element_bytes() const { return column_bytes() * static_cast<std::size_t>(columns); }
};

using Attributes = std::map<std::string, int, std::less<>>;  ///< accessor by semantic

enum class PrimitiveMode { Points, Lines, LineLoop, LineStrip, Triangles, Strip, Fan };

struct MeshPrimitive {
    Attributes attributes;
    int indices = -1;
    int material = -1;
    PrimitiveMode mode = PrimitiveMode::Triangles;
    std::vector<Attributes> targets;
};

struct Mesh {
    std::string name;
    std::vector<MeshPrimitive> primitives;
    std::vector<float> weights;
};

struct Node {
    std::string name;
    std::vector<int> children;
    int mesh = -1;
    int skin = -1;
    int camera = -1;
    int light = -1;
    glm::mat4 parent_from_local = glm::mat4(1.0f);
    std::vector<float> weights;
};

struct Skin {
    int inverse_bind_matrices = -1;
    std::vector<int> joints;
};

struct Image {
    std::string name;
    std::optional<std::string> uri;
    int view = -1;
    std::string mime_type;
};

struct Sampler {
    Wrap wrap_u = Wrap::Repeat;
    Wrap wrap_v = Wrap::Repeat;
    Filter filter = Filter::Linear;
};

struct Texture {
    int sampler = -1;
    int image = -1;
};

/// A material's use of a texture; absent while `texture` is -1.
struct TextureUse {
    int texture = -1;
    int uv_set = 0;
    UvTransform transform;
};

struct Material {
    std::string name;
    glm::vec4 base_color_factor = glm::vec4(1.0f);
    TextureUse base_color;
    float metallic_factor = 1.0f;
    float roughness_factor = 1.0f;
    TextureUse metallic_roughness;
    TextureUse normal;
    float normal_scale = 1.0f;
    TextureUse occlusion;
    float occlusion_strength = 1.0f;
    TextureUse emissive;
    glm::vec3 emissive_factor = glm::vec3(0.0f);
    AlphaMode alpha_mode = AlphaMode::Opaque;
    float alpha_cutoff = 0.5f;
    bool double_sided = false;
    bool unlit = false;
    float ior = 1.5f;
    float specular_factor = 1.0f;
    glm::vec3 specular_color_factor = glm::vec3(1.0f);
    float emissive_strength = 1.0f;
    std::optional<std::string> record;  ///< extras.patina
};

struct SceneRoots {
    std::string name;
    std::vector<int> nodes;
    std::optional<std::string> record;  ///< extras.patina
};

struct Model {
    std::vector<Buffer> buffers;
    std::vector<BufferView> views;
    std::vector<Accessor> accessors;
    std::vector<Mesh> meshes;
    std::vector<Node> nodes;
    std::vector<Skin> skins;
    std::vector<SceneCamera> cameras;  ///< not yet placed
    std::vector<Light> lights;         ///< not yet placed
    std::vector<Image> images;
    std::vector<Sampler> samplers;
    std::vector<Texture> textures;
    std::vector<Material> materials;
    std::vector<SceneRoots> scenes;
    int scene = -1;  ///< the one to show; -1 when there is none
    std::vector<std::string> warnings;
};

struct ModelLimits {
    int nodes = 1'000'000;
    int node_depth = 1'000;
};

/// Checks the whole file against ROBUSTNESS section 1 and takes what Patina shows. Failure: the
/// JSON pointer and the fault, without the file's name.
Result<Model> read_gltf_model(const nlohmann::json& root, const ModelLimits& limits = {});

}  // namespace patina::io::gltf
