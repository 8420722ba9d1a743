// SPDX-License-Identifier: MIT
#include "editor/dialogs/palette.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "editor/dialogs/modal.h"
#include "editor/widgets/buttons.h"
#include "editor/widgets/name_search.h"
#include "editor/widgets/text_field.h"

namespace patina::editor {
namespace {

std::vector<const ActionInfo*> found(const std::string& search) {
    std::vector<const ActionInfo*> result;
    for (const ActionInfo& row : actions())
        if (row.action != Action::FindAction &&
            name_matches(std::string(kMenuNames[static_cast<std::size_t>(row.menu)]) + " " +
                             std::string(row.label),
                         search))
            result.push_back(&row);
    return result;
}

Press draw_row(Ui& ui, const Rect& rect, const ActionInfo& row, bool chosen, bool enabled) {
    const Press pressed = press(ui, rect,
                                {.label = row.label,
                                 .kind = "action",
                                 .value = chosen ? "chosen" : "",
                                 .enabled = enabled});
    row_tint(ui, rect, chosen, pressed.hovered);
    const Faded faded(ui, !enabled);
    Rect inner = rect.inset(ui.px(14), 0);
    const Rect glyph = inner.cut_left(ui.px(22));
    if (row.icon != nullptr)
        icon_glyph(ui, {glyph.x0, glyph.y0, glyph.x0 + ui.px(16), glyph.y1}, row.icon,
                   theme::kText2, 13);
    if (!row.key.empty()) {
        const float width = text_width(ui.fonts.caption11, row.key) + ui.px(8);
        key_chip(ui, inner.cut_right(width), row.key);
        inner.cut_right(ui.px(8));
    }
    text(ui, inner, ui.fonts.body13, theme::kText, row.label);
    return pressed;
}

}  // namespace

std::optional<Action> Palette::draw(Ui& ui, const Shown& shown) {
    if (!open_) return std::nullopt;
    const Modal modal(ui, {"Find an action", 520, 380, 0.16f}, [this] { return is_open(); });
    Rect rest = modal.content();
    const Rect field = rest.cut_top(ui.px(44)).inset(ui.px(8), ui.px(8));
    if (search_field(
            ui, field,
            {.label = "Action", .hint = "Find an action", .focus = std::exchange(fresh_, false)},
            search_))
        chosen_ = 0;
    hairline(ui, rest, theme::kFieldHover);
    rest.cut_top(ui.px(1));
    rest.cut_bottom(ui.px(6));
    const std::vector<const ActionInfo*> rows = found(search_);
    const int last = static_cast<int>(rows.size()) - 1;
    const auto key = [](ImGuiKey which) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(which)); };
    const int before = chosen_;
    if (key(ImGuiKey_DownArrow)) ++chosen_;
    if (key(ImGuiKey_UpArrow)) --chosen_;
    chosen_ = std::clamp(chosen_, 0, std::max(last, 0));
    std::optional<Action> result;
    ScrollArea area(ui, "actions", rest);
    Rect row = area.content();
    row.y1 = row.y0 + ui.px(30);
    for (int i = 0; i <= last; ++i) {
        const ActionInfo& each = *rows[static_cast<std::size_t>(i)];
        const bool enabled = applies(each.action, shown);
        const Press pressed = draw_row(ui, row, each, i == chosen_, enabled);
        const bool entered = i == chosen_ && (key(ImGuiKey_Enter) || key(ImGuiKey_KeyPadEnter));
        if (enabled && (pressed.clicked || entered)) result = each.action;
        if (i == chosen_ && chosen_ != before) area.reveal(row.y0, row.y1);
        row = row.moved(0, row.height());
    }
    if (rows.empty())
        text(ui, row.inset(ui.px(16), 0), ui.fonts.body13, theme::kText3,
             "Nothing matches '" + search_ + "'");
    area.set_height(static_cast<float>(rows.size()) * row.height());
    if (result || modal.dismissed()) open_ = false;
    return result;
}

}  // namespace patina::editor
