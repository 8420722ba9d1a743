// SPDX-License-Identifier: MIT
#pragma once

/// The editor's whole state beside its window: the session, what is looked at, the dialogs; and how
/// requests are carried out.

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "editor/dialogs/export_dialog.h"
#include "editor/dialogs/file_dialog.h"
#include "editor/dialogs/log_dialog.h"
#include "editor/dialogs/palette.h"
#include "editor/dialogs/preset_dialog.h"
#include "editor/dialogs/question.h"
#include "editor/dialogs/save_preset_dialog.h"
#include "editor/dialogs/save_view_dialog.h"
#include "editor/session/session.h"
#include "editor/state/requests.h"
#include "editor/state/view_state.h"

namespace patina::editor {

class Workspace {
  public:
    explicit Workspace(std::unique_ptr<Session> session) : session_(std::move(session)) {}

    Session& session() { return *session_; }
    ViewState& view() { return view_; }
    FileDialog& file_dialog() { return file_dialog_; }
    Palette& palette() { return palette_; }
    QuestionDialog& question() { return question_; }
    PresetDialog& preset_dialog() { return preset_dialog_; }
    SavePresetDialog& save_preset_dialog() { return save_preset_dialog_; }
    ExportDialog& export_dialog() { return export_dialog_; }
    SaveViewDialog& save_view_dialog() { return save_view_dialog_; }
    KeysDialog& keys() { return keys_; }
    LogDialog& log() { return log_; }
    bool dialog_open() const {
        return file_dialog_.is_open() || palette_.is_open() || question_.is_open() ||
               preset_dialog_.is_open() || save_preset_dialog_.is_open() ||
               export_dialog_.is_open() || save_view_dialog_.is_open() || keys_.is_open() ||
               log_.is_open();
    }

    /// Edits first, in one go, then the rest.
    void carry_out(Requests requests);
    void perform(Action action);
    /// A model is opened, an image or a folder of textures becomes a layer, a preset is applied, a
    /// panorama lights; an .exr
    /// is an image where it is dropped on the layers, and a panorama elsewhere.
    void take_file(const TakeFile& file);
    /// Asks first when there are unsaved edits.
    void quit();
    bool quitting() const { return quitting_; }
    /// Whether the layout has a panel for the log; without one it opens in a box.
    void set_has_log_panel(bool has) { has_log_panel_ = has; }
    /// Steps of the interface's scale that were asked for since the last call.
    int take_scale_steps() { return std::exchange(scale_steps_, 0); }

  private:
    void carry_out_one(const Request& request);
    // Each performs the actions of its subject and lets all others pass.
    void perform_file(Action action);
    void perform_material(Action action);
    void perform_stack(Action action);
    void perform_layer(Action action);
    void perform_picture(Action action);
    void perform_camera(Action action);
    void perform_interface(Action action);
    void frame(const Bounds& bounds);
    void look_from(render::ViewDirection direction);
    void add_layer_and_select(const Layer& layer);
    void add_material_and_select(const Edit& edit);
    void assign_material_at(const AssignMaterialAt& request);
    void edit_and_select_new(const Edit& edit);
    void select_neighbour(int step);
    void move_selected(int step);
    void save_then(std::function<void()> after);
    void ask_save_as(std::function<void()> after);
    void ask_export();
    void ask_save_view();
    void ask_file(FileDialog::Request request);
    void ask_export_folder(const io::MapExportOptions& options);
    void ask_save_preset(bool whole_material);
    void save_preset(const SavePreset& request);
    void ask_image(std::function<void(const ImageAssetPtr&)> use);
    void lay_textures(const std::filesystem::path& folder);
    void choose_image_for(const ChooseImageFor& request);
    void when_edits_may_go(std::function<void()> go_on);
    void open_shape(Shape shape);
    void use_image(const ImageAssetPtr& image, Edit edit, std::string label);
    void add_image_layer(const ImageAssetPtr& image);
    void lay_preset(const io::PresetFile& file, bool replace_stack);
    void apply_preset_by_id(const ApplyPreset& request);
    void turn_knobs(const std::string& preset_id);
    void apply_preset_from(const std::filesystem::path& path);

    std::unique_ptr<Session> session_;
    ViewState view_;
    FileDialog file_dialog_;
    std::filesystem::path file_dialog_beside_;  ///< the document that it looked beside
    Palette palette_;
    QuestionDialog question_;
    PresetDialog preset_dialog_;
    SavePresetDialog save_preset_dialog_;
    ExportDialog export_dialog_;
    SaveViewDialog save_view_dialog_;
    KeysDialog keys_;
    LogDialog log_;
    bool quitting_ = false;
    bool has_log_panel_ = true;
    int scale_steps_ = 0;
};

}  // namespace patina::editor
