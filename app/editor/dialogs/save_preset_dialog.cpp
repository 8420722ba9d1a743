// SPDX-License-Identifier: MIT
#include "editor/dialogs/save_preset_dialog.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "editor/dialogs/modal.h"
#include "editor/widgets/buttons.h"
#include "editor/widgets/form.h"
#include "editor/widgets/text_field.h"

namespace patina::editor {

void SavePresetDialog::open(SavePreset wanted) {
    if (!wanted_.author.empty()) wanted.author = wanted_.author;
    if (!wanted_.licence.empty()) wanted.licence = wanted_.licence;
    wanted_ = std::move(wanted);
    open_ = focus_name_ = true;
}

/// True when Enter was pressed in one of them.
bool SavePresetDialog::draw_fields(Ui& ui, Rect& rest) {
    const bool focus = std::exchange(focus_name_, false);
    bool entered = false;
    const auto field = [&](std::string_view label, std::string& words, bool first = false) {
        Rect row = next_line(ui, rest);
        text(ui, row.cut_left(ui.px(96)), ui.fonts.value12, theme::kText2, label);
        entered = line_field(ui, row, label, words, first && focus) || entered;
    };
    field("Name", wanted_.name, true);
    field("Category", wanted_.category);
    field("Author", wanted_.author);
    field("Licence", wanted_.licence);
    field("Description", wanted_.description);
    return entered;
}

std::optional<SavePreset> SavePresetDialog::draw(Ui& ui, const Shown& shown) {
    if (!open_) return std::nullopt;
    const Modal modal(ui, {"Save as preset", 460, 288}, [this] { return open_; });
    Rect rest = modal.content().inset(ui.px(20), ui.px(16));
    text(ui, rest.cut_top(ui.px(24)), ui.fonts.name15, theme::kText,
         wanted_.whole_material ? "Save the material as a preset" : "Save the layer as a preset");
    rest.cut_top(ui.px(8));
    const bool entered = draw_fields(ui, rest);
    Rect buttons = rest.cut_bottom(ui.px(26));
    const bool complete = !wanted_.name.empty() && !wanted_.category.empty() &&
                          !wanted_.author.empty() && !wanted_.licence.empty() &&
                          !wanted_.description.empty();
    const bool known =
        std::any_of(shown.presets.begin(), shown.presets.end(),
                    [&](const Preset* preset) { return preset->name == wanted_.name; });
    rest.cut_top(ui.px(4));
    paragraph(ui, rest, ui.fonts.caption11, theme::kText3,
              !complete ? "Every line has to say something"
              : known   ? "There is a preset of this name: if it is your own, it is replaced"
                        : "It goes into your own folder and appears in the shelf");
    std::optional<SavePreset> chosen;
    if (dialog_button(ui, buttons, {.label = "Save", .main = true, .enabled = complete}) ||
        (entered && complete))
        chosen = wanted_;
    const bool cancelled = dialog_button(ui, buttons, {.label = "Cancel"});
    if (chosen || cancelled || modal.dismissed()) open_ = false;
    return chosen;
}

}  // namespace patina::editor
