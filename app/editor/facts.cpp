// SPDX-License-Identifier: MIT
#include "editor/facts.h"

#include <fmt/format.h>

#include "core/hash.h"
#include "document/record.h"

namespace patina::editor {
namespace {

constexpr const char* yes_or_no(bool holds) {
    return holds ? "yes" : "no";
}

void state_view(UiMap& map, const ViewState& view) {
    const render::View& picture = view.view;
    map.set_fact("channel", render::info(picture.channel).id);
    map.set_fact("compare", render::kCompareModes[static_cast<std::size_t>(picture.compare)].id);
    map.set_fact("left", render::kShadingModels[static_cast<std::size_t>(picture.left.model)].id);
    map.set_fact("right", render::kShadingModels[static_cast<std::size_t>(picture.right.model)].id);
    map.set_fact("left path", render::kRenderPaths[static_cast<std::size_t>(picture.left.path)].id);
    map.set_fact("right path",
                 render::kRenderPaths[static_cast<std::size_t>(picture.right.path)].id);
    const render::Camera& camera = picture.camera;
    map.set_fact("camera", fmt::format("{:.2f} {:.2f} {:.2f}", camera.position.x, camera.position.y,
                                       camera.position.z));
    map.set_fact("lens", camera.orthographic_height > 0.0f
                             ? "orthographic"
                             : fmt::format("{:.0f}", camera.fov_y_degrees));
    map.set_fact("divider", fmt::format("{:.3f}", picture.divider));
}

}  // namespace

void Facts::state_document(UiMap& map, const Shown& shown) {
    map.set_fact("document", shown.document ? shown.file_name : "");
    map.set_fact("edited", yes_or_no(shown.edited));
    map.set_fact("undo", yes_or_no(shown.history.can_undo));
    map.set_fact("redo", yes_or_no(shown.history.can_redo));
    map.set_fact("steps", std::to_string(shown.history.labels.size()));
    map.set_fact("material", shown.material ? shown.material->name : "");
    map.set_fact("environment", shown.document ? shown.document->environment.name : "");
    map.set_fact("layer", shown.layer ? shown.layer->name : "");
    if (hashed_ != shown.document) {
        hashed_ = shown.document;
        content_ = hashed_ ? to_hex(hash_text(serialise(*hashed_))) : "";
    }
    map.set_fact("content", content_);
}

void Facts::state(Ui& ui, const Frame& frame) {
    UiMap& map = ui.map;
    if (!map.is_written()) return;
    const bool held = ImGui::IsAnyMouseDown();
    map.set_fact("settled", yes_or_no(frame.quiet && !held && frame.session.settled()));
    // Input is taken in its order: who sent a pointer move sees here that all before it was taken.
    const ImVec2 mouse = ImGui::GetMousePos();
    map.set_fact("pointer", ImGui::IsMousePosValid(&mouse)
                                ? fmt::format("{:.0f} {:.0f}", mouse.x, mouse.y)
                                : "");
    state_document(map, frame.shown);
    state_view(map, frame.view);
    const RefinementShown& refined = frame.shown.refinement;
    map.set_fact("samples", fmt::format("{}/{}", refined.drawn, refined.draws));
    const Rect& viewport = frame.layout.viewport;
    map.set_fact("viewport", fmt::format("{} {} {} {}", viewport.x0, viewport.y0, viewport.width(),
                                         viewport.height()));
    map.set_fact("scale", fmt::format("{:.2f}", ui.scale));
}

}  // namespace patina::editor
