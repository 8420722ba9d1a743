// SPDX-License-Identifier: MIT
#pragma once

/// What is looked at and how: selection, camera, open panels. Not part of the document: neither
/// undone nor saved with it.

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>

#include "core/hash.h"
#include "document/document.h"
#include "editor/widgets/curve_field.h"
#include "render/view.h"

namespace patina::editor {

/// Layers only where the window is too narrow for a left column; elsewhere that is Layer.
enum class RightTab { Layers, Layer, Material, Inspect };
enum class ShelfTab { Presets, Images, Environments };
enum class HistoryTab { History, Log };
enum class ViewportTool { Move, Probe };

/// Where splitters were put, in logical pixels; 0 is where the layout table has them.
struct Splitters {
    float left = 0.0f;
    float right = 0.0f;
    float shelf = 0.0f;
    float materials = 0.0f;
    bool operator==(const Splitters&) const = default;
};

/// Which parts are unfolded.
struct Unfolded {
    bool channels = true;
    bool mask = true;
    bool uv = true;
    bool bake = true;
    bool lights = true;
    bool environment = true;
    bool surface = true;
    bool parts = false;
    bool cost = true;
    bool crosshair = true;
    bool difference = true;
    bool terms = true;
    bool phong = true;
    bool shelf = true;
    bool narrow_shelf = false;       ///< in a narrow window, where it takes much of the room
    std::optional<Channel> channel;  ///< whose source editor is open
    bool uv_scale_linked = true;     ///< both scales change together
    bool uv_channels_linked = true;  ///< channels that lie alike are moved together
    std::optional<MaskEntryId> mask_entry;
};

/// A layer under way in the layer list.
struct LayerDrag {
    LayerId layer = {};
    bool moving = false;      ///< the pointer has left the 4 px around where it went down
    LayerId over_group = {};  ///< a folded group under the pointer, which opens after a while
    double over_since = 0.0;  ///< when it came under the pointer, in seconds
};

/// A preset or image of the shelf under way to the model or the layer list, or a material on its
/// way to a part of the model.
struct DragToModel {
    std::variant<std::monostate, std::string, Hash128, MaterialId> what;  ///< text: a preset's id
    bool moving = false;  ///< the pointer has left the 4 px around where it went down
};

struct ViewState {
    MaterialId material;
    LayerId layer;
    /// Camera, compare mode, shading ...; its environment and lights are the document's and are
    /// filled in when it is drawn.
    render::View view;
    RightTab right_tab = RightTab::Layers;
    ShelfTab shelf_tab = ShelfTab::Presets;
    HistoryTab history_tab = HistoryTab::History;
    ViewportTool tool = ViewportTool::Move;
    Splitters splitters;
    Unfolded unfolded;
    bool panels_hidden = false;
    bool refine_when_idle = true;
    std::string shelf_search;
    std::string shelf_category;        ///< empty: all
    std::set<std::string> favourites;  ///< ids of presets
    bool favourites_alone = false;     ///< the shelf shows no other presets
    bool small_cards = false;          ///< in the shelf
    std::optional<std::string> layer_search;
    std::optional<std::string> material_search;
    LayerDrag layer_drag;
    DragToModel drag_to_model;
    LayerId renaming_layer;
    MaterialId renaming_material;
    MaskEntryId renaming_mask_entry;
    MaskEntryId mask_entry_at_hand;  ///< under the pointer or with the keyboard at it; 0: none
    CurveHold curve;                 ///< of the adjustment that is shown
    /// The pixel of the viewport that is explained, in shares of the picture; unset: none.
    std::optional<glm::vec2> crosshair;
    /// The layer that is shown alone (Alt-click on its eye); 0: none.
    LayerId solo;
    /// Groups that were folded or unfolded here, where the file may say otherwise.
    std::map<LayerId, bool> unfolded_groups;
    /// Whose mask is shown in grey instead of the material; 0: none.
    LayerId viewed_mask;
};

/// Whether two shadings are on screen, and the tab beside them is about that.
inline bool is_comparing(const ViewState& view) {
    return view.view.compare != render::CompareMode::Single && view.tool != ViewportTool::Probe;
}

/// How many views of the model lie beside each other.
inline int view_columns(const render::View& view) {
    if (view.compare != render::CompareMode::TwoViews) return 1;
    return render::shows_difference_beside(view) ? 3 : 2;
}

/// Whether a group's children are listed below it. Folding is no edit: the file keeps what it said.
inline bool is_unfolded(const Layer& group, const ViewState& view) {
    const auto* content = std::get_if<GroupContent>(&group.content);
    if (content == nullptr) return false;
    const auto chosen = view.unfolded_groups.find(group.id);
    return chosen != view.unfolded_groups.end() ? chosen->second : content->open;
}

}  // namespace patina::editor
