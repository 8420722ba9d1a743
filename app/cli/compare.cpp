// SPDX-License-Identifier: MIT
// patina compare: what differs between two files, in words and in the numbers of their maps.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/input.h"
#include "cli/progress_bar.h"
#include "composite/bake_channels.h"
#include "core/json.h"
#include "document/difference.h"

namespace patina::cli {
namespace {

constexpr const char* kCompareFooter =
    "Materials and layers are matched by their names. Both are baked at the same size, and every\n"
    "channel is compared texel by texel: colours in linear light, 1 is the whole range.\n"
    "\n"
    "Examples:\n"
    "  patina compare before.glb after.glb\n"
    "  patina compare before.glb after.glb --size 2048 --json";

struct CompareOptions {
    std::filesystem::path before;
    std::filesystem::path after;
    int size = 512;
    WorkOptions work;
};

/// How far a channel of a material is from the other's.
struct ChannelDistance {
    std::string material;
    Channel channel;
    double mean = 0.0;     ///< of the absolute difference, over all texels and components
    double largest = 0.0;  ///< of it
    double share = 0.0;    ///< of texels that differ by more than 1/255, 0 to 1
};

/// What is said of the maps of materials that both files have.
struct MapComparison {
    std::size_t materials = 0;                    ///< that both have
    std::vector<ChannelDistance> distances = {};  ///< of channels that differ
};

std::vector<Channel> all_channels() {
    std::vector<Channel> channels;
    for (const ChannelInfo& entry : kChannels) channels.push_back(entry.channel);
    return channels;
}

ChannelDistance distance(const std::string& material, Channel channel, const ChannelPlanes& before,
                         const ChannelPlanes& after) {
    ChannelDistance result{.material = material, .channel = channel};
    const auto index = static_cast<std::size_t>(channel);
    const std::size_t texels = before.planes[index][0].size();
    std::size_t differing = 0;
    std::size_t components = 0;
    double sum = 0.0;
    std::vector<bool> differs(texels, false);
    for (std::size_t k = 0; k < 3 && !before.planes[index][k].empty(); ++k, ++components)
        for (std::size_t i = 0; i < texels; ++i) {
            const double apart = std::abs(static_cast<double>(after.planes[index][k][i]) -
                                          static_cast<double>(before.planes[index][k][i]));
            sum += apart;
            result.largest = std::max(result.largest, apart);
            if (apart <= 1.0 / 255.0 || differs[i]) continue;
            differs[i] = true;
            ++differing;
        }
    result.mean = sum / static_cast<double>(std::max<std::size_t>(texels * components, 1));
    result.share = static_cast<double>(differing) / static_cast<double>(texels);
    return result;
}

Result<MapComparison> compare_maps(const io::LoadedDocument& before,
                                   const io::LoadedDocument& after, int size,
                                   const Progress& progress) {
    MapComparison compared;
    for (const MaterialPtr& material : after.document->materials) {
        const auto& others = before.document->materials;
        const auto other = std::find_if(others.begin(), others.end(), [&](const MaterialPtr& m) {
            return m->name == material->name;
        });
        if (other == others.end()) continue;
        ++compared.materials;
        progress.set_stage(fmt::format("Baking {}", quoted_for_message(material->name, 60)));
        const auto old_planes = bake_channels(Program::compile(*before.document, **other),
                                              *before.images, size, all_channels());
        if (!old_planes) return passed_on(old_planes);
        const auto new_planes = bake_channels(Program::compile(*after.document, *material),
                                              *after.images, size, all_channels());
        if (!new_planes) return passed_on(new_planes);
        for (const Channel channel : all_channels()) {
            const auto found = distance(material->name, channel, *old_planes, *new_planes);
            if (found.largest > 0.0) compared.distances.push_back(found);
        }
    }
    return compared;
}

void print(const std::vector<Difference>& differences, const MapComparison& maps, int size) {
    for (const Difference& difference : differences) {
        std::string place = difference.material.empty() ? "scene" : difference.material;
        if (!difference.layer.empty()) place += " / " + difference.layer;
        fmt::print("{}: {}\n", quoted_for_message(place, 200), difference.what);
    }
    if (differences.empty()) fmt::print("the documents say the same\n");
    if (maps.materials == 0) {
        fmt::print("no material is in both files by its name: there are no maps to compare\n");
        return;
    }
    if (maps.distances.empty()) {
        fmt::print("the maps are the same, baked at {0} x {0}\n", size);
        return;
    }
    fmt::print("\nmaps baked at {0} x {0}:\n{1:<28} {2:<11} {3:>9} {4:>9} {5:>22}\n", size,
               "material", "channel", "mean", "largest", "texels over 1/255");
    for (const ChannelDistance& found : maps.distances)
        fmt::print("{:<28} {:<11} {:>9.5f} {:>9.5f} {:>21.2f}%\n",
                   quoted_for_message(found.material, 27), info(found.channel).id, found.mean,
                   found.largest, 100.0 * found.share);
}

Json to_json(const std::vector<Difference>& differences, const MapComparison& maps, int size) {
    Json json = {{"equal", differences.empty() && maps.distances.empty()},
                 {"size", size},
                 {"materials_compared", maps.materials},
                 {"differences", Json::array()},
                 {"maps", Json::array()}};
    for (const Difference& difference : differences)
        json["differences"].push_back({{"material", difference.material},
                                       {"layer", difference.layer},
                                       {"what", difference.what}});
    for (const ChannelDistance& found : maps.distances)
        json["maps"].push_back({{"material", found.material},
                                {"channel", info(found.channel).id},
                                {"mean", found.mean},
                                {"largest", found.largest},
                                {"share_over_1_255", found.share}});
    return json;
}

Status run_compare(const CompareOptions& options) {
    const ThreadScope threads(options.work);
    const Progress progress;
    std::vector<Difference> found;
    Result<MapComparison> maps;
    {
        const ProgressBar bar(progress, !options.work.quiet);
        const auto before = opened_document(options.before, progress);
        if (!before) return passed_on(before);
        const auto after = opened_document(options.after, progress);
        if (!after) return passed_on(after);
        found = differences(*before->document, *after->document);
        maps = compare_maps(*before, *after, options.size, progress);
    }
    if (!maps) return passed_on(maps);
    if (options.work.json)
        fmt::print("{}\n", to_json(found, *maps, options.size).dump(2));
    else if (!options.work.quiet)
        print(found, *maps, options.size);
    return {};
}

}  // namespace

void add_compare(CLI::App& app, Command& chosen) {
    auto* command = app.add_subcommand(
        "compare", "Say what differs between two files, in words and in their maps' numbers");
    command->footer(kCompareFooter);
    auto options = std::make_shared<CompareOptions>();
    command->add_option("BEFORE", options->before, "A .gltf or .glb file")
        ->required()
        ->type_name("");
    command->add_option("AFTER", options->after, "The other one")->required()->type_name("");
    command->add_option("--size", options->size, "Side of the maps that are compared")
        ->check(CLI::Range(1, 8192))
        ->type_name("N")
        ->capture_default_str();
    add_work_options(*command, options->work);
    command->callback([options, &chosen] { chosen = [options] { return run_compare(*options); }; });
}

}  // namespace patina::cli
