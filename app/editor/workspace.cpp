// SPDX-License-Identifier: MIT
#include "editor/workspace.h"

#include <fmt/format.h>

#include "document/edits.h"

namespace patina::editor {

void Workspace::carry_out(Requests requests) {
    for (const Edit& edit : requests.edits) session_->apply(edit);
    for (const Request& request : requests.others) carry_out_one(request);
}

void Workspace::carry_out_one(const Request& request) {
    if (const auto* action = std::get_if<Action>(&request)) perform(*action);
    if (const auto* file = std::get_if<TakeFile>(&request)) take_file(*file);
    if (const auto* preset = std::get_if<ApplyPreset>(&request)) apply_preset_by_id(*preset);
    if (const auto* turn = std::get_if<TurnKnobs>(&request)) turn_knobs(turn->id);
    if (const auto* choose = std::get_if<ChooseImageFor>(&request)) choose_image_for(*choose);
    if (const auto* cancel = std::get_if<CancelJob>(&request)) session_->cancel(cancel->job);
    if (const auto* toast = std::get_if<DismissToast>(&request)) session_->dismiss(toast->toast);
    if (const auto* held = std::get_if<HoldToast>(&request)) session_->hold_toast(held->toast);
    if (!session_->has_document()) return;
    if (const auto* step = std::get_if<JumpToStep>(&request))
        session_->history().jump_to(step->position);
    if (const auto* preset = std::get_if<SavePreset>(&request)) save_preset(*preset);
    if (const auto* made = std::get_if<AddNewLayer>(&request)) add_layer_and_select(made->layer);
    if (const auto* added = std::get_if<AddImageAsLayer>(&request)) {
        const auto found = session_->document().images.find(added->image);
        if (found != session_->document().images.end())
            add_layer_and_select(image_layer(*found->second));
    }
    if (const auto* assign = std::get_if<AssignMaterialAt>(&request)) assign_material_at(*assign);
    if (const auto* pick = std::get_if<PickAt>(&request)) {
        const glm::vec2 at(pick->x, pick->y);
        if (pick->explain) {
            session_->explain(view_, at);
            view_.right_tab = RightTab::Inspect;
        } else if (const auto hit = session_->pick(at)) {
            const MaterialPtr material = material_of(session_->document(), hit->source_material);
            if (material && material->id != view_.material) {
                view_.material = material->id;
                view_.layer = {};
            }
        }
    }
}

void Workspace::assign_material_at(const AssignMaterialAt& request) {
    const Document& document = session_->document();
    const MaterialPtr material = find_material(document, request.material);
    const auto hit = session_->pick(glm::vec2(request.x, request.y));
    if (!material || !hit) return;
    const MeshInstance& instance =
        document.scene->instances[static_cast<std::size_t>(hit->instance)];
    const PartRef ref = document.scene->meshes[static_cast<std::size_t>(instance.mesh)]
                            .primitives[static_cast<std::size_t>(hit->primitive)]
                            .source;
    for (const Part& part : parts_of(document)) {
        if (part.ref != ref || part.material == material) continue;
        session_->history().seal();
        if (session_->apply(assign_material(*material, part)))
            session_->toast(ToastKind::Done,
                            fmt::format("{} assigned to {}", material->name, part.name), "Undo",
                            Action::Undo);
    }
    view_.material = material->id;
}

void Workspace::perform(Action action) {
    perform_file(action);
    perform_material(action);
    perform_stack(action);
    perform_layer(action);
    perform_picture(action);
    perform_camera(action);
    perform_interface(action);
}

}  // namespace patina::editor
