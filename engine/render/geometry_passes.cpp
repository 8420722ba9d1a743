// SPDX-License-Identifier: MIT
#include "render/geometry_passes.h"

#include <algorithm>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace patina::render {
namespace {

void bind_item(const RendererState& state, gl::Pass& pass, gl::Program& program,
               const DrawItem& item) {
    state.materials.bind(pass, program, state.materials.at(item.source_material));
    program.set("world_from_local", item.world_from_local);
    program.set("normal_world_from_local", glm::inverseTranspose(glm::mat3(item.world_from_local)));
    program.set("handedness", item.mirrored ? -1.0f : 1.0f);
    program.set("ids", glm::vec3(item.instance, item.primitive, item.source_material));
}

void draw_faces(const RendererState& state, gl::Pass& pass, const gl::Program& program,
                const gl::State& base, const DrawItem& item, gl::Cull cull) {
    gl::State draw_state = base;
    draw_state.cull = cull;
    draw_state.front_is_clockwise = item.mirrored;
    pass.set_state(draw_state);
    const gl::VertexArray& vertices = state.scene->vertex_arrays[item.vertices];
    pass.draw(program, vertices, {.count = vertices.count()});
}

gl::Format color_format(GBufferPrecision precision, gl::Format bytes) {
    return precision == GBufferPrecision::Halves ? gl::Format::Rgba16F : bytes;
}

gl::FramebufferDescription gbuffer_description(const std::string& label,
                                               GBufferPrecision precision) {
    return {.label = label,
            .colors = {{"albedo", color_format(precision, gl::Format::Srgb8Alpha8)},
                       {"normal_roughness", gl::Format::Rgba16F},
                       {"specular_ior", gl::Format::Rgba16F},
                       {"emissive_occlusion", gl::Format::Rgba16F}},
            .depth = gl::Format::Depth32F};
}

gl::FramebufferDescription with_surface_target(gl::FramebufferDescription description,
                                               GBufferPrecision precision) {
    description.colors.push_back({"surface", color_format(precision, gl::Format::Rgba8)});
    return description;
}

}  // namespace

FrameCamera frame_camera(const View& view, const Bounds& bounds, glm::ivec2 size,
                         glm::vec2 jitter_pixels) {
    const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
    FrameCamera camera;
    camera.range = depth_range(view.camera, bounds);
    camera.view_from_world = view_from_world(view.camera);
    // The picture moves against the sample point.
    const glm::vec2 shift_clip = -2.0f * jitter_pixels / glm::vec2(size);
    camera.clip_from_world = glm::translate(glm::mat4(1.0f), glm::vec3(shift_clip, 0.0f)) *
                             clip_from_view(view.camera, aspect, camera.range) *
                             camera.view_from_world;
    camera.position = view.camera.position;
    camera.forward = -glm::transpose(glm::mat3(camera.view_from_world))[2];
    camera.size = size;
    return camera;
}

gl::Viewport area_seen(const Bounds& bounds, const FrameCamera& camera) {
    glm::vec2 low(camera.size);
    glm::vec2 high(0.0f);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 point((corner & 1) != 0 ? bounds.high.x : bounds.low.x,
                              (corner & 2) != 0 ? bounds.high.y : bounds.low.y,
                              (corner & 4) != 0 ? bounds.high.z : bounds.low.z);
        const glm::vec4 clip = camera.clip_from_world * glm::vec4(point, 1.0f);
        if (clip.w <= 0.0f) return {{0, 0}, camera.size};
        const glm::vec2 pixel = (glm::vec2(clip) / clip.w * 0.5f + 0.5f) * glm::vec2(camera.size);
        low = glm::min(low, pixel);
        high = glm::max(high, pixel);
    }
    const glm::ivec2 first(glm::max(glm::floor(low), glm::vec2(0.0f)));
    const glm::ivec2 end(glm::min(glm::ceil(high), glm::vec2(camera.size)));
    return {first, glm::max(end - first, glm::ivec2(0))};
}

bool belongs(const GpuMaterial& material, SurfaceSet surfaces) {
    const bool blended = material.surface.alpha_mode == AlphaMode::Blend;
    return surfaces == SurfaceSet::All || blended == (surfaces == SurfaceSet::Blended);
}

Result<gl::Program*> SurfacePrograms::program_for(const GpuMaterial& material) {
    const SlotBits textured = textured_slots(material) & reads_;
    if (const auto found = ready_.find(textured); found != ready_.end()) return found->second;
    ShaderVariant variant = variant_;
    variant.constants.push_back(shader_constant("TEXTURED_SLOTS", textured));
    const Result<gl::Program*> program = shaders_.program(variant);
    if (!program) return program;
    set_up_(**program);
    return ready_.emplace(textured, *program).first->second;
}

Status draw_surfaces(const RendererState& state, gl::Pass& pass, SurfacePrograms& programs,
                     const gl::State& base, const std::vector<std::size_t>& order,
                     SurfaceSet surfaces) {
    for (const std::size_t index : order) {
        const DrawItem& item = state.scene->items[index];
        const GpuMaterial& material = state.materials.at(item.source_material);
        if (!belongs(material, surfaces)) continue;
        const Result<gl::Program*> program = programs.program_for(material);
        if (!program) return passed_on(program);
        bind_item(state, pass, **program, item);
        draw_faces(state, pass, **program, base, item,
                   material.surface.double_sided ? gl::Cull::None : gl::Cull::Back);
    }
    return {};
}

