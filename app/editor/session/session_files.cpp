// SPDX-License-Identifier: MIT

/// The part of the session that reads and writes files, on workers.

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <utility>

#include "core/log.h"
#include "document/edits.h"
#include "document/scene_edits.h"
#include "editor/session/session.h"
#include "editor/widgets/number_text.h"
#include "io/image_file.h"
#include "io/mesh_to_glb.h"
#include "io/save.h"
#include "scene/shapes.h"

namespace patina::editor {
namespace {

namespace fs = std::filesystem;

constexpr auto kCancelPoll = std::chrono::milliseconds(50);

/// The document with its groups folded as they are seen: not an edit, but the file tells the next
/// who opens it.
DocumentPtr folded_as_seen(const DocumentPtr& document, const ViewState& view) {
    Document folded = *document;
    for (const auto& [id, open] : view.unfolded_groups)
        for (const MaterialPtr& material : document->materials) {
            const MaterialPtr now = find_material(folded, material->id);
            const LayerPtr group = find_layer(*now, id);
            if (!group || !group->is_group()) continue;
            if (Result<Document> next = set_group_open(*now, *group, open).apply(folded))
                folded = *std::move(next);
        }
    return std::make_shared<const Document>(std::move(folded));
}

}  // namespace

/// A still under way: the thread that draws makes it a sample a frame, a worker waits for it.
struct Session::StillWork {
    render::Still still;
    std::promise<Result<render::StillMean>> made;
    std::atomic<float> drawn_share = 0.0f;
    std::atomic<bool> given_up = false;
};

void Session::report_job_failure(const Error& error) {
    if (error.message.find("cancelled") != std::string::npos)
        toast(ToastKind::Note, "Cancelled");
    else
        toast(ToastKind::Error, error.message);
}

void Session::open(const fs::path& path) {
    jobs_.start("Opening " + path.filename().string(), [this, path](const Progress& progress) {
        auto loaded =
            std::make_shared<Result<io::LoadedDocument>>(io::load_document(path, {}, progress));
        return [this, path, loaded] {
            if (*loaded)
                adopt(std::move(**loaded), path);
            else
                report_job_failure(loaded->error());
        };
    });
}

void Session::open_shape(Shape shape) {
    std::string name = std::string(kShapes[static_cast<std::size_t>(shape)].id) + ".glb";
    std::replace(name.begin(), name.end(), '-', '_');
    jobs_.start("Making " + name, [this, shape, name](const Progress& progress) {
        auto loaded = std::make_shared<Result<io::LoadedDocument>>(
            io::load_document_from_memory(io::shape_to_glb(shape), name, {}, progress));
        return [this, loaded, name] {
            if (!*loaded) return report_job_failure(loaded->error());
            adopt(std::move(**loaded), {});
            shape_name_ = name;
        };
    });
}

fs::path Session::file_name() const {
    return path_.empty() ? fs::path(shape_name_) : path_.filename();
}

void Session::adopt(io::LoadedDocument loaded, fs::path path) {
    history_.emplace(loaded.document);
    images_ = loaded.images;
    path_ = std::move(path);
    texel_.reset();
    environments_.set_folder(path_.empty() ? fs::path() : fs::absolute(path_).parent_path());
    lit_ = {};
    thumbnails_.set_images(images_);
    picture_.set_scene(loaded.document->scene);
    frame_new_document_ = true;
    for (const std::string& warning : loaded.warnings) log_warning("{}", warning);
    if (loaded.warnings.empty()) return;
    if (loaded.warnings.size() == 1)
        toast(ToastKind::Note, loaded.warnings.front(), "Show log", Action::ShowLog);
    else
        toast(ToastKind::Note, fmt::format("Opened with {} warnings", loaded.warnings.size()),
              "Show log", Action::ShowLog);
}

void Session::save(const fs::path& path, const ViewState& view, std::function<void()> after) {
    const DocumentPtr snapshot = history_->document();
    const DocumentPtr written = folded_as_seen(snapshot, view);
    // What was there before this session stays, not what the save before left.
    const bool keep = keep_previous_ && !kept_.contains(fs::absolute(path));
    jobs_.start("Saving " + path.filename().string(),
                [this, path, snapshot, written, images = images_, after = std::move(after),
                 keep](const Progress& progress) {
                    auto report = std::make_shared<Result<io::SaveReport>>(io::save_document(
                        *written, *images, path, {.keep_previous = keep}, progress));
                    return [this, path, snapshot, images, report, after] {
                        if (!*report) return report_job_failure(report->error());
                        kept_.insert(fs::absolute(path));
                        for (const std::string& warning : (*report)->warnings)
                            log_warning("{}", warning);
                        toast(ToastKind::Done, "Saved " + path.filename().string());
                        if (images != images_) return;  // of a document that is closed
                        history_->mark_saved(snapshot);
                        path_ = path;
                        environments_.set_folder(fs::absolute(path).parent_path());
                        if (after) after();
                    };
                });
}

fs::path Session::export_target(const fs::path& folder) const {
    const fs::path name = file_name();
    return folder / name.stem().concat(".glb");
}

void Session::export_maps(const fs::path& folder, const io::MapExportOptions& options) {
    const DocumentPtr snapshot = history_->document();
    jobs_.start("Exporting maps", [this, folder, options, target = export_target(folder), snapshot,
                                   images = images_](const Progress& progress) {
        using Files = Result<std::vector<fs::path>>;
        const auto saved = io::save_document(*snapshot, *images, target, {}, progress);
        const auto files = std::make_shared<Files>(
            saved ? io::export_maps(*snapshot, *images, folder, options, progress)
                  : Files(passed_on(saved)));
        return [this, folder, files] {
            if (!*files) return report_job_failure(files->error());
            toast(ToastKind::Done,
                  fmt::format("Exported {} to {}", counted((*files)->size(), "map"),
                              folder.filename().string()));
        };
    });
}

void Session::save_preset(Preset preset) {
    const fs::path folder = io::user_preset_folder();
    if (folder.empty())
        return toast(ToastKind::Error,
                     "Cannot save the preset: there is no home folder. Set HOME or XDG_DATA_HOME");
    preset.id = io::preset_id_of(preset.name);
    const auto is_own = [&](const io::PresetFile& file) {
        return file.path.parent_path() == folder;
    };
    const io::PresetFile* before = this->preset(preset.id);
    if (before != nullptr && !is_own(*before)) {
        preset.id = io::preset_id_of(preset.id + " mine");
        before = this->preset(preset.id);
    }
    if (before != nullptr) preset.version = before->preset.version + 1;
    const fs::path path = before != nullptr ? before->path : folder / (preset.id + ".json");
    jobs_.start("Saving preset " + preset.name, [this, path, preset,
                                                 snapshot = history_->document()](const Progress&) {
        using Written = Result<io::PresetFile>;
        const auto written = std::make_shared<Written>(io::write_preset(path, preset, *snapshot));
        return [this, written] {
            if (!*written) return report_job_failure(written->error());
            toast(ToastKind::Done, fmt::format("{} is in the shelf", (*written)->preset.name));
            take_preset(std::move(**written));
        };
    });
}

void Session::save_view(const fs::path& path, const ViewState& state, const StillOptions& options) {
    if (still_) return toast(ToastKind::Note, "A view is being saved: wait until it is done");
    auto work = std::make_shared<StillWork>();
    const bool linear = io::image_format_of(path) == io::ImageFormat::Exr;
    work->still = {.view = state.view,
                   .size = still_size(options.height, viewport_aspect_),
                   .samples = options.samples,
                   .linear = linear};
    // The studio's backdrop is painted for a screen and has no place in linear light.
    render::Background& background = work->still.view.background;
    if (options.transparent || (linear && background.kind == render::Background::Kind::Studio))
        background.kind = render::Background::Kind::Transparent;
    work->still.view.lights = document().lights;
    work->still.view.environment_rotation_degrees = document().environment.rotation_degrees;
    work->still.view.environment_intensity = document().environment.intensity;
    still_ = work;
    jobs_.start("Saving " + path.filename().string(),
                [this, path, work, linear](const Progress& progress) -> Jobs::Delivery {
                    auto made = work->made.get_future();
                    while (made.wait_for(kCancelPoll) != std::future_status::ready) {
                        progress.report(work->drawn_share);
                        if (progress.cancelled()) {
                            work->given_up = true;
                            return [this] { toast(ToastKind::Note, "Cancelled"); };
                        }
                    }
                    const Result<render::StillMean> mean = made.get();
                    if (!mean) return [this, error = mean.error()] { report_job_failure(error); };
                    const Status written = io::write_image_file(
                        path, linear ? render::linear_image(*mean) : render::srgb_image(*mean));
                    return [this, path, written] {
                        if (!written) return report_job_failure(written.error());
                        toast(ToastKind::Done, "Saved " + path.filename().string());
                    };
                });
}

/// One more sample of the still that is under way.
void Session::draw_still() {
    if (!still_) return;
    StillWork& work = *still_;
    if (work.given_up) return still_.reset();
    const Status drawn = picture_.renderer().draw_sample(work.still);
    work.drawn_share =
        static_cast<float>(work.still.drawn) / static_cast<float>(work.still.samples);
    wants_frame_ = true;
    if (drawn && !work.still.is_finished()) return;
    if (drawn)
        work.made.set_value(picture_.renderer().mean(work.still));
    else
        work.made.set_value(passed_on(drawn));
    still_.reset();
}

template <typename Value>
void Session::with_read(std::string label,
                        std::function<Result<Value>(io::ImageStore&, const Progress&)> read,
                        std::function<void(const Value&)> use) {
    if (!images_) return;
    jobs_.start(std::move(label), [this, images = images_, read = std::move(read),
                                   use = std::move(use)](const Progress& progress) {
        auto value = std::make_shared<Result<Value>>(read(*images, progress));
        return [this, value, images, use] {
            if (images != images_) return;  // of a document that is closed
            if (*value)
                use(**value);
            else
                report_job_failure(value->error());
        };
    });
}

void Session::with_image(const fs::path& path, std::function<void(const ImageAssetPtr&)> use) {
    with_read<ImageAssetPtr>(
        "Reading " + path.filename().string(),
        [path](io::ImageStore& images, const Progress&) { return images.add_file(path); },
        std::move(use));
}

void Session::with_preset_images(const io::PresetFile& file,
                                 std::function<void(const std::vector<ImageAssetPtr>&)> use) {
    with_read<std::vector<ImageAssetPtr>>(
        "Reading " + file.preset.name,
        [file](io::ImageStore& images, const Progress&) {
            return io::add_preset_images(file, images);
        },
        std::move(use));
}

void Session::with_texture_folder(const fs::path& folder,
                                  std::function<void(const io::TextureFolder&)> use) {
    with_read<io::TextureFolder>(
        "Reading " + folder.filename().string(),
        [folder](io::ImageStore& images, const Progress& progress) {
            return io::read_texture_folder(folder, images, progress);
        },
        [use = std::move(use)](const io::TextureFolder& textures) {
            for (const io::TextureUseOfFile& file : textures.files) log_info("{}", file.described);
            use(textures);
        });
}

void Session::use_environment_file(const fs::path& path) {
    const std::string name = environments_.choose(path);
    if (!history_ || document().environment.name == name) return light_with({name});
    apply(set_environment_name(name));
}

}  // namespace patina::editor
