// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "editor/panels/panels.h"
#include "editor/widgets/number_text.h"

namespace patina::editor {
namespace {

constexpr double kShownAfterSeconds = 0.3;
constexpr double kSpinnerStep = 0.1;

/// "Frame 4.8 ms", right-aligned; returns what is left.
void draw_figure(Ui& ui, Rect& rest, std::string_view name, const std::string& value) {
    const ImFont* font = ui.fonts.value12;
    const Rect right = rest.cut_right(std::ceil(text_width(font, value)) + 1);
    text(ui, right, font, theme::kText, value);
    rest.cut_right(ui.px(4));
    const Rect left = rest.cut_right(std::ceil(text_width(font, name)) + 1);
    text(ui, left, font, theme::kText2, name);
    rest.cut_right(ui.px(16));
    ui.map.add(name, "figure", value, {left.x0, left.y0, right.x1, right.y1}, true);
}

void draw_spinner(Ui& ui, const Rect& rect) {
    constexpr int kDots = 8;
    const int turn = static_cast<int>(ImGui::GetTime() / kSpinnerStep) % kDots;
    for (int i = 0; i < kDots; ++i) {
        const float angle = static_cast<float>(i) * 6.2831853f / kDots;
        const int age = (turn - i + kDots) % kDots;
        const ImU32 color = with_alpha(theme::kAccentHigh, static_cast<unsigned>(255 - 26 * age));
        disc(ui, rect.center_x() + std::cos(angle) * 4.5f * ui.scale,
             rect.center_y() + std::sin(angle) * 4.5f * ui.scale, 1.1f, color);
    }
    ui.wake_in(kSpinnerStep);
}

Requests draw_job(Ui& ui, Rect& rest, const JobShown& job) {
    Requests requests;
    const Place place(ui, "Job", static_cast<std::uint64_t>(job.id));
    const ImFont* font = ui.fonts.value12;
    if (job.can_cancel) {
        const Rect cross = rest.cut_right(ui.px(16)).centered(ui.px(16), ui.px(20));
        const Tip tip{"Cancel"};
        const Press pressed = press(ui, cross, {.label = "Cancel", .kind = "button", .tip = &tip});
        icon_glyph(ui, cross, icon::kClose, pressed.hovered ? theme::kText : theme::kText2, 12);
        if (pressed.clicked) requests.ask(CancelJob{job.id});
        rest.cut_right(ui.px(8));
    }
    const std::string percent = number_text(std::floor(static_cast<double>(job.fraction) * 100.0),
                                            {.decimals = 0, .unit = "%"});
    text(ui, rest.cut_right(ui.px(34)), font, theme::kText2, percent, Align::Right);
    rest.cut_right(ui.px(8));
    Rect track = rest.cut_right(ui.px(120)).centered(ui.px(120), ui.px(4));
    fill(ui, track, theme::kTrack, 2);
    track.x1 = track.x0 + std::round(track.width() * std::clamp(job.fraction, 0.0f, 1.0f));
    if (track.width() >= 1) fill(ui, track, theme::kAccent, 2);
    rest.cut_right(ui.px(8));
    const float most = std::max(rest.width() - ui.px(40), 0.0f);
    const float width = std::min(std::ceil(text_width(font, job.stage)) + 1, most);
    const Rect words = rest.cut_right(width);
    text(ui, words, font, theme::kText, job.stage);
    note(ui, words, {.label = "Working", .kind = "progress", .value = job.stage});
    rest.cut_right(ui.px(8));
    draw_spinner(ui, rest.cut_right(ui.px(12)));
    rest.cut_right(ui.px(16));
    return requests;
}

std::string_view hint_for(const Shown& shown, const ViewState& view) {
    if (!shown.document) return "Drop a .glb, .gltf or an image here";
    if (view.tool == ViewportTool::Probe)
        return "Click a texel to explain it \u00b7 Esc puts the eyedropper away";
    if (view.view.compare == render::CompareMode::Split)
        return "Drag the divider to compare \u00b7 Shift-drag turns the environment";
    return "Drag to orbit, middle to pan, wheel to zoom \u00b7 Shift-drag turns the environment";
}

}  // namespace

Requests draw_status_bar(Ui& ui, const Rect& rect, const Shown& shown, ViewState& view) {
    Requests requests;
    const Place place(ui, "Status");
    fill(ui, rect, theme::kBar);
    Rect rest = rect.inset(ui.px(12), 0);
    draw_figure(ui, rest, "GPU", megabytes(shown.cost.gpu_bytes));
    draw_figure(ui, rest, "Memory", megabytes(shown.cost.memory_bytes));
    const NumberFormat ms{.decimals = 1, .unit = "ms"};
    draw_figure(ui, rest, "Composite", number_text(shown.cost.composite_ms, ms));
    draw_figure(ui, rest, "Frame", number_text(shown.cost.frame_ms, ms));
    if (const RefinementShown& refined = shown.refinement; refined.draws > 0)
        draw_figure(ui, rest, "Samples", fmt::format("{} / {}", refined.drawn, refined.draws));
    for (const JobShown& job : shown.jobs) {
        if (job.seconds < kShownAfterSeconds) {
            ui.wake_in(kShownAfterSeconds - job.seconds + 0.01);
            continue;
        }
        fill(ui, rest.cut_right(ui.px(1)).centered(ui.px(1), ui.px(16)), theme::kBorder);
        rest.cut_right(ui.px(16));
        requests.append(draw_job(ui, rest, job));
        break;
    }
    if (rest.width() > ui.px(120))
        text(ui, rest, ui.fonts.value12, theme::kText3, hint_for(shown, view));
    return requests;
}

}  // namespace patina::editor
