// SPDX-License-Identifier: MIT
#include "editor/panels/surface_fields.h"

#include <algorithm>
#include <set>

#include "document/parts.h"
#include "editor/widgets/buttons.h"
#include "editor/widgets/form.h"

namespace patina::editor {
namespace {

bool is_worn(const Part& part, MaterialId material) {
    return part.material && part.material->id == material;
}

/// A box to tick for one name of a list.
Requests draw_name(Ui& ui, const Rect& rect, const SourcePlace& place, const GeometrySource& now,
                   std::vector<std::string> GeometrySource::*list, const std::string& name,
                   const std::string& label) {
    Requests requests;
    const Parameter parameter =
        list == &GeometrySource::meshes ? Parameter::GeometryMeshes : Parameter::GeometryMaterials;
    const auto& names = now.*list;
    const bool on = std::find(names.begin(), names.end(), name) != names.end();
    if (!labelled_checkbox(ui, rect, label, on, info(parameter).tooltip)) return requests;
    GeometrySource changed = now;
    if (on)
        std::erase(changed.*list, name);
    else
        (changed.*list).push_back(name);
    requests.edit(set_geometry(place, changed, parameter));
    return requests;
}

}  // namespace

std::vector<std::string> worn_parts(const Document& document, MaterialId material) {
    std::vector<std::string> names;
    for (const Part& part : parts_of(document))
        if (is_worn(part, material)) names.push_back(part.name);
    return names;
}

Requests draw_geometry(Ui& ui, Rect& rest, const SourcePlace& place, const GeometrySource& now,
                       const Shown& shown) {
    Requests requests;
    std::set<std::string> parts, materials;
    for (const Part& part : parts_of(*shown.document)) {
        if (!is_worn(part, shown.material->id)) continue;
        parts.insert(part.name);
        if (part.material_of_file) materials.insert(part.material_of_file->name);
    }
    if (parts.empty())
        text(ui, next_line(ui, rest), ui.fonts.caption11, theme::kText3,
             "No part wears this material: everywhere");
    std::set<std::string> others(now.meshes.begin(), now.meshes.end());
    for (const std::string& name : parts) {
        requests.append(
            draw_name(ui, next_line(ui, rest), place, now, &GeometrySource::meshes, name, name));
        others.erase(name);
    }
    for (const std::string& name : others)
        requests.append(draw_name(ui, next_line(ui, rest), place, now, &GeometrySource::meshes,
                                  name, name + " (mesh or node)"));
    if (materials.size() < 2) materials.clear();
    materials.insert(now.materials.begin(), now.materials.end());
    for (const std::string& name : materials)
        requests.append(draw_name(ui, next_line(ui, rest), place, now, &GeometrySource::materials,
                                  name, "Material " + name));
    return requests;
}

}  // namespace patina::editor
