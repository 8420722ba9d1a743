// SPDX-License-Identifier: MIT
#include "editor/widgets/log_lines.h"

namespace patina::editor {

void draw_log_lines(Ui& ui, const Rect& rect, std::span<const LogLine> log) {
    if (log.empty()) {
        const Rect row{rect.x0, rect.y0, rect.x1, rect.y0 + ui.px(theme::kHistoryRow)};
        text(ui, row.inset(ui.px(12), 0), ui.fonts.caption11, theme::kText3, "Nothing to report");
        return;
    }
    ScrollArea area(ui, "log", rect);
    const Rect row = area.content().inset(ui.px(12), 0);
    float height = 0.0f;
    for (auto each = log.rbegin(); each != log.rend(); ++each) {
        const ImU32 color = each->is_warning ? theme::kWarning : theme::kText2;
        const Rect place = row.moved(0, height);
        const float used = paragraph(ui, place, ui.fonts.caption11, color, each->text);
        ui.map.add(each->text, "log line", each->is_warning ? "warning" : "",
                   visible_part({place.x0, place.y0, place.x1, place.y0 + used}), true);
        height += used + ui.px(4);
    }
    area.set_height(height);
}

}  // namespace patina::editor
