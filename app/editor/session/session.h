// SPDX-License-Identifier: MIT
#pragma once

/// What is open and the work around it. One-way flow: a snapshot of the History goes through the
/// compositor on a worker to the renderer's textures; edits come back. Lives on the thread that
/// draws; everything slow runs on workers and comes back as values.

#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "document/history.h"
#include "editor/session/environments.h"
#include "editor/session/jobs.h"
#include "editor/session/live_materials.h"
#include "editor/session/thumbnail_cache.h"
#include "editor/session/viewport_picture.h"
#include "editor/state/shown.h"
#include "editor/state/still_options.h"
#include "editor/state/view_state.h"
#include "io/image_store.h"
#include "io/load.h"
#include "io/map_export.h"
#include "io/preset_library.h"
#include "io/texture_folder.h"
#include "scene/shapes.h"

namespace patina::editor {

class Session {
  public:
    /// Needs the window's OpenGL context. `wake` may be called from any thread.
    static Result<std::unique_ptr<Session>> create(std::function<void()> wake);
    ~Session();

    // Files. All of them return at once; what comes of it shows in jobs and toasts.
    void open(const std::filesystem::path& path);
    void open_shape(Shape shape);
    /// With groups folded as they are seen.
    /// @param after  called when the file has been written
    void save(const std::filesystem::path& path, const ViewState& view,
              std::function<void()> after = {});
    /// Whether the first save of a file in this session leaves the version before as name~.
    void set_keep_previous(bool keep) { keep_previous_ = keep; }
    bool keeps_previous() const { return keep_previous_; }
    void export_maps(const std::filesystem::path& folder, const io::MapExportOptions& options);
    /// The copy of the model that export_maps writes beside the maps.
    std::filesystem::path export_target(const std::filesystem::path& folder) const;
    /// Width / height of the viewport.
    float viewport_aspect() const { return viewport_aspect_; }
    /// A picture of what the viewport shows: PNG as seen, EXR in linear radiance.
    void save_view(const std::filesystem::path& path, const ViewState& view,
                   const StillOptions& options);
    /// Writes a preset of layers of the document into the user's own folder and puts it into the
    /// shelf. Its id is made of its name; one of the user's with that id is replaced.
    void save_preset(Preset preset);
    /// Reads an image on a worker and gives it to `use` as edits to make.
    void with_image(const std::filesystem::path& path,
                    std::function<void(const ImageAssetPtr&)> use);
    /// Likewise the images of a preset.
    void with_preset_images(const io::PresetFile& file,
                            std::function<void(const std::vector<ImageAssetPtr>&)> use);
    /// Likewise a folder of textures, as a layer.
    void with_texture_folder(const std::filesystem::path& folder,
                             std::function<void(const io::TextureFolder&)> use);
    /// A panorama that the user chose.
    void use_environment_file(const std::filesystem::path& path);

    // The document.
    bool has_document() const { return history_.has_value(); }
    const Document& document() const { return *history_->document(); }
    MaterialPtr selected_material(const ViewState& view) const;
    LayerPtr selected_layer(const ViewState& view) const;
    /// Applies an edit; a refusal becomes a toast.
    bool apply(const Edit& edit);
    History& history() { return *history_; }
    bool is_edited() const { return history_ && history_->is_edited(); }
    const std::filesystem::path& path() const { return path_; }
    /// Without its folder; what a shape that was made here would be saved as.
    std::filesystem::path file_name() const;
    /// The preset of that id, until one is saved; null where there is none.
    const io::PresetFile* preset(const std::string& id) const;
    const Bounds& bounds() const { return picture_.bounds(); }
    /// Of the parts that are drawn with the selected material; of the whole model where none is.
    Bounds bounds_of_material(const ViewState& view) const;
    /// Width / height of one view of the model.
    float view_aspect(const ViewState& view) const;

    // Around it.
    void toast(ToastKind kind, std::string message, std::string link = {},
               Action action = Action::Undo);
    void dismiss(int toast);
    void hold_toast(int toast);
    void cancel(int job) { jobs_.cancel(job); }
    /// Looks into a pixel, in shares of the picture.
    std::optional<render::Pick> pick(glm::vec2 at);
    void explain(ViewState& view, glm::vec2 at);
    void forget_texel() { texel_.reset(); }

