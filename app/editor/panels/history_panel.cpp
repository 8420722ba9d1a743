// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "editor/panels/panels.h"
#include "editor/widgets/buttons.h"
#include "editor/widgets/number_text.h"

namespace patina::editor {
namespace {

Requests draw_steps(Ui& ui, const Rect& rect, const HistoryShown& history) {
    Requests requests;
    if (history.labels.size() <= 1) {
        text(ui, rect.inset(ui.px(12), 0), ui.fonts.caption11, theme::kText3,
             "Nothing to undo yet");
        return requests;
    }
    ScrollArea area(ui, "steps", rect);
    Rect row = area.content();
    row.y1 = row.y0 + ui.px(theme::kHistoryRow);
    for (std::size_t i = 0; i < history.labels.size(); ++i) {
        const int position = static_cast<int>(i);
        const bool current = position == history.position;
        const bool undone = position > history.position;
        const Place place(ui, history.labels[i], i + 1);
        const Press pressed = press(ui, row,
                                    {.label = history.labels[i],
                                     .kind = "row",
                                     .value = current  ? "current"
                                              : undone ? "undone"
                                                       : "done"});
        if (current || pressed.hovered) fill(ui, row, theme::kRowHover);
        const float x = row.x0 + ui.px(15);
        if (undone)
            ring(ui, x, row.center_y(), 2.5f, theme::kDot, 1);
        else
            disc(ui, x, row.center_y(), 3, current ? theme::kAccent : theme::kDot);
        Rect words = row;
        words.cut_left(ui.px(26));
        words.cut_right(ui.px(8));
        const ImU32 color = current ? theme::kText : undone ? theme::kText3 : theme::kText2;
        text(ui, words, ui.fonts.body13, color, history.labels[i]);
        if (pressed.clicked && !current) requests.ask(JumpToStep{position});
        if (current && !ImGui::IsWindowHovered()) area.reveal(row.y0, row.y1);
        row = row.moved(0, row.height());
    }
    area.set_height(static_cast<float>(history.labels.size()) * row.height());
    return requests;
}

}  // namespace

Requests draw_history_panel(Ui& ui, const Rect& rect, const Shown& shown, ViewState& view) {
    Requests requests;
    if (rect.empty()) return requests;
    const Place place(ui, "History");
    fill(ui, rect, theme::kPanel, 6);
    Rect rest = rect;
    Rect title = rest.cut_top(ui.px(theme::kPanelTitle));
    title.cut_left(ui.px(theme::kPadding));
    title.cut_right(ui.px(14));
    const bool log = view.history_tab == HistoryTab::Log;
    if (tab(ui, title, {"History", !log})) view.history_tab = HistoryTab::History;
    if (tab(ui, title, {"Log", log})) view.history_tab = HistoryTab::Log;
    rest.cut_bottom(ui.px(6));
    if (log) {
        draw_log_lines(ui, rest, shown.log);
        return requests;
    }
    const std::size_t steps = shown.history.labels.empty() ? 0 : shown.history.labels.size() - 1;
    if (steps > 0)
        text(ui, title, ui.fonts.caption11, theme::kText3,
             fmt::format("{} \u00b7 {}", counted(steps, "step"), megabytes(shown.history.bytes)),
             Align::Right);
    Rect first = rest;
    if (steps == 0) first = rest.cut_top(ui.px(theme::kHistoryRow));
    requests.append(draw_steps(ui, first, shown.history));
    return requests;
}

}  // namespace patina::editor
