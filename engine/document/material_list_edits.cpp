// SPDX-License-Identifier: MIT
#include "document/material_list_edits.h"

#include <fmt/format.h>

#include <algorithm>

#include "document/check.h"
#include "document/stack_tree.h"

namespace patina {
namespace {

/// Numbers for the renderer come round again after so many ids.
constexpr std::uint64_t kAddedNumbers = std::uint64_t{1} << 22;

/// Issues the next id and the number that the material is drawn by.
void name_as_added(Material& material, std::uint64_t& next_id) {
    material.source_material = kFirstAddedMaterial + static_cast<int>(next_id % kAddedNumbers);
    material.id = MaterialId{next_id++};
}

/// Behind all but the default one, which is last.
Result<Document> with_added(Document document, Material material) {
    if (document.materials.size() >= std::size_t{kMaxMaterials})
        return failure("a model can have at most {} materials", kMaxMaterials);
    const auto is_default = [](const MaterialPtr& each) { return !each->source_material; };
    document.materials.insert(
        std::find_if(document.materials.begin(), document.materials.end(), is_default),
        std::make_shared<const Material>(std::move(material)));
    return document;
}

Result<MaterialPtr> known_material(const Document& document, MaterialId id) {
    MaterialPtr material = find_material(document, id);
    if (!material) return failure("there is no material {}", id.value);
    return material;
}

const Primitive* find_part(const Document& document, PartRef part) {
    if (!document.scene) return nullptr;
    for (const Mesh& mesh : document.scene->meshes)
        for (const Primitive& primitive : mesh.primitives)
            if (primitive.source == part) return &primitive;
    return nullptr;
}

}  // namespace

std::string free_material_name(const Document& document, std::string_view wanted) {
    const auto is_taken = [&](const std::string& name) {
        return std::any_of(document.materials.begin(), document.materials.end(),
                           [&](const MaterialPtr& material) { return material->name == name; });
    };
    std::string name(wanted);
    for (int number = 2; is_taken(name); ++number) name = fmt::format("{} {}", wanted, number);
    return name;
}

Edit add_material(std::string name) {
    std::string label = "Add material " + name;
    return {.label = std::move(label),
            .merge_key = {},
            .apply = [name = std::move(name)](const Document& before) -> Result<Document> {
                if (Status status = check_name(name); !status) return passed_on(status);
                Document after = before;
                Material material;
                material.name = name;
                name_as_added(material, after.next_id);
                return with_added(std::move(after), std::move(material));
            }};
}

Edit duplicate_material(const Material& material) {
    return {.label = "Duplicate material " + material.name,
            .merge_key = {},
            .apply = [id = material.id](const Document& before) -> Result<Document> {
                const Result<MaterialPtr> original = known_material(before, id);
                if (!original) return passed_on(original);
                Document after = before;
                Material copy = **original;
                if (!is_added(copy)) copy.copied_from = copy.source_material;
                name_as_added(copy, after.next_id);
                const std::string name = free_material_name(before, copy.name + " copy");
                if (check_name(name)) copy.name = name;
                copy.stack = with_fresh_ids(copy.stack, after.next_id);
                return with_added(std::move(after), std::move(copy));
            }};
}

Edit remove_material(const Material& material) {
    return {.label = "Delete material " + material.name,
            .merge_key = {},
            .apply = [id = material.id](const Document& before) -> Result<Document> {
                const Result<MaterialPtr> doomed = known_material(before, id);
                if (!doomed) return passed_on(doomed);
                if (!is_added(**doomed))
                    return failure("{} is a material of the file and stays in it",
                                   quoted_for_message((*doomed)->name, 80));
                Document after = before;
                std::erase(after.materials, *doomed);
                std::erase_if(after.assigned, [id](const auto& each) { return each.second == id; });
                return after;
            }};
}

Edit assign_material(const Material& material, const Part& part) {
    return {
        .label = fmt::format("Assign {} to {}", material.name, part.name),
        .merge_key = {},
        .apply = [id = material.id, ref = part.ref](const Document& before) -> Result<Document> {
            const Result<MaterialPtr> wanted = known_material(before, id);
            if (!wanted) return passed_on(wanted);
            const Primitive* primitive = find_part(before, ref);
            if (!primitive)
                return failure("the model has no part {} of mesh {}", ref.primitive, ref.mesh);
            Document after = before;
            // What the file says needs no word of ours.
            if (material_of(before, primitive->source_material) == *wanted)
                after.assigned.erase(ref);
            else
                after.assigned[ref] = id;
            return after;
        }};
}

}  // namespace patina
