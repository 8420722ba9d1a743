// SPDX-License-Identifier: MIT
#include "cli/contact_sheet.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace patina::cli {
namespace {

constexpr std::size_t kMostInOneRow = render::kStripChannelCount;

const render::ChannelViewInfo& info_of(const ContactSheet& sheet, int index) {
    return render::info(sheet.channels[static_cast<std::size_t>(index)]);
}

int count_of(const ContactSheet& sheet) {
    return static_cast<int>(sheet.channels.size());
}

}  // namespace

int columns_for(std::size_t channels) {
    if (channels <= kMostInOneRow) return static_cast<int>(channels);
    return static_cast<int>(std::ceil(std::sqrt(static_cast<double>(channels))));
}

render::PictureSize ContactSheet::size() const {
    const int rows = (count_of(*this) + columns - 1) / columns;
    return {columns * cell.width, rows * cell.height};
}

TexelBox ContactSheet::place(int index) const {
    const int x = index % columns * cell.width;
    const int y = index / columns * cell.height;
    return {x, y, x + cell.width, y + cell.height};
}

Result<Image> ContactSheet::blank(SampleType type) const {
    const auto [width, height] = size();
    if (width > render::kMaxPictureSide || height > render::kMaxPictureSide)
        return failure(
            "{} channels of {}x{} in {} columns make a picture of {}x{}, and {} a side "
            "is the most: give a smaller --size or other --columns",
            count_of(*this), cell.width, cell.height, columns, width, height,
            render::kMaxPictureSide);
    Image image{.width = width, .height = height, .channels = 4, .type = type, .data = {}};
    image.data.assign(image.row_bytes() * static_cast<std::size_t>(height), std::byte{0});
    return image;
}

void put_cell(Image& image, const ContactSheet& sheet, int index, const Image& picture,
              const Lettering* lettering) {
    const TexelBox place = sheet.place(index);
    put(image, place.x0, place.y0, picture);
    if (lettering != nullptr) draw_plate(image, place, info_of(sheet, index).label, *lettering);
}

nlohmann::ordered_json to_json(const ContactSheet& sheet) {
    nlohmann::ordered_json cells = nlohmann::ordered_json::array();
    for (int i = 0; i < count_of(sheet); ++i)
        cells.push_back({{"channel", info_of(sheet, i).id},
                         {"label", info_of(sheet, i).label},
                         {"x", sheet.place(i).x0},
                         {"y", sheet.place(i).y0}});
    return cells;
}

}  // namespace patina::cli