    // A frame.
    /// Takes what the workers made, brings the picture up to date, and says what panels show.
    /// True when the viewport changed and another frame is wanted.
    struct FrameInput {
        render::PictureSize viewport;
        render::PictureSize strip_card;
        std::optional<glm::vec2> hovered;  ///< with the eyedropper, in shares of the picture
        bool moving = false;               ///< a drag is under way: speed before sharpness
        int refining_draws = 0;  ///< that the picture shall be the mean of; 0: of the one it is
        bool resting = false;    ///< the hand is off: there is time to refine
    };
    void update(ViewState& view, const FrameInput& input);
    Shown shown(const ViewState& view);
    /// Nothing is under way: what is on screen is what was asked for. It may still be refined.
    bool settled() const;
    /// All else is settled, and another draw would refine the picture while the hand rests.
    bool refining() const;
    bool wants_frame() const { return wants_frame_; }

  private:
    struct Toast {
        ToastShown shown;
        double until = 0.0;  ///< in seconds of the interface's clock; 0: stays
    };

    Session(std::function<void()> wake, ViewportPicture picture);
    struct StillWork;

    void adopt(io::LoadedDocument loaded, std::filesystem::path path);
    void select_something(ViewState& view) const;
    /// What of a material is shown instead of it.
    struct Part {
        MaterialPtr material;
        LayerId mask;
        LayerId solo;
        bool operator==(const Part&) const = default;
    };
    MaterialPtr part_of(const MaterialPtr& material, const ViewState& view);
    int seen_size(const Material& material, const ViewState& view, int picture_height) const;
    void show_materials(const ViewState& view, int picture_height);
    /// What the light is filtered from.
    struct EnvironmentChoice {
        std::string name;
        float sun_elevation_degrees = kSunElevationDegrees;
        bool operator==(const EnvironmentChoice&) const = default;
    };
    void follow_environment();
    void light_with(const EnvironmentChoice& chosen);
    void filter_environment(const EnvironmentSource& source, std::string label);
    void finish_environment(const ImagePtr& map, int generation);
    Jobs::Delivery light_delivery(render::FilteredEnvironment light, int generation);
    Jobs::Delivery light_failure(const Error& error, int generation);
    void follow_texel(const ViewState& view);
    void follow_uv_layout(const ViewState& view);
    void follow_crosshair(ViewState& view) const;
    void draw_still();
    void follow_comparison(ViewState& view, bool moving);
    void expire_toasts();
    void report_job_failure(const Error& error);
    void list_presets();
    void take_preset(io::PresetFile file);
    /// Gives to `use` what a worker has read into the images of the document, if that is open
    /// still.
    template <typename Value>
    void with_read(std::string label,
                   std::function<Result<Value>(io::ImageStore& images, const Progress&)> read,
                   std::function<void(const Value&)> use);

    std::function<void()> wake_;
    std::optional<History> history_;
    std::shared_ptr<io::ImageStore> images_;
    std::filesystem::path path_;
    std::string shape_name_;  ///< where there is no path
    bool frame_new_document_ = false;
    ViewportPicture picture_;
    EnvironmentChoice lit_;
    int environment_generation_ = 0;
    bool first_light_pending_ = false;
    int finishing_light_ = 0;  ///< the job
    std::vector<io::PresetFile> presets_;
    std::vector<const Preset*> preset_list_;
    Part part_;
    MaterialPtr part_shown_;
    Environments environments_;
    bool keep_previous_ = true;
    std::set<std::filesystem::path> kept_;  ///< files whose version before is kept
    std::shared_ptr<StillWork> still_;
    std::optional<ComparisonShown> comparison_;
    std::optional<glm::vec2> compared_at_;  ///< where its values are of
    int compared_picture_ = -1;             ///< and of which picture it is
    std::optional<TexelShown> texel_;
    /// As of which texel_ is explained.
    struct Explained {
        MaterialPtr material;
        UvSurfacePtr surface;  ///< that its layers read as it is shown, or null
        bool operator==(const Explained&) const = default;
    };
    Explained explained_;
    std::optional<render::Probe> hovered_;
    /// How the parts of a material lie in its UVs; without a layout while that is measured.
    struct MeasuredUvs {
        DocumentPtr document;
        MaterialPtr material;
        UvSurfacePtr surface;
        std::optional<UvLayout> layout;
    };
    MeasuredUvs uvs_;
    std::vector<JobShown> jobs_shown_;
    std::vector<Toast> toasts_;
    std::vector<ToastShown> toasts_shown_;
    int next_toast_ = 1;
    std::vector<LogLine> log_;
    std::shared_ptr<std::deque<LogLine>> log_inbox_;
    std::shared_ptr<std::mutex> log_mutex_;
    double composite_ms_ = 0.0;
    double frame_ms_ = 0.0;
    float viewport_aspect_ = 1.6f;  ///< width / height, of all views together
    bool wants_frame_ = false;
    // Workers last: they are stopped before what they use is gone.
    ThumbnailCache thumbnails_;
    LiveMaterials live_;
    Jobs jobs_;
};

}  // namespace patina::editor
