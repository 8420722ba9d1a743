// SPDX-License-Identifier: MIT
#pragma once

/// A rectangle in pixels of the window, y down, and cutting it up: panels are laid out by cutting
/// rows and columns off what is left.

#include <algorithm>

namespace patina::editor {

struct Rect {
    float x0 = 0.0f;
    float y0 = 0.0f;
    float x1 = 0.0f;
    float y1 = 0.0f;

    float width() const { return x1 - x0; }
    float height() const { return y1 - y0; }
    float center_x() const { return 0.5f * (x0 + x1); }
    float center_y() const { return 0.5f * (y0 + y1); }
    bool empty() const { return x1 <= x0 || y1 <= y0; }
    bool contains(float x, float y) const { return x >= x0 && x < x1 && y >= y0 && y < y1; }
    bool operator==(const Rect&) const = default;

    /// Takes a piece off one side; what is left stays here.
    Rect cut_left(float amount) {
        const Rect piece{x0, y0, std::min(x0 + amount, x1), y1};
        x0 = piece.x1;
        return piece;
    }
    Rect cut_right(float amount) {
        const Rect piece{std::max(x1 - amount, x0), y0, x1, y1};
        x1 = piece.x0;
        return piece;
    }
    Rect cut_top(float amount) {
        const Rect piece{x0, y0, x1, std::min(y0 + amount, y1)};
        y0 = piece.y1;
        return piece;
    }
    Rect cut_bottom(float amount) {
        const Rect piece{x0, std::max(y1 - amount, y0), x1, y1};
        y1 = piece.y0;
        return piece;
    }
    Rect inset(float x, float y) const { return {x0 + x, y0 + y, x1 - x, y1 - y}; }
    Rect inset(float all) const { return inset(all, all); }
    Rect moved(float x, float y) const { return {x0 + x, y0 + y, x1 + x, y1 + y}; }
    /// A rectangle of that size with the same middle, on whole pixels.
    Rect centered(float w, float h) const {
        const float left = static_cast<float>(static_cast<int>(center_x() - 0.5f * w + 0.5f));
        const float top = static_cast<float>(static_cast<int>(center_y() - 0.5f * h + 0.5f));
        return {left, top, left + w, top + h};
    }
    Rect intersected(const Rect& other) const {
        return {std::max(x0, other.x0), std::max(y0, other.y0), std::min(x1, other.x1),
                std::min(y1, other.y1)};
    }
};

}  // namespace patina::editor
