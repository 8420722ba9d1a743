// SPDX-License-Identifier: MIT
#include "cli/map_options.h"

#include "cli/arguments.h"

namespace patina::cli {

void add_map_options(CLI::App& app, io::MapExportOptions& options) {
    add_choice_option(
        app, "--map-format", io::kImageFormats,
        [&options](const io::ImageFormatInfo& entry) { options.format = entry.format; },
        "The format of those files")
        ->default_str("png");
    app.add_option("--bits", options.bits,
                   "Bits a channel: png 8 or 16, tif 8, 16 or 32, exr 16 or 32; 32 are floats\n"
                   "[8, exr 16]")
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
