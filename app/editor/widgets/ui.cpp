// SPDX-License-Identifier: MIT
#include "editor/widgets/ui.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

namespace patina::editor {
namespace {

constexpr double kTipDelaySeconds = 0.5;

ImU32 seen(const Ui& ui, ImU32 color) {
    return ui.alpha == 255 ? color : with_alpha(color, ui.alpha);
}

ImDrawList& canvas() {
    return *ImGui::GetWindowDrawList();
}

const char* begin_of(std::string_view words) {
    return words.data();
}
const char* end_of(std::string_view words) {
    return words.data() + words.size();
}

/// The longest start of `words`, on a character border, that leaves room for an ellipsis.
std::string shortened(const ImFont* font, std::string_view words, float width) {
    const float room = width - text_width(font, "\u2026");
    std::string_view kept = words;
    while (!kept.empty() && text_width(font, kept) > room) {
        kept.remove_suffix(1);
        while (!kept.empty() && (static_cast<unsigned char>(kept.back()) & 0xC0u) == 0x80u)
            kept.remove_suffix(1);
        if (!kept.empty() && (static_cast<unsigned char>(kept.back()) & 0xC0u) == 0xC0u)
            kept.remove_suffix(1);
    }
    return std::string(kept) + "\u2026";
}

void draw_tip(const Ui& ui, const Rect& anchor, const Tip& tip) {
    const float pad_x = ui.px(10);
    const float pad_y = ui.px(8);
    const float key_width =
        tip.key.empty() ? 0 : text_width(ui.fonts.caption11, tip.key) + ui.px(16);
    const float first = text_width(ui.fonts.medium13, tip.title) + key_width;
    const float wrap = ui.px(340);
    ImFont* small = ui.fonts.value12;
    const ImVec2 body = tip.text.empty() ? ImVec2(0, 0)
                                         : small->CalcTextSizeA(small->FontSize, FLT_MAX, wrap,
                                                                tip.text.data(), end_of(tip.text));
    const float line_height = ui.px(18);
    const float width = std::max(first, body.x) + 2 * pad_x;
    const float height = line_height + (tip.text.empty() ? 0 : body.y + ui.px(2)) + 2 * pad_y;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float below = anchor.y1 + ui.px(8);
    const float y = below + height < screen.y ? below : anchor.y0 - ui.px(8) - height;
    const float x =
        std::clamp(anchor.x0, ui.px(4), std::max(screen.x - width - ui.px(4), ui.px(4)));
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    const float radius = ui.px(6);
    list.AddRectFilled(ImVec2(x, y), ImVec2(x + width, y + height), theme::kPopup, radius);
    list.AddRect(ImVec2(x, y), ImVec2(x + width, y + height), theme::kBorder, radius);
    ImFont* bold = ui.fonts.medium13;
    list.AddText(bold, bold->FontSize,
                 ImVec2(x + pad_x, y + pad_y + 0.5f * (line_height - bold->FontSize)), theme::kText,
                 begin_of(tip.title), end_of(tip.title));
    if (!tip.key.empty()) {
        ImFont* font = ui.fonts.caption11;
        const float chip_x = x + width - pad_x - key_width + ui.px(8);
        const float chip_y = y + pad_y + ui.px(1);
        list.AddRect(ImVec2(chip_x, chip_y), ImVec2(x + width - pad_x, chip_y + ui.px(16)),
                     theme::kBorder, ui.px(3));
        list.AddText(font, font->FontSize,
                     ImVec2(chip_x + ui.px(4), chip_y + 0.5f * (ui.px(16) - font->FontSize)),
                     theme::kText2, begin_of(tip.key), end_of(tip.key));
    }
    if (!tip.text.empty())
        list.AddText(small, small->FontSize, ImVec2(x + pad_x, y + pad_y + line_height + ui.px(2)),
                     theme::kText2, begin_of(tip.text), end_of(tip.text), wrap);
}

}  // namespace

float Ui::px(float logical) const {
    return std::floor(logical * scale + 0.5f);
}

void Ui::wake_in(double seconds) {
    if (wake_seconds_ < 0.0 || seconds < wake_seconds_) wake_seconds_ = seconds;
}

void Ui::begin_frame() {
    wake_seconds_ = -1.0;
    tip_offered_ = false;
    edit_ended = false;
    map.begin_frame();
    focus.begin_frame();
}

void Ui::end_frame() {
    focus.end_frame(scale);
    if (!tip_offered_) {
        tip_id_ = 0;
        return;
    }
    const double rested = ImGui::GetTime() - tip_since_;
    if (ImGui::IsAnyMouseDown()) {
        tip_since_ = ImGui::GetTime();
    } else if (rested >= kTipDelaySeconds) {
        draw_tip(*this, tip_anchor_, tip_);
        map.add(tip_.title, "tooltip", tip_.text, tip_anchor_, true);
    } else {
        wake_in(kTipDelaySeconds - rested + 0.01);
    }
}

void Ui::offer_tip(ImGuiID id, const Rect& anchor, const Tip& tip) {
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    const bool resting = tip_id_ == id && moved.x == 0.0f && moved.y == 0.0f;
    const bool shown = tip_id_ == id && ImGui::GetTime() - tip_since_ >= kTipDelaySeconds;
    if (!resting && !shown) tip_since_ = ImGui::GetTime();
    tip_id_ = id;
    tip_offered_ = true;
    tip_anchor_ = anchor;
    tip_ = tip;
}

Place::Place(Ui& ui, std::string_view name) : ui_(ui) {
    ImGui::PushID(name.data(), end_of(name));
    ui_.map.push_place(name);
}

Place::Place(Ui& ui, std::string_view name, std::uint64_t id) : ui_(ui) {
    ImGui::PushID(reinterpret_cast<const void*>(static_cast<std::uintptr_t>(id)));
    ui_.map.push_place(name);
}

Place::~Place() {
    ui_.map.pop_place();
    ImGui::PopID();
}

Faded::Faded(Ui& ui, bool faded, unsigned alpha) : ui_(ui), before_(ui.alpha) {
    if (faded) ui_.alpha = ui_.alpha * alpha / 255u;
}

void fill(const Ui& ui, const Rect& rect, ImU32 color, float radius, ImDrawFlags corners) {
    canvas().AddRectFilled(ImVec2(rect.x0, rect.y0), ImVec2(rect.x1, rect.y1), seen(ui, color),
                           radius * ui.scale, corners);
}

void outline(const Ui& ui, const Rect& rect, ImU32 color, float radius, float thickness) {
    canvas().AddRect(ImVec2(rect.x0, rect.y0), ImVec2(rect.x1, rect.y1), seen(ui, color),
                     radius * ui.scale, 0, std::max(1.0f, std::round(thickness * ui.scale)));
}

void hairline(const Ui& ui, const Rect& rect, ImU32 color) {
    fill(ui, {rect.x0, rect.y0, rect.x1, rect.y0 + std::max(1.0f, std::floor(ui.scale))}, color);
}

void disc(const Ui& ui, float x, float y, float radius, ImU32 color) {
    canvas().AddCircleFilled(ImVec2(x, y), radius * ui.scale, seen(ui, color));
}

void ring(const Ui& ui, float x, float y, float radius, ImU32 color, float thickness) {
    canvas().AddCircle(ImVec2(x, y), radius * ui.scale, seen(ui, color), 0, thickness * ui.scale);
}

void line(const Ui& ui, float x0, float y0, float x1, float y1, ImU32 color, float thickness) {
    canvas().AddLine(ImVec2(x0, y0), ImVec2(x1, y1), seen(ui, color), thickness * ui.scale);
}

void picture(const Ui& ui, const Rect& rect, const Picture& shown, float radius) {
    if (shown.texture == nullptr) return;
    const ImVec2 low(rect.x0, rect.y0);
    const ImVec2 high(rect.x1, rect.y1);
    const ImU32 tint = seen(ui, IM_COL32_WHITE);
    if (radius <= 0.0f)
        canvas().AddImage(shown.texture, low, high, shown.uv0, shown.uv1, tint);
    else
        canvas().AddImageRounded(shown.texture, low, high, shown.uv0, shown.uv1, tint,
                                 radius * ui.scale);
}

float text_width(const ImFont* font, std::string_view words) {
    if (words.empty()) return 0.0f;
    return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, begin_of(words), end_of(words)).x;
}

