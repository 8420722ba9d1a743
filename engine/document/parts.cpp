// SPDX-License-Identifier: MIT
#include "document/parts.h"

#include <fmt/format.h>

#include <set>

namespace patina {
namespace {

std::string part_name(const MeshInstance& instance, const Mesh& mesh, std::size_t primitive) {
    std::string name = instance.name.empty() ? mesh.name : instance.name;
    if (name.empty()) name = fmt::format("Mesh {}", instance.mesh + 1);
    return mesh.primitives.size() > 1 ? fmt::format("{}, {}", name, primitive + 1) : name;
}

}  // namespace

MaterialPtr material_of_part(const Document& document, const Primitive& primitive) {
    const auto assigned = document.assigned.find(primitive.source);
    return assigned == document.assigned.end() ? material_of(document, primitive.source_material)
                                               : find_material(document, assigned->second);
}

std::vector<Part> parts_of(const Document& document) {
    std::vector<Part> parts;
    if (!document.scene) return parts;
    std::set<PartRef> seen;
    for (const MeshInstance& instance : document.scene->instances) {
        const Mesh& mesh = document.scene->meshes[static_cast<std::size_t>(instance.mesh)];
        for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
            const Primitive& primitive = mesh.primitives[i];
            if (!seen.insert(primitive.source).second) continue;
            parts.push_back({.ref = primitive.source,
                             .name = part_name(instance, mesh, i),
                             .material = material_of_part(document, primitive),
                             .material_of_file = material_of(document, primitive.source_material)});
        }
    }
    return parts;
}

std::map<PartRef, int> assigned_numbers(const Document& document) {
    std::map<PartRef, int> numbers;
    for (const auto& [part, id] : document.assigned)
        if (const MaterialPtr material = find_material(document, id))
            numbers.emplace(part, material->source_material.value_or(-1));
    return numbers;
}

}  // namespace patina
