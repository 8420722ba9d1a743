// SPDX-License-Identifier: MIT
#include <algorithm>

#include "io/gltf_read.h"

namespace patina::io::gltf {
namespace {

/// All attributes of a primitive describe the same vertices.
void check_counts(const JsonPlace& place, const Model& model, const Attributes& attributes,
                  std::int64_t vertices) {
    for (const auto& [semantic, accessor] : attributes) {
        const auto count = model.accessors[static_cast<std::size_t>(accessor)].count;
        if (count != vertices)
            place.fault(semantic,
                        fmt::format("has {} elements, other attributes have {}", count, vertices));
    }
}

Attributes read_attributes(const JsonPlace& place, const Model& model) {
    Attributes attributes;
    for (const auto& [semantic, accessor] : place.index_members(model.accessors.size()))
        attributes.emplace(semantic, accessor);
    return attributes;
}

void check_variants(const JsonPlace& primitive, const Model& model, std::size_t variants) {
    const JsonPlace extension = primitive.object("extensions").object("KHR_materials_variants");
    for (const JsonPlace& mapping : extension.objects("mappings")) {
        mapping.required_index("material", model.materials.size());
        mapping.indices("variants", variants);
    }
}

MeshPrimitive read_primitive(const JsonPlace& place, const Model& model) {
    MeshPrimitive primitive;
    const JsonPlace attributes = place.object("attributes");
    primitive.attributes = read_attributes(attributes, model);
    primitive.indices = place.index("indices", model.accessors.size());
    primitive.material = place.index("material", model.materials.size());
    primitive.mode = static_cast<PrimitiveMode>(place.integer("mode", 4, {0, 6}));
    if (primitive.attributes.empty()) return primitive;
    const int first = primitive.attributes.begin()->second;
    const auto vertices = model.accessors[static_cast<std::size_t>(first)].count;
    check_counts(attributes, model, primitive.attributes, vertices);
    for (const JsonPlace& target : place.objects("targets")) {
        primitive.targets.push_back(read_attributes(target, model));
        check_counts(target, model, primitive.targets.back(), vertices);
    }
    return primitive;
}

}  // namespace

void read_meshes(const JsonPlace& root, Model& model) {
    const std::size_t variants =
        root.object("extensions").object("KHR_materials_variants").array_size("variants");
    for (const JsonPlace& place : root.objects("meshes")) {
        Mesh mesh{
            .name = place.text("name"), .primitives = {}, .weights = place.numbers("weights")};
        for (const JsonPlace& primitive : place.objects("primitives")) {
            mesh.primitives.push_back(read_primitive(primitive, model));
            check_variants(primitive, model, variants);
        }
        const auto targets = [](const MeshPrimitive& p) { return p.targets.size(); };
        for (const MeshPrimitive& primitive : mesh.primitives)
            if (targets(primitive) != targets(mesh.primitives.front()))
                place.fault("primitives", "differ in their number of morph targets");
        model.meshes.push_back(std::move(mesh));
    }
}

void read_skins(const JsonPlace& root, Model& model) {
    const std::size_t nodes = root.array_size("nodes");
    for (const JsonPlace& place : root.objects("skins")) {
        Skin skin;
        skin.inverse_bind_matrices = place.index("inverseBindMatrices", model.accessors.size());
        skin.joints = place.indices("joints", nodes);
        place.index("skeleton", nodes);
        if (skin.joints.empty()) place.fault("joints", "must name at least one node");
        if (skin.inverse_bind_matrices >= 0) {
            const auto& matrices =
                model.accessors[static_cast<std::size_t>(skin.inverse_bind_matrices)];
            if (matrices.components() != 16 || matrices.type != ComponentType::F32)
                place.fault("inverseBindMatrices", "must be 4x4 matrices of floats");
            if (static_cast<std::size_t>(matrices.count) < skin.joints.size())
                place.fault("inverseBindMatrices", fmt::format("has {} matrices for {} joints",
                                                               matrices.count, skin.joints.size()));
        }
        model.skins.push_back(std::move(skin));
    }
}

void check_animations(const JsonPlace& root) {
    const std::size_t nodes = root.array_size("nodes");
    const std::size_t accessors = root.array_size("accessors");
    for (const JsonPlace& animation : root.objects("animations")) {
        const auto samplers = animation.objects("samplers");
        for (const JsonPlace& sampler : samplers) {
            sampler.required_index("input", accessors);
            sampler.required_index("output", accessors);
        }
        for (const JsonPlace& channel : animation.objects("channels")) {
            channel.required_index("sampler", samplers.size());
            channel.object("target").index("node", nodes);
        }
    }
}

}  // namespace patina::io::gltf
