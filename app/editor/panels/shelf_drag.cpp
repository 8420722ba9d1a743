// SPDX-License-Identifier: MIT
#include "editor/panels/panels.h"
#include "editor/widgets/dragging.h"

namespace patina::editor {
namespace {

struct Carried {
    Request drop;
    std::string name;
    Picture thumbnail;
};

/// What the drag holds, where that still exists.
std::optional<Carried> carried(const ShelfDrag& drag, const Shown& shown) {
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
    return std::nullopt;
}

}  // namespace

Requests carry_shelf_drag(Ui& ui, const Rect& viewport, const Rect& layers, const Shown& shown,
                          ViewState& view) {
    Requests requests;
    if (!view.shelf_drag.moving) return requests;
    const std::optional<Carried> dragged = carried(view.shelf_drag, shown);
    if (!dragged || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) {
        view.shelf_drag = {};
        return requests;
    }
    const ImVec2 mouse = ImGui::GetMousePos();
    const bool on_layers = layers.contains(mouse.x, mouse.y);
    if (on_layers) outline(ui, layers, theme::kAccent, 6, 1);
    draw_ghost(ui, dragged->thumbnail, dragged->name);
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return requests;
    const bool on_view = viewport.contains(mouse.x, mouse.y);
    // On a part of the model it goes to that part's material, beside it to the selected one.
    if (on_view)
        requests.ask(PickAt{(mouse.x - viewport.x0) / viewport.width(),
                            (mouse.y - viewport.y0) / viewport.height()});
    if (on_view || on_layers) requests.ask(dragged->drop);
    view.shelf_drag = {};
    return requests;
}

}  // namespace patina::editor
