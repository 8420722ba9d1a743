// SPDX-License-Identifier: MIT
#pragma once

/// What a panel hands back: edits of the document, and what else it asks for. Panels change nothing
/// but the ViewState.

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "core/hash.h"
#include "document/edit.h"
#include "document/layer.h"
#include "document/layer_edits.h"
#include "document/preset_knobs.h"
#include "editor/state/actions.h"

namespace patina::editor {

/// Where a file was let go.
enum class DropPlace { Window, Viewport, Layers };
/// Files from a dialog, the command line or a drop; what happens depends on their kind.
struct TakeFile {
    std::filesystem::path path;
    DropPlace place = DropPlace::Window;
};
/// Lays a preset of the shelf on the selected material.
struct ApplyPreset {
    std::string id;
    bool replace_stack = false;
    std::vector<KnobSetting> knobs = {};  ///< turned from where they stand in the preset
};
/// Asks how the knobs of a preset are to be turned, and then lays it on.
struct TurnKnobs {
    std::string id;
};
/// Writes the selected layer, or all layers of the material, as a preset of the user's own.
struct SavePreset {
    bool whole_material = false;
    std::string name = {};
    std::string category = {};
    std::string author = {};
    std::string licence = {};
    std::string description = {};
};
/// A layer that is not there yet, above the selected one.
struct AddNewLayer {
    Layer layer;
};
/// An image of the document as a new layer.
struct AddImageAsLayer {
    Hash128 image;
};
/// Draws the part under a point of the viewport with a material.
struct AssignMaterialAt {
    MaterialId material;
    float x = 0.0f;  ///< in shares of the picture
    float y = 0.0f;
};
struct JumpToStep {
    int position = 0;
};
struct CancelJob {
    int job = 0;
};
struct DismissToast {
    int toast = 0;
};
/// Keeps a message while the pointer is on it.
struct HoldToast {
    int toast = 0;
};
/// Asks for an image and puts it into a channel or a new mask entry of a layer.
struct ChooseImageFor {
    LayerId layer;
    std::variant<Channel, MaskEntryId, std::monostate> part;  ///< monostate: a new mask entry
};
/// Looks into the pixel under a point of the viewport, in shares of the picture.
struct PickAt {
    float x = 0.0f;
    float y = 0.0f;
    bool explain = false;  ///< keep it under the crosshair
};

using Request = std::variant<Action, TakeFile, ApplyPreset, TurnKnobs, SavePreset, AddNewLayer,
                             AddImageAsLayer, AssignMaterialAt, JumpToStep, CancelJob, DismissToast,
                             HoldToast, ChooseImageFor, PickAt>;

struct Requests {
    Edits edits;
    std::vector<Request> others;

    void edit(Edit edit) { edits.push_back(std::move(edit)); }
    /// Made in place: GCC warns falsely about a variant that is moved.
    template <typename Kind>
    void ask(Kind request) {
        others.emplace_back(std::move(request));
    }
    void append(Requests more) {
        for (Edit& each : more.edits) edits.push_back(std::move(each));
        for (Request& each : more.others) others.push_back(std::move(each));
    }
};

}  // namespace patina::editor
