// SPDX-License-Identifier: MIT
#include "editor/dialogs/preset_dialog.h"

#include <algorithm>

#include "editor/dialogs/modal.h"
#include "editor/widgets/buttons.h"
#include "editor/widgets/form.h"
#include "editor/widgets/slider.h"

namespace patina::editor {
namespace {

constexpr float kBallSide = 132.0f;
constexpr float kHeadHeight = 66.0f;

}  // namespace

void PresetDialog::open(const Preset& preset) {
    preset_ = preset;
    knobs_.clear();
    for (const PresetKnob& knob : preset.knobs) knobs_.push_back({knob.id, knob.value});
    ball_asked_ = ball_shown_ = knobs_;
}

Picture PresetDialog::ball(Thumbnails& thumbnails) {
    Picture newest = thumbnails.preset(*preset_, ball_asked_);
    if (newest.texture == nullptr) return thumbnails.preset(*preset_, ball_shown_);
    ball_shown_ = ball_asked_;
    ball_asked_ = knobs_;
    return newest;
}

void PresetDialog::draw_knobs(Ui& ui, Rect rest) {
    for (std::size_t i = 0; i < knobs_.size(); ++i) {
        const PresetKnob& knob = preset_->knobs[i];
        const NumberSpec spec{.label = knob.name,
                              .shown_label = knob.name,
                              .standard = static_cast<double>(knob.value),
                              .display_scale = 100.0,
                              .decimals = 0,
                              .unit = "%",
                              .tooltip = "0 to 100 %; a right click puts it back"};
        if (const auto value =
                number_field(ui, next_line(ui, rest), spec, static_cast<double>(knobs_[i].value)))
            knobs_[i].value = static_cast<float>(*value);
    }
}

std::optional<ApplyPreset> PresetDialog::draw(Ui& ui, const Shown& shown) {
    if (!preset_) return std::nullopt;
    const float fields = 28.0f * static_cast<float>(knobs_.size());
    const float middle = std::max(kBallSide, kHeadHeight + fields);
    const Modal modal(ui, {"Preset", 520, 32 + middle + 16 + 26}, [this] { return is_open(); });
    Rect rest = modal.content().inset(ui.px(16), ui.px(16));
    Rect buttons = rest.cut_bottom(ui.px(26));
    const Rect square = rest.cut_left(ui.px(kBallSide));
    picture(ui, {square.x0, square.y0, square.x1, square.y0 + ui.px(kBallSide)},
            ball(*shown.thumbnails));
    rest.cut_left(ui.px(16));
    text(ui, rest.cut_top(ui.px(22)), ui.fonts.name15, theme::kText, preset_->name);
    paragraph(ui, rest.cut_top(ui.px(kHeadHeight - 22)), ui.fonts.value12, theme::kText2,
              preset_->description);
    draw_knobs(ui, rest);

    std::optional<ApplyPreset> chosen;
    if (dialog_button(ui, buttons, {.label = "Add above the layer", .main = true}))
        chosen = ApplyPreset{preset_->id, false, knobs_};
    if (dialog_button(ui, buttons, {.label = "Replace the stack"}))
        chosen = ApplyPreset{preset_->id, true, knobs_};
    const bool cancelled = dialog_button(ui, buttons, {.label = "Cancel"});
    if (chosen || cancelled || modal.dismissed()) preset_.reset();
    return chosen;
}

}  // namespace patina::editor
