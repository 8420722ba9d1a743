// SPDX-License-Identifier: MIT
// patina check: everything read and decoded; what is wrong, and what is not plausible.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/input.h"
#include "composite/program.h"

namespace patina::cli {
namespace {

constexpr const char* kCheckFooter =
    "Exit status 1 when the file cannot be opened or one of its images cannot be decoded. What is\n"
    "merely unusual (a material that is half a metal, a white that is whiter than snow) is "
    "reported\n"
    "with status 0.\n"
    "\n"
    "Example:\n"
    "  patina check model.glb --json";

struct CheckOptions {
    std::filesystem::path input;
    bool json = false;
};

struct Findings {
    std::vector<std::string> faults;
    std::vector<std::string> warnings;
};

/// Images that cannot be decoded.
std::vector<std::string> image_faults(const io::LoadedDocument& loaded) {
    std::vector<std::string> faults;
    for (const auto& [hash, image] : loaded.document->images)
        if (const auto pixels = loaded.images->pixels(hash); !pixels)
            faults.push_back(fmt::format("image {}: {}", quoted_for_message(image->name),
                                         pixels.error().message));
    return faults;
}

/// What real surfaces hardly are, of the slots that are one value everywhere. Base colours of
/// non-metals lie between charcoal and fresh snow, of metals above titanium: linear 0.02 to 0.9
/// and 0.4 (measured values as collected for physically based shading, such as Lagarde's charts).
std::vector<std::string> implausible(const Document& document, const Material& material) {
    constexpr float kDarkest = 0.02f;
    constexpr float kBrightest = 0.9f;
    constexpr float kDarkestMetal = 0.4f;
    const Program program = Program::compile(document, material);
    const auto constant = [&](Slot slot) {
        return std::get_if<SlotConstant>(&program.slots()[static_cast<std::size_t>(slot)]);
    };
    const auto* base = constant(Slot::BaseColor);
    const auto* surface = constant(Slot::MetallicRoughness);
    std::vector<std::string> findings;
    const auto find = [&](std::string_view what) {
        findings.push_back(fmt::format("material {}: {}", quoted_for_message(material.name), what));
    };
    const float metalness = surface != nullptr ? surface->value.z : 0.0f;
    if (metalness > 0.1f && metalness < 0.9f)
        find("it is neither a metal nor a non-metal: metalness is between 0.1 and 0.9 everywhere");
    if (base == nullptr || surface == nullptr) return findings;
    const glm::vec4& color = base->value;
    const float brightest = std::max({color.x, color.y, color.z});
    if (metalness <= 0.1f && brightest < kDarkest) find("its base colour is darker than charcoal");
    if (metalness <= 0.1f && std::min({color.x, color.y, color.z}) > kBrightest)
        find("its base colour is brighter than fresh snow");
    if (metalness >= 0.9f && brightest < kDarkestMetal)
        find("its base colour is darker than that of any bare metal");
    return findings;
}

Findings findings_of(const io::LoadedDocument& loaded) {
    Findings findings = {.faults = image_faults(loaded), .warnings = loaded.warnings};
    for (const MaterialPtr& material : loaded.document->materials)
        for (std::string& line : implausible(*loaded.document, *material))
            findings.warnings.push_back(std::move(line));
    return findings;
}

Status run_check(const CheckOptions& options) {
    // Not by opened_document: the warnings are the report here.
    const auto loaded = io::load_document(options.input);
    if (!loaded) return passed_on(loaded);
    const Findings findings = findings_of(*loaded);
    if (options.json) {
        const nlohmann::ordered_json json = {{"file", options.input.string()},
                                             {"faults", findings.faults},
                                             {"warnings", findings.warnings}};
        fmt::print("{}\n", json.dump(2));
    } else {
        for (const std::string& line : findings.faults) fmt::print("fault: {}\n", line);
        for (const std::string& line : findings.warnings) fmt::print("warning: {}\n", line);
    }
    if (!findings.faults.empty())
        return failure("{}: {} of its images cannot be decoded",
                       quoted_for_message(options.input.string()), findings.faults.size());
    if (!options.json && findings.warnings.empty())
        fmt::print("{}: nothing to report\n", quoted_for_message(options.input.string()));
    return {};
}

}  // namespace

void add_check(CLI::App& app, Command& chosen) {
    auto* command = app.add_subcommand("check", "Read and decode everything; report what is wrong");
    command->footer(kCheckFooter);
    auto options = std::make_shared<CheckOptions>();
    command->add_option("IN", options->input, "A .gltf or .glb file")->required()->type_name("");
    command->add_flag("--json", options->json, "Report as JSON");
    command->callback([options, &chosen] { chosen = [options] { return run_check(*options); }; });
}

}  // namespace patina::cli
