// SPDX-License-Identifier: MIT
#include "io/mesh_read.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>

#include "io/texture_use.h"
#include "io/triangles.h"
#include "scene/normals.h"
#include "scene/tangents.h"

namespace patina::io {
namespace {

using Attributes = std::map<std::string, int>;
using MeshPrimitive = tinygltf::Primitive;

// A vertex with all its attributes, and again for the copy that splitting corners can make.
constexpr std::uint64_t kVertexBytes = 160;
// With what making tangents takes for a corner while it runs.
constexpr std::uint64_t kIndexBytes = 64;

/// Joint indices and weights of each vertex, four at a time (JOINTS_0, JOINTS_1 ...).
struct SkinBinding {
    std::vector<std::vector<std::uint32_t>> joints;
    std::vector<std::vector<float>> weights;
};

/// Reads the attributes of one primitive.
class AttributeReader {
  public:
    AttributeReader(const GltfData& data, std::string pointer)
        : data_(data), pointer_(std::move(pointer)) {}

    /// An attribute as vectors; empty where it is absent. Integers of colours are normalised
    /// whether the file says so or not, as the standard asks.
    template <int N>
    Result<std::vector<glm::vec<N, float>>> vectors(const Attributes& attributes,
                                                    const std::string& semantic) {
        const auto found = attributes.find(semantic);
        if (found == attributes.end()) return std::vector<glm::vec<N, float>>();
        if (components(found->second) != N)
            return failure("{}/{}: has {} components, must have {}", pointer_, semantic,
                           components(found->second), N);
        auto numbers = read_floats(data_, found->second, not_finite_);
        if (!numbers) return passed_on(numbers);
        std::vector<glm::vec<N, float>> vectors(numbers->size() / N);
        std::memcpy(static_cast<void*>(vectors.data()), numbers->data(),
                    numbers->size() * sizeof(float));
        return vectors;
    }

    Result<std::vector<glm::vec4>> colors(const Attributes& attributes) {
        const auto found = attributes.find("COLOR_0");
        if (found == attributes.end() || components(found->second) == 4)
            return vectors<4>(attributes, "COLOR_0");
        auto rgb = vectors<3>(attributes, "COLOR_0");
        if (!rgb) return passed_on(rgb);
        std::vector<glm::vec4> rgba(rgb->size());
        std::transform(rgb->begin(), rgb->end(), rgba.begin(),
                       [](const glm::vec3& color) { return glm::vec4(color, 1.0f); });
        return rgba;
    }

    Result<SkinBinding> skin(const Attributes& attributes) {
        SkinBinding binding;
        for (int set = 0;; ++set) {
            const auto joints = attributes.find(fmt::format("JOINTS_{}", set));
            const auto weights = attributes.find(fmt::format("WEIGHTS_{}", set));
            if (joints == attributes.end() || weights == attributes.end()) return binding;
            if (components(joints->second) != 4 || components(weights->second) != 4)
                return failure("{}: joints and weights must have 4 components", pointer_);
            auto indices = read_unsigned(data_, joints->second);
            if (!indices) return passed_on(indices);
            auto amounts = read_floats(data_, weights->second, not_finite_);
            if (!amounts) return passed_on(amounts);
            binding.joints.push_back(std::move(*indices));
            binding.weights.push_back(std::move(*amounts));
        }
    }

    std::size_t not_finite() const { return not_finite_; }

  private:
    int components(int accessor) const {
        return layout_of(data_.model.accessors[static_cast<std::size_t>(accessor)]).components();
    }

