// SPDX-License-Identifier: MIT
#include "editor/dialogs/question.h"

#include <array>
#include <utility>

#include "editor/dialogs/modal.h"
#include "editor/widgets/buttons.h"

namespace patina::editor {
namespace {

struct KeyRow {
    std::string_view key;
    std::string_view what;
};

constexpr std::array kKeys = {
    KeyRow{"Ctrl O, S, Shift S", "Open, save, save as"},
    KeyRow{"Ctrl Z, Shift Z", "Undo, redo"},
    KeyRow{"Ctrl K", "Find an action"},
    KeyRow{"Ctrl E", "Export maps"},
    KeyRow{"Ctrl D, G, C, V", "Duplicate, group, copy, paste"},
    KeyRow{"F2, Delete, H", "Rename, delete, hide"},
    KeyRow{"Up, Down; Alt", "Choose; move layer"},
    KeyRow{"Alt-click eye, mask", "Show alone, view mask"},
    KeyRow{"0, 1 to 9", "Final, channels"},
    KeyRow{"C, Shift C", "Next, previous channel"},
    KeyRow{"V, X", "Next compare mode, swap sides"},
    KeyRow{"P, O", "PBR, Phong"},
    KeyRow{"F, Shift F", "Frame the model, the material"},
    KeyRow{"I, U", "Eyedropper, UV"},
    KeyRow{"[ ]", "Exposure by 1/3 EV"},
    KeyRow{"Left, Right", "Move the divider by 1 %"},
    KeyRow{"F10, F1", "Hide panels, this list"},
    KeyRow{"Drag, middle, wheel", "Orbit, pan, zoom"},
    KeyRow{"Shift-drag", "Turn the environment"},
    KeyRow{"Ctrl wheel", "Step a number or a choice"},
};

}  // namespace

void QuestionDialog::draw(Ui& ui) {
    if (!question_) return;
    const Modal modal(ui, {"Question", 440, 150}, [this] { return is_open(); });
    Rect rest = modal.content().inset(ui.px(20), ui.px(16));
    text(ui, rest.cut_top(ui.px(22)), ui.fonts.name15, theme::kText, question_->title);
    rest.cut_top(ui.px(4));
    Rect buttons = rest.cut_bottom(ui.px(26));
    paragraph(ui, rest, ui.fonts.body13, theme::kText2, question_->text);
    std::function<void()> chosen;
    bool answered = false;
    for (const Question::Answer& answer : question_->answers) {
        if (!dialog_button(ui, buttons, {.label = answer.label, .main = answer.main})) continue;
        chosen = answer.chosen;
        answered = true;
    }
    if (answered || modal.dismissed()) question_.reset();
    if (chosen) chosen();
}

void KeysDialog::draw(Ui& ui) {
    if (!open_) return;
    const Modal modal(ui, {"Keys and mouse", 460, 110 + 22 * static_cast<float>(kKeys.size())},
                      [this] { return open_; });
    Rect rest = modal.content().inset(ui.px(20), ui.px(16));
    text(ui, rest.cut_top(ui.px(24)), ui.fonts.name15, theme::kText, "Keys and mouse");
    rest.cut_top(ui.px(8));
    Rect buttons = rest.cut_bottom(ui.px(26));
    for (const KeyRow& row : kKeys) {
        Rect line_box = rest.cut_top(ui.px(22));
        text(ui, line_box.cut_left(ui.px(170)), ui.fonts.medium12, theme::kText, row.key);
        text(ui, line_box, ui.fonts.value12, theme::kText2, row.what);
    }
    if (dialog_button(ui, buttons, {.label = "Close", .main = true}) || modal.dismissed())
        open_ = false;
}

}  // namespace patina::editor
