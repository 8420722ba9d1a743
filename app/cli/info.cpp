// SPDX-License-Identifier: MIT
// patina info: what a file holds, each material's stack as a tree.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/input.h"
#include "cli/uv_report.h"
#include "core/json.h"
#include "document/choices.h"
#include "document/worn_surface.h"

namespace patina::cli {
namespace {

constexpr const char* kInfoFooter =
    "The top of a stack is printed first, as in the editor.\n"
    "\n"
    "Examples:\n"
    "  patina info model.glb\n"
    "  patina info model.glb --json\n"
    "  patina info model.glb --materials";

struct InfoOptions {
    std::filesystem::path input;
    bool json = false;
    bool materials = false;
};

struct SceneCounts {
    std::size_t meshes = 0;
    std::size_t primitives = 0;
    std::size_t vertices = 0;
    std::size_t triangles = 0;
};

SceneCounts counts_of(const Scene& scene) {
    SceneCounts counts = {.meshes = scene.meshes.size()};
    for (const Mesh& mesh : scene.meshes)
        for (const Primitive& primitive : mesh.primitives) {
            ++counts.primitives;
            counts.vertices += primitive.positions.size();
            counts.triangles += primitive.indices.size() / 3;
        }
    return counts;
}

std::string_view kind_of(const Layer& layer) {
    if (layer.is_adjustment()) return "adjustment";
    return layer.is_group() ? "group" : "fill";
}

/// The ids of the channels that a layer lays something on.
std::vector<std::string_view> channels_of(const Layer& layer) {
    std::vector<std::string_view> ids;
    for (const ChannelInfo& channel : kChannels)
        if (at(layer.channels, channel.channel).enabled) ids.push_back(channel.id);
    return ids;
}

/// Of the entries of the mask that are adjustments.
std::vector<std::string_view> adjustments_of(const Mask& mask) {
    std::vector<std::string_view> ids;
    for (const MaskEntry& entry : mask.entries)
        if (entry.adjustment) ids.push_back(choice(entry.adjustment->kind).id);
    return ids;
}

std::string described(const Mask& mask) {
    const std::vector<std::string_view> adjustments = adjustments_of(mask);
    std::string text = fmt::format("mask of {}", mask.entries.size());
    if (!adjustments.empty()) text += fmt::format(" ({})", fmt::join(adjustments, ", "));
    return text;
}

Json to_json(const Layer& layer) {
    Json json = {{"id", layer.id.value},
                 {"name", layer.name},
                 {"kind", kind_of(layer)},
                 {"visible", layer.visible},
                 {"locked", layer.locked},
                 {"opacity", layer.opacity},
                 {"mode", info(layer.mode).id},
                 {"mask_entries", layer.mask.entries.size()},
                 {"mask_adjustments", adjustments_of(layer.mask)},
                 {"clipped", layer.clipped},
                 {"channels", channels_of(layer)},
                 {"height_blend", layer.height_blend.enabled}};
    if (const auto* content = std::get_if<AdjustmentContent>(&layer.content))
        json["adjustment"] = choice(content->adjustment.kind).id;
    if (const auto* group = std::get_if<GroupContent>(&layer.content)) {
        json["children"] = Json::array();
        for (const LayerPtr& child : group->children) json["children"].push_back(to_json(*child));
    }
    return json;
}

/// The first name of each part that wears a material: what a mask picks it by.
std::vector<std::string> part_names(const UvSurface& surface) {
    std::vector<std::string> names;
    for (const SurfacePart& part : surface.parts())
        names.push_back(quoted_for_message(part.names.empty() ? "" : part.names.front(), 60));
    return names;
}

Json to_json(const Document& document, const Material& material) {
    const UvSurfacePtr surface = worn_surface(document, material);
    Json json = {{"name", material.name},
                 {"resolution", material.resolution},
                 {"alpha_mode", choice(material.alpha_mode).id},
                 {"double_sided", material.double_sided},
                 {"padding", choice(material.padding).id},
                 {"uvs", uv_layout_json(uv_layout(*surface))},
                 {"parts", part_names(*surface)},
                 {"missing", missing_of_surface(material, *surface)},
                 {"stack", Json::array()}};
    for (const LayerPtr& layer : material.stack) json["stack"].push_back(to_json(*layer));
    return json;
}

Json to_json(const SceneCamera& camera) {
    if (camera.orthographic_height > 0.0f)
        return {{"name", camera.name},
                {"kind", "orthographic"},
                {"height_m", camera.orthographic_height}};
    return {{"name", camera.name},
            {"kind", "perspective"},
            {"fov_y_degrees", glm::degrees(camera.fov_y_radians)}};
}

std::string described(const SceneCamera& camera) {
    if (camera.orthographic_height > 0.0f)
        return fmt::format("orthographic, {:.3g} m high", camera.orthographic_height);
    return fmt::format("perspective, {:.1f} degrees from bottom to top",
                       glm::degrees(camera.fov_y_radians));
}

Json to_json(const InfoOptions& options, const io::LoadedDocument& loaded) {
    const Document& document = *loaded.document;
    const SceneCounts counts = counts_of(*document.scene);
    Json json = {{"file", options.input.string()},  {"meshes", counts.meshes},
                 {"primitives", counts.primitives}, {"vertices", counts.vertices},
                 {"triangles", counts.triangles},   {"lights", document.lights.size()},
                 {"cameras", Json::array()},        {"environment", document.environment.name},
                 {"images", Json::array()},         {"materials", Json::array()},
                 {"warnings", loaded.warnings}};
    for (const SceneCamera& camera : document.scene->cameras)
        json["cameras"].push_back(to_json(camera));
    for (const auto& [hash, image] : document.images)
        json["images"].push_back({{"name", image->name},
                                  {"hash", to_hex(hash)},
                                  {"width", image->width},
                                  {"height", image->height},
                                  {"channels", image->channels},
                                  {"type", choice(image->type).id}});
    for (const MaterialPtr& material : document.materials)
        json["materials"].push_back(to_json(document, *material));
    return json;
}

/// Whether a source of the layer is projected on the model, or picks parts of it.
std::vector<std::string_view> read_of_model(const Layer& layer) {
    std::set<std::string_view> found;
    const auto look = [&](const Source& source) {
        if (const auto projection = projection_of(source))
            found.insert(choice(projection->kind).id);
        if (std::holds_alternative<GeometrySource>(source)) found.insert("parts");
    };
    for (const ChannelSettings& settings : layer.channels)
        if (settings.enabled) look(settings.source);
    for (const MaskEntry& entry : layer.mask.entries) look(entry.source);
    return {found.begin(), found.end()};
}

std::string described(const Layer& layer) {
    std::string text = fmt::format("{}  [{}", quoted_for_message(layer.name), kind_of(layer));
    if (const auto* content = std::get_if<AdjustmentContent>(&layer.content))
        text += fmt::format(", {}", choice(content->adjustment.kind).label);
    if (layer.clipped) text += ", clipped";
    if (layer.mode != BlendMode::Normal) text += fmt::format(", {}", info(layer.mode).label);
    if (layer.height_blend.enabled) text += ", by height";
    if (layer.opacity != 1.0f) text += fmt::format(", {:.0f} %", 100.0f * layer.opacity);
    if (!layer.mask.entries.empty()) text += ", " + described(layer.mask);
    for (const std::string_view what : read_of_model(layer)) text += fmt::format(", {}", what);
    if (!layer.visible) text += ", hidden";
    if (layer.locked) text += ", locked";
    return text + fmt::format("]  {}", fmt::join(channels_of(layer), ", "));
}

/// The top layer first. `indent` is what stands before each line.
void print_stack(const std::vector<LayerPtr>& layers, const std::string& indent) {
    for (std::size_t i = layers.size(); i-- > 0;) {
        const bool last = i == 0;
        fmt::print("{}{} {}\n", indent, last ? "└─" : "├─", described(*layers[i]));
        if (const auto* group = std::get_if<GroupContent>(&layers[i]->content))
            print_stack(group->children, indent + (last ? "   " : "│  "));
    }
}

void print(const InfoOptions& options, const io::LoadedDocument& loaded) {
    const Document& document = *loaded.document;
    const SceneCounts counts = counts_of(*document.scene);
    fmt::print("{}: {} meshes, {} primitives, {} vertices, {} triangles, {} images, {} lights\n",
               quoted_for_message(options.input.string()), counts.meshes, counts.primitives,
               counts.vertices, counts.triangles, document.images.size(), document.lights.size());
    for (std::size_t i = 0; i < document.scene->cameras.size(); ++i)
        fmt::print("camera {} {}: {}\n", i, quoted_for_message(document.scene->cameras[i].name),
                   described(document.scene->cameras[i]));
    for (const auto& [hash, image] : document.images)
        fmt::print("image {}: {}x{}, {} channels, {}\n", quoted_for_message(image->name),
                   image->width, image->height, image->channels, choice(image->type).label);
    for (const MaterialPtr& material : document.materials) {
        fmt::print("\nmaterial {}: {} texels a side, {}\n", quoted_for_message(material->name),
                   material->resolution, choice(material->alpha_mode).id);
        const UvSurfacePtr surface = worn_surface(document, *material);
        fmt::print("UVs: {}\n", uv_layout_words(uv_layout(*surface)));
        fmt::print("parts: {}\n", fmt::join(part_names(*surface), "; "));
        for (const std::string& line : missing_of_surface(*material, *surface))
            fmt::print("note: {}\n", line);
        print_stack(material->stack, "");
    }
}

Status run_info(const InfoOptions& options) {
    const auto loaded = opened_document(options.input, {});
    if (!loaded) return passed_on(loaded);
    if (options.materials)
        for (const MaterialPtr& material : loaded->document->materials)
            fmt::print("{}\n", quoted_for_message(material->name));
    else if (options.json)
        fmt::print("{}\n", to_json(options, *loaded).dump(2));
    else
        print(options, *loaded);
    return {};
}

}  // namespace

void add_info(CLI::App& app, Command& chosen) {
    auto* command =
        app.add_subcommand("info", "Show the scene and each material's stack as a tree");
    command->footer(kInfoFooter);
    auto options = std::make_shared<InfoOptions>();
    command->add_option("IN", options->input, "A .gltf or .glb file")->required()->type_name("");
    auto* json = command->add_flag("--json", options->json, "Report as JSON");
    command
        ->add_flag("--materials", options->materials, "Only the names of the materials, one a line")
        ->excludes(json);
    command->callback([options, &chosen] { chosen = [options] { return run_info(*options); }; });
}

}  // namespace patina::cli
