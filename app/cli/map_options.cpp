// SPDX-License-Identifier: MIT
#include "cli/map_options.h"

#include "cli/arguments.h"

namespace patina::cli {
namespace {

std::string joined_ids(std::string_view between) {
    std::vector<std::string_view> ids;
    for (const io::ImageFormatInfo& entry : io::kImageFormats) ids.push_back(entry.id);
    return fmt::format("{}", fmt::join(ids, between));
}

/// "jpg" or "base-color=jpg".
void read_map_format(const std::string& text, io::MapExportOptions& options) {
    const std::size_t equals = text.find('=');
    const bool of_one = equals != std::string::npos;
    const auto format = io::image_format_from_id(of_one ? text.substr(equals + 1) : text);
    if (!format)
        throw CLI::ValidationError(
            "--map-format",
            fmt::format("'{}' is none of {}, nor a map and one such as base-color=jpg", text,
                        joined_ids(", ")));
    if (of_one)
        options.format_of_map[text.substr(0, equals)] = *format;
    else
        options.format = *format;
}

}  // namespace

void add_map_options(CLI::App& app, io::MapExportOptions& options) {
    app.add_option_function<std::vector<std::string>>(
           "--map-format",
           [&options](const std::vector<std::string>& texts) {
               for (const std::string& text : texts) read_map_format(text, options);
           },
           "The format of those files, or of one of them: MAP=FORMAT, as in base-color=jpg;\n"
           "may be given several times. Normals stay png unless normal=jpg asks for them")
        ->allow_extra_args(false)
        ->type_name(joined_ids("|"))
        ->default_str("png");
    app.add_option("--jpg-quality", options.jpeg_quality, "Of the jpg files among them, 1 to 100")
        ->check(CLI::Range(1, 100))
        ->type_name("N")
        ->capture_default_str();
    app.add_option("--png-level", options.png_level,
                   "How hard png files are compressed, those in a glTF file too: 1 is fastest")
        ->check(CLI::IsMember({1, 2, 3}))
        ->type_name("1|2|3")
        ->capture_default_str();
    app.add_option("--bits", options.bits,
                   "Bits a channel: png 8 or 16, tif 8, 16 or 32, exr 16 or 32, jpg 8; 32 are\n"
                   "floats [8, exr 16]")
        ->check(CLI::IsMember({8, 16, 32}))
        ->type_name("8|16|32");
    static const std::span<const io::MapPacking> kPackings = io::map_packings();
    std::string help = "What goes into which file:";
    for (const io::MapPacking& packing : kPackings)
        help += fmt::format("\n  {:<11} {}", packing.id, packing.description);
    add_choice_option(
        app, "--packing", kPackings,
        [&options](const io::MapPacking& packing) { options.packing = &packing; }, help)
        ->default_str("gltf");
}

void add_map_size_option(CLI::App& app, std::optional<int>& size) {
    app.add_option("--size", size,
                   "Side of the baked maps, 1 to 16384; as each material says if unset")
        ->check(CLI::Range(1, 16384))
        ->type_name("N");
}

}  // namespace patina::cli
