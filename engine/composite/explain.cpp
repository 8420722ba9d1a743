// SPDX-License-Identifier: MIT
#include "composite/compile.h"
#include "composite/composite.h"
#include "composite/run_tile.h"
#include "composite/uniform_values.h"

namespace patina {
namespace {

/// The first texel of planes, with colours taken to linear light.
glm::vec3 value_of(const ReadPlane* planes, Channel channel, bool encoded) {
    glm::vec3 value(0.0f);
    for (int k = 0; k < component_count(channel); ++k) value[k] = planes[k].data[0];
    return encoded ? linear_color(value) : value;
}

ExplainStep step_of(const ProgramData& program, const Operation& operation,
                    const FetchedSource& source, TilePlanes& planes) {
    const LayerRecord& layer = program.layers[static_cast<std::size_t>(operation.layer)];
    const bool encoded = (operation.flags & kEncoded) != 0;
    ReadPlane result[3];
    for (int k = 0; k < component_count(operation.channel); ++k)
        result[k] = {.data = planes.channel(operation.depth, operation.channel, k)};
    return {.layer = layer.id,
            .layer_name = layer.name,
            .depth = layer.depth,
            .mode = operation.mode,
            .source = value_of(source.components, operation.channel, encoded),
            .result = value_of(result, operation.channel, encoded)};
}

}  // namespace

Result<std::vector<ExplainStep>> explain_texel(const Material& material,
                                               const UvSurfacePtr& surface, ImageProvider& images,
                                               Channel channel, int size, int x, int y) {
    if (size < 1 || x < 0 || y < 0 || x >= size || y >= size)
        return failure("texel ({}, {}) is not in a map of {} texels a side", x, y, size);
    const ProgramData program = compile_material(material, surface, CoveredLayers::Keep);
    ReducedImages reduced;
    const BoundImages bound =
        bind_images(program, channel_bit(channel), size, images, MissingImages::Wait, reduced);
    if (!bound.failures.empty()) return failure("{}", bound.failures.front());

    std::vector<ExplainStep> steps;
    AroundPass around({.program = &program,
                       .images = &bound,
                       .wanted = channel_bit(channel),
                       .size = size,
                       .rect = {x, y, x + 1, y + 1}});
    around.move_to(y, y + 1, {});
    TilePlanes planes(program.depths);
    const TileRun run{.program = &program,
                      .images = &bound,
                      .wanted = program.with_needed(channel_bit(channel)),
                      .observer =
                          [&](const Operation& operation, const FetchedSource& source, float weight,
                              float mask, TilePlanes& tile) {
                              if (operation.channel != channel) return;
                              steps.push_back(step_of(program, operation, source, tile));
                              steps.back().weight = weight;
                              steps.back().mask = mask;
                          },
                      .around = &around.list()};
    run_tile(run, {.x = x, .y = y, .count = 1, .size = size}, planes);
    return steps;
}

}  // namespace patina
