// SPDX-License-Identifier: MIT
#include "io/gltf_check.h"

namespace patina::io {
namespace {

using Members = std::vector<std::pair<std::string, int>>;

/// All attributes of a primitive describe the same vertices.
void check_counts(const JsonPlace& place, const CheckedGltf& checked, const Members& attributes,
                  std::int64_t vertices) {
    for (const auto& [semantic, accessor] : attributes) {
        const auto count = checked.accessors[static_cast<std::size_t>(accessor)].count;
        if (count != vertices)
            place.fault(semantic,
                        fmt::format("has {} elements, other attributes have {}", count, vertices));
    }
}

void check_variants(const JsonPlace& primitive, std::size_t materials, std::size_t variants) {
    const JsonPlace extension = primitive.object("extensions").object("KHR_materials_variants");
    for (const JsonPlace& mapping : extension.objects("mappings")) {
        mapping.required_index("material", materials);
        mapping.indices("variants", variants);
    }
}

/// @return how many morph targets it has
std::size_t check_primitive(const JsonPlace& place, const CheckedGltf& checked,
                            std::size_t materials) {
    const std::size_t accessors = checked.accessors.size();
    const JsonPlace attributes = place.object("attributes");
    const Members members = attributes.index_members(accessors);
    place.index("indices", accessors);
    place.index("material", materials);
    place.integer("mode", 4, {0, 6});
    const auto targets = place.objects("targets");
    std::vector<Members> target_members;
    for (const JsonPlace& target : targets)
        target_members.push_back(target.index_members(accessors));
    if (members.empty()) return targets.size();
    const auto first = static_cast<std::size_t>(members.front().second);
    const std::int64_t vertices = checked.accessors[first].count;
    check_counts(attributes, checked, members, vertices);
    for (std::size_t i = 0; i < targets.size(); ++i)
        check_counts(targets[i], checked, target_members[i], vertices);
    return targets.size();
}

}  // namespace

void check_meshes(const JsonPlace& root, const CheckedGltf& checked) {
    const std::size_t variants =
        root.object("extensions").object("KHR_materials_variants").array_size("variants");
    const std::size_t materials = root.array_size("materials");
    for (const JsonPlace& place : root.objects("meshes")) {
        place.text("name");
        place.numbers("weights");
        std::size_t targets = 0;
        bool is_first = true;
        for (const JsonPlace& primitive : place.objects("primitives")) {
            const std::size_t count = check_primitive(primitive, checked, materials);
            check_variants(primitive, materials, variants);
            if (!is_first && count != targets)
                place.fault("primitives", "differ in their number of morph targets");
            targets = count;
            is_first = false;
        }
    }
}

void check_skins(const JsonPlace& root, const CheckedGltf& checked) {
    const std::size_t nodes = root.array_size("nodes");
    for (const JsonPlace& place : root.objects("skins")) {
        const int matrices = place.index("inverseBindMatrices", checked.accessors.size());
        const std::size_t joints = place.indices("joints", nodes).size();
        place.index("skeleton", nodes);
        if (joints == 0) place.fault("joints", "must name at least one node");
        if (matrices < 0) continue;
        const CheckedAccessor& accessor = checked.accessors[static_cast<std::size_t>(matrices)];
        if (accessor.layout.components() != 16 || accessor.layout.type != ComponentType::F32)
            place.fault("inverseBindMatrices", "must be 4x4 matrices of floats");
        if (static_cast<std::size_t>(accessor.count) < joints)
            place.fault("inverseBindMatrices",
                        fmt::format("has {} matrices for {} joints", accessor.count, joints));
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

}  // namespace patina::io
