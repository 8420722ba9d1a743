// SPDX-License-Identifier: MIT
#include "document/worn_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "document/parts.h"
#include "document/stack_tree.h"

namespace patina {
namespace {

void add_name(const std::string& name, std::vector<std::string>& names) {
    if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(name);
}

}  // namespace

UvSurfacePtr worn_surface(const Document& document, const Material& material,
                          const UvSurfacePtr& last) {
    std::vector<SurfacePart> parts;
    const ScenePtr scene = document.scene ? document.scene : std::make_shared<const Scene>();
    std::map<PartRef, std::string> part_names;
    for (Part& part : parts_of(document)) part_names.emplace(part.ref, std::move(part.name));
    std::map<const Primitive*, std::size_t> places;
    for (const MeshInstance& instance : scene->instances) {
        const Mesh& mesh = scene->meshes[static_cast<std::size_t>(instance.mesh)];
        for (const Primitive& primitive : mesh.primitives) {
            const MaterialPtr worn = material_of_part(document, primitive);
            if (!worn || worn->id != material.id) continue;
            const auto [place, is_new] = places.try_emplace(&primitive, parts.size());
            if (is_new) {
                parts.push_back(
                    {.primitive = &primitive, .world_from_local = instance.world_from_local});
                add_name(part_names[primitive.source], parts.back().names);
                add_name(mesh.name, parts.back().names);
                if (const MaterialPtr of_file = material_of(document, primitive.source_material))
                    parts.back().material = of_file->name;
            }
            add_name(instance.name, parts[place->second].names);
        }
    }
    if (last && last->scene() == scene && last->uv_set() == material.uv_set &&
        last->parts() == parts)
        return last;
    return std::make_shared<const UvSurface>(scene, std::move(parts), material.uv_set);
}

std::optional<Projection> projection_of(const Source& source) {
    const Projection* projection = nullptr;
    if (const auto* image = std::get_if<ImageSource>(&source)) projection = &image->projection;
    if (const auto* noise = std::get_if<ProceduralSource>(&source)) projection = &noise->projection;
    if (projection == nullptr || projection->kind == ProjectionKind::Uv) return std::nullopt;
    return *projection;
}

bool reads_surface(const Material& material) {
    bool found = false;
    for_each_source(material.stack, [&](const Source& source) {
        found = found || projection_of(source) || std::holds_alternative<GeometrySource>(source);
    });
    return found;
}

UvSurfacePtr surface_read(const Document& document, const Material& material,
                          const UvSurfacePtr& last) {
    return reads_surface(material) ? worn_surface(document, material, last) : nullptr;
}

std::vector<std::string> missing_of_surface(const Material& material, const UvSurface& surface) {
    if (!reads_surface(material)) return {};
    if (!surface.has_uvs())
        return {
            "no part that has UVs wears it: masks by parts cover everything, and projections "
            "follow the UVs"};
    std::set<std::string> names, materials;
    for (const SurfacePart& part : surface.parts()) {
        names.insert(part.names.begin(), part.names.end());
        materials.insert(part.material);
    }
    std::set<std::string> missing;
    const auto look = [&](const std::vector<std::string>& picked,
                          const std::set<std::string>& known, std::string_view what,
                          std::string_view fault) {
        for (const std::string& name : picked)
            if (!known.contains(name))
                missing.insert(fmt::format("a mask picks {}\"{}\", but {}", what,
                                           quoted_for_message(name, 60), fault));
    };
    for_each_source(material.stack, [&](const Source& source) {
        const auto* const geometry = std::get_if<GeometrySource>(&source);
        if (geometry == nullptr) return;
        look(geometry->meshes, names, "", "no part that wears it has that name");
        look(geometry->materials, materials, "parts of ", "none that wears it is of that material");
    });
    return {missing.begin(), missing.end()};
}

}  // namespace patina
