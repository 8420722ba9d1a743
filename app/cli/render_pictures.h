// SPDX-License-Identifier: MIT
#pragma once

/// The pictures that `patina render` is asked for.

#include "cli/contact_sheet.h"
#include "cli/render_options.h"
#include "core/progress.h"

namespace patina::cli {

/// How several channels lie in one picture; nothing where one alone is drawn. Refers to `options`.
std::optional<ContactSheet> sheet_of(const RenderOptions& options);

/// Whether heat in the picture stands for a difference.
bool is_heat_map(const RenderOptions& options);

/// Draws what was asked for, and hands each picture to `each`.
Status draw_pictures(const RenderOptions& options, const render::EachPicture& each,
                     const Progress& progress);

}  // namespace patina::cli
