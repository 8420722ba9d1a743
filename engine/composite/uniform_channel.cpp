// SPDX-License-Identifier: MIT
#include "composite/uniform_channel.h"

#include "composite/tile_runner.h"
#include "composite/uniform_values.h"

namespace patina {

glm::vec3 uniform_channel(const ProgramData& program, Channel channel) {
    BoundImages no_images;
    no_images.sources.resize(program.sources.size());
    TilePlanes planes(program.depths);
    const TileRun run{.program = &program, .images = &no_images, .wanted = channel_bit(channel)};
    TileRunner(run, planes).run({.x = 0, .y = 0, .count = 1, .size = 1});
    glm::vec3 value(0.0f);
    for (int k = 0; k < component_count(channel); ++k) value[k] = planes.channel(0, channel, k)[0];
    return (program.top_encoded & channel_bit(channel)) != 0 ? linear_color(value) : value;
}

}  // namespace patina
