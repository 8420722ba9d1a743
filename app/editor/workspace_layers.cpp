// SPDX-License-Identifier: MIT
#include "editor/workspace.h"

#include <imgui.h>

#include "document/edits.h"

namespace patina::editor {
namespace {

/// All layers that are unfolded in the list, top to bottom.
void listed(const std::vector<LayerPtr>& layers, const ViewState& view,
            std::vector<LayerPtr>& result) {
    for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) {
        result.push_back(*layer);
        if (is_unfolded(**layer, view))
            listed(std::get<GroupContent>((*layer)->content).children, view, result);
    }
}

/// The list that holds the layer (siblings, bottom to top) and its place in it.
struct Siblings {
    const std::vector<LayerPtr>* list = nullptr;
    std::size_t index = 0;
    LayerPtr parent;
};

std::optional<Siblings> siblings_of(const std::vector<LayerPtr>& layers, LayerId id,
                                    const LayerPtr& parent = nullptr) {
    for (std::size_t i = 0; i < layers.size(); ++i) {
        if (layers[i]->id == id) return Siblings{&layers, i, parent};
        const auto* group = std::get_if<GroupContent>(&layers[i]->content);
        if (group == nullptr) continue;
        if (auto found = siblings_of(group->children, id, layers[i])) return found;
    }
    return std::nullopt;
}

/// The topmost layer that is not in `before`; null when all are.
LayerPtr first_new(const std::vector<LayerPtr>& layers, const Material& before) {
    for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) {
        if (!find_layer(before, (*layer)->id)) return *layer;
        const auto* group = std::get_if<GroupContent>(&(*layer)->content);
        if (group == nullptr) continue;
        if (LayerPtr found = first_new(group->children, before)) return found;
    }
    return nullptr;
}

}  // namespace

void Workspace::add_layer_and_select(const Layer& layer) {
    const MaterialPtr material = session_->selected_material(view_);
    if (!material) return;
    const LayerPtr selected = session_->selected_layer(view_);
    const LayerId id = next_layer_id(session_->document());
    session_->history().seal();
    if (session_->apply(
            add_layer(*material, layer, selected ? above(selected->id) : top_of_stack())))
        view_.layer = id;
    session_->history().seal();
}

/// What is made is what is named and worked on next.
void Workspace::add_material_and_select(const Edit& edit) {
    const MaterialId id{session_->document().next_id};
    session_->history().seal();
    if (!session_->apply(edit)) return;
    view_.material = id;
    view_.layer = {};
    view_.renaming_material = id;
}

/// What an edit made (a copy, a group, what was pasted) is what the next one is about.
void Workspace::edit_and_select_new(const Edit& edit) {
    const MaterialPtr before = session_->selected_material(view_);
    session_->history().seal();
    const bool applied = session_->apply(edit);
    session_->history().seal();
    const MaterialPtr after = session_->selected_material(view_);
    if (!applied || !before || !after || before == after) return;
    if (const LayerPtr made = first_new(after->stack, *before)) view_.layer = made->id;
}

void Workspace::select_neighbour(int step) {
    const MaterialPtr material = session_->selected_material(view_);
    if (!material) return;
    std::vector<LayerPtr> rows;
    listed(material->stack, view_, rows);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i]->id != view_.layer) continue;
        const std::ptrdiff_t next = static_cast<std::ptrdiff_t>(i) + step;
        if (next >= 0 && next < static_cast<std::ptrdiff_t>(rows.size()))
            view_.layer = rows[static_cast<std::size_t>(next)]->id;
        return;
    }
}

void Workspace::move_selected(int step) {
    const MaterialPtr material = session_->selected_material(view_);
    const LayerPtr layer = session_->selected_layer(view_);
    if (!layer) return;
    const auto siblings = siblings_of(material->stack, layer->id);
    if (!siblings) return;
    const std::ptrdiff_t next = static_cast<std::ptrdiff_t>(siblings->index) + step;
    const auto count = static_cast<std::ptrdiff_t>(siblings->list->size());
    std::optional<LayerPlace> place;
    if (next >= 0 && next < count) {
        const LayerId neighbour = (*siblings->list)[static_cast<std::size_t>(next)]->id;
        place = step > 0 ? above(neighbour) : below(neighbour);
    } else if (siblings->parent) {
        place = step > 0 ? above(siblings->parent->id) : below(siblings->parent->id);
    }
    if (place) session_->apply(move_layer(*material, *layer, *place));
}

