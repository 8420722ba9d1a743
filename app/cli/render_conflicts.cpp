// SPDX-License-Identifier: MIT
#include "cli/render_conflicts.h"

#include <array>

#include "io/image_file.h"

namespace patina::cli {
namespace {

struct Rule {
    bool broken;
    std::string_view words;
};

template <std::size_t N>
std::string_view first_broken(const std::array<Rule, N>& rules) {
    for (const Rule& rule : rules)
        if (rule.broken) return rule.words;
    return {};
}

/// Of several channels in one picture.
std::string_view sheet_conflict(const RenderOptions& options) {
    const bool sheet = options.channels.size() > 1;
    const render::CompareMode compare = options.request.view.compare;
    return first_broken(std::array{
        Rule{sheet && options.turntable.has_value(),
             "--turntable takes one channel: name one with --channel"},
        Rule{sheet && compare != render::CompareMode::Single &&
                 compare != render::CompareMode::Split,
             "several channels can be --split, but not shown as two views or as a difference"},
        Rule{!sheet && options.columns.has_value(),
             "--columns is of several channels: add --channel all, strip or a list"},
    });
}

/// Of linear radiance and raw numbers.
std::string_view exr_conflict(const CLI::App& command, const RenderOptions& options) {
    const bool exr = io::image_format_of(options.output) == io::ImageFormat::Exr;
    return first_broken(std::array{
        Rule{exr && options.channels.size() > 1,
             "an .exr holds the raw numbers of one channel: name one with --channel, or write a "
             ".png"},
        Rule{exr && command.count("--wires") > 0,
             "--wires are no light: an .exr has none, write a .png"},
        Rule{exr && command.count("--bits") > 0,
             "--bits is of a .png or .tif: an .exr holds 32-bit floats"},
    });
}

std::string_view side_conflict(const CLI::App& command, const RenderOptions& options) {
    const auto given = [&](const char* flag) { return command.count(flag) > 0; };
    const render::View& view = options.request.view;
    const bool compares = view.compare != render::CompareMode::Single;
    const bool of_right = given("--against") || given("--against-path") || given("--against-terms");
    const bool other_kind =
        given("--shading") && command.get_option("--shading")->as<std::string>() != "split";
    return first_broken(std::array{
        Rule{given("--split") && other_kind,
             "--split X is --shading split: leave out the other --shading, or name the left side "
             "with --left"},
        Rule{given("--split") && given("--divider"), "--split X says where the divider is"},
        Rule{given("--divider") && view.compare != render::CompareMode::Split,
             "--divider is of a split: add --shading split"},
        Rule{of_right && !compares,
             "there is no right side to set with --against: add --split X, or --shading split, "
             "two-views or difference"},
        Rule{given("--left") && !compares,
             "--left is the left side of a comparison: how a single picture is lit says --shading"},
        Rule{options.against_terms && view.right.model != render::ShadingModel::Pbr,
             "--against-terms are of PBR, which --against says the right side is not"},
    });
}

std::string_view difference_conflict(const CLI::App& command, const RenderOptions& options) {
    const render::View& view = options.request.view;
    const bool difference = view.compare == render::CompareMode::Difference;
    const bool lit = render::info(view.channel).origin == render::ChannelOrigin::Lighting;
    return first_broken(std::array{
        Rule{difference && !lit,
             "a difference of that channel is nothing anywhere: both sides shade the same surface; "
             "leave out --channel, or name one of light such as specular-direct"},
        Rule{!difference && command.count("--difference-range") > 0,
             "--difference-range is of a heat map: add --shading difference"},
    });
}

}  // namespace

std::string_view conflict_in(const CLI::App& command, const RenderOptions& options) {
    for (const std::string_view conflict :
         {sheet_conflict(options), exr_conflict(command, options), side_conflict(command, options),
          difference_conflict(command, options)})
        if (!conflict.empty()) return conflict;
    return {};
}

}  // namespace patina::cli