float text(const Ui& ui, const Rect& rect, const ImFont* font, ImU32 color, std::string_view words,
           Align align) {
    if (words.empty() || rect.width() <= 0.0f) return rect.x0;
    float width = text_width(font, words);
    std::string cut;
    if (width > rect.width() + 0.5f) {
        cut = shortened(font, words, rect.width());
        words = cut;
        width = text_width(font, words);
    }
    float x = rect.x0;
    if (align == Align::Center) x = std::floor(rect.center_x() - 0.5f * width);
    if (align == Align::Right) x = std::floor(rect.x1 - width);
    const float y = std::floor(rect.center_y() - 0.5f * font->FontSize);
    canvas().AddText(font, font->FontSize, ImVec2(x, y), seen(ui, color), begin_of(words),
                     end_of(words));
    return x + width;
}

float paragraph(const Ui& ui, const Rect& rect, const ImFont* font, ImU32 color,
                std::string_view words) {
    const float wrap = std::max(rect.width(), 1.0f);
    canvas().AddText(font, font->FontSize, ImVec2(rect.x0, rect.y0), seen(ui, color),
                     begin_of(words), end_of(words), wrap);
    return font->CalcTextSizeA(font->FontSize, FLT_MAX, wrap, begin_of(words), end_of(words)).y;
}

