// SPDX-License-Identifier: MIT
// patina explain: how the value of one texel comes about, layer by layer.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/input.h"
#include "composite/composite.h"
#include "core/json.h"
#include "document/choices.h"
#include "document/worn_surface.h"

namespace patina::cli {
namespace {

constexpr const char* kExplainFooter =
    "Runs the program that bakes, for one texel: what is printed is exact. The lowest layer "
    "stands\n"
    "first. Colours are linear light; weight is opacity x channel opacity x mask x coverage. The "
    "mask\n"
    "has in it what heights decide of a layer that blends by height. Covered is what the group "
    "has\n"
    "laid down of the channel so far. A normal that heights bend ends with a step \"from "
    "height\".\n"
    "\n"
    "Examples:\n"
    "  patina explain rusty.glb --material Ball --uv 0.25,0.5\n"
    "  patina explain rusty.glb --material Ball --uv 0.25,0.5 --channel roughness --json";

struct ExplainOptions {
    std::filesystem::path input;
    std::string material;
    glm::vec2 uv = glm::vec2(0.5f);
    std::vector<Channel> channels;
    std::optional<int> size;
    bool json = false;
};

struct Explained {
    Channel channel;
    std::vector<ExplainStep> steps;
};

int texel_of(float coordinate, int size) {
    const float wrapped = coordinate - std::floor(coordinate);
    return std::min(static_cast<int>(wrapped * static_cast<float>(size)), size - 1);
}

bool is_vector(Channel channel) {
    const ChannelKind kind = info(channel).kind;
    return kind == ChannelKind::Color || kind == ChannelKind::Normal;
}

std::string text_of(Channel channel, const glm::vec3& value) {
    if (!is_vector(channel)) return fmt::format("{:.4f}", value.x);
    return fmt::format("{:.4f} {:.4f} {:.4f}", value.x, value.y, value.z);
}

Json json_value(Channel channel, const glm::vec3& value) {
    if (!is_vector(channel)) return value.x;
    return Json{value.x, value.y, value.z};
}

Json to_json(const Explained& explained) {
    Json steps = Json::array();
    for (const ExplainStep& step : explained.steps)
        steps.push_back({{"layer", step.layer_name},
                         {"id", step.layer == LayerId{} ? Json() : Json(step.layer.value)},
                         {"depth", step.depth},
                         {"mode", info(step.mode).id},
                         {"source", json_value(explained.channel, step.source)},
                         {"mask", step.mask},
                         {"weight", step.weight},
                         {"coverage", step.coverage},
                         {"result", json_value(explained.channel, step.result)}});
    return {{"channel", info(explained.channel).id}, {"steps", steps}};
}

void print(const Explained& explained) {
    const Channel channel = explained.channel;
    fmt::print("\n{}\n", info(channel).label);
    if (explained.steps.empty()) {
        fmt::print("  no layer touches it\n");
        return;
    }
    const int width = is_vector(channel) ? 22 : 8;
    fmt::print("  {:<28} {:<14} {:<{}} {:>6} {:>7} {:>7}  {}\n", "layer", "mode", "value in", width,
               "mask", "weight", "covered", "value out");
    for (const ExplainStep& step : explained.steps) {
        const std::string name = std::string(static_cast<std::size_t>(2 * step.depth), ' ') +
                                 quoted_for_message(step.layer_name, 26);
        fmt::print("  {:<28} {:<14} {:<{}} {:>6.3f} {:>7.4f} {:>7.4f}  {}\n", name,
                   info(step.mode).id, text_of(channel, step.source), width, step.mask, step.weight,
                   step.coverage, text_of(channel, step.result));
    }
}

Result<MaterialPtr> chosen_material(const ExplainOptions& options, const Document& document) {
    const auto materials = named_materials(document, options.material);
    if (!materials) return passed_on(materials);
    if (options.material.empty() && materials->size() > 1)
        return failure("{}: it has {} materials; pick one with --material",
                       quoted_for_message(options.input.string()), materials->size());
    return materials->front();
}

Status run_explain(const ExplainOptions& options) {
    const auto loaded = opened_document(options.input, {});
    if (!loaded) return passed_on(loaded);
    const auto material = chosen_material(options, *loaded->document);
    if (!material) return passed_on(material);
    const int size = options.size.value_or((*material)->resolution);
    const int x = texel_of(options.uv.x, size);
    const int y = texel_of(options.uv.y, size);
    const UvSurfacePtr surface = surface_read(*loaded->document, **material);
    std::vector<Explained> all;
    for (const ChannelInfo& entry : kChannels) {
        const bool wanted =
            options.channels.empty() || std::find(options.channels.begin(), options.channels.end(),
                                                  entry.channel) != options.channels.end();
        if (!wanted) continue;
        auto steps = explain_texel(**material, surface, *loaded->images, entry.channel, size, x, y);
        if (!steps) return passed_on(steps);
        all.push_back({entry.channel, std::move(*steps)});
    }
    if (options.json) {
        Json json = {{"material", (*material)->name}, {"size", size}, {"x", x}, {"y", y}};
        json["channels"] = Json::array();
        for (const Explained& explained : all) json["channels"].push_back(to_json(explained));
        fmt::print("{}\n", json.dump(2));
        return {};
    }
    fmt::print("material {}, texel {}, {} of {} x {}\n", quoted_for_message((*material)->name), x,
               y, size, size);
    for (const Explained& explained : all) print(explained);
    return {};
}

}  // namespace

void add_explain(CLI::App& app, Command& chosen) {
    auto* command = app.add_subcommand("explain", "Show how a texel comes about, layer by layer");
    command->footer(kExplainFooter);
    auto options = std::make_shared<ExplainOptions>();
    command->add_option("IN", options->input, "A .gltf or .glb file")->required()->type_name("");
    command->add_option("--material", options->material, "Which one, where the file has several")
        ->type_name("NAME");
    add_uv_option(*command, "--uv", options->uv,
                  "The place: u to the right and v down from the upper left corner")
        ->required();
    add_choice_option(
        *command, "--channel", kChannels,
        [options](const ChannelInfo& entry) { options->channels.push_back(entry.channel); },
        "Only this channel");
    command->add_option("--size", options->size, "Side of the map; as the material says if unset")
        ->check(CLI::Range(1, 16384))
        ->type_name("N");
    command->add_flag("--json", options->json, "Report as JSON");
    command->callback([options, &chosen] { chosen = [options] { return run_explain(*options); }; });
}

}  // namespace patina::cli
