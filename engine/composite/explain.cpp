// SPDX-License-Identifier: MIT
#include "composite/compile.h"
#include "composite/composite.h"
#include "composite/composite_rect.h"
#include "composite/tile_runner.h"
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
            .result = value_of(result, operation.channel, encoded),
            .coverage = operation.depth > 0 ? planes.coverage(operation.depth, operation.channel)[0]
                                            : 1.0f};
}

/// The normal of one texel as the bake has it, bent by the heights.
glm::vec3 baked_normal(const ProgramData& program, const BoundImages& images, int size,
                       const TexelRect& texel) {
    glm::vec3 normal(0.0f);
    composite_tiles({.program = &program,
                     .images = &images,
                     .wanted = channel_bit(Channel::Normal),
                     .size = size,
                     .rect = texel},
                    [&](const TileSpan&, TilePlanes& planes) {
                        for (int k = 0; k < 3; ++k)
                            normal[k] = planes.channel(0, Channel::Normal, k)[0];
                    },
                    {});
    return normal;
}

/// The step from what the layers say of the normal to what is baked.
ExplainStep step_from_height(const ProgramData& program, const BoundImages& images, int size,
                             const TexelRect& texel) {
    ProgramData heights = program;
    for (Operation& operation : heights.operations)
        operation.channels &= static_cast<ChannelBits>(~channel_bit(Channel::Normal));
    return {.layer = {},
            .layer_name = "from height",
            .mode = BlendMode::NormalRnm,
            .source = baked_normal(heights, images, size, texel),
            .weight = 1.0f,
            .result = baked_normal(program, images, size, texel)};
}

}  // namespace

Result<std::vector<ExplainStep>> explain_texel(const Material& material,
                                               const UvSurfacePtr& surface, ImageProvider& images,
                                               Channel channel, int size, int x, int y) {
    if (size < 1 || x < 0 || y < 0 || x >= size || y >= size)
        return failure("texel ({}, {}) is not in a map of {} texels a side", x, y, size);
    const ProgramData program = compile_material(material, surface, CoveredLayers::Keep);
    const bool bent =
        channel == Channel::Normal && (program.touched & channel_bit(Channel::Height)) != 0;
    ChannelBits read = channel_bit(channel);
    if (bent) read |= channel_bit(Channel::Height);
    ReducedImages reduced;
    const BoundImages bound = bind_images(program, read, size, images, reduced);
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
    TileRunner(run, planes).run({.x = x, .y = y, .count = 1, .size = size});
    if (bent) steps.push_back(step_from_height(program, bound, size, {x, y, x + 1, y + 1}));
    return steps;
}

}  // namespace patina