Status draw_blended_surfaces(RendererState& state, gl::Pass& pass, SurfacePrograms& programs,
                             const gl::State& base, const Camera& camera) {
    for (const std::size_t index : back_to_front(state.scene->items, camera)) {
        const DrawItem& item = state.scene->items[index];
        const GpuMaterial& material = state.materials.at(item.source_material);
        if (!belongs(material, SurfaceSet::Blended)) continue;
        const Result<gl::Program*> program = programs.program_for(material);
        if (!program) return passed_on(program);
        sort_triangles(*state.scene, item, camera);
        bind_item(state, pass, **program, item);
        // The far wall of what is hollow comes first: large triangles are not always sorted right.
        if (material.surface.double_sided)
            draw_faces(state, pass, **program, base, item, gl::Cull::Front);
        draw_faces(state, pass, **program, base, item, gl::Cull::Back);
    }
    return {};
}

GBufferTargets::GBufferTargets(const std::string& label, GBufferPrecision precision)
    : plain(gbuffer_description(label, precision)),
      with_surface(with_surface_target(gbuffer_description(label, precision), precision)) {}

bool is_forward(const View& view, const Shading& shading) {
    return shading.path == RenderPath::Forward && view.channel == ChannelView::Final;
}

bool filters_normals(const View& view) {
    return view.filter_normals && view.channel == ChannelView::Final;
}

std::optional<FrameSide> gbuffer_readers(const View& view) {
    const bool left = !is_forward(view, view.left);
    const bool right = view.compare == CompareMode::Single ? left : !is_forward(view, view.right);
    if (left && right) return FrameSide::Shared;
    if (left) return FrameSide::Left;
    if (right) return FrameSide::Right;
    return std::nullopt;
}

Result<gl::Framebuffer*> draw_gbuffer(RendererState& state, GBufferTargets& targets,
                                      const View& view, const FrameCamera& camera,
                                      SurfaceSet surfaces,
                                      const std::optional<gl::Viewport>& only) {
    const bool with_surface = state.materials.any_needs_surface_target();
    Result<gl::Framebuffer*> gbuffer =
        (with_surface ? targets.with_surface : targets.plain).at(camera.size);
    if (!gbuffer) return gbuffer;
    ShaderVariant variant{kSurfaceVertexFile, "passes/gbuffer.frag", {}};
    if (with_surface) variant.constants.push_back({"SURFACE_TARGET", "1"});
    if (filters_normals(view)) variant.constants.push_back({"FILTER_NORMALS", "1"});
    const glm::vec4 eye_world = view.camera.orthographic_height > 0.0f
                                    ? glm::vec4(-camera.forward, 0.0f)
                                    : glm::vec4(camera.position, 1.0f);
    SurfacePrograms programs(state.shaders, variant, kAllSlots, [&](gl::Program& program) {
        program.set("clip_from_world", camera.clip_from_world);
        program.set("level_bias", camera.level_bias);
        program.set("eye_world", eye_world);
    });

    // Colours need no clearing: nothing reads them where depth is 1.
    const gl::State base{.encode_srgb = true};
    const PassTimers::Scope timed =
        state.timers.measure(gbuffer_readers(view).value_or(FrameSide::Shared), "G-buffer");
    gl::Pass pass({.label = "G-buffer",
                   .target = *gbuffer,
                   .scissor = only,
                   .state = base,
                   .clear_depth = 1.0f});
    const Status drawn = draw_surfaces(state, pass, programs, base,
                                       front_to_back(state.scene->items, view.camera), surfaces);
    if (!drawn) return passed_on(drawn);
    return gbuffer;
}

std::optional<Inspected> inspected_for(ChannelView channel) {
    switch (channel) {
        case ChannelView::Alpha:
            return Inspected::Alpha;
        case ChannelView::Tangent:
            return Inspected::Tangent;
        case ChannelView::GeometricNormal:
            return Inspected::GeometricNormal;
        case ChannelView::Uv0:
            return Inspected::Uv0;
        case ChannelView::Uv1:
            return Inspected::Uv1;
        case ChannelView::UvChecker:
            return Inspected::UvChecker;
        case ChannelView::Final:
        case ChannelView::BaseColor:
        case ChannelView::Metalness:
        case ChannelView::Roughness:
        case ChannelView::NormalWorld:
        case ChannelView::F0:
        case ChannelView::Position:
        case ChannelView::Depth:
        case ChannelView::Occlusion:
        case ChannelView::Emissive:
        case ChannelView::NormalView:
        case ChannelView::Ior:
        case ChannelView::DiffuseDirect:
        case ChannelView::SpecularDirect:
        case ChannelView::DiffuseAmbient:
        case ChannelView::SpecularAmbient:
        case ChannelView::DistributionTerm:
        case ChannelView::FresnelTerm:
        case ChannelView::GeometryTerm:
            return std::nullopt;
    }
    return std::nullopt;
}

Result<gl::Framebuffer*> draw_inspection(RendererState& state, const View& view,
                                         const FrameCamera& camera, Inspected inspected,
                                         const std::optional<gl::Viewport>& only) {
    Result<gl::Framebuffer*> target = state.inspection.at(camera.size);
    if (!target) return target;
    SurfacePrograms programs(state.shaders, {kSurfaceVertexFile, "passes/inspection.frag", {}},
                             kBaseColorSlot, [&](gl::Program& program) {
                                 program.set("clip_from_world", camera.clip_from_world);
                                 program.set("inspected", static_cast<int>(inspected));
                             });

    const gl::State base;
    const PassTimers::Scope timed = state.timers.measure(FrameSide::Shared, "Inspection");
    gl::Pass pass({.label = "inspection",
                   .target = *target,
                   .scissor = only,
                   .state = base,
                   .clear_colors = {glm::vec4(0.0f)},
                   .clear_depth = 1.0f});
    const Status drawn =
        draw_surfaces(state, pass, programs, base, front_to_back(state.scene->items, view.camera),
                      SurfaceSet::All);
    if (!drawn) return passed_on(drawn);
    return target;
}

}  // namespace patina::render
