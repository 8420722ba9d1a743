// SPDX-License-Identifier: MIT
#include "editor/session/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <set>
#include <utility>

#include "composite/composite.h"
#include "core/log.h"
#include "document/edits.h"
#include "document/parts.h"
#include "document/worn_surface.h"
#include "editor/session/thumbnail_materials.h"
#include "scene/part_bounds.h"

namespace patina::editor {
namespace {

constexpr render::DepthRange kAnyDepthRange{0.1f, 10.0f};  // where depth does not matter
constexpr double kToastSeconds = 6.0;
constexpr double kHeldToastSeconds = 2.0;  // after the pointer has left it
constexpr std::size_t kMostToasts = 3;
constexpr std::size_t kMostLogLines = 200;

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
        case render::ChannelView::F0:
        case render::ChannelView::Position:
        case render::ChannelView::Depth:
        case render::ChannelView::Tangent:
        case render::ChannelView::GeometricNormal:
        case render::ChannelView::Ior:
        case render::ChannelView::Uv0:
        case render::ChannelView::Uv1:
        case render::ChannelView::DiffuseDirect:
        case render::ChannelView::SpecularDirect:
        case render::ChannelView::DiffuseAmbient:
        case render::ChannelView::SpecularAmbient:
        case render::ChannelView::DistributionTerm:
        case render::ChannelView::FresnelTerm:
        case render::ChannelView::GeometryTerm:
        case render::ChannelView::UvChecker:
            return std::nullopt;
    }
    return std::nullopt;
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
    if (Result<std::vector<io::PresetFile>> presets = io::all_presets())
        presets_ = std::move(*presets);
    else
        log_warning("{}", presets.error().message);
    list_presets();
    thumbnails_.set_presets(&presets_);
    thumbnails_.set_environments(
        [this](const std::string& name) { return environments_.find(name); });
    light_with({"studio"});
}

Session::~Session() {
    set_log_sink({});
}

// --- the document --------------------------------------------------------------------------------

MaterialPtr Session::selected_material(const ViewState& view) const {
    return history_ ? find_material(*history_->document(), view.material) : nullptr;
}

LayerPtr Session::selected_layer(const ViewState& view) const {
    const MaterialPtr material = selected_material(view);
    return material ? find_layer(*material, view.layer) : nullptr;
}

/// What the shelf shows points into the presets.
void Session::list_presets() {
    preset_list_.clear();
    for (const io::PresetFile& file : presets_) preset_list_.push_back(&file.preset);
}

/// In its place by the id, instead of one that has that.
void Session::take_preset(io::PresetFile file) {
    const auto at = std::lower_bound(
        presets_.begin(), presets_.end(), file.preset.id,
        [](const io::PresetFile& each, const std::string& id) { return each.preset.id < id; });
    if (at != presets_.end() && at->preset.id == file.preset.id)
        *at = std::move(file);
    else
        presets_.insert(at, std::move(file));
    list_presets();
}

const io::PresetFile* Session::preset(const std::string& id) const {
    for (const io::PresetFile& file : presets_)
        if (file.preset.id == id) return &file;
    return nullptr;
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
    if (kind == ToastKind::Error) {
        log_warning("{}", message);
        if (link.empty()) {
            link = "Show log";
            action = Action::ShowLog;
        }
    }
    const double until = kind == ToastKind::Error ? 0.0 : now_seconds() + kToastSeconds;
    toasts_.push_back({{next_toast_++, kind, std::move(message), std::move(link), action}, until});
    if (toasts_.size() > kMostToasts) toasts_.erase(toasts_.begin());
    wants_frame_ = true;
    wake_();
}

void Session::hold_toast(int toast) {
    for (Toast& each : toasts_)
        if (each.shown.id == toast && each.until > 0.0)
            each.until = std::max(each.until, now_seconds() + kHeldToastSeconds);
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
    texel_ = TexelShown{.probe = *probe, .pixel = picture_.pixel(at), .material = material->id};
    explained_ = {};
    follow_texel(view);
}

