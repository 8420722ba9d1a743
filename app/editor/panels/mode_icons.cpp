// SPDX-License-Identifier: MIT
#include "editor/panels/mode_icons.h"

namespace patina::editor {
namespace {

/// Draws in the icon's own coordinates, 16 x 14.
class Sketch {
  public:
    Sketch(const Ui& ui, const Rect& box) : ui_(ui), box_(box) {}
    Rect at(float x, float y, float w, float h) const {
        const float s = ui_.scale;
        return {box_.x0 + x * s, box_.y0 + y * s, box_.x0 + (x + w) * s, box_.y0 + (y + h) * s};
    }

  private:
    const Ui& ui_;
    Rect box_;
};

}  // namespace

void draw_mode_icon(const Ui& ui, const Rect& rect, render::CompareMode mode, ImU32 color) {
    const Sketch sketch(ui, rect.centered(ui.px(16), ui.px(14)));
    constexpr float kStroke = 1.4f;
    switch (mode) {
        case render::CompareMode::Single:
            outline(ui, sketch.at(1, 1, 14, 12), color, 2, kStroke);
            return;
        case render::CompareMode::Split:
            outline(ui, sketch.at(1, 1, 14, 12), color, 2, kStroke);
            fill(ui, sketch.at(8, 1, 7, 12), color, 1);
            return;
        case render::CompareMode::TwoViews:
            outline(ui, sketch.at(0.7f, 1, 6.3f, 12), color, 1.5f, kStroke);
            outline(ui, sketch.at(9, 1, 6.3f, 12), color, 1.5f, kStroke);
            return;
        case render::CompareMode::Difference:
            outline(ui, sketch.at(1, 1, 9, 8), color, 1.5f, kStroke);
            outline(ui, sketch.at(6, 5, 9, 8), color, 1.5f, kStroke);
            fill(ui, sketch.at(6, 5, 4, 4), color);
            return;
    }
}

}  // namespace patina::editor
