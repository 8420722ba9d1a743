// SPDX-License-Identifier: MIT
#include "editor/dialogs/export_dialog.h"

#include <fmt/format.h>

#include <array>
#include <utility>
#include <vector>

#include "document/material.h"
#include "editor/dialogs/dialog_choice.h"
#include "editor/dialogs/modal.h"
#include "editor/widgets/buttons.h"

namespace patina::editor {

void ExportDialog::open(std::function<void(const io::MapExportOptions&)> chosen) {
    chosen_ = std::move(chosen);
}

void ExportDialog::draw_choices(Ui& ui, Rect& rest) {
    std::vector<std::pair<std::string, const io::MapPacking*>> packings;
    for (const io::MapPacking& row : io::map_packings())
        packings.emplace_back(std::string(row.id), &row);
    dialog_choice(ui, rest, "Packing", "What goes into which file", packings, options_.packing);
    std::vector<std::pair<std::string, io::ImageFormat>> formats;
    for (const io::ImageFormatInfo& row : io::kImageFormats)
        formats.emplace_back(std::string(row.id), row.format);
    dialog_choice(ui, rest, "Format", "Of the files", formats, options_.format);
    using Number = std::optional<int>;
    std::vector<std::pair<std::string, Number>> bits = {
        {options_.format == io::ImageFormat::Exr ? "Usual (16)" : "Usual (8)", std::nullopt}};
    for (const int each : {8, 16, 32}) {
        io::MapExportOptions with = options_;
        with.bits = each;
        if (io::check_map_options(with)) bits.emplace_back(fmt::format("{}", each), each);
    }
    dialog_choice(ui, rest, "Bits", "Of each channel; 32 are floats", bits, options_.bits);
    std::vector<std::pair<std::string, Number>> sizes = {{"As each material says", std::nullopt}};
    for (int size = kMinResolution; size <= kMaxResolution; size *= 2)
        sizes.emplace_back(fmt::format("{} px", size), size);
    dialog_choice(ui, rest, "Size", "Side of the maps", sizes, options_.size);
}

void ExportDialog::draw(Ui& ui) {
    if (!is_open()) return;
    const Modal modal(ui, {"Export maps", 460, 262}, [this] { return is_open(); });
    Rect rest = modal.content().inset(ui.px(20), ui.px(16));
    text(ui, rest.cut_top(ui.px(24)), ui.fonts.name15, theme::kText, "Export maps");
    rest.cut_top(ui.px(8));
    draw_choices(ui, rest);
    Rect buttons = rest.cut_bottom(ui.px(26));
    const Status good = io::check_map_options(options_);
    rest.cut_top(ui.px(4));
    paragraph(ui, rest, ui.fonts.caption11, good ? theme::kText3 : theme::kError,
              good ? options_.packing->description : std::string_view(good.error().message));
    const bool accepted = dialog_button(
        ui, buttons, {.label = "Choose a folder\u2026", .main = true, .enabled = good.has_value()});
    const bool cancelled = dialog_button(ui, buttons, {.label = "Cancel"});
    if (!accepted && !cancelled && !modal.dismissed()) return;
    const auto chosen = std::exchange(chosen_, nullptr);
    if (accepted) chosen(options_);
}

}  // namespace patina::editor
