// SPDX-License-Identifier: MIT
#include "editor/dialogs/save_view_dialog.h"

#include <fmt/format.h>

#include <utility>

#include "editor/dialogs/dialog_choice.h"
#include "editor/dialogs/modal.h"
#include "editor/widgets/buttons.h"

namespace patina::editor {

void SaveViewDialog::open(float aspect, std::function<void(const StillOptions&)> chosen) {
    aspect_ = aspect;
    chosen_ = std::move(chosen);
}

void SaveViewDialog::draw(Ui& ui) {
    if (!is_open()) return;
    const Modal modal(ui, {"Save the view", 460, 236}, [this] { return is_open(); });
    Rect rest = modal.content().inset(ui.px(20), ui.px(16));
    text(ui, rest.cut_top(ui.px(24)), ui.fonts.name15, theme::kText, "Save the view");
    rest.cut_top(ui.px(8));
    std::vector<std::pair<std::string, int>> heights;
    for (const int height : {540, 720, 1080, 1440, 2160}) {
        const render::PictureSize size = still_size(height, aspect_);
        heights.emplace_back(fmt::format("{} \u00d7 {} px", size.width, size.height), height);
    }
    dialog_choice(ui, rest, "Size", "Of the picture, which has the viewport's shape", heights,
                  options_.height);
    dialog_choice(ui, rest, "Samples",
                  "Of each pixel. From 64 on they sample the environment itself, and the more "
                  "there are, the nearer is the picture to the integral",
                  {{"16, a draft", 16}, {"64", 64}, {"256", 256}, {"1024", 1024}, {"4096", 4096}},
                  options_.samples);
    dialog_choice(ui, rest, "Background", "What is behind the model",
                  {{"As on screen", false}, {"Transparent", true}}, options_.transparent);
    Rect buttons = rest.cut_bottom(ui.px(26));
    rest.cut_top(ui.px(4));
    paragraph(ui, rest, ui.fonts.caption11, theme::kText3,
              "The ending of the file decides: .png as on screen, .exr in linear light, before "
              "exposure and tone mapping.");
    const bool accepted =
        dialog_button(ui, buttons, {.label = "Choose a file\u2026", .main = true});
    const bool cancelled = dialog_button(ui, buttons, {.label = "Cancel"});
    if (!accepted && !cancelled && !modal.dismissed()) return;
    const auto chosen = std::exchange(chosen_, nullptr);
    if (accepted) chosen(options_);
}

}  // namespace patina::editor