void Workspace::perform_material(Action action) {
    if (!session_->has_document()) return;
    const MaterialPtr material = session_->selected_material(view_);
    switch (action) {
        case Action::Undo:
            session_->history().undo();
            return;
        case Action::Redo:
            session_->history().redo();
            return;
        case Action::AddMaterial:
            return add_material_and_select(
                add_material(free_material_name(session_->document(), "Material")));
        case Action::DuplicateMaterial:
            if (material) add_material_and_select(duplicate_material(*material));
            return;
        case Action::DeleteMaterial:
            if (material) edit_and_select_new(remove_material(*material));
            return;
        case Action::RenameMaterial:
            if (material) view_.renaming_material = material->id;
            return;
        case Action::ClearStack:
            if (material) edit_and_select_new(replace_stack(*material, {}, "Remove all layers"));
            return;
        case Action::SaveMaterialPreset:
            if (material) ask_save_preset(true);
            return;
        default:
            return;
    }
}

/// What needs a material, and no layer.
void Workspace::perform_stack(Action action) {
    if (!session_->has_document()) return;
    const MaterialPtr material = session_->selected_material(view_);
    if (!material) return;
    switch (action) {
        case Action::AddValueLayer:
            return add_layer_and_select(value_layer());
        case Action::AddNoiseLayer:
            return add_layer_and_select(procedural_layer(ProceduralKind::PerlinNoise));
        case Action::AddGroup:
            return add_layer_and_select(group_layer());
        case Action::AddAdjustment:
            return add_layer_and_select(adjustment_layer(AdjustmentKind::Levels));
        case Action::AddImageLayer:
            ask_image([this](const ImageAssetPtr& image) { add_image_layer(image); });
            return;
        case Action::SelectLayerAbove:
            return select_neighbour(-1);
        case Action::SelectLayerBelow:
            return select_neighbour(1);
        case Action::Paste: {
            const char* clipboard = ImGui::GetClipboardText();
            const LayerPtr layer = session_->selected_layer(view_);
            const LayerPlace place = layer ? above(layer->id) : top_of_stack();
            return edit_and_select_new(
                paste_layers(*material, clipboard == nullptr ? "" : clipboard, place));
        }
        default:
            return;
    }
}

/// What is done to the layer that is chosen, and to its mask.
void Workspace::perform_layer(Action action) {
    if (!session_->has_document()) return;
    const MaterialPtr material = session_->selected_material(view_);
    const LayerPtr layer = session_->selected_layer(view_);
    if (!material || !layer) return;
    const auto edit = [this](const Edit& each) { edit_and_select_new(each); };
    switch (action) {
        case Action::DuplicateLayer:
            return edit(duplicate_layer(*material, *layer));
        case Action::DeleteLayer:
            return edit(remove_layer(*material, *layer));
        case Action::GroupLayer:
            return edit(group_layers(*material, {layer}));
        case Action::UngroupLayer:
            if (layer->is_group()) edit(ungroup_layer(*material, *layer));
            return;
        case Action::RenameLayer:
            if (view_.mask_entry_at_hand != MaskEntryId{})
                view_.renaming_mask_entry = view_.mask_entry_at_hand;
            else
                view_.renaming_layer = layer->id;
            return;
        case Action::HideLayer:
            return edit(set_layer_visible(*material, *layer, !layer->visible));
        case Action::ClipLayer:
            return edit(set_layer_clipped(*material, *layer, !layer->clipped));
        case Action::LockLayer:
            return edit(set_layer_locked(*material, *layer, !layer->locked));
        case Action::SaveLayerPreset:
            return ask_save_preset(false);
        case Action::MoveLayerUp:
            return move_selected(1);
        case Action::MoveLayerDown:
            return move_selected(-1);
        case Action::SoloLayer:
            view_.solo = view_.solo == layer->id ? LayerId{} : layer->id;
            return;
        case Action::ViewMask:
            view_.viewed_mask = view_.viewed_mask == layer->id ? LayerId{} : layer->id;
            return;
        case Action::AddNoiseMask:
            return edit(add_mask_entry(*material, *layer,
                                       procedural_mask_entry(ProceduralKind::PerlinNoise)));
        case Action::AddImageMask:
            return choose_image_for({layer->id, std::monostate{}});
        case Action::ClearMask:
            return edit(clear_mask(*material, *layer));
        case Action::Copy:
            ImGui::SetClipboardText(copied_layers({layer}, material->stack).c_str());
            return session_->toast(ToastKind::Done, "Copied " + layer->name);
        default:
            return;
    }
}

}  // namespace patina::editor
