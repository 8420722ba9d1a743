// SPDX-License-Identifier: MIT
#pragma once

/// Colours: a swatch with its hexadecimal number, and the picker that it opens. Colours are stored
/// as linear light and shown and typed sRGB-encoded.

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "editor/widgets/ui.h"

namespace patina::editor {

/// As on screen.
ImU32 screen_color(const glm::vec3& color_linear);
/// "#61766F".
std::string hex_color(const glm::vec3& color_linear);
/// The colour of "#61766F", "61766f" or "#678"; nothing for other text.
std::optional<glm::vec3> color_from_hex(std::string_view text);

/// Each component within 0..1.
glm::vec3 srgb_from_linear(const glm::vec3& linear);
glm::vec3 linear_from_srgb(const glm::vec3& srgb);

struct ColorSpec {
    std::string_view label;
    std::string_view tooltip = {};
};
/// Returns the new colour in every frame in which it changes.
std::optional<glm::vec3> color_field(Ui& ui, const Rect& rect, const ColorSpec& spec,
                                     const glm::vec3& color_linear);

/// The popup with the id "color" below `anchor`, opened by ImGui::OpenPopup("color").
std::optional<glm::vec3> color_popup(Ui& ui, const Rect& anchor, const glm::vec3& color_linear);

}  // namespace patina::editor