void icon_glyph(const Ui& ui, const Rect& rect, const char* glyph, ImU32 color, float size) {
    const ImFont* font = ui.fonts.body13;
    // The icons are merged at 14 of the 16 pixels that the body font is high.
    const float font_size = std::round(font->FontSize * size / 14.0f);
    unsigned code = 0;
    ImTextCharFromUtf8(&code, glyph, nullptr);
    const ImFontGlyph* shape = font->FindGlyph(static_cast<ImWchar>(code));
    if (shape == nullptr) return;
    const float zoom = font_size / font->FontSize;
    const float x = std::floor(rect.center_x() - 0.5f * zoom * (shape->X0 + shape->X1) + 0.5f);
    const float y = std::floor(rect.center_y() - 0.5f * zoom * (shape->Y0 + shape->Y1) + 0.5f);
    font->RenderChar(&canvas(), font_size, ImVec2(x, y), seen(ui, color),
                     static_cast<ImWchar>(code));
}

float key_chip(const Ui& ui, const Rect& rect, std::string_view key) {
    const float width = text_width(ui.fonts.caption11, key) + ui.px(8);
    const Rect chip = Rect{rect.x0, rect.y0, rect.x0 + width, rect.y1}.centered(width, ui.px(16));
    outline(ui, chip, theme::kBorder, 3);
    text(ui, chip, ui.fonts.caption11, theme::kText2, key, Align::Center);
    return width;
}

Rect visible_part(const Rect& rect) {
    const ImVec2 low = canvas().GetClipRectMin();
    const ImVec2 high = canvas().GetClipRectMax();
    return rect.intersected({low.x, low.y, high.x, high.y});
}

Press press(Ui& ui, const Rect& rect, const Control& control) {
    Press result;
    ImGuiWindow* window = ImGui::GetCurrentWindow();
    std::string name(control.label);
    name += '\x1f';
    name += control.kind;
    result.id = window->GetID(name.c_str());
    ui.map.add(control.label, control.kind, control.value, visible_part(rect), control.enabled);
    const bool by_keyboard = control.enabled && control.focusable;
    result.focused = by_keyboard && ui.focus.visit(result.id, rect);
    if (result.focused) ui.focus.drawn_at(visible_part(rect));
    const ImRect box(rect.x0, rect.y0, rect.x1, rect.y1);
    if (!ImGui::ItemAdd(box, result.id)) return result;
    if (!control.enabled) {
        result.hovered = false;
        if (control.tip != nullptr && ImGui::ItemHoverable(box, result.id))
            ui.offer_tip(result.id, rect, *control.tip);
        return result;
    }
    bool hovered = false;
    bool held = false;
    const bool was_held = ImGui::GetActiveID() == result.id;
    const bool clicked = ImGui::ButtonBehavior(box, result.id, &hovered, &held);
    result.hovered = hovered;
    result.held = held;
    result.started = held && !was_held;
    result.released = was_held && !held;
    result.clicked = clicked || (result.focused && ui.focus.pressed());
    result.double_clicked = hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    result.right_clicked = hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Right);
    if (hovered && !held && control.tip != nullptr) ui.offer_tip(result.id, rect, *control.tip);
    return result;
}

void note(Ui& ui, const Rect& rect, const Control& control) {
    const Rect seen_part = visible_part(rect);
    ui.map.add(control.label, control.kind, control.value, seen_part, control.enabled);
    const ImVec2 mouse = ImGui::GetMousePos();
    if (control.tip != nullptr && seen_part.contains(mouse.x, mouse.y) &&
        ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem))
        ui.offer_tip(
            ImGui::GetCurrentWindow()->GetID(begin_of(control.label), end_of(control.label)), rect,
            *control.tip);
}

ScrollArea::ScrollArea(Ui& ui, const char* id, const Rect& rect) : rect_(rect) {
    ImGui::SetCursorScreenPos(ImVec2(rect.x0, rect.y0));
    ImGui::PushStyleVar(ImGuiStyleVar_ScrollbarSize, ui.px(6));
    ImGui::BeginChild(id, ImVec2(rect.width(), std::max(rect.height(), 1.0f)), false,
                      ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    content_ = {start.x, start.y, start.x + rect.width(), rect.y1};
}

ScrollArea::~ScrollArea() {
    ImGui::SetCursorScreenPos(ImVec2(content_.x0, content_.y0));
    ImGui::Dummy(ImVec2(1.0f, height_));
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

void ScrollArea::reveal(float y0, float y1) const {
    const float scroll = ImGui::GetScrollY();
    if (y0 < rect_.y0) ImGui::SetScrollY(scroll - (rect_.y0 - y0));
    if (y1 > rect_.y1) ImGui::SetScrollY(scroll + (y1 - rect_.y1));
}

}  // namespace patina::editor
