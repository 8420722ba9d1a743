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
    const bool exr = io::image_format_of(options.output) == io::ImageFormat::Exr;
    const render::CompareMode compare = options.request.view.compare;
    return first_broken(std::array{
        Rule{sheet && options.turntable.has_value(),
             "--turntable takes one channel: name one with --channel"},
        Rule{sheet && exr,
             "an .exr holds the raw numbers of one channel: name one with --channel, or write a "
             ".png"},
        Rule{sheet && compare != render::CompareMode::Single &&
                 compare != render::CompareMode::Split,
             "several channels can be --split, but not shown as two views or as a difference"},
        Rule{!sheet && options.columns.has_value(),
             "--columns is of several channels: add --channel all, strip or a list"},
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
    const std::string_view of_sheet = sheet_conflict(options);
    return of_sheet.empty() ? difference_conflict(command, options) : of_sheet;
}

}  // namespace patina::cli
