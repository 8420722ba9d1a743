// SPDX-License-Identifier: MIT
#pragma once

/// Everything that has a name and can be asked for from a menu, a key or the palette, as one table.
/// To add one: an enumerator, a row in actions.cpp, and a case in the perform_... of its subject
/// (app/editor/workspace_*.cpp).

#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace patina::editor {

enum class Action {
    Open,
    OpenSample,
    NewSphere,
    NewRoundedCube,
    NewPlane,
    NewCylinder,
    NewTorus,
    Save,
    SaveAs,
    Export,
    Quit,
    Undo,
    Redo,
    Copy,
    Paste,
    FindAction,
    AddValueLayer,
    AddImageLayer,
    AddNoiseLayer,
    AddGroup,
    AddAdjustment,
    ClipLayer,
    SaveLayerPreset,
    DuplicateLayer,
    DeleteLayer,
    GroupLayer,
    UngroupLayer,
    RenameLayer,
    HideLayer,
    LockLayer,
    MoveLayerUp,
    MoveLayerDown,
    SelectLayerAbove,
    SelectLayerBelow,
    SoloLayer,
    ViewMask,
    AddNoiseMask,
    AddImageMask,
    ClearMask,
    AddMaterial,
    DuplicateMaterial,
    RenameMaterial,
    DeleteMaterial,
    ClearStack,
    SaveMaterialPreset,
    ViewSingle,
    ViewSplit,
    ViewTwo,
    ViewDifference,
    NextCompareMode,
    SwapSides,
    ShadePbr,
    ShadePhong,
    ShadeBlinnPhong,
    NextChannel,
    PreviousChannel,
    BrighterExposure,
    DarkerExposure,
    FrameModel,
    FrameMaterial,
    LookFromThreeQuarter,
    LookFromFront,
    LookFromBack,
    LookFromLeft,
    LookFromRight,
    LookFromTop,
    LookFromBottom,
    Orthographic,
    ProbeTool,
    ShowUv,
    ShowWires,
    ShowLights,
    SaveView,
    ResetLayout,
    HidePanels,
    ShowLog,
    KeepPrevious,
    LargerInterface,
    SmallerInterface,
    Keys,
    About,
};

enum class Menu { File, Edit, Layer, Material, View, Help, Camera };
/// Those in the bar at the top; Camera is among the tools of the viewport.
inline constexpr int kBarMenuCount = 6;
inline constexpr std::array<std::string_view, 7> kMenuNames = {"File", "Edit", "Layer", "Material",
                                                               "View", "Help", "Camera"};

/// What has to be there for the action to apply.
enum class Needs {
    Nothing,
    Document,
    Material,
    AddedMaterial,  ///< one that the file does not have
    Layer,
    Group,
    Mask,
    UndoStep,
    RedoStep,
};

struct ActionInfo {
    Action action;
    Menu menu;
    const char* icon;  ///< or null
    std::string_view label;
    std::string_view key;  ///< as it is written in menus; bindings are in app/editor/keys.cpp
    Needs needs;
    bool separator_before = false;
};

std::span<const ActionInfo> actions();
const ActionInfo& info(Action action);

}  // namespace patina::editor
