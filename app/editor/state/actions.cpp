// SPDX-License-Identifier: MIT
#include "editor/state/actions.h"

#include <array>

#include "editor/widgets/icons.h"

namespace patina::editor {
namespace {

// clang-format off
constexpr std::array kActions = {
    ActionInfo{Action::Open, Menu::File, icon::kFolderOpen, "Open\u2026", "Ctrl O", Needs::Nothing},
    ActionInfo{Action::OpenSample, Menu::File, nullptr, "Open the sample", "", Needs::Nothing},
    ActionInfo{Action::NewSphere, Menu::File, nullptr, "New sphere", "", Needs::Nothing, true},
    ActionInfo{Action::NewRoundedCube, Menu::File, nullptr, "New rounded cube", "", Needs::Nothing},
    ActionInfo{Action::NewPlane, Menu::File, nullptr, "New plane", "", Needs::Nothing},
    ActionInfo{Action::NewCylinder, Menu::File, nullptr, "New cylinder", "", Needs::Nothing},
    ActionInfo{Action::NewTorus, Menu::File, nullptr, "New torus", "", Needs::Nothing},
    ActionInfo{Action::Save, Menu::File, icon::kSave, "Save", "Ctrl S", Needs::Document, true},
    ActionInfo{Action::SaveAs, Menu::File, nullptr, "Save as\u2026", "Ctrl Shift S", Needs::Document},
    ActionInfo{Action::Export, Menu::File, icon::kExport, "Export maps\u2026", "Ctrl E", Needs::Document},
    ActionInfo{Action::KeepPrevious, Menu::File, nullptr, "Keep the previous version as name~", "", Needs::Nothing, true},
    ActionInfo{Action::Quit, Menu::File, nullptr, "Quit", "Ctrl Q", Needs::Nothing, true},

    ActionInfo{Action::Undo, Menu::Edit, icon::kUndo, "Undo", "Ctrl Z", Needs::UndoStep},
    ActionInfo{Action::Redo, Menu::Edit, icon::kRedo, "Redo", "Ctrl Shift Z", Needs::RedoStep},
    ActionInfo{Action::Copy, Menu::Edit, icon::kCopy, "Copy layer", "Ctrl C", Needs::Layer, true},
    ActionInfo{Action::Paste, Menu::Edit, icon::kPaste, "Paste layers", "Ctrl V", Needs::Material},
    ActionInfo{Action::FindAction, Menu::Edit, icon::kSearch, "Find an action", "Ctrl K", Needs::Nothing, true},

    ActionInfo{Action::AddValueLayer, Menu::Layer, icon::kDroplet, "Add value layer", "", Needs::Material},
    ActionInfo{Action::AddNoiseLayer, Menu::Layer, icon::kNoise, "Add noise layer", "", Needs::Material},
    ActionInfo{Action::AddImageLayer, Menu::Layer, icon::kImage, "Add image layer\u2026", "", Needs::Material},
    ActionInfo{Action::AddGroup, Menu::Layer, icon::kFolder, "Add group", "", Needs::Material},
    ActionInfo{Action::AddAdjustment, Menu::Layer, icon::kInvert, "Add adjustment", "", Needs::Material},
    ActionInfo{Action::ClipLayer, Menu::Layer, nullptr, "Clip to layer below", "", Needs::Layer},
    ActionInfo{Action::DuplicateLayer, Menu::Layer, icon::kClone, "Duplicate layer", "Ctrl D", Needs::Layer, true},
    ActionInfo{Action::GroupLayer, Menu::Layer, nullptr, "Group layer", "Ctrl G", Needs::Layer},
    ActionInfo{Action::UngroupLayer, Menu::Layer, nullptr, "Ungroup", "Ctrl Shift G", Needs::Group},
    ActionInfo{Action::RenameLayer, Menu::Layer, icon::kPencil, "Rename layer", "F2", Needs::Layer},
    ActionInfo{Action::HideLayer, Menu::Layer, icon::kEye, "Hide or show layer", "H", Needs::Layer},
    ActionInfo{Action::LockLayer, Menu::Layer, icon::kLock, "Lock or unlock layer", "", Needs::Layer},
    ActionInfo{Action::DeleteLayer, Menu::Layer, icon::kTrash, "Delete layer", "Delete", Needs::Layer},
    ActionInfo{Action::SaveLayerPreset, Menu::Layer, icon::kSave, "Save layer as preset\u2026", "", Needs::Layer},
    ActionInfo{Action::MoveLayerUp, Menu::Layer, nullptr, "Move layer up", "Alt Up", Needs::Layer, true},
    ActionInfo{Action::MoveLayerDown, Menu::Layer, nullptr, "Move layer down", "Alt Down", Needs::Layer},
    ActionInfo{Action::SelectLayerAbove, Menu::Layer, nullptr, "Choose layer above", "Up", Needs::Material},
    ActionInfo{Action::SelectLayerBelow, Menu::Layer, nullptr, "Choose layer below", "Down", Needs::Material},
    ActionInfo{Action::SoloLayer, Menu::Layer, nullptr, "Show layer alone", "Alt-click eye", Needs::Layer},
    ActionInfo{Action::AddNoiseMask, Menu::Layer, icon::kPlus, "Add noise to mask", "", Needs::Layer, true},
    ActionInfo{Action::AddImageMask, Menu::Layer, nullptr, "Add image to mask\u2026", "", Needs::Layer},
    ActionInfo{Action::ViewMask, Menu::Layer, nullptr, "View mask", "Alt-click mask", Needs::Mask},
    ActionInfo{Action::ClearMask, Menu::Layer, nullptr, "Remove mask", "", Needs::Mask},

    ActionInfo{Action::AddMaterial, Menu::Material, icon::kPlus, "Add material", "", Needs::Document},
    ActionInfo{Action::DuplicateMaterial, Menu::Material, icon::kClone, "Duplicate material", "", Needs::Material},
    ActionInfo{Action::RenameMaterial, Menu::Material, icon::kPencil, "Rename material", "", Needs::Material},
    ActionInfo{Action::DeleteMaterial, Menu::Material, icon::kTrash, "Delete added material", "", Needs::AddedMaterial},
    ActionInfo{Action::ClearStack, Menu::Material, nullptr, "Remove all layers", "", Needs::Material, true},
    ActionInfo{Action::SaveMaterialPreset, Menu::Material, icon::kSave, "Save material as preset\u2026", "", Needs::Material},

    ActionInfo{Action::ViewSingle, Menu::View, nullptr, "Single view", "", Needs::Nothing},
    ActionInfo{Action::ViewSplit, Menu::View, nullptr, "Split view", "", Needs::Nothing},
    ActionInfo{Action::ViewTwo, Menu::View, nullptr, "Two views", "", Needs::Nothing},
    ActionInfo{Action::ViewDifference, Menu::View, nullptr, "Difference", "", Needs::Nothing},
    ActionInfo{Action::NextCompareMode, Menu::View, nullptr, "Next compare mode", "V", Needs::Nothing},
    ActionInfo{Action::SwapSides, Menu::View, icon::kSwap, "Swap sides", "X", Needs::Nothing},
    ActionInfo{Action::ShadePbr, Menu::View, nullptr, "Shade as PBR", "P", Needs::Nothing, true},
    ActionInfo{Action::ShadePhong, Menu::View, nullptr, "Shade as Phong", "O", Needs::Nothing},
    ActionInfo{Action::ShadeBlinnPhong, Menu::View, nullptr, "Shade as Blinn-Phong", "", Needs::Nothing},
    ActionInfo{Action::NextChannel, Menu::View, nullptr, "Next channel", "C", Needs::Nothing, true},
    ActionInfo{Action::PreviousChannel, Menu::View, nullptr, "Previous channel", "Shift C", Needs::Nothing},
    ActionInfo{Action::BrighterExposure, Menu::View, nullptr, "Brighter by 1/3 EV", "]", Needs::Nothing},
    ActionInfo{Action::DarkerExposure, Menu::View, nullptr, "Darker by 1/3 EV", "[", Needs::Nothing},
    ActionInfo{Action::FrameModel, Menu::View, icon::kFrame, "Frame the model", "F", Needs::Document, true},
    ActionInfo{Action::ProbeTool, Menu::View, icon::kEyedropper, "Read and explain a texel", "I", Needs::Document},
    ActionInfo{Action::ShowUv, Menu::View, icon::kGrid, "UV checker", "U", Needs::Document},
    ActionInfo{Action::ShowWires, Menu::View, nullptr, "Wires", "W", Needs::Document},
    ActionInfo{Action::ShowLights, Menu::View, icon::kSun, "Lights", "", Needs::Document},
    ActionInfo{Action::SaveView, Menu::View, icon::kCamera, "Save the view\u2026", "", Needs::Document},
    ActionInfo{Action::HidePanels, Menu::View, nullptr, "Hide or show panels", "F10", Needs::Nothing, true},
    ActionInfo{Action::ShowLog, Menu::View, nullptr, "Log", "", Needs::Nothing},
    ActionInfo{Action::ResetLayout, Menu::View, nullptr, "Reset the layout", "", Needs::Nothing},
    ActionInfo{Action::LargerInterface, Menu::View, nullptr, "Larger interface", "Ctrl +", Needs::Nothing},
    ActionInfo{Action::SmallerInterface, Menu::View, nullptr, "Smaller interface", "Ctrl \u2212", Needs::Nothing},

    ActionInfo{Action::FrameMaterial, Menu::Camera, nullptr, "Frame the material", "Shift F", Needs::Material},
    ActionInfo{Action::LookFromThreeQuarter, Menu::Camera, nullptr, "Three-quarter view", "", Needs::Document, true},
    ActionInfo{Action::LookFromFront, Menu::Camera, nullptr, "Front view", "", Needs::Document},
    ActionInfo{Action::LookFromBack, Menu::Camera, nullptr, "Back view", "", Needs::Document},
    ActionInfo{Action::LookFromLeft, Menu::Camera, nullptr, "Left view", "", Needs::Document},
    ActionInfo{Action::LookFromRight, Menu::Camera, nullptr, "Right view", "", Needs::Document},
    ActionInfo{Action::LookFromTop, Menu::Camera, nullptr, "Top view", "", Needs::Document},
    ActionInfo{Action::LookFromBottom, Menu::Camera, nullptr, "Bottom view", "", Needs::Document},
    ActionInfo{Action::Orthographic, Menu::Camera, nullptr, "Orthographic", "", Needs::Document, true},

    ActionInfo{Action::Keys, Menu::Help, icon::kQuestion, "Keys and mouse", "F1", Needs::Nothing},
    ActionInfo{Action::About, Menu::Help, nullptr, "About Patina", "", Needs::Nothing},
};
// clang-format on

}  // namespace

std::span<const ActionInfo> actions() {
    return kActions;
}

const ActionInfo& info(Action action) {
    for (const ActionInfo& row : kActions)
        if (row.action == action) return row;
    return kActions[0];
}

}  // namespace patina::editor
