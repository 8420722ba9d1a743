// SPDX-License-Identifier: MIT
#include "render/renderer.h"

#include "core/program_folders.h"
#include "render/frame.h"
#include "render/renderer_state.h"
#include "render/wires.h"

namespace patina::render {
namespace {

gl::FramebufferDescription color_target(std::string label, gl::Format format) {
    return {.label = label, .size = {1, 1}, .colors = {{label, format}}};
}

gl::FramebufferDescription with_depth(gl::FramebufferDescription description) {
    description.depth = gl::Format::Depth32F;
    return description;
}

gl::Sampler linear_sampler() {
    return gl::Sampler::make({.label = "linear"});
}

glm::ivec2 vector_of(PictureSize size) {
    return {size.width, size.height};
}

Status check_size(PictureSize size) {
    if (size.width >= 1 && size.height >= 1 && size.width <= kMaxPictureSide &&
        size.height <= kMaxPictureSide)
        return {};
    return failure("a picture of {} x {} cannot be drawn: its sides are 1 to {} pixels", size.width,
                   size.height, kMaxPictureSide);
}

const gl::Framebuffer* shown_picture(const RendererState& state) {
    return state.shown == nullptr ? nullptr : state.shown->get();
}

Result<Image> image_of(const gl::Framebuffer* framebuffer) {
    if (framebuffer == nullptr) return failure("nothing has been drawn yet: draw a view first");
    const gl::Texture& texture = framebuffer->color(0);
    const std::vector<std::uint8_t> bytes = texture.read_bytes();
    Image image{.width = texture.size().x,
                .height = texture.size().y,
                .channels = 4,
                .type = SampleType::U8,
                .data = {}};
    image.data.resize(bytes.size());
    const auto height = static_cast<std::size_t>(image.height);
    for (std::size_t y = 0; y < height; ++y)
        std::memcpy(image.data.data() + y * image.row_bytes(),
                    bytes.data() + (height - 1 - y) * image.row_bytes(), image.row_bytes());
    return image;
}

std::uintptr_t texture_of(const gl::Framebuffer* framebuffer) {
    return framebuffer == nullptr ? 0 : framebuffer->color(0).name();
}

}  // namespace

Result<gl::Framebuffer*> SizedTarget::at(glm::ivec2 size) {
    if (framebuffer_) {
        if (Status resized = framebuffer_->resize(size); !resized) return passed_on(resized);
        return &*framebuffer_;
    }
    description_.size = size;
    Result<gl::Framebuffer> made = gl::Framebuffer::make(description_);
    if (!made) return passed_on(made);
    framebuffer_ = std::move(*made);
    return &*framebuffer_;
}

RendererState::RendererState(std::filesystem::path shader_folder, GpuGroundShadow made_shadow)
    : shaders(std::move(shader_folder)),
      full_screen(gl::VertexArray::make({.label = "full screen"})),
      linear(linear_sampler()),
      shadow(std::move(made_shadow)),
      gbuffer("gbuffer", GBufferPrecision::Bytes),
      still_gbuffer("still gbuffer", GBufferPrecision::Halves),
      strip_gbuffer("strip gbuffer", GBufferPrecision::Bytes),
      inspection(with_depth(color_target("inspection", gl::Format::Rgba32F))),
      // Highlights of smooth metal in the sun go beyond what half floats hold, and infinity less a
      // share of itself is no number.
      radiance(with_depth(color_target("radiance", gl::Format::Rgba32F))),
      left(with_depth(color_target("left", gl::Format::Rgba32F))),
      right(with_depth(color_target("right", gl::Format::Rgba32F))),
      picture(with_depth(color_target("picture", gl::Format::Rgba8))),
      smoothed(color_target("smoothed", gl::Format::Rgba8)),
      wires({.label = "wires",
             .colors = {{"wires", gl::Format::Rgba8}},
             .depth = gl::Format::Depth32F}),
      strip(with_depth(color_target("strip", gl::Format::Rgba8))),
      accumulation(with_depth(color_target("accumulation", gl::Format::Rgba32F))),
      accumulation_right(with_depth(color_target("accumulation.right", gl::Format::Rgba32F))),
      still(color_target("still", gl::Format::Rgba32F)),
      refinement(with_depth(color_target("refinement", gl::Format::Rgba32F))),
      refined(color_target("refined", gl::Format::Rgba8)),
      probe_values(color_target("probe", gl::Format::Rgba32F)) {}

Status require_content(const RendererState& state) {
    if (!state.scene) return failure("nothing to draw: set a scene first");
    if (!state.environment) return failure("nothing to light with: set an environment first");
    return {};
}

Result<const EnvironmentTables*> environment_tables(RendererState& state, const PbrTerms& terms) {
    PbrTerms wanted = terms;
    wanted.multiple_scattering = false;  // is a factor of what the tables hold
    for (const auto& [made_for, tables] : state.environment_tables)
        if (made_for == wanted) return &tables;
    Result<EnvironmentTables> made = upload_environment_tables(wanted);
    if (!made) return passed_on(made);
    state.environment_tables.emplace_back(wanted, std::move(*made));
    return &state.environment_tables.back().second;
}

Renderer::Renderer(std::unique_ptr<RendererState> state) : state_(std::move(state)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

Result<Renderer> Renderer::create() {
    const Result<std::filesystem::path> shaders = resource_folder("shaders");
    if (!shaders) return passed_on(shaders);
    Result<GpuGroundShadow> shadow =
        upload_ground_shadow({.side = 1, .extent = 0.0f, .hidden = {HiddenSky{}}});
    if (!shadow) return passed_on(shadow);
    auto state = std::make_unique<RendererState>(*shaders, std::move(*shadow));
    if (const auto tables = environment_tables(*state, {}); !tables) return passed_on(tables);
    return Renderer(std::move(state));
}

Status Renderer::set_scene(const ScenePtr& scene) {
    state_->scene = upload_scene(scene);
    state_->shadow.casters.reset();
    state_->shadow_maps.stale = true;
    return {};
}

void Renderer::assign_materials(const std::map<PartRef, int>& source_materials) {
    if (!state_->scene) return;
    for (DrawItem& item : state_->scene->items) {
        const Primitive& primitive = primitive_of(*state_->scene, item);
        const auto assigned = source_materials.find(primitive.source);
        item.source_material =
            assigned == source_materials.end() ? primitive.source_material : assigned->second;
    }
    // Cut-out materials cast other shadows.
    state_->shadow_maps.stale = true;
}

Status Renderer::set_material(int source_material, const SurfaceMaterial& surface,
                              const std::optional<TexelRect>& changed) {
    state_->shadow_maps.stale = true;
    return state_->materials.set(source_material, surface, changed);
}

void Renderer::clear_materials() {
    state_->shadow_maps.stale = true;
    state_->materials.clear();
}

Status Renderer::set_environment(const FilteredEnvironment& environment) {
    Result<GpuEnvironment> uploaded = upload_environment(environment);
    if (!uploaded) return passed_on(uploaded);
    state_->environment = std::move(*uploaded);
    state_->sampled_environment.reset();
    state_->shadow.rotation_degrees.reset();
    return {};
}

Result<FrameStats> Renderer::draw(const View& view, PictureSize size) {
    if (Status ready = require_content(*state_); !ready) return passed_on(ready);
    if (Status fits = check_size(size); !fits) return passed_on(fits);
    const Result<gl::Framebuffer*> picture = state_->picture.at(vector_of(size));
    if (!picture) return passed_on(picture);
    if (Status drawn = draw_frame(*state_, view, vector_of(size), {.framebuffer = *picture});
        !drawn)
        return passed_on(drawn);
    state_->last_view = view;
    state_->last_size = size;
    state_->shown = &state_->picture;
    if (view.anti_aliasing == AntiAliasing::Fast && view.channel == ChannelView::Final &&
        view.compare != CompareMode::Difference) {
        const Result<gl::Framebuffer*> smoothed = state_->smoothed.at(vector_of(size));
        if (!smoothed) return passed_on(smoothed);
        if (Status done = draw_smoothed(*state_, **picture, **smoothed,
                                        surface_areas(*state_, view, vector_of(size)));
            !done)
            return passed_on(done);
        state_->shown = &state_->smoothed;
    }
    if (view.wires)
        if (Status done = draw_wires(*state_, view, *state_->shown->get()); !done)
            return passed_on(done);
    return frame_stats(*state_);
}

FrameStats Renderer::stats() const {
    return frame_stats(*state_);
}

Status Renderer::draw_strip(const View& view, PictureSize thumbnail) {
    if (Status ready = require_content(*state_); !ready) return ready;
    const PictureSize whole{thumbnail.width * kStripChannelCount, thumbnail.height};
    if (Status fits = check_size(whole); !fits) return fits;
    const Result<gl::Framebuffer*> strip = state_->strip.at(vector_of(whole));
    if (!strip) return passed_on(strip);
    return draw_strip_frame(*state_, view, vector_of(thumbnail), **strip);
}

Status Renderer::lay_wires(const View& view, Image& still) {
    if (Status ready = require_content(*state_); !ready) return ready;
    return render::lay_wires(*state_, view, still);
}

std::uintptr_t Renderer::picture_texture() const {
    return texture_of(shown_picture(*state_));
}

std::uintptr_t Renderer::strip_texture() const {
    return texture_of(state_->strip.get());
}

Result<Image> Renderer::read_picture() {
    return image_of(shown_picture(*state_));
}

const Bounds& Renderer::bounds_world() const {
    static const Bounds kEmpty;
    return state_->scene ? state_->scene->bounds_world : kEmpty;
}

float Renderer::texels_seen(int source_material, int uv_set, const Camera& camera,
                            int picture_height) const {
    if (!state_->scene) return 0.0f;
    return render::texels_seen(*state_->scene, source_material, uv_set, camera, picture_height);
}

}  // namespace patina::render
