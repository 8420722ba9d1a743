// SPDX-License-Identifier: MIT
#include "editor/workspace.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "document/edits.h"

namespace patina::editor {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kModels = {".glb", ".gltf"};
const std::vector<std::string> kImages = {".png", ".jpg",  ".jpeg", ".tif", ".tiff", ".exr",
                                          ".hdr", ".webp", ".psd",  ".tga", ".bmp"};

std::string ending_of(const fs::path& path) {
    std::string ending = path.extension().string();
    for (char& letter : ending)
        letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return ending;
}

bool is_one_of(const std::string& ending, const std::vector<std::string>& endings) {
    return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

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

// --- requests ------------------------------------------------------------------------------------

void Workspace::carry_out(Requests requests) {
    for (const Edit& edit : requests.edits) session_->apply(edit);
    for (const Request& request : requests.others) carry_out_one(request);
}

void Workspace::carry_out_one(const Request& request) {
    if (const auto* action = std::get_if<Action>(&request)) perform(*action);
    if (const auto* file = std::get_if<TakeFile>(&request)) take_file(*file);
    if (const auto* preset = std::get_if<ApplyPreset>(&request)) apply_preset_by_id(*preset);
    if (const auto* choose = std::get_if<ChooseImageFor>(&request)) choose_image_for(*choose);
    if (const auto* cancel = std::get_if<CancelJob>(&request)) session_->cancel(cancel->job);
    if (const auto* toast = std::get_if<DismissToast>(&request)) session_->dismiss(toast->toast);
    if (const auto* held = std::get_if<HoldToast>(&request)) session_->hold_toast(held->toast);
    if (!session_->has_document()) return;
    if (const auto* step = std::get_if<JumpToStep>(&request))
        session_->history().jump_to(step->position);
    if (const auto* added = std::get_if<AddImageAsLayer>(&request)) {
        const auto found = session_->document().images.find(added->image);
        if (found != session_->document().images.end())
            add_layer_and_select(image_layer(*found->second));
    }
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

void Workspace::perform(Action action) {
    perform_file(action);
    perform_layer(action);
    perform_view(action);
}

// --- files ---------------------------------------------------------------------------------------

void Workspace::when_edits_may_go(std::function<void()> go_on) {
    if (!session_->is_edited()) return go_on();
    const std::string name =
        session_->path().empty() ? "the sample" : session_->path().filename().string();
    question_.ask({.title = "Save the edits?",
                   .text = fmt::format("{} has edits that are not saved. Without saving they are "
                                       "lost.",
                                       name),
                   .answers = {{"Save", [this, go_on] { save_then(go_on); }, true},
                               {"Discard", go_on},
                               {"Cancel", {}}}});
}

void Workspace::save_then(std::function<void()> after) {
    if (session_->path().empty()) return ask_save_as(std::move(after));
    session_->save(session_->path(), std::move(after));
}

void Workspace::ask_save_as(std::function<void()> after) {
    const std::string name =
        session_->path().empty() ? "shader_ball.glb" : session_->path().filename().string();
    file_dialog_.open({.title = "Save as",
                       .button = "Save",
                       .extensions = kModels,
                       .name = name,
                       .writing = true,
                       .folder = false,
                       .chosen = [this, after = std::move(after)](const fs::path& path) {
                           session_->save(path, after);
                       }});
}

void Workspace::ask_export() {
    const auto chosen = [this](const fs::path& folder) {
        const fs::path target = session_->export_target(folder);
        std::error_code error;
        if (!fs::exists(target, error)) return session_->export_maps(folder);
        question_.ask({.title = "Replace the model there?",
                       .text = fmt::format("{} is in {} already. The copy of the model with its "
                                           "baked maps would take its place.",
                                           quoted_for_message(target.filename().string(), 80),
                                           quoted_for_message(folder.string(), 120)),
                       .answers = {{"Replace", [this, folder] { session_->export_maps(folder); }},
                                   {"Choose another folder", [this] { ask_export(); }, true},
                                   {"Cancel", {}}}});
    };
    file_dialog_.open({.title = "Export the baked maps and a copy of the model to",
                       .button = "Export here",
                       .extensions = {},
                       .name = {},
                       .folder = true,
                       .chosen = chosen});
}

void Workspace::perform_file(Action action) {
    switch (action) {
        case Action::Open:
            when_edits_may_go([this] {
                file_dialog_.open(
                    {.title = "Open a model",
                     .button = "Open",
                     .extensions = kModels,
                     .name = {},
                     .chosen = [this](const fs::path& path) { session_->open(path); }});
            });
            return;
        case Action::OpenSample:
            when_edits_may_go([this] { session_->open_sample(); });
            return;
        case Action::Save:
            if (session_->has_document()) save_then({});
            return;
        case Action::SaveAs:
            if (session_->has_document()) ask_save_as({});
            return;
        case Action::Export:
            if (session_->has_document()) ask_export();
            return;
        case Action::SaveView:
            if (session_->has_document())
                file_dialog_.open(
                    {.title = "Save the view, 1920 \u00d7 1080",
                     .button = "Save",
                     .extensions = {".png"},
                     .name = "view.png",
                     .writing = true,
                     .chosen = [this](const fs::path& path) { session_->save_view(path, view_); }});
            return;
        case Action::KeepPrevious:
            return session_->set_keep_previous(!session_->keeps_previous());
        case Action::Quit:
            quit();
            return;
        default:
            return;
    }
}

void Workspace::quit() {
    if (question_.is_open()) return;
    when_edits_may_go([this] { quitting_ = true; });
}

void Workspace::take_file(const TakeFile& file) {
    const fs::path& path = file.path;
    const std::string ending = ending_of(path);
    if (is_one_of(ending, kModels)) {
        when_edits_may_go([this, path] { session_->open(path); });
    } else if (ending == ".hdr" || (ending == ".exr" && file.place != DropPlace::Layers)) {
        session_->use_environment_file(path);
    } else if (ending == ".json") {
        apply_preset_from(path);
    } else if (is_one_of(ending, kImages)) {
        if (!session_->has_document())
            session_->toast(ToastKind::Note, "Open a model before dropping images");
        else
            session_->with_image(path,
                                 [this](const ImageAssetPtr& image) { add_image_layer(image); });
    } else {
        session_->toast(ToastKind::Error,
                        fmt::format("Cannot use {}: not a model, image, preset or panorama",
                                    quoted_for_message(path.filename().string())));
    }
}

void Workspace::ask_image(std::function<void(const ImageAssetPtr&)> use) {
    file_dialog_.open({.title = "Choose an image",
                       .button = "Use",
                       .extensions = kImages,
                       .name = {},
                       .chosen = [this, use = std::move(use)](const fs::path& path) {
                           session_->with_image(path, use);
                       }});
}

void Workspace::use_image(const ImageAssetPtr& image, Edit edit, std::string label) {
    session_->history().seal();
    session_->apply(in_one_step(std::move(label), {add_image(image), std::move(edit)}));
    session_->history().seal();
}

void Workspace::add_image_layer(const ImageAssetPtr& image) {
    const MaterialPtr material = session_->selected_material(view_);
    if (!material) return;
    const LayerPtr selected = session_->selected_layer(view_);
    const LayerPlace place = selected ? above(selected->id) : top_of_stack();
    edit_and_select_new(
        in_one_step("Add image " + image->name,
                    {add_image(image), add_layer(*material, image_layer(*image), place)}));
}

void Workspace::choose_image_for(const ChooseImageFor& request) {
    ask_image([this, request](const ImageAssetPtr& image) {
        const MaterialPtr material = session_->selected_material(view_);
        const LayerPtr layer = material ? find_layer(*material, request.layer) : nullptr;
        if (!layer) return;
        if (const auto* channel = std::get_if<Channel>(&request.part)) {
            const SourcePlace place = source_place(*material, *layer, *channel);
            ImageSource source{.image = image->hash};
            const bool color = info(*channel).kind == ChannelKind::Color;
            source.color_space =
                color && image->type != SampleType::F32 ? ColorSpace::Srgb : ColorSpace::Linear;
            const auto* before = std::get_if<ImageSource>(find_source(*material, place));
            Edit edit = before != nullptr ? set_image(place, image) : set_source(place, source);
            use_image(image, std::move(edit), "Image of " + place.name);
        } else if (const auto* id = std::get_if<MaskEntryId>(&request.part)) {
            for (const MaskEntry& entry : layer->mask.entries)
                if (entry.id == *id)
                    use_image(image,
                              set_source(source_place(*material, *layer, entry),
                                         ImageSource{.image = image->hash}),
                              "Image of mask entry " + entry.name);
        } else {
            use_image(image, add_mask_entry(*material, *layer, image_mask_entry(*image)),
                      "Add mask entry " + image->name);
        }
    });
}

void Workspace::lay_preset(const io::PresetFile& file, bool replace_stack) {
    const auto lay = [this, preset = file.preset, target = view_.material, above_id = view_.layer,
                      replace_stack](const std::vector<ImageAssetPtr>& images) {
        const MaterialPtr material = find_material(session_->document(), target);
        if (!material) return;
        const LayerPtr layer = find_layer(*material, above_id);
        const LayerPlace place = layer ? above(layer->id) : top_of_stack();
        const DocumentPtr before = session_->history().document();
        edit_and_select_new(replace_stack ? replace_stack_by_preset(*material, preset, images)
                                          : apply_preset(*material, preset, place, images));
        if (session_->history().document() == before) return;
        session_->toast(ToastKind::Done,
                        fmt::format("{} applied to {}", preset.name, material->name), "Undo",
                        Action::Undo);
    };
    session_->with_preset_images(file, lay);
}

void Workspace::apply_preset_by_id(const ApplyPreset& request) {
    for (const io::PresetFile& file : session_->presets())
        if (file.preset.id == request.id && session_->has_document())
            lay_preset(file, request.replace_stack);
}

void Workspace::apply_preset_from(const fs::path& path) {
    if (!session_->has_document()) {
        session_->toast(ToastKind::Note, "Open a model before dropping presets");
        return;
    }
    const Result<io::PresetFile> file = io::read_preset(path);
    if (file)
        lay_preset(*file, false);
    else
        session_->toast(ToastKind::Error, file.error().message);
}

// --- layers --------------------------------------------------------------------------------------

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

void Workspace::perform_layer(Action action) {
    if (!session_->has_document()) return;
    const MaterialPtr material = session_->selected_material(view_);
    if (!material) return;
    const LayerPtr layer = session_->selected_layer(view_);
    const auto edit = [this](const Edit& each) { edit_and_select_new(each); };
    switch (action) {
        case Action::Undo:
            session_->history().undo();
            return;
        case Action::Redo:
            session_->history().redo();
            return;
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
        case Action::RenameMaterial:
            view_.renaming_material = material->id;
            return;
        case Action::ClearStack:
            return edit(replace_stack(*material, {}, "Remove all layers"));
        case Action::SelectLayerAbove:
            return select_neighbour(-1);
        case Action::SelectLayerBelow:
            return select_neighbour(1);
        case Action::Paste: {
            const char* clipboard = ImGui::GetClipboardText();
            const LayerPlace place = layer ? above(layer->id) : top_of_stack();
            return edit(paste_layers(*material, clipboard == nullptr ? "" : clipboard, place));
        }
        default:
            break;
    }
    if (!layer) return;
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
            view_.renaming_layer = layer->id;
            return;
        case Action::HideLayer:
            return edit(set_layer_visible(*material, *layer, !layer->visible));
        case Action::ClipLayer:
            return edit(set_layer_clipped(*material, *layer, !layer->clipped));
        case Action::LockLayer:
            return edit(set_layer_locked(*material, *layer, !layer->locked));
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
            ImGui::SetClipboardText(copied_layers({layer}).c_str());
            return session_->toast(ToastKind::Done, "Copied " + layer->name);
        default:
            return;
    }
}

// --- the view ------------------------------------------------------------------------------------

void Workspace::perform_view(Action action) {
    render::View& view = view_.view;
    const auto step_channel = [&view](int step) {
        const int count = render::kChannelViewCount;
        const int next = (static_cast<int>(view.channel) + step + count) % count;
        view.channel = static_cast<render::ChannelView>(next);
    };
    switch (action) {
        case Action::ViewSingle:
            view.compare = render::CompareMode::Single;
            return;
        case Action::ViewSplit:
            view.compare = render::CompareMode::Split;
            return;
        case Action::ViewTwo:
            view.compare = render::CompareMode::TwoViews;
            return;
        case Action::ViewDifference:
            view.compare = render::CompareMode::Difference;
            return;
        case Action::NextCompareMode:
            view.compare =
                static_cast<render::CompareMode>((static_cast<int>(view.compare) + 1) % 4);
            return;
        case Action::SwapSides:
            std::swap(view.left, view.right);
            return;
        case Action::ShadePbr:
            view.left.model = render::ShadingModel::Pbr;
            return;
        case Action::ShadePhong:
            view.left.model = render::ShadingModel::Phong;
            return;
        case Action::ShadeBlinnPhong:
            view.left.model = render::ShadingModel::BlinnPhong;
            return;
        case Action::NextChannel:
            return step_channel(1);
        case Action::PreviousChannel:
            return step_channel(-1);
        case Action::BrighterExposure:
            view.exposure_ev = std::min(view.exposure_ev + 1.0f / 3.0f, 6.0f);
            return;
        case Action::DarkerExposure:
            view.exposure_ev = std::max(view.exposure_ev - 1.0f / 3.0f, -6.0f);
            return;
        case Action::FrameModel:
            if (session_->has_document())
                view.camera = render::framed_from(view.camera, session_->bounds(), 1.6f);
            return;
        case Action::ProbeTool:
            view_.tool =
                view_.tool == ViewportTool::Probe ? ViewportTool::Move : ViewportTool::Probe;
            return;
        case Action::ShowLights:
            view_.right_tab = RightTab::Material;
            view_.unfolded.lights = true;
            return;
        case Action::ShowUv:
            view.channel = view.channel == render::ChannelView::Uv0 ? render::ChannelView::Final
                                                                    : render::ChannelView::Uv0;
            return;
        case Action::HidePanels:
            view_.panels_hidden = !view_.panels_hidden;
            return;
        case Action::ShowLog:
            if (has_log_panel_)
                view_.history_tab = HistoryTab::Log;
            else
                log_.open();
            return;
        case Action::ResetLayout:
            view_.splitters = {};
            view_.panels_hidden = false;
            return;
        case Action::LargerInterface:
            ++scale_steps_;
            return;
        case Action::SmallerInterface:
            --scale_steps_;
            return;
        case Action::FindAction:
            palette_.open();
            return;
        case Action::Keys:
            keys_.open();
            return;
        case Action::About:
            question_.ask({.title = fmt::format("Patina {}", PATINA_VERSION),
                           .text = "An editor for layered physically based materials. What it "
                                   "saves is glTF 2.0. MIT licence.",
                           .answers = {{"Close", {}, true}}});
            return;
        default:
            return;
    }
}

}  // namespace patina::editor