void Session::follow_texel(const ViewState& view) {
    if (!texel_) return;
    const MaterialPtr material = find_material(document(), texel_->material);
    if (!material) return texel_.reset();
    const std::optional<Channel> channel = stack_channel(view.view.channel);
    const UvSurfacePtr last = live_.surface_of(material->id);
    const Explained wanted{material, last};
    if (explained_ == wanted && texel_->channel == channel) return;
    explained_ = wanted;
    const int size = material->resolution;
    const auto texel_at = [size](float uv) {
        const float wrapped = uv - std::floor(uv);
        return std::min(static_cast<int>(wrapped * static_cast<float>(size)), size - 1);
    };
    texel_->texel_x = texel_at(texel_->probe.uv.x);
    texel_->texel_y = texel_at(texel_->probe.uv.y);
    texel_->channel = channel;
    texel_->steps.clear();
    if (!channel) return;
    auto steps = explain_texel(*material, surface_read(*history_->document(), *material, last),
                               *images_, *channel, size, texel_->texel_x, texel_->texel_y);
    if (steps)
        texel_->steps = std::move(*steps);
    else
        toast(ToastKind::Error, steps.error().message);
}

/// The crosshair of what is explained stays on its point of the model when the camera moves.
Bounds Session::bounds_of_material(const ViewState& view) const {
    const MaterialPtr material = selected_material(view);
    std::set<PartRef> parts;
    if (material && document().scene)
        for (const patina::Part& part : parts_of(document()))
            if (part.material == material) parts.insert(part.ref);
    return parts.empty() ? bounds() : bounds_world_of(*document().scene, parts);
}

float Session::view_aspect(const ViewState& view) const {
    return viewport_aspect_ / static_cast<float>(view_columns(view.view));
}

void Session::follow_crosshair(ViewState& view) const {
    if (!texel_ || !view.crosshair || view.tool != ViewportTool::Probe) return;
    const auto columns = static_cast<float>(view_columns(view.view));
    const float column = std::floor(view.crosshair->x * columns);
    const render::Camera& camera = view.view.camera;
    const glm::vec4 point(texel_->probe[render::ChannelView::Position], 1.0f);
    const glm::vec4 clip = render::clip_from_view(camera, view_aspect(view), kAnyDepthRange) *
                           (render::view_from_world(camera) * point);
    if (clip.w <= 0.0f) return;
    view.crosshair = glm::vec2((column + 0.5f + 0.5f * clip.x / clip.w) / columns,
                               0.5f - 0.5f * clip.y / clip.w);
}

// --- a frame -------------------------------------------------------------------------------------

/// A layer alone or a mask, made anew only when something else is to be seen: another node would be
/// composited again.
MaterialPtr Session::part_of(const MaterialPtr& material, const ViewState& view) {
    const Part wanted{material, view.viewed_mask, view.solo};
    if (part_shown_ && part_ == wanted) return part_shown_;
    part_ = wanted;
    part_shown_ = std::make_shared<const Material>(
        view.viewed_mask.value != 0 ? with_mask_shown(*material, view.viewed_mask)
                                    : with_only_layer(*material, view.solo));
    return part_shown_;
}

/// The smallest power of two at which no texel is wider than two pixels, within what an edit can
/// wait for: what moves is drawn at half its size, and what rests is soon made at its full one.
int Session::seen_size(const Material& material, const ViewState& view, int picture_height) const {
    constexpr int kLeast = 256, kMost = 2048;
    const float texels =
        picture_.texels_seen(material.source_material.value_or(-1), material.uv_set,
                             view.view.camera, picture_height / 2);
    int size = kLeast;
    while (size < kMost && static_cast<float>(size) < texels) size *= 2;
    return size;
}

void Session::show_materials(const ViewState& view, int picture_height) {
    std::vector<LiveMaterials::Wanted> materials;
    for (const MaterialPtr& material : history_->document()->materials) {
        const bool in_part =
            material->id == view.material && (view.viewed_mask.value != 0 || view.solo.value != 0);
        materials.push_back({.material = in_part ? part_of(material, view) : material,
                             .seen_size = seen_size(*material, view, picture_height)});
    }
    live_.show(history_->document(), std::move(materials), images_, view.material);
    thumbnails_.set_surfaces(live_.surfaces());
    picture_.assign_materials(assigned_numbers(*history_->document()));
}

/// Numbers about what is compared, when someone looks at them and nothing moves.
void Session::follow_comparison(ViewState& view, bool moving) {
    const bool looked_at =
        view.right_tab == RightTab::Inspect || render::shows_difference_beside(view.view);
    if (!is_comparing(view) || !looked_at || view.view.channel != render::ChannelView::Final)
        return comparison_.reset();
    const int drawn = picture_.pictures_drawn();
    if (moving || (comparison_ && compared_picture_ == drawn && compared_at_ == view.crosshair))
        return;
    ComparisonShown comparison{.difference = picture_.difference(), .values = {}};
    if (view.crosshair) comparison.values = picture_.sides(*view.crosshair);
    // Beside the model there is nothing to compare.
    if (!comparison.values) view.crosshair.reset();
    if (comparison.values) {
        const float exposure = std::exp2(view.view.exposure_ev);
        comparison.values->left *= exposure;
        comparison.values->right *= exposure;
    }
    compared_picture_ = drawn;
    compared_at_ = view.crosshair;
    comparison_ = std::move(comparison);
    wants_frame_ = true;
}

