// SPDX-License-Identifier: MIT
#include "io/part_materials.h"

#include <algorithm>

#include "composite/composite.h"

namespace patina::io {
namespace {

bool is_in_file(const Material& material) {
    return material.source_material && !is_added(material);
}

Json beginning_of(const Material& material, const Json& materials) {
    if (!material.copied_from) return Json::object();
    Json copy = materials[static_cast<std::size_t>(*material.copied_from)];
    if (const auto extras = copy.find("extras"); extras != copy.end() && extras->is_object()) {
        extras->erase("patina");
        if (extras->empty()) copy.erase("extras");
    }
    return copy;
}

std::set<int> uv_sets_of(const Document& document, const Material& material) {
    std::set<int> sets;
    const Program program = Program::compile(document, material);  // owns the slots it lists
    for (const SlotPlan& plan : program.slots()) {
        if (const auto* image = std::get_if<SlotImage>(&plan)) sets.insert(image->source.uv_set);
        if (std::holds_alternative<SlotBaked>(plan)) sets.insert(material.uv_set);
    }
    return sets;
}

bool lacks(const Primitive& primitive, const std::set<int>& uv_sets) {
    return std::any_of(uv_sets.begin(), uv_sets.end(), [&](int set) {
        const auto index = static_cast<std::size_t>(set);
        return index >= primitive.uvs.size() || primitive.uvs[index].empty();
    });
}

/// The primitive of the JSON, or null.
Json* primitive_at(Json& meshes, PartRef part) {
    if (part.mesh < 0 || static_cast<std::size_t>(part.mesh) >= meshes.size()) return nullptr;
    Json& primitives = meshes[static_cast<std::size_t>(part.mesh)]["primitives"];
    if (part.primitive < 0 || static_cast<std::size_t>(part.primitive) >= primitives.size())
        return nullptr;
    return &primitives[static_cast<std::size_t>(part.primitive)];
}

void name_default_material(Json& meshes, int place) {
    for_each_primitive(meshes, [&](Json& primitive) {
        if (!primitive.contains("material")) primitive["material"] = place;
    });
}

}  // namespace

std::map<MaterialId, int> place_new_materials(const std::vector<MaterialPtr>& edited,
                                              GltfJson& gltf) {
    std::map<MaterialId, int> places;
    Json& materials = gltf.array("materials");
    for (const MaterialPtr& material : edited) {
        if (is_in_file(*material)) continue;
        places.emplace(material->id, static_cast<int>(materials.size()));
        materials.push_back(beginning_of(*material, materials));
    }
    return places;
}

void give_parts_their_materials(const Document& document, const std::map<MaterialId, int>& places,
                                GltfJson& gltf) {
    if (document.assigned.empty() && places.empty()) return;
    Json& meshes = gltf.array("meshes");
    for (const auto& [part, id] : document.assigned) {
        const MaterialPtr material = find_material(document, id);
        Json* primitive = primitive_at(meshes, part);
        if (!material || !primitive) continue;
        const auto place = places.find(id);
        if (place != places.end())
            (*primitive)["material"] = place->second;
        else if (material->source_material)
            (*primitive)["material"] = *material->source_material;
        else
            primitive->erase("material");
    }
    for (const auto& [id, place] : places)
        if (const MaterialPtr material = find_material(document, id);
            material && !material->source_material)
            name_default_material(meshes, place);
}

std::set<MaterialId> shown_without_uvs(const Document& document) {
    std::set<MaterialId> found;
    if (document.assigned.empty() || !document.scene) return found;
    std::map<MaterialId, std::set<int>> uv_sets;
    for (const auto& [part, id] : document.assigned)
        if (const MaterialPtr material = find_material(document, id))
            uv_sets.try_emplace(id, uv_sets_of(document, *material));
    for (const Mesh& mesh : document.scene->meshes)
        for (const Primitive& primitive : mesh.primitives) {
            const auto assigned = document.assigned.find(primitive.source);
            if (assigned == document.assigned.end()) continue;
            const auto sets = uv_sets.find(assigned->second);
            if (sets != uv_sets.end() && lacks(primitive, sets->second))
                found.insert(assigned->second);
        }
    return found;
}

}  // namespace patina::io
