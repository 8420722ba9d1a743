// SPDX-License-Identifier: MIT
#pragma once

/// Pictures of several channels in one, in rows, each with its name.

#include <nlohmann/json_fwd.hpp>
#include <span>

#include "cli/lettering.h"
#include "render/channel_view.h"
#include "render/renderer.h"

namespace patina::cli {

/// Ten channels fit in a row, as the editor has them; more stand in a square.
int columns_for(std::size_t channels);

struct ContactSheet {
    std::span<const render::ChannelView> channels;
    render::PictureSize cell;
    int columns = 1;

    /// Of the whole sheet.
    render::PictureSize size() const;
    /// Where the picture of a channel lies.
    TexelBox place(int index) const;
    /// Without pictures yet. A sheet that is too large for one is a failure that says so.
    Result<Image> blank(SampleType type) const;
};

/// Puts the picture of a channel into its place.
/// @param lettering  null: without the channel's name
void put_cell(Image& image, const ContactSheet& sheet, int index, const Image& picture,
              const Lettering* lettering);

/// For each channel its id, its name and its place, as an array.
nlohmann::ordered_json to_json(const ContactSheet& sheet);

}  // namespace patina::cli
