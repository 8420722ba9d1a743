// SPDX-License-Identifier: MIT
#pragma once

/// The colours and measures of the interface. Neutral greys, so that colours in the viewport can be
/// judged; the accent means selected, focused, on, or the main button, and nothing else.

#include <imgui.h>

namespace patina::editor {

constexpr ImU32 rgb(unsigned hex) {
    return IM_COL32((hex >> 16) & 255u, (hex >> 8) & 255u, hex & 255u, 255u);
}
/// The same colour at `alpha`, 0 to 255, of its own.
constexpr ImU32 with_alpha(ImU32 color, unsigned alpha) {
    return (color & ~IM_COL32_A_MASK) |
           ((((color >> IM_COL32_A_SHIFT) * alpha) / 255u) << IM_COL32_A_SHIFT);
}

namespace theme {
inline constexpr ImU32 kBase = rgb(0x121212);  ///< gaps, the viewport's edge
inline constexpr ImU32 kPanel = rgb(0x1E1E1E);
inline constexpr ImU32 kBar = rgb(0x252525);  ///< top and status
inline constexpr ImU32 kField = rgb(0x2D2D2D);
inline constexpr ImU32 kFieldHover = rgb(0x383838);
inline constexpr ImU32 kFieldPressed = rgb(0x454545);
inline constexpr ImU32 kSearchField = rgb(0x1C1C1C);  ///< a field on a bar
inline constexpr ImU32 kFill = rgb(0x3B3B3B);
inline constexpr ImU32 kFillActive = rgb(0x24564D);
inline constexpr ImU32 kLevelLine = rgb(0x9A9A9A);
inline constexpr ImU32 kPopup = rgb(0x2A2A2A);
inline constexpr ImU32 kBorder = rgb(0x484848);
inline constexpr ImU32 kHairline = rgb(0x2A2A2A);
inline constexpr ImU32 kTableLine = rgb(0x333333);
inline constexpr ImU32 kRowHover = rgb(0x2A2A2A);
inline constexpr ImU32 kOpenRow = rgb(0x242424);  ///< a row with its editor unfolded below
inline constexpr ImU32 kOverlay = with_alpha(rgb(0x161616), 224);
inline constexpr ImU32 kText = rgb(0xE8E8E8);
inline constexpr ImU32 kText2 = rgb(0xB4B4B4);  ///< labels, units
inline constexpr ImU32 kText3 = rgb(0x979797);  ///< hints, counts, what is off
inline constexpr ImU32 kAccent = rgb(0x45BFA9);
inline constexpr ImU32 kAccentHigh = rgb(0x6AD3C0);  ///< icons, links
inline constexpr ImU32 kInk = rgb(0x06201B);         ///< on the accent
inline constexpr ImU32 kSelected = rgb(0x1F3D38);
inline constexpr ImU32 kSelectedHover = rgb(0x25473F);
inline constexpr ImU32 kWarning = rgb(0xE3B341);
inline constexpr ImU32 kError = rgb(0xF58B8B);
inline constexpr ImU32 kTrack = rgb(0x3A3A3A);      ///< of progress and level bars
inline constexpr ImU32 kTrackFull = rgb(0x8A8A8A);  ///< the filled part of a row's level bar
inline constexpr ImU32 kCheckboxEdge = rgb(0x6E6E6E);
inline constexpr ImU32 kDot = rgb(0x6A6A6A);

// Heights, in logical pixels.
inline constexpr float kTopBar = 40.0f;
inline constexpr float kViewportBar = 36.0f;
inline constexpr float kStatusBar = 24.0f;
inline constexpr float kPanelTitle = 34.0f;
inline constexpr float kFieldHeight = 24.0f;
inline constexpr float kIconButton = 26.0f;
inline constexpr float kChannelRow = 28.0f;
inline constexpr float kMaskRow = 38.0f;
inline constexpr float kMaterialRow = 40.0f;
inline constexpr float kLayerRow = 44.0f;
inline constexpr float kHistoryRow = 24.0f;
inline constexpr float kGap = 4.0f;
inline constexpr float kPadding = 12.0f;
}  // namespace theme

/// The style of Dear ImGui with these tokens, for a scale of 1 to 2.5.
ImGuiStyle scaled_style(float scale);

}  // namespace patina::editor
