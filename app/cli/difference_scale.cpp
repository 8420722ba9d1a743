// SPDX-License-Identifier: MIT
#include "cli/difference_scale.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/formulae/formulae.h"

namespace patina::cli {
namespace {

void draw_heat(Image& picture, const TexelBox& box) {
    const float steps = static_cast<float>(std::max(box.x1 - box.x0 - 1, 1));
    for (int x = box.x0; x < box.x1; ++x) {
        const formulae::Real3 heat =
            formulae::heat_map_inferno(static_cast<float>(x - box.x0) / steps);
        lay_over(picture, {x, box.y0, x + 1, box.y1}, {heat.x, heat.y, heat.z, 1.0f});
    }
}

}  // namespace

void draw_difference_scale(Image& picture, float range, const Lettering& lettering) {
    const int em = lettering.em_pixels();
    const int margin = em / 2;
    const std::string title = "Difference in luminance";
    const std::string most = fmt::format("{:g} and above", range);
    const int width = std::max(lettering.width(title), lettering.width("0" + most) + 2 * em);
    // From the bottom: numbers, the colours, the title.
    const TexelBox plate{0, picture.height - 4 * em - 2 * margin, width + 2 * margin,
                         picture.height};
    lay_over(picture, plate, kPlateColor);
    const int left = plate.x0 + margin;
    const int numbers_y = plate.y1 - margin - em / 4;
    lettering.draw(picture, {left, plate.y0 + margin + em}, title, plate);
    draw_heat(picture, {left, numbers_y - 2 * em - em / 4, left + width, numbers_y - em - em / 4});
    lettering.draw(picture, {left, numbers_y}, "0", plate);
    lettering.draw(picture, {left + width - lettering.width(most), numbers_y}, most, plate);
}

}  // namespace patina::cli
