// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstdio>

#include "io/gltf_check.h"

namespace patina::io {
namespace {

/// What becomes of a file that requires an extension. One that is in neither table could mean
/// anything, so that the picture would be wrong without a word: it is refused.
constexpr std::array kShown = std::to_array<std::string_view>({
    "EXT_texture_webp",
    "KHR_animation_pointer",
    "KHR_lights_punctual",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_pbrSpecularGlossiness",
    "KHR_materials_specular",
    "KHR_materials_unlit",
    "KHR_materials_variants",
    "KHR_mesh_quantization",
    "KHR_texture_transform",
    "KHR_xmp",
    "KHR_xmp_json_ld",
});

/// Kept in the file and left out of the picture, with a warning.
constexpr std::array kKept = std::to_array<std::string_view>({
    "EXT_lights_ies",
    "EXT_lights_image_based",
    "EXT_mesh_manifold",
    "KHR_audio_emitter",
    "KHR_implicit_shapes",
    "KHR_interactivity",
    "KHR_materials_anisotropy",
    "KHR_materials_clearcoat",
    "KHR_materials_diffuse_transmission",
    "KHR_materials_dispersion",
    "KHR_materials_iridescence",
    "KHR_materials_sheen",
    "KHR_materials_transmission",
    "KHR_materials_volume",
    "KHR_materials_volume_scatter",
    "KHR_node_hoverability",
    "KHR_node_selectability",
    "KHR_node_visibility",
    "KHR_physics_rigid_bodies",
    "MSFT_lod",
    "MSFT_packing_normalRoughnessMetallic",
    "MSFT_packing_occlusionRoughnessMetallic",
});

struct Version {
    int major = 0;
    int minor = 0;
};

/// "2.0" and nothing around it.
std::optional<Version> parsed_version(const std::string& text) {
    Version version;
    int length = 0;
    if (text.size() > 16) return std::nullopt;
    if (std::sscanf(text.c_str(), "%5d.%5d%n", &version.major, &version.minor, &length) != 2)
        return std::nullopt;
    if (static_cast<std::size_t>(length) != text.size() || version.major < 0) return std::nullopt;
    return version;
}

void check_required_extensions(const JsonPlace& root, CheckedGltf& checked) {
    for (const std::string& name : root.texts("extensionsRequired")) {
        const auto is_name = [&](std::string_view known) { return known == name; };
        const std::string shown = quoted_for_message(name, 80);
        if (std::any_of(kKept.begin(), kKept.end(), is_name))
            checked.warnings.push_back(fmt::format(
                "{} is kept in the file, but Patina shows the model without it", shown));
        else if (std::none_of(kShown.begin(), kShown.end(), is_name))
            root.fault("extensionsRequired",
                       fmt::format("needs {}, which Patina does not support; export the model "
                                   "without it",
                                   shown));
    }
}

}  // namespace

void check_versions(const JsonPlace& root, CheckedGltf& checked) {
    if (!root.has("asset")) return root.fault("asset", "is missing: not a glTF 2.0 file");
    const JsonPlace asset = root.object("asset");
    const auto version = parsed_version(asset.text("version"));
    if (!version || version->major != 2)
        return asset.fault("version",
                           fmt::format("is \"{}\", only glTF 2.0 is supported; convert the model",
                                       quoted_for_message(asset.text("version"), 20)));
    if (asset.has("minVersion")) {
        const auto least = parsed_version(asset.text("minVersion"));
        if (!least || least->major != 2 || least->minor != 0)
            asset.fault("minVersion",
                        fmt::format("is \"{}\", Patina reads glTF 2.0",
                                    quoted_for_message(asset.text("minVersion"), 20)));
    }
    root.texts("extensionsUsed");
    check_required_extensions(root, checked);
}

}  // namespace patina::io
