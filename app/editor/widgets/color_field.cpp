// SPDX-License-Identifier: MIT
#include "editor/widgets/color_field.h"

#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/formulae/formulae.h"
#include "core/hex_color.h"
#include "core/stored_values.h"
#include "editor/widgets/slider.h"
#include "editor/widgets/text_field.h"

namespace patina::editor {

glm::vec3 srgb_from_linear(const glm::vec3& linear) {
    const auto channel = [](float value) {
        return static_cast<float>(formulae::srgb_from_linear(std::clamp(value, 0.0f, 1.0f)));
    };
    return {channel(linear.x), channel(linear.y), channel(linear.z)};
}

glm::vec3 linear_from_srgb(const glm::vec3& srgb) {
    const auto channel = [](float value) {
        return static_cast<float>(formulae::linear_from_srgb(std::clamp(value, 0.0f, 1.0f)));
    };
    return {channel(srgb.x), channel(srgb.y), channel(srgb.z)};
}

namespace {

ImU32 packed(const glm::vec3& srgb) {
    const auto byte = [](float value) {
        return static_cast<ImU32>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
    };
    return IM_COL32(byte(srgb.x), byte(srgb.y), byte(srgb.z), 255);
}

struct Hsv {
    float hue = 0.0f;
    float saturation = 0.0f;
    float value = 0.0f;
};

/// Hue and saturation of greys and black are not in the colour: the picker remembers them.
Hsv remembered_hsv(const glm::vec3& srgb) {
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    Hsv hsv;
    ImGui::ColorConvertRGBtoHSV(srgb.x, srgb.y, srgb.z, hsv.hue, hsv.saturation, hsv.value);
    float& hue = *storage.GetFloatRef(ImGui::GetID("hue"));
    float& saturation = *storage.GetFloatRef(ImGui::GetID("saturation"));
    if (hsv.value <= 0.0f) hsv.saturation = saturation;
    if (hsv.saturation <= 0.0f || hsv.value <= 0.0f) hsv.hue = hue;
    return hsv;
}

glm::vec3 srgb_of(const Hsv& hsv) {
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    storage.SetFloat(ImGui::GetID("hue"), hsv.hue);
    storage.SetFloat(ImGui::GetID("saturation"), hsv.saturation);
    glm::vec3 srgb;
    ImGui::ColorConvertHSVtoRGB(hsv.hue, hsv.saturation, hsv.value, srgb.x, srgb.y, srgb.z);
    return srgb;
}

float share(float at, float low, float high) {
    return std::clamp((at - low) / (high - low), 0.0f, 1.0f);
}

/// Saturation to the right, value upwards.
std::optional<Hsv> saturation_value_square(Ui& ui, const Rect& rect, Hsv hsv) {
    const Press pressed = press(ui, rect, {.label = "Saturation and value", .kind = "plane"});
    glm::vec3 pure;
    ImGui::ColorConvertHSVtoRGB(hsv.hue, 1.0f, 1.0f, pure.x, pure.y, pure.z);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 low(rect.x0, rect.y0);
    const ImVec2 high(rect.x1, rect.y1);
    const ImU32 white = IM_COL32_WHITE;
    const ImU32 black = IM_COL32_BLACK;
    const ImU32 clear = IM_COL32(0, 0, 0, 0);
    list.AddRectFilledMultiColor(low, high, white, packed(pure), packed(pure), white);
    list.AddRectFilledMultiColor(low, high, clear, clear, black, black);
    const float x = rect.x0 + hsv.saturation * rect.width();
    const float y = rect.y1 - hsv.value * rect.height();
    ring(ui, x, y, 6, IM_COL32(0, 0, 0, 200), 3);
    ring(ui, x, y, 6, white, 1.5f);
    if (pressed.released) ui.edit_ended = true;
    if (!pressed.held) return std::nullopt;
    const ImVec2 mouse = ImGui::GetMousePos();
    hsv.saturation = share(mouse.x, rect.x0, rect.x1);
    hsv.value = 1.0f - share(mouse.y, rect.y0, rect.y1);
    return hsv;
}

std::optional<Hsv> hue_bar(Ui& ui, const Rect& rect, Hsv hsv) {
    const Press pressed = press(ui, rect, {.label = "Hue", .kind = "plane"});
    Rect rest = rect;
    const float step = rect.width() / 6.0f;
    for (int i = 0; i < 6; ++i) {
        glm::vec3 left;
        glm::vec3 right;
        const auto sixth = static_cast<float>(i) / 6.0f;
        ImGui::ColorConvertHSVtoRGB(sixth, 1, 1, left.x, left.y, left.z);
        ImGui::ColorConvertHSVtoRGB(sixth + 1.0f / 6.0f, 1, 1, right.x, right.y, right.z);
        const Rect part = rest.cut_left(step);
        ImGui::GetWindowDrawList()->AddRectFilledMultiColor(
            ImVec2(part.x0, part.y0), ImVec2(part.x1, part.y1), packed(left), packed(right),
            packed(right), packed(left));
    }
    const float x = rect.x0 + hsv.hue * rect.width();
    const Rect grab{x - ui.px(3), rect.y0 - ui.px(2), x + ui.px(3), rect.y1 + ui.px(2)};
    outline(ui, grab, IM_COL32(0, 0, 0, 200), 2, 3);
    outline(ui, grab, IM_COL32_WHITE, 2, 1.5f);
    if (pressed.released) ui.edit_ended = true;
    if (!pressed.held) return std::nullopt;
    hsv.hue = std::min(share(ImGui::GetMousePos().x, rect.x0, rect.x1), 0.9999f);
    return hsv;
}

std::optional<glm::vec3> component_fields(Ui& ui, Rect rect, const glm::vec3& srgb) {
    constexpr std::array<std::string_view, 3> kNames = {"Red", "Green", "Blue"};
    constexpr std::array<std::string_view, 3> kShort = {"R", "G", "B"};
    const float width = (rect.width() - 2 * ui.px(4)) / 3.0f;
    std::optional<glm::vec3> result;
    for (int i = 0; i < 3; ++i) {
        const auto index = static_cast<std::size_t>(i);
        const NumberSpec spec{.label = kNames[index],
                              .shown_label = kShort[index],
                              .maximum = 255.0,
                              .step = 1.0,
                              .decimals = 0,
                              .whole = true,
                              .tooltip = "sRGB-encoded, 0 to 255"};
        const double byte = std::round(static_cast<double>(srgb[i]) * 255.0);
        if (const auto next = number_field(ui, rect.cut_left(width), spec, byte)) {
            result = srgb;
            (*result)[i] = static_cast<float>(*next / 255.0);
        }
        rect.cut_left(ui.px(4));
    }
    return result;
}

std::optional<glm::vec3> hex_field(Ui& ui, const Rect& rect, const glm::vec3& linear) {
    const std::string hex = hex_color(linear);
    const Press pressed = press(ui, rect, {.label = "Hexadecimal", .kind = "text", .value = hex});
    fill(ui, rect, pressed.hovered ? theme::kFieldHover : theme::kField, 4);
    if (ui.typing.id == pressed.id) {
        const auto words = typed(ui, pressed.id, rect, ui.fonts.value12);
        return words ? color_from_hex(*words) : std::nullopt;
    }
    text(ui, rect.inset(ui.px(8), 0), ui.fonts.value12, theme::kText, hex);
    if (pressed.clicked) start_typing(ui, pressed.id, hex);
    return std::nullopt;
}

/// What is in the popup: plane, hue, numbers, and the hexadecimal name.
std::optional<glm::vec3> picker(Ui& ui, Rect rest, const glm::vec3& color_linear) {
    const Place place(ui, "Colour");
    const glm::vec3 srgb = srgb_from_linear(color_linear);
    const Hsv hsv = remembered_hsv(srgb);
    std::optional<glm::vec3> result;
    if (const auto next = saturation_value_square(ui, rest.cut_top(ui.px(150)), hsv))
        result = linear_from_srgb(srgb_of(*next));
    rest.cut_top(ui.px(8));
    if (const auto next = hue_bar(ui, rest.cut_top(ui.px(14)), hsv))
        result = linear_from_srgb(srgb_of(*next));
    rest.cut_top(ui.px(10));
    if (const auto next = component_fields(ui, rest.cut_top(ui.px(24)), srgb))
        result = linear_from_srgb(*next);
    rest.cut_top(ui.px(6));
    Rect last = rest.cut_top(ui.px(24));
    fill(ui, last.cut_left(ui.px(48)), packed(srgb), 4);
    last.cut_left(ui.px(6));
    if (const auto next = hex_field(ui, last, color_linear)) {
        result = *next;
        ui.edit_ended = true;
    }
    return result;
}

}  // namespace

ImU32 screen_color(const glm::vec3& color_linear) {
    return packed(srgb_from_linear(color_linear));
}

std::string hex_color(const glm::vec3& color_linear) {
    const glm::vec3 srgb = srgb_from_linear(color_linear);
    const auto byte = [](float value) { return static_cast<int>(std::lround(value * 255.0f)); };
    return fmt::format("#{:02X}{:02X}{:02X}", byte(srgb.x), byte(srgb.y), byte(srgb.z));
}

std::optional<glm::vec3> color_from_hex(std::string_view words) {
    while (!words.empty() && (words.front() == '#' || words.front() == ' ')) words.remove_prefix(1);
    while (!words.empty() && words.back() == ' ') words.remove_suffix(1);
    const auto rgb = rgb_from_hex(words);
    if (!rgb) return std::nullopt;
    return linear_of_rgb(*rgb);
}

std::optional<glm::vec3> color_popup(Ui& ui, const Rect& anchor, const glm::vec3& color_linear) {
    ImGui::SetNextWindowPos(ImVec2(anchor.x0, anchor.y1 + ui.px(4)), ImGuiCond_Appearing);
    ImGui::SetNextWindowSize(ImVec2(ui.px(248), ui.px(264)));
    if (!ImGui::BeginPopup("color", ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav))
        return std::nullopt;
    if (ui.typing.id == 0 && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)))
        ImGui::CloseCurrentPopup();
    const ImVec2 corner = ImGui::GetWindowPos();
    const Rect box{corner.x, corner.y, corner.x + ui.px(248), corner.y + ui.px(264)};
    const std::optional<glm::vec3> result = picker(ui, box.inset(ui.px(12)), color_linear);
    ImGui::EndPopup();
    return result;
}

std::optional<glm::vec3> color_field(Ui& ui, const Rect& rect, const ColorSpec& spec,
                                     const glm::vec3& color_linear) {
    const std::string hex = hex_color(color_linear);
    const Tip tip{std::string(spec.label), std::string(spec.tooltip)};
    const Press pressed =
        press(ui, rect, {.label = spec.label, .kind = "color", .value = hex, .tip = &tip});
    fill(ui, rect, pressed.hovered ? theme::kFieldHover : theme::kField, 4);
    Rect rest = rect.inset(ui.px(4), ui.px(3));
    const Rect swatch = rest.cut_left(ui.px(18));
    fill(ui, swatch, screen_color(color_linear), 3);
    rest.cut_left(ui.px(6));
    text(ui, rest, ui.fonts.value12, theme::kText, hex);
    ImGui::PushID(static_cast<int>(pressed.id));
    if (pressed.clicked) ImGui::OpenPopup("color");
    const std::optional<glm::vec3> result = color_popup(ui, rect, color_linear);
    ImGui::PopID();
    return result;
}

}  // namespace patina::editor
