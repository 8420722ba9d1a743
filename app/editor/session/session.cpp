// SPDX-License-Identifier: MIT
#include "editor/session/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <utility>

#include "composite/composite.h"
#include "core/log.h"
#include "document/edits.h"
#include "editor/session/thumbnail_materials.h"
#include "io/image_file.h"
#include "io/mesh_to_glb.h"
#include "io/save.h"
#include "render/environment.h"
#include "scene/shapes.h"

namespace patina::editor {
namespace {

namespace fs = std::filesystem;

constexpr double kToastSeconds = 6.0;
constexpr std::size_t kMostToasts = 3;
constexpr std::size_t kMostLogLines = 200;
constexpr int kStillSamples = 16;

double now_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// Memory of the process, as the system counts it.
std::size_t resident_bytes() {
    std::ifstream statm("/proc/self/statm");
    std::size_t total = 0;
    std::size_t resident = 0;
    constexpr std::size_t kPage = 4096;
    return statm >> total >> resident ? resident * kPage : 0;
}

std::string environment_label(const std::string& name) {
    for (const render::BuiltinEnvironment& builtin : render::kBuiltinEnvironments)
        if (builtin.id == name) return std::string(builtin.label);
    return fs::path(name).stem().string();
}

Result<ImagePtr> environment_map(const std::string& name) {
    if (Result<Image> builtin = render::builtin_environment(name))
        return std::make_shared<const Image>(std::move(*builtin));
    const Result<Bytes> file = read_file(name);
    if (!file) return passed_on(file);
    return io::decode_image(*file, name);
}

/// The channel of the stack that a channel view shows, if it shows one.
std::optional<Channel> stack_channel(render::ChannelView view) {
    switch (view) {
        case render::ChannelView::Final:
        case render::ChannelView::BaseColor:
            return Channel::BaseColor;
        case render::ChannelView::Metalness:
            return Channel::Metalness;
        case render::ChannelView::Roughness:
            return Channel::Roughness;
        case render::ChannelView::NormalWorld:
        case render::ChannelView::NormalView:
            return Channel::Normal;
        case render::ChannelView::Occlusion:
            return Channel::Occlusion;
        case render::ChannelView::Emissive:
            return Channel::Emissive;
        case render::ChannelView::Alpha:
            return Channel::Opacity;
        default:
            return std::nullopt;
    }
}

}  // namespace

Result<std::unique_ptr<Session>> Session::create(std::function<void()> wake) {
    Result<ViewportPicture> picture = ViewportPicture::create();
    if (!picture) return passed_on(picture);
    std::unique_ptr<Session> session(new Session(std::move(wake), std::move(*picture)));
    return session;
}

Session::Session(std::function<void()> wake, ViewportPicture picture)
    : wake_(std::move(wake)),
      picture_(std::move(picture)),
      log_inbox_(std::make_shared<std::deque<LogLine>>()),
      log_mutex_(std::make_shared<std::mutex>()),
      thumbnails_(wake_),
      live_(wake_),
      jobs_(wake_) {
    set_log_sink([inbox = log_inbox_, mutex = log_mutex_](LogLevel level, std::string_view line) {
        const std::lock_guard lock(*mutex);
        inbox->push_back({level != LogLevel::Info, std::string(line)});
    });
    for (const render::BuiltinEnvironment& builtin : render::kBuiltinEnvironments)
        environments_.push_back({std::string(builtin.id), std::string(builtin.label)});
    if (Result<std::vector<io::PresetFile>> presets = io::shipped_presets())
        presets_ = std::move(*presets);
    else
        log_warning("{}", presets.error().message);
    for (const io::PresetFile& file : presets_) preset_list_.push_back(&file.preset);
    thumbnails_.set_presets(&presets_);
    filter_environment("studio");
}

Session::~Session() {
    set_log_sink({});
}

// --- files ---------------------------------------------------------------------------------------

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

void Session::open_sample() {
    jobs_.start("Making the sample", [this](const Progress& progress) {
        const std::array materials = {
            io::PlainMaterial{.name = "Ball", .roughness = 0.4f},
            io::PlainMaterial{
                .name = "Stand", .base_color_linear = glm::vec3(0.06f), .roughness = 0.55f},
        };
        auto loaded = std::make_shared<Result<io::LoadedDocument>>(
            io::load_document_from_memory(io::mesh_to_glb(shape_mesh(Shape::ShaderBall), materials),
                                          "shader_ball.glb", {}, progress));
        return [this, loaded] {
            if (*loaded)
                adopt(std::move(**loaded), {});
            else
                report_job_failure(loaded->error());
        };
    });
}

void Session::adopt(io::LoadedDocument loaded, fs::path path) {
    history_.emplace(loaded.document);
    images_ = loaded.images;
    path_ = std::move(path);
    texel_.reset();
    thumbnails_.set_images(images_);
    picture_.set_scene(loaded.document->scene);
    frame_new_document_ = true;
    for (const std::string& warning : loaded.warnings) log_warning("{}", warning);
    if (!loaded.warnings.empty())
        toast(ToastKind::Note,
              loaded.warnings.size() == 1
                  ? loaded.warnings.front()
                  : fmt::format("Opened with {} warnings: see the log", loaded.warnings.size()));
}

void Session::save(const fs::path& path, std::function<void()> after) {
    const DocumentPtr snapshot = history_->document();
    const auto images = images_;
    jobs_.start("Saving " + path.filename().string(),
                [this, path, snapshot, images, after](const Progress& progress) {
                    auto report = std::make_shared<Result<io::SaveReport>>(
                        io::save_document(*snapshot, *images, path, {}, progress));
                    return [this, path, snapshot, report, after] {
                        if (!*report) {
                            report_job_failure(report->error());
                            return;
                        }
                        path_ = path;
                        if (history_ && history_->document() == snapshot) history_->mark_saved();
                        for (const std::string& warning : (*report)->warnings)
                            log_warning("{}", warning);
                        toast(ToastKind::Done, "Saved " + path.filename().string());
                        if (after) after();
                    };
                });
}

void Session::export_maps(const fs::path& folder) {
    const DocumentPtr snapshot = history_->document();
    const auto images = images_;
    const fs::path name = path_.empty() ? fs::path("shader_ball.glb") : path_.filename();
    jobs_.start("Exporting maps", [this, folder, name, snapshot, images](const Progress& progress) {
        const fs::path target = folder / name.stem().concat(".glb");
        auto report = std::make_shared<Result<io::SaveReport>>(io::save_document(
            *snapshot, *images, target, {.size = {}, .maps_folder = folder}, progress));
        return [this, folder, report] {
            if (!*report) {
                report_job_failure(report->error());
                return;
            }
            toast(ToastKind::Done,
                  fmt::format("Exported {} maps to {}", (*report)->map_files.size(),
                              folder.filename().string()));
        };
    });
}

void Session::save_view(const fs::path& path, const ViewState& state) {
    render::View view = state.view;
    view.lights = document().lights;
    view.environment_rotation_degrees = document().environment.rotation_degrees;
    view.environment_intensity = document().environment.intensity;
    const Result<Image> still = picture_.still(view, {1920, 1080}, kStillSamples);
    if (!still) return report_job_failure(still.error());
    const Status written = io::write_image_file(path, *still);
    if (!written) return report_job_failure(written.error());
    toast(ToastKind::Done, "Saved " + path.filename().string());
}

void Session::with_image(const fs::path& path, std::function<void(const ImageAssetPtr&)> use) {
    if (!images_) return;
    jobs_.start("Reading " + path.filename().string(),
                [this, path, images = images_, use = std::move(use)](const Progress&) {
                    auto added = std::make_shared<Result<ImageAssetPtr>>(images->add_file(path));
                    return [this, added, use] {
                        if (*added)
                            use(**added);
                        else
                            report_job_failure(added->error());
                    };
                });
}

void Session::apply_preset_file(const io::PresetFile& file, const ViewState& view,
                                bool replace_stack) {
    const MaterialPtr material = selected_material(view);
    if (!material) return;
    const Result<std::vector<ImageAssetPtr>> images = io::add_preset_images(file, *images_);
    if (!images) return report_job_failure(images.error());
    const LayerPtr layer = selected_layer(view);
    const LayerPlace place = layer ? above(layer->id) : top_of_stack();
    history_->seal();
    const Edit edit = replace_stack ? replace_stack_by_preset(*material, file.preset, *images)
                                    : apply_preset(*material, file.preset, place, *images);
    if (!apply(edit)) return;
    history_->seal();
    toast(ToastKind::Done, fmt::format("{} applied to {}", file.preset.name, material->name),
          "Undo", Action::Undo);
}

void Session::use_environment_file(const fs::path& path) {
    const std::string name = fs::absolute(path).string();
    const bool known = std::any_of(environments_.begin(), environments_.end(),
                                   [&](const auto& each) { return each.name == name; });
    if (!known) environments_.push_back({name, environment_label(name)});
    if (history_)
        apply(set_environment_name(name));
    else
        filter_environment(name);
}

// --- the document --------------------------------------------------------------------------------

MaterialPtr Session::selected_material(const ViewState& view) const {
    return history_ ? find_material(*history_->document(), view.material) : nullptr;
}

LayerPtr Session::selected_layer(const ViewState& view) const {
    const MaterialPtr material = selected_material(view);
    return material ? find_layer(*material, view.layer) : nullptr;
}

bool Session::apply(const Edit& edit) {
    if (!history_) return false;
    const Status applied = history_->apply(edit);
    if (!applied) toast(ToastKind::Error, applied.error().message);
    wants_frame_ = true;
    return applied.has_value();
}

void Session::select_something(ViewState& view) const {
    const Document& now = *history_->document();
    if (!find_material(now, view.material)) {
        view.material = now.materials.empty() ? MaterialId{} : now.materials.front()->id;
        view.layer = {};
    }
    const MaterialPtr material = find_material(now, view.material);
    if (material && !find_layer(*material, view.layer))
        view.layer = material->stack.empty() ? LayerId{} : material->stack.back()->id;
}

// --- around it -----------------------------------------------------------------------------------

void Session::toast(ToastKind kind, std::string message, std::string link, Action action) {
    const double until = kind == ToastKind::Error ? 0.0 : now_seconds() + kToastSeconds;
    toasts_.push_back({{next_toast_++, kind, std::move(message), std::move(link), action}, until});
    if (toasts_.size() > kMostToasts) toasts_.erase(toasts_.begin());
    wants_frame_ = true;
    wake_();
}

void Session::dismiss(int toast) {
    std::erase_if(toasts_, [toast](const Toast& each) { return each.shown.id == toast; });
    wants_frame_ = true;
}

void Session::expire_toasts() {
    const double now = now_seconds();
    std::erase_if(toasts_,
                  [now](const Toast& toast) { return toast.until > 0.0 && toast.until < now; });
}

std::optional<render::Pick> Session::pick(glm::vec2 at) {
    return picture_.pick(at);
}

void Session::explain(ViewState& view, glm::vec2 at) {
    const std::optional<render::Probe> probe = picture_.probe(at);
    texel_.reset();
    view.crosshair.reset();
    if (!probe) return;
    const MaterialPtr material = material_of(document(), probe->source_material);
    if (!material) return;
    view.crosshair = at;
    view.material = material->id;
    TexelShown texel;
    texel.probe = *probe;
    texel.pixel = picture_.pixel(at);
    texel.material = material->id;
    const int size = material->resolution;
    const auto texel_at = [size](float uv) {
        const float wrapped = uv - std::floor(uv);
        return std::min(static_cast<int>(wrapped * static_cast<float>(size)), size - 1);
    };
    texel.texel_x = texel_at(probe->uv.x);
    texel.texel_y = texel_at(probe->uv.y);
    texel.channel = stack_channel(view.view.channel);
    if (texel.channel) {
        auto steps =
            explain_texel(*material, *images_, *texel.channel, size, texel.texel_x, texel.texel_y);
        if (steps)
            texel.steps = std::move(*steps);
        else
            toast(ToastKind::Error, steps.error().message);
    }
    texel_ = std::move(texel);
}

// --- a frame -------------------------------------------------------------------------------------

void Session::show_materials(const ViewState& view) {
    std::vector<MaterialPtr> materials = history_->document()->materials;
    for (MaterialPtr& material : materials) {
        if (material->id != view.material) continue;
        if (view.viewed_mask.value != 0)
            material = std::make_shared<Material>(with_mask_shown(*material, view.viewed_mask));
        else if (view.solo.value != 0)
            material = std::make_shared<Material>(with_only_layer(*material, view.solo));
    }
    live_.show(std::move(materials), images_, view.material);
}

void Session::filter_environment(const std::string& name) {
    environment_name_ = name;
    const int generation = ++environment_generation_;
    jobs_.start(
        "Filtering " + environment_label(name),
        [this, name, generation](const Progress& progress) -> Jobs::Delivery {
            const Result<ImagePtr> map = environment_map(name);
            if (!map) return [this, error = map.error()] { report_job_failure(error); };
            auto light = std::make_shared<Result<render::FilteredEnvironment>>(
                render::filter_environment(**map, render::FilterQuality::First, progress));
            return [this, light, map = *map, generation] {
                if (generation != environment_generation_) return;
                if (!*light) return report_job_failure(light->error());
                picture_.set_environment(**light);
                jobs_.start("Filtering the environment", [this, map,
                                                          generation](const Progress& finer) {
                    auto finished = std::make_shared<Result<render::FilteredEnvironment>>(
                        render::filter_environment(*map, render::FilterQuality::Finished, finer));
                    return [this, finished, generation] {
                        if (generation == environment_generation_ && *finished)
                            picture_.set_environment(**finished);
                    };
                });
            };
        });
}

void Session::follow_environment() {
    const std::string& name = history_->document()->environment.name;
    if (name == environment_name_) return;
    const bool known = std::any_of(environments_.begin(), environments_.end(),
                                   [&](const auto& each) { return each.name == name; });
    if (!known) environments_.push_back({name, environment_label(name)});
    filter_environment(name);
}

void Session::update(ViewState& view, const FrameInput& input) {
    wants_frame_ = false;
    jobs_.deliver();
    expire_toasts();
    {
        const std::lock_guard lock(*log_mutex_);
        for (LogLine& line : *log_inbox_) log_.push_back(std::move(line));
        log_inbox_->clear();
        if (log_.size() > kMostLogLines)
            log_.erase(log_.begin(), log_.end() - static_cast<std::ptrdiff_t>(kMostLogLines));
    }
    if (history_) {
        select_something(view);
        follow_environment();
        show_materials(view);
        const std::vector<LiveMaterials::Changed> changed = live_.take();
        for (const LiveMaterials::Changed& each : changed)
            if (each.elapsed_ms > 0.0) composite_ms_ = each.elapsed_ms;
        picture_.set_materials(changed);
        const float aspect = static_cast<float>(std::max(input.viewport.width, 1)) /
                             static_cast<float>(std::max(input.viewport.height, 1));
        if (std::exchange(frame_new_document_, false)) {
            view.view.camera = render::framed(picture_.bounds(), aspect);
            view.crosshair.reset();
        }
        render::View drawn = view.view;
        const Document& now = *history_->document();
        drawn.lights = now.lights;
        drawn.environment_rotation_degrees = now.environment.rotation_degrees;
        drawn.environment_intensity = now.environment.intensity;
        if (picture_.draw(drawn, input.viewport, input.strip_card, input.moving))
            frame_ms_ = picture_.frame_ms();
        if (picture_.out_of_date()) wants_frame_ = true;
        hovered_.reset();
        if (input.hovered) hovered_ = picture_.probe(*input.hovered);
    }
    if (thumbnails_.finish_some(input.moving)) wants_frame_ = true;
}

Shown Session::shown(const ViewState& view) {
    Shown shown;
    shown.thumbnails = &thumbnails_;
    shown.presets = preset_list_;
    shown.environments = environments_;
    jobs_shown_ = jobs_.shown();
    shown.jobs = jobs_shown_;
    toasts_shown_.clear();
    for (const Toast& toast : toasts_) toasts_shown_.push_back(toast.shown);
    shown.toasts = toasts_shown_;
    shown.log = log_;
    shown.cost = {.frame_ms = frame_ms_,
                  .composite_ms = composite_ms_,
                  .memory_bytes = resident_bytes(),
                  .frame = picture_.stats()};
    const render::FrameStats& stats = picture_.stats();
    shown.cost.gpu_bytes = stats.material_texture_bytes + stats.left.bytes() +
                           (stats.right ? stats.right->environment_bytes : 0) +
                           thumbnails_.texture_bytes();
    if (!history_) return shown;
    shown.document = history_->document();
    shown.material = selected_material(view);
    shown.layer = selected_layer(view);
    shown.file_name = path_.empty() ? "shader_ball.glb" : path_.filename().string();
    shown.edited = history_->is_edited();
    shown.history = {.labels = history_->labels(),
                     .position = history_->position(),
                     .bytes = history_->bytes(),
                     .can_undo = history_->can_undo(),
                     .can_redo = history_->can_redo()};
    // The renderer's pictures have their first row at the bottom.
    shown.viewport = {reinterpret_cast<ImTextureID>(picture_.texture()), ImVec2(0, 1),
                      ImVec2(1, 0)};
    shown.strip = {reinterpret_cast<ImTextureID>(picture_.strip_texture())};
    shown.texel = texel_;
    shown.hovered = hovered_;
    return shown;
}

bool Session::settled() const {
    const bool drawn = !history_ || (live_.settled() && !picture_.out_of_date());
    return drawn && !jobs_.running() && thumbnails_.settled() && !wants_frame_;
}

}  // namespace patina::editor