/// Measures on a worker, where the Material tab tells of it.
void Session::follow_uv_layout(const ViewState& view) {
    const DocumentPtr document = history_->document();
    const MaterialPtr material = selected_material(view);
    if (view.right_tab != RightTab::Material || !material) return;
    if (uvs_.document == document && uvs_.material == material) return;
    const UvSurfacePtr surface = worn_surface(*document, *material, uvs_.surface);
    const bool same = surface == uvs_.surface;
    uvs_.document = document;
    uvs_.material = material;
    if (same) return;
    uvs_.surface = surface;
    uvs_.layout.reset();
    jobs_.start("Measuring UVs", [this, surface](const Progress&) {
        return [this, surface, layout = uv_layout(*surface)] {
            if (uvs_.surface == surface) uvs_.layout = layout;
        };
    });
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
        follow_texel(view);
        follow_uv_layout(view);
        show_materials(view, input.viewport.height);
        const std::vector<LiveMaterials::Changed> changed = live_.take();
        for (const LiveMaterials::Changed& each : changed)
            if (each.elapsed_ms > 0.0) composite_ms_ = each.elapsed_ms;
        picture_.set_materials(changed);
        viewport_aspect_ = static_cast<float>(std::max(input.viewport.width, 1)) /
                           static_cast<float>(std::max(input.viewport.height, 1));
        if (std::exchange(frame_new_document_, false)) {
            view.view.camera = render::framed(picture_.bounds(), view_aspect(view));
            view.crosshair.reset();
            view.solo = {};
            view.viewed_mask = {};
            view.unfolded_groups.clear();
        }
        follow_crosshair(view);
        render::View drawn = view.view;
        const Document& now = *history_->document();
        drawn.lights = now.lights;
        drawn.environment_rotation_degrees = now.environment.rotation_degrees;
        drawn.environment_intensity = now.environment.intensity;
        picture_.set_refining_draws(input.refining_draws);
        if (picture_.draw(drawn, input.viewport, input.strip_card, input.moving))
            frame_ms_ = picture_.frame_ms();
        if (picture_.out_of_date()) wants_frame_ = true;
        follow_comparison(view, input.moving);
        hovered_.reset();
        if (input.hovered) hovered_ = picture_.probe(*input.hovered);
    }
    draw_still();
    if (thumbnails_.finish_some(input.moving)) wants_frame_ = true;
    // Last: what has been asked for comes first.
    if (input.resting && !input.moving && refining()) picture_.refine();
}

bool Session::refining() const {
    const RefinementShown refinement = picture_.refinement();
    return history_ && refinement.drawn < refinement.draws && settled();
}

Shown Session::shown(const ViewState& view) {
    Shown shown;
    shown.thumbnails = &thumbnails_;
    shown.presets = preset_list_;
    shown.environments = environments_.shown();
    jobs_shown_ = jobs_.shown();
    shown.jobs = jobs_shown_;
    toasts_shown_.clear();
    for (const Toast& toast : toasts_) toasts_shown_.push_back(toast.shown);
    shown.toasts = toasts_shown_;
    shown.log = log_;
    shown.keeps_previous = keep_previous_;
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
    shown.file_name = file_name().string();
    shown.edited = history_->is_edited();
    shown.history = {.labels = history_->labels(),
                     .position = history_->position(),
                     .bytes = history_->bytes(),
                     .can_undo = history_->can_undo(),
                     .can_redo = history_->can_redo()};
    shown.refinement = picture_.refinement();
    // The renderer's pictures have their first row at the bottom.
    shown.viewport = {reinterpret_cast<ImTextureID>(picture_.texture()), ImVec2(0, 1),
                      ImVec2(1, 0)};
    shown.strip = {reinterpret_cast<ImTextureID>(picture_.strip_texture())};
    shown.texel = texel_;
    if (uvs_.material == shown.material) shown.uv_layout = uvs_.layout;
    shown.comparison = comparison_;
    shown.hovered = hovered_;
    return shown;
}

bool Session::settled() const {
    const bool drawn = !history_ || (live_.settled() && !picture_.out_of_date());
    return drawn && !jobs_.running() && thumbnails_.settled() && !wants_frame_;
}

}  // namespace patina::editor
