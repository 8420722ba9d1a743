// SPDX-License-Identifier: MIT
#include "io/stand_in.h"

#include <algorithm>

#include "io/record_json.h"

namespace patina::io {
namespace {

constexpr const char* kVariants = "KHR_materials_variants";

bool lacks(const Json& primitive, const std::set<int>& uv_sets) {
    const auto attributes = primitive.find("attributes");
    return std::any_of(uv_sets.begin(), uv_sets.end(), [&](int set) {
        return attributes == primitive.end() ||
               !attributes->contains(fmt::format("TEXCOORD_{}", set));
    });
}

/// The places where a primitive names a material: its own, and those of its variants.
std::vector<Json*> material_references(Json& primitive) {
    std::vector<Json*> references;
    if (primitive.contains("material")) references.push_back(&primitive["material"]);
    const auto extensions = primitive.find("extensions");
    if (extensions == primitive.end() || !extensions->contains(kVariants)) return references;
    Json& variants = (*extensions)[kVariants];
    if (!variants.contains("mappings")) return references;
    for (Json& mapping : variants["mappings"])
        if (mapping.is_object() && mapping.contains("material"))
            references.push_back(&mapping["material"]);
    return references;
}

}  // namespace

int find_stand_in(const Json& materials, MaterialId id) {
    for (std::size_t i = 0; i < materials.size(); ++i)
        if (const auto record = record_of(materials[i]); record && record->stands_for == id)
            return static_cast<int>(i);
    return -1;
}

bool some_primitive_lacks(const Json& meshes, const std::set<int>& shown,
                          const std::set<int>& uv_sets) {
    bool found = false;
    Json copy = meshes;
    for_each_primitive(copy, [&](Json& primitive) {
        if (!lacks(primitive, uv_sets)) return;
        for (const Json* reference : material_references(primitive))
            found =
                found || (reference->is_number_integer() && shown.contains(reference->get<int>()));
    });
    return found;
}

void share_out(Json& meshes, int material, int stand_in, const std::set<int>& uv_sets) {
    for_each_primitive(meshes, [&](Json& primitive) {
        const int wanted = lacks(primitive, uv_sets) ? stand_in : material;
        for (Json* reference : material_references(primitive))
            if (*reference == material || *reference == stand_in) *reference = wanted;
    });
}

}  // namespace patina::io
