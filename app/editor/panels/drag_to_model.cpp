// SPDX-License-Identifier: MIT
#include "editor/panels/panels.h"
#include "editor/widgets/dragging.h"

namespace patina::editor {
namespace {

struct Carried {
    Request drop;
    std::string name;
    Picture thumbnail;
    bool makes_layer = true;  ///< it can be dropped on the layer list too
};

/// What the drag holds, where that still exists.
std::optional<Carried> carried(const DragToModel& drag, const Shown& shown) {
    if (const auto* id = std::get_if<std::string>(&drag.what))
        for (const Preset* preset : shown.presets)
            if (preset->id == *id)
                return Carried{ApplyPreset{*id}, preset->name,
                               shown.thumbnails->preset(*preset, {})};
    if (const auto* image = std::get_if<Hash128>(&drag.what); image && shown.document)
        if (const auto found = shown.document->images.find(*image);
            found != shown.document->images.end())
            return Carried{AddImageAsLayer{*image}, found->second->name,
                           shown.thumbnails->image(*found->second)};
    if (const auto* id = std::get_if<MaterialId>(&drag.what); id && shown.document)
        if (const MaterialPtr material = find_material(*shown.document, *id))
            return Carried{AssignMaterialAt{*id, 0.0f, 0.0f}, material->name,
                           shown.thumbnails->material(*material), false};
    return std::nullopt;
}

/// A drop on the model: on a part it is about that part or its material, beside it about the
/// selected one.
Requests dropped_on_model(const Carried& dragged, float x, float y) {
    Requests requests;
    if (const auto* assign = std::get_if<AssignMaterialAt>(&dragged.drop)) {
        requests.ask(AssignMaterialAt{assign->material, x, y});
    } else {
        requests.ask(PickAt{x, y});
        requests.ask(dragged.drop);
    }
    return requests;
}

}  // namespace

bool clicked_or_dragged(const Ui& ui, const Press& pressed, DragToModel dragged, ViewState& view) {
    if (pressed.started) view.drag_to_model = std::move(dragged);
    if (pressed.held && drag_has_begun(ui)) view.drag_to_model.moving = true;
    // Who is used to double clicks wants it once all the same.
    const bool once_more =
        pressed.released && ImGui::GetIO().MouseClickedLastCount[ImGuiMouseButton_Left] > 1;
    return pressed.clicked && !once_more && !view.drag_to_model.moving;
}

Requests carry_to_model(Ui& ui, const Rect& viewport, const Rect& layers, const Shown& shown,
                        ViewState& view) {
    Requests requests;
    if (!view.drag_to_model.moving) return requests;
    const std::optional<Carried> dragged = carried(view.drag_to_model, shown);
    if (!dragged || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) {
        view.drag_to_model = {};
        return requests;
    }
    const ImVec2 mouse = ImGui::GetMousePos();
    const bool on_layers = dragged->makes_layer && layers.contains(mouse.x, mouse.y);
    if (on_layers) outline(ui, layers, theme::kAccent, 6, 1);
    draw_ghost(ui, dragged->thumbnail, dragged->name);
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return requests;
    const bool on_view = viewport.contains(mouse.x, mouse.y);
    if (on_view)
        requests.append(dropped_on_model(*dragged, (mouse.x - viewport.x0) / viewport.width(),
                                         (mouse.y - viewport.y0) / viewport.height()));
    if (on_layers) requests.ask(dragged->drop);
    view.drag_to_model = {};
    return requests;
}

}  // namespace patina::editor
