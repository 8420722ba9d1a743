// SPDX-License-Identifier: MIT
#include "editor/widgets/theme.h"

#include <initializer_list>

namespace patina::editor {
namespace {

void set_colors(ImGuiStyle& style, std::initializer_list<ImGuiCol> which, ImU32 color) {
    for (const ImGuiCol index : which) style.Colors[index] = ImGui::ColorConvertU32ToFloat4(color);
}

void set_all_colors(ImGuiStyle& style) {
    constexpr ImU32 clear = IM_COL32(0, 0, 0, 0);
    set_colors(style, {ImGuiCol_Text}, theme::kText);
    set_colors(style, {ImGuiCol_TextDisabled}, theme::kText3);
    set_colors(style, {ImGuiCol_WindowBg}, theme::kPanel);
    set_colors(
        style,
        {ImGuiCol_ChildBg, ImGuiCol_BorderShadow, ImGuiCol_ScrollbarBg, ImGuiCol_ResizeGrip,
         ImGuiCol_ResizeGripHovered, ImGuiCol_ResizeGripActive, ImGuiCol_Tab, ImGuiCol_TabHovered,
         ImGuiCol_TabActive, ImGuiCol_TableHeaderBg, ImGuiCol_TableRowBg, ImGuiCol_TableRowBgAlt},
        clear);
    set_colors(style, {ImGuiCol_PopupBg}, theme::kPopup);
    set_colors(style, {ImGuiCol_Border}, theme::kBorder);
    set_colors(style, {ImGuiCol_FrameBg}, theme::kField);
    set_colors(style, {ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive}, theme::kFieldHover);
    set_colors(
        style,
        {ImGuiCol_TitleBg, ImGuiCol_TitleBgActive, ImGuiCol_TitleBgCollapsed, ImGuiCol_MenuBarBg},
        theme::kBar);
    set_colors(style, {ImGuiCol_ScrollbarGrab}, rgb(0x4A4A4A));
    set_colors(style, {ImGuiCol_ScrollbarGrabHovered}, rgb(0x5E5E5E));
    set_colors(style, {ImGuiCol_ScrollbarGrabActive}, rgb(0x757575));
    set_colors(style, {ImGuiCol_CheckMark}, theme::kInk);
    set_colors(style, {ImGuiCol_SliderGrab}, theme::kLevelLine);
    set_colors(style, {ImGuiCol_SliderGrabActive}, theme::kAccentHigh);
    set_colors(style, {ImGuiCol_Button}, theme::kField);
    set_colors(style, {ImGuiCol_ButtonHovered}, theme::kFieldHover);
    set_colors(style, {ImGuiCol_ButtonActive}, theme::kFieldPressed);
    set_colors(style, {ImGuiCol_Header}, theme::kSelected);
    set_colors(style, {ImGuiCol_HeaderHovered}, theme::kRowHover);
    set_colors(style, {ImGuiCol_HeaderActive}, theme::kSelectedHover);
    set_colors(style, {ImGuiCol_Separator}, theme::kHairline);
    set_colors(style, {ImGuiCol_SeparatorHovered, ImGuiCol_SeparatorActive}, theme::kAccent);
    set_colors(style, {ImGuiCol_TableBorderStrong, ImGuiCol_TableBorderLight}, theme::kTableLine);
    set_colors(style, {ImGuiCol_TextSelectedBg}, rgb(0x2C6B60));
    set_colors(style, {ImGuiCol_DragDropTarget, ImGuiCol_NavHighlight}, theme::kAccent);
    set_colors(style,
               {ImGuiCol_PlotLines, ImGuiCol_PlotLinesHovered, ImGuiCol_PlotHistogram,
                ImGuiCol_PlotHistogramHovered},
               theme::kText2);
    set_colors(style, {ImGuiCol_ModalWindowDimBg, ImGuiCol_NavWindowingDimBg},
               IM_COL32(0, 0, 0, 140));
}

}  // namespace

ImGuiStyle scaled_style(float scale) {
    ImGuiStyle style;
    style.WindowPadding = ImVec2(0, 0);
    style.WindowRounding = 6;
    style.PopupRounding = 6;
    style.ChildRounding = 0;
    style.FrameRounding = 4;
    style.GrabRounding = 2;
    style.ScrollbarSize = 8;
    style.ScrollbarRounding = 4;
    style.TabRounding = 0;
    style.WindowBorderSize = 0;
    style.ChildBorderSize = 0;
    style.FrameBorderSize = 0;
    style.TabBorderSize = 0;
    style.PopupBorderSize = 1;
    style.FramePadding = ImVec2(8, 4);
    style.ItemSpacing = ImVec2(4, 4);
    style.ItemInnerSpacing = ImVec2(6, 4);
    style.CellPadding = ImVec2(0, 3);
    style.IndentSpacing = 16;
    style.DisabledAlpha = 0.45f;
    style.SelectableTextAlign = ImVec2(0, 0.5f);
    style.WindowMenuButtonPosition = ImGuiDir_None;
    style.CircleTessellationMaxError = 0.2f;
    set_all_colors(style);
    style.ScaleAllSizes(scale);
    style.PopupBorderSize = 1;
    return style;
}

}  // namespace patina::editor
