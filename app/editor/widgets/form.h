// SPDX-License-Identifier: MIT
#pragma once

/// Fields in lines: one under the other, equal ones side by side.

#include <array>
#include <cmath>
#include <cstddef>

#include "editor/widgets/ui.h"

namespace patina::editor {

/// The next field of 24 px, with a gap below, cut off the top of `rest`.
inline Rect next_line(const Ui& ui, Rect& rest) {
    const Rect line_box = rest.cut_top(ui.px(theme::kFieldHeight));
    rest.cut_top(ui.px(theme::kGap));
    return line_box;
}

/// The same, with the panel's margin left free at both sides.
inline Rect padded_line(const Ui& ui, Rect& rest) {
    return next_line(ui, rest).inset(ui.px(12), 0);
}

/// N fields of equal width in one line.
template <std::size_t N>
std::array<Rect, N> side_by_side(const Ui& ui, Rect rect) {
    const float gap = ui.px(theme::kGap);
    const float width =
        std::floor((rect.width() - gap * static_cast<float>(N - 1)) / static_cast<float>(N));
    std::array<Rect, N> result;
    for (std::size_t i = 0; i < N; ++i) {
        result[i] = i + 1 == N ? rect : rect.cut_left(width);
        if (i + 1 < N) rect.cut_left(gap);
    }
    return result;
}

}  // namespace patina::editor
