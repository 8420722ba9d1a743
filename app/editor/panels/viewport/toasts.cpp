// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "editor/panels/viewport/parts.h"
#include "editor/widgets/buttons.h"

namespace patina::editor {
namespace {

Requests draw_toast(Ui& ui, const Rect& box, const ToastShown& toast) {
    Requests requests;
    const Place place(ui, "Toast", static_cast<std::uint64_t>(toast.id));
    const bool error = toast.kind == ToastKind::Error;
    note(ui, box, {.label = toast.message, .kind = "toast", .value = error ? "error" : "note"});
    const ImVec2 mouse = ImGui::GetMousePos();
    if (box.contains(mouse.x, mouse.y)) requests.ask(HoldToast{toast.id});
    fill(ui, box, theme::kPopup, 6);
    outline(ui, box, theme::kBorder, 6);
    fill(ui, {box.x0, box.y0, box.x0 + ui.px(3), box.y1}, error ? theme::kError : theme::kAccent, 6,
         ImDrawFlags_RoundCornersLeft);
    Rect rest = box;
    rest.cut_left(ui.px(12));
    rest.cut_right(ui.px(8));
    icon_glyph(ui, rest.cut_left(ui.px(18)),
               error                           ? icon::kWarning
               : toast.kind == ToastKind::Note ? icon::kInfo
                                               : icon::kCheck,
               error ? theme::kError : theme::kAccentHigh, 14);
    rest.cut_left(ui.px(8));
    if (icon_button(ui, rest.cut_right(ui.px(26)),
                    {.icon = icon::kClose, .label = "Dismiss", .size = 13}))
        requests.ask(DismissToast{toast.id});
    if (!toast.link.empty()) {
        const TextButton link{.label = toast.link, .link = true};
        const Rect link_box = rest.cut_right(text_button_width(ui, link));
        if (text_button(ui, link_box.centered(link_box.width(), ui.px(26)), link)) {
            requests.ask(toast.action);
            requests.ask(DismissToast{toast.id});
        }
    }
    rest.cut_right(ui.px(8));
    const float wanted = text_width(ui.fonts.body13, toast.message);
    if (wanted <= rest.width())
        text(ui, rest, ui.fonts.body13, theme::kText, toast.message);
    else
        paragraph(ui, rest.inset(0, ui.px(6)), ui.fonts.body13, theme::kText, toast.message);
    return requests;
}

}  // namespace

Requests draw_toasts(Ui& ui, const Rect& rect, std::span<const ToastShown> toasts) {
    Requests requests;
    float bottom = rect.y1 - ui.px(12);
    for (auto toast = toasts.rbegin(); toast != toasts.rend(); ++toast) {
        const float link =
            toast->link.empty() ? 0 : text_width(ui.fonts.medium13, toast->link) + ui.px(16);
        const float words = text_width(ui.fonts.body13, toast->message);
        const float most = std::min(rect.width() - ui.px(24), ui.px(560));
        const float chrome = link + ui.px(12 + 18 + 8 + 8 + 26 + 8);
        const float width = std::min(std::ceil(words + chrome) + 2, most);
        const float lines = std::ceil(words / std::max(width - chrome, 1.0f) * 1.1f);
        const float height = words + chrome <= width ? ui.px(44) : ui.px(14) + lines * ui.px(17);
        const Rect box{rect.x1 - ui.px(12) - width, bottom - height, rect.x1 - ui.px(12), bottom};
        requests.append(draw_toast(ui, box, *toast));
        bottom = box.y0 - ui.px(8);
    }
    return requests;
}

Requests draw_empty(Ui& ui, const Rect& rect) {
    Requests requests;
    fill(ui, rect, rgb(0x1A1A1A));
    Rect column = rect.centered(ui.px(360), ui.px(70));
    text(ui, column.cut_top(ui.px(20)), ui.fonts.body13, theme::kText2,
         "Open a model or drop a .glb here", Align::Center);
    column.cut_top(ui.px(14));
    const TextButton open{
        .label = "Open", .icon = icon::kFolderOpen, .key = "Ctrl O", .main = true};
    const TextButton sample{.label = "Try the sample"};
    const float open_width = text_button_width(ui, open);
    const float sample_width = text_button_width(ui, sample);
    Rect row = column.cut_top(ui.px(26)).centered(open_width + sample_width + ui.px(8), ui.px(26));
    if (text_button(ui, row.cut_left(open_width), open)) requests.ask(Action::Open);
    row.cut_left(ui.px(8));
    if (text_button(ui, row.cut_left(sample_width), sample)) requests.ask(Action::OpenSample);
    return requests;
}

}  // namespace patina::editor
