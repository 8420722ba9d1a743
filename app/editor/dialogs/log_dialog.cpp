// SPDX-License-Identifier: MIT
#include "editor/dialogs/log_dialog.h"

#include "editor/dialogs/modal.h"
#include "editor/widgets/buttons.h"
#include "editor/widgets/log_lines.h"

namespace patina::editor {

void LogDialog::draw(Ui& ui, std::span<const LogLine> log) {
    if (!open_) return;
    const Modal modal(ui, {"Log", 640, 420}, [this] { return open_; });
    Rect rest = modal.content().inset(ui.px(20), ui.px(16));
    text(ui, rest.cut_top(ui.px(24)), ui.fonts.name15, theme::kText, "Log");
    rest.cut_top(ui.px(8));
    Rect buttons = rest.cut_bottom(ui.px(26));
    rest.cut_bottom(ui.px(12));
    fill(ui, rest, theme::kPanel, 4);
    draw_log_lines(ui, rest.inset(0, ui.px(8)), log);
    if (dialog_button(ui, buttons, {.label = "Close", .main = true}) || modal.dismissed())
        open_ = false;
    if (!dialog_button(ui, buttons, {.label = "Copy", .enabled = !log.empty()})) return;
    std::string all;
    for (const LogLine& each : log) all += each.text + '\n';
    ImGui::SetClipboardText(all.c_str());
}

}  // namespace patina::editor
