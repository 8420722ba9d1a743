// SPDX-License-Identifier: MIT
#include "editor/workspace.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <utility>

#include "document/edits.h"
#include "editor/widgets/number_text.h"

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

}  // namespace

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

void Workspace::open_shape(Shape shape) {
    when_edits_may_go([this, shape] { session_->open_shape(shape); });
}

void Workspace::save_then(std::function<void()> after) {
    if (session_->path().empty()) return ask_save_as(std::move(after));
    session_->save(session_->path(), view_, std::move(after));
}

/// Where the document lies, as long as nobody has looked elsewhere since it was opened.
void Workspace::ask_file(FileDialog::Request request) {
    const fs::path document = session_->path();
    if (!document.empty() && document != file_dialog_beside_) {
        file_dialog_beside_ = document;
        std::error_code error;
        const fs::path whole = fs::absolute(document, error);
        if (!error) file_dialog_.look_in(whole.parent_path());
    }
    file_dialog_.open(std::move(request));
}

void Workspace::ask_save_as(std::function<void()> after) {
    const std::string name = session_->file_name().string();
    ask_file({.title = "Save as",
              .button = "Save",
              .extensions = kModels,
              .name = name,
              .writing = true,
              .folder = false,
              .chosen = [this, after = std::move(after)](const fs::path& path) {
                  session_->save(path, view_, after);
              }});
}

void Workspace::ask_export() {
    export_dialog_.open(
        [this](const io::MapExportOptions& options) { ask_export_folder(options); });
}

void Workspace::ask_export_folder(const io::MapExportOptions& options) {
    const auto chosen = [this, options](const fs::path& folder) {
        const fs::path target = session_->export_target(folder);
        std::error_code error;
        if (!fs::exists(target, error)) return session_->export_maps(folder, options);
        question_.ask(
            {.title = "Replace the model there?",
             .text = fmt::format("{} is in {} already. The copy of the model with its "
                                 "baked maps would take its place.",
                                 quoted_for_message(target.filename().string(), 80),
                                 quoted_for_message(folder.string(), 120)),
             .answers = {
                 {"Replace", [this, folder, options] { session_->export_maps(folder, options); }},
                 {"Choose another folder", [this, options] { ask_export_folder(options); }, true},
                 {"Cancel", {}}}});
    };
    ask_file({.title = "Export the baked maps and a copy of the model to",
              .button = "Export here",
              .extensions = {},
              .name = {},
              .folder = true,
              .chosen = chosen});
}

void Workspace::ask_save_view() {
    save_view_dialog_.open(session_->viewport_aspect(), [this](const StillOptions& options) {
        ask_file({.title = "Save the view",
                  .button = "Save",
                  .extensions = {".png", ".exr"},
                  .name = session_->file_name().stem().string() + ".png",
                  .writing = true,
                  .chosen = [this, options](const fs::path& path) {
                      session_->save_view(path, view_, options);
                  }});
    });
}

void Workspace::perform_file(Action action) {
    switch (action) {
        case Action::Open:
            when_edits_may_go([this] {
                ask_file({.title = "Open a model",
                          .button = "Open",
                          .extensions = kModels,
                          .name = {},
                          .chosen = [this](const fs::path& path) { session_->open(path); }});
            });
            return;
        case Action::OpenSample:
            return open_shape(Shape::ShaderBall);
        case Action::NewSphere:
            return open_shape(Shape::Sphere);
        case Action::NewRoundedCube:
            return open_shape(Shape::RoundedCube);
        case Action::NewPlane:
            return open_shape(Shape::Plane);
        case Action::NewCylinder:
            return open_shape(Shape::Cylinder);
        case Action::NewTorus:
            return open_shape(Shape::Torus);
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
            if (session_->has_document()) ask_save_view();
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
    if (io::is_texture_folder(path)) {
        lay_textures(path);
    } else if (is_one_of(ending, kModels)) {
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
        session_->toast(
            ToastKind::Error,
            fmt::format("Cannot use {}: not a model, image, preset, panorama or folder of textures",
                        quoted_for_message(path.filename().string())));
    }
}

void Workspace::ask_image(std::function<void(const ImageAssetPtr&)> use) {
    ask_file({.title = "Choose an image",
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

void Workspace::lay_textures(const fs::path& folder) {
    if (!session_->has_document())
        return session_->toast(ToastKind::Note, "Open a model before dropping textures");
    session_->with_texture_folder(folder, [this](const io::TextureFolder& textures) {
        const MaterialPtr material = session_->selected_material(view_);
        if (!material) return;
        const LayerPtr selected = session_->selected_layer(view_);
        Edits edits;
        for (const ImageAssetPtr& image : textures.images) edits.push_back(add_image(image));
        edits.push_back(
            add_layer(*material, textures.layer, selected ? above(selected->id) : top_of_stack()));
        edit_and_select_new(in_one_step("Add textures " + textures.layer.name, std::move(edits)));
        const bool hidden = at(textures.layer.channels, Channel::Opacity).enabled &&
                            material->alpha_mode == AlphaMode::Opaque;
        session_->toast(
            hidden ? ToastKind::Note : ToastKind::Done,
            fmt::format("{} of {} as a layer{}", counted(textures.images.size(), "map"),
                        textures.layer.name,
                        hidden ? "; set Alpha to Mask or Blend to see its opacity" : ""),
            "Show log", Action::ShowLog);
    });
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
    const io::PresetFile* const file = session_->preset(request.id);
    if (file == nullptr || !session_->has_document()) return;
    const auto layers = turned_layers(file->preset, request.knobs);
    if (!layers) return session_->toast(ToastKind::Error, layers.error().message);
    io::PresetFile turned = *file;
    turned.preset.layers = *layers;
    lay_preset(turned, request.replace_stack);
}

void Workspace::ask_save_preset(bool whole_material) {
    const MaterialPtr material = session_->selected_material(view_);
    const LayerPtr layer = session_->selected_layer(view_);
    if (!material || (!whole_material && !layer)) return;
    const char* user = std::getenv("USER");
    save_preset_dialog_.open({.whole_material = whole_material,
                              .name = whole_material ? material->name : layer->name,
                              .category = "Mine",
                              .author = user == nullptr ? "" : user,
                              .licence = "NOASSERTION",  // SPDX: nothing is said of it
                              .description = "Made of " + material->name});
}

void Workspace::save_preset(const SavePreset& request) {
    const MaterialPtr material = session_->selected_material(view_);
    const LayerPtr layer = session_->selected_layer(view_);
    if (!material || (!request.whole_material && !layer)) return;
    Preset preset;
    preset.name = request.name;
    preset.category = request.category;
    preset.author = request.author;
    preset.licence = request.licence;
    preset.description = request.description;
    preset.layers = request.whole_material ? material->stack : std::vector<LayerPtr>{layer};
    session_->save_preset(std::move(preset));
}

void Workspace::turn_knobs(const std::string& preset_id) {
    const io::PresetFile* const file = session_->preset(preset_id);
    if (file != nullptr && session_->has_document()) preset_dialog_.open(file->preset);
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

}  // namespace patina::editor