    const GltfData& data_;
    std::string pointer_;
    std::size_t not_finite_ = 0;
};

Status read_attributes(AttributeReader& reader, const Attributes& attributes, Primitive& out) {
    auto positions = reader.vectors<3>(attributes, "POSITION");
    if (!positions) return passed_on(positions);
    auto normals = reader.vectors<3>(attributes, "NORMAL");
    if (!normals) return passed_on(normals);
    auto tangents = reader.vectors<4>(attributes, "TANGENT");
    if (!tangents) return passed_on(tangents);
    auto colors = reader.colors(attributes);
    if (!colors) return passed_on(colors);
    for (std::size_t set = 0; set < out.uvs.size(); ++set) {
        auto uvs = reader.vectors<2>(attributes, fmt::format("TEXCOORD_{}", set));
        if (!uvs) return passed_on(uvs);
        out.uvs[set] = std::move(*uvs);
    }
    out.positions = std::move(*positions);
    out.normals = std::move(*normals);
    out.tangents = std::move(*tangents);
    out.colors = std::move(*colors);
    return {};
}

/// Adds `weight` times the displacement to the xyz of each value.
template <typename Vector>
void displace(std::vector<Vector>& values, const std::vector<glm::vec3>& displacement,
              float weight) {
    for (std::size_t i = 0; i < std::min(values.size(), displacement.size()); ++i)
        for (int axis = 0; axis < 3; ++axis) values[i][axis] += weight * displacement[i][axis];
}

Status apply_morphs(AttributeReader& reader, const MeshPrimitive& source,
                    std::span<const float> weights, Primitive& out) {
    for (std::size_t i = 0; i < std::min(source.targets.size(), weights.size()); ++i) {
        if (weights[i] == 0.0f) continue;
        const Attributes& target = source.targets[i];
        const auto positions = reader.vectors<3>(target, "POSITION");
        if (!positions) return passed_on(positions);
        const auto normals = reader.vectors<3>(target, "NORMAL");
        if (!normals) return passed_on(normals);
        const auto tangents = reader.vectors<3>(target, "TANGENT");
        if (!tangents) return passed_on(tangents);
        displace(out.positions, *positions, weights[i]);
        displace(out.normals, *normals, weights[i]);
        displace(out.tangents, *tangents, weights[i]);
    }
    return {};
}

/// The blend of joint matrices that moves a vertex.
Result<glm::mat4> skin_matrix(const SkinBinding& binding, std::size_t vertex,
                              std::span<const glm::mat4> joints_world) {
    glm::mat4 sum(0.0f);
    float total = 0.0f;
    for (std::size_t set = 0; set < binding.joints.size(); ++set) {
        for (std::size_t i = 4 * vertex; i < 4 * vertex + 4; ++i) {
            const float weight = binding.weights[set][i];
            if (weight == 0.0f) continue;
            const std::uint32_t joint = binding.joints[set][i];
            if (joint >= joints_world.size())
                return failure("JOINTS_{}: vertex {} uses joint {}, the skin has {}", set, vertex,
                               joint, joints_world.size());
            sum += weight * joints_world[joint];
            total += weight;
        }
    }
    // Weights that do not sum to 1 would scale the model; without any, the vertex stays.
    if (!(std::abs(total) > 1e-6f)) return glm::mat4(1.0f);
    return sum / total;
}

Status apply_skin(const SkinBinding& binding, std::span<const glm::mat4> joints_world,
                  Primitive& out) {
    for (std::size_t i = 0; i < out.positions.size(); ++i) {
        const auto matrix = skin_matrix(binding, i, joints_world);
        if (!matrix) return passed_on(matrix);
        out.positions[i] = glm::vec3(*matrix * glm::vec4(out.positions[i], 1.0f));
        const glm::mat3 linear(*matrix);
        // The transposed inverse, times the determinant: no division, and mirrors keep their side.
        const glm::mat3 cofactors(glm::cross(linear[1], linear[2]),
                                  glm::cross(linear[2], linear[0]),
                                  glm::cross(linear[0], linear[1]));
        if (!out.normals.empty()) out.normals[i] = cofactors * out.normals[i];
        if (!out.tangents.empty())
            out.tangents[i] = glm::vec4(linear * glm::vec3(out.tangents[i]), out.tangents[i].w);
    }
    return {};
}

Result<std::vector<std::uint32_t>> read_triangles(const GltfData& data, const MeshPrimitive& source,
                                                  std::size_t vertices,
                                                  const std::string& pointer) {
    std::vector<std::uint32_t> corners;
    if (source.indices >= 0) {
        auto indices = read_unsigned(data, source.indices);
        if (!indices) return failure("{}/indices: {}", pointer, indices.error().message);
        corners = std::move(*indices);
        const auto beyond = std::find_if(corners.begin(), corners.end(),
                                         [&](std::uint32_t index) { return index >= vertices; });
        if (beyond != corners.end())
            return failure("{}/indices: index {} is {}, there are {} vertices", pointer,
                           beyond - corners.begin(), *beyond, vertices);
    } else {
        corners.resize(vertices);
        for (std::size_t i = 0; i < vertices; ++i) corners[i] = static_cast<std::uint32_t>(i);
    }
    return triangle_list(source.mode, std::move(corners));
}

/// The UV set that the normal map of the primitive's material uses.
int tangent_uv_set(const GltfData& data, const MeshPrimitive& source, const Primitive& primitive) {
    if (source.material < 0) return 0;
    const auto& material = data.model.materials[static_cast<std::size_t>(source.material)];
    const TextureUse normal = texture_use(material.normalTexture);
    return normal.texture >= 0 && normal.uv_set == 1 && !primitive.uvs[1].empty() ? 1 : 0;
}

void complete_frames(const GltfData& data, const MeshPrimitive& source, Primitive& primitive) {
    if (primitive.normals.empty()) {
        // Given tangents without normals are to be ignored.
        primitive.tangents.clear();
        make_flat_normals(primitive);
    }
    repair_normals(primitive);
    const int set = tangent_uv_set(data, source, primitive);
    if (!primitive.tangents.empty())
        repair_tangents(primitive);
    else if (!primitive.uvs[static_cast<std::size_t>(set)].empty())
        generate_tangents(primitive, set);
}

bool all_finite(const std::vector<glm::vec3>& vectors) {
    return std::all_of(vectors.begin(), vectors.end(), [](const glm::vec3& v) {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    });
}

std::uint64_t estimated_bytes(const GltfData& data, const MeshPrimitive& source,
                              std::size_t vertices) {
    std::size_t corners = vertices;
    if (source.indices >= 0)
        corners = data.model.accessors[static_cast<std::size_t>(source.indices)].count;
    // Strips and fans make three corners of one; flat normals make a vertex of each corner.
    const bool is_list = source.mode == TINYGLTF_MODE_TRIANGLES;
    const std::size_t list_corners = is_list ? corners : 3 * corners;
    const bool is_flat = source.attributes.find("NORMAL") == source.attributes.end();
    const std::size_t drawn = is_flat ? std::max(list_corners, vertices) : vertices;
    return drawn * kVertexBytes + list_corners * kIndexBytes;
}

/// Nothing when the primitive has no triangles to draw.
Result<std::optional<Primitive>> read_primitive(const GltfData& data, const MeshPrimitive& source,
                                                const std::string& pointer, const MeshPose& pose,
                                                GeometryBudget& budget,
                                                std::vector<std::string>& warnings) {
    const auto position = source.attributes.find("POSITION");
    if (position == source.attributes.end()) {
        warnings.push_back(fmt::format("{}: has no positions and is left out", pointer));
        return std::nullopt;
    }
    if (source.mode < TINYGLTF_MODE_TRIANGLES) {
        warnings.push_back(fmt::format("{}: points and lines are not shown", pointer));
        return std::nullopt;
    }
    const auto vertices = data.model.accessors[static_cast<std::size_t>(position->second)].count;
    if (const auto fits = budget.take(estimated_bytes(data, source, vertices)); !fits)
        return failure("{}: {}", pointer, fits.error().message);

    Primitive primitive;
    primitive.source_material = source.material;
    AttributeReader reader(data, pointer + "/attributes");
    if (const auto read = read_attributes(reader, source.attributes, primitive); !read)
        return passed_on(read);
    if (const auto morphed = apply_morphs(reader, source, pose.morph_weights, primitive); !morphed)
        return passed_on(morphed);
    const auto binding = reader.skin(source.attributes);
    if (!binding) return passed_on(binding);
    if (!pose.joints_world.empty() && !binding->joints.empty())
        if (const auto skinned = apply_skin(*binding, pose.joints_world, primitive); !skinned)
            return failure("{}/attributes/{}", pointer, skinned.error().message);
    if (!all_finite(primitive.positions))
        return failure("{}: morphs and skins move vertices to infinity", pointer);
    auto indices = read_triangles(data, source, primitive.positions.size(), pointer);
    if (!indices) return passed_on(indices);
    primitive.indices = std::move(*indices);
    if (primitive.indices.empty()) return std::nullopt;
    complete_frames(data, source, primitive);
    if (reader.not_finite() > 0)
        warnings.push_back(fmt::format("{}: {} numbers are not finite and are taken as 0", pointer,
                                       reader.not_finite()));
    return primitive;
}

}  // namespace

Status GeometryBudget::take(std::uint64_t bytes) {
    if (bytes > left_)
        return failure("the meshes need more than the limit of {} MiB; simplify the model",
                       limit_ >> 20);
    left_ -= bytes;
    return {};
}

Result<Mesh> read_mesh(const GltfData& data, int index, const MeshPose& pose,
                       GeometryBudget& budget, std::vector<std::string>& warnings) {
    const tinygltf::Mesh& source = data.model.meshes[static_cast<std::size_t>(index)];
    Mesh mesh{.name = source.name, .primitives = {}};
    for (std::size_t i = 0; i < source.primitives.size(); ++i) {
        const std::string pointer = fmt::format("/meshes/{}/primitives/{}", index, i);
        auto primitive =
            read_primitive(data, source.primitives[i], pointer, pose, budget, warnings);
        if (!primitive) return passed_on(primitive);
        if (!*primitive) continue;
        (*primitive)->source = {.mesh = index, .primitive = static_cast<int>(i)};
        mesh.primitives.push_back(std::move(**primitive));
    }
    return mesh;
}

}  // namespace patina::io
