// SPDX-License-Identifier: MIT
#include "render/picture_passes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/formulae/formulae.h"
#include "render/light_uniforms.h"

namespace patina::render {
namespace {

// Texture units; 0 to 4 belong to materials, 8 to 11 to the environment and 12 to shadows.
constexpr int kGBufferUnit = 0;
constexpr int kDepthUnit = 5;
constexpr int kInspectionUnit = 6;
constexpr int kGroundShadowUnit = 7;
/// Of the shadows on the floor behind a mean of many draws, which is drawn once: of a still, and of
/// a picture that is shown while it refines.
constexpr int kFloorDrawsOfStill = 16;
constexpr int kFloorDrawsOfMean = 4;

int floor_draws_for(const PictureTarget& target, int averaged) {
    if (averaged <= 1) return 1;
    return target.output == OutputMode::Srgb ? kFloorDrawsOfMean : kFloorDrawsOfStill;
}
constexpr std::array<const char*, 5> kGBufferSamplers = {
    "albedo", "normal_roughness", "specular_ior", "emissive_occlusion", "surface_target"};

using Constants = std::vector<gl::ShaderDefine>;

bool has_shadows(const RendererState& state) {
    return !state.shadow_maps.plan.lights.empty();
}

void add_shading_constants(Constants& constants, const RendererState& state, const SideView& side,
                           const PictureTarget& target) {
    const auto& [view, shading, of_comparison] = side;
    constants.push_back(shader_constant("SHADOWS", has_shadows(state)));
    constants.push_back(shader_constant("AREA_LIGHTS", state.lights.any_has_size()));
    constants.push_back(shader_constant("OCCLUDE_REFLECTIONS", view.occlude_reflections));
    constants.push_back(shader_constant("SHADING_MODEL", shading.model));
    constants.push_back(shader_constant("DISTRIBUTION", shading.terms.distribution));
    constants.push_back(shader_constant("GEOMETRY", shading.terms.geometry));
    constants.push_back(shader_constant("FRESNEL", shading.terms.fresnel));
    constants.push_back(shader_constant("DIFFUSE", shading.terms.diffuse));
    constants.push_back(shader_constant("MULTIPLE_SCATTERING", shading.terms.multiple_scattering));
    constants.push_back(shader_constant("SAMPLED_ENVIRONMENT", target.still.has_value()));
}

void add_output_constants(Constants& constants, const View& view, OutputMode output) {
    constants.push_back(shader_constant("OUTPUT_MODE", output));
    constants.push_back(shader_constant("TONE_MAP", view.tone_map));
}

void add_background_constants(Constants& constants, const RendererState& state, const View& view) {
    constants.push_back(shader_constant("BACKGROUND_KIND", view.background.kind));
    constants.push_back(shader_constant("SHADOWS", shades_floor(view) && has_shadows(state)));
}

void set_camera(gl::Program& program, const FrameCamera& camera, const PictureTarget& target) {
    program.set("world_from_clip", glm::inverse(camera.clip_from_world));
    program.set("view_from_world", camera.view_from_world);
    program.set("camera_position", camera.position);
    program.set("camera_forward", camera.forward);
    program.set("picture_size", glm::vec2(camera.size));
    program.set("picture_offset", target.picture_offset);
}

void set_output(gl::Program& program, const View& view) {
    program.set("exposure", std::exp2(view.exposure_ev));
}

glm::vec3 linear_color(const glm::vec3& srgb) {
    const formulae::Real3 linear = formulae::linear_from_srgb({srgb.x, srgb.y, srgb.z});
    return {linear.x, linear.y, linear.z};
}

/// What stands behind the surfaces.
struct Backdrop {
    const View& view;
    const EnvironmentTables& tables;
    int draw_index = 0;
    int floor_draws = 1;
};

void set_background(gl::Pass& pass, gl::Program& program, const RendererState& state,
                    const Backdrop& backdrop) {
    const View& view = backdrop.view;
    program.set("background_color", linear_color(view.background.color_srgb));
    pass.bind_texture(program, "ground_shadow", kGroundShadowUnit, state.shadow.light,
                      &state.linear);
    program.set("ground_shadow_extent", view.ground_shadow ? state.shadow.shadow.extent : 0.0f);
    program.set("floor_center", state.shadow.shadow.center_world);
    program.set("floor_radius", std::max(state.scene->bounds_world.radius(), 1e-6f));
    program.set("scene_low", state.scene->bounds_world.low);
    program.set("scene_high", state.scene->bounds_world.high);
    program.set("floor_draws", backdrop.floor_draws);
    bind_environment(pass, program, *state.environment, backdrop.tables, state.linear, view);
    state.lights.bind(pass, program);
    bind_shadows(pass, program, state, backdrop.draw_index);
}

/// What a pass reads beside surfaces.
struct PassLight {
    const SideView& side;
    const PictureTarget& target;
    const EnvironmentTables& tables;
};

void bind_light(gl::Pass& pass, gl::Program& program, const RendererState& state,
                const PassLight& light) {
    const auto& [side, target, tables] = light;
    if (target.still)
        bind_environment_samples(pass, program, *state.sampled_environment, *target.still);
    bind_environment(pass, program, *state.environment, tables, state.linear, side.view);
    state.lights.bind(pass, program);
    set_lighting(program, side.view, side.shading, *state.environment);
    bind_shadows(pass, program, state, target.draw_index);
}

/// What is black and white in a channel that is fitted to the scene.
void set_channel_range(gl::Program& program, const RendererState& state, const View& view,
                       const FrameCamera& camera) {
    glm::vec3 low = state.scene->bounds_world.low;
    glm::vec3 high = state.scene->bounds_world.high;
    if (view.channel == ChannelView::Depth) {
        low = glm::vec3(camera.range.near_m);
        high = glm::vec3(camera.range.far_m);
    } else if (view.channel == ChannelView::Ior) {
        low = glm::vec3(1.0f);
        high = glm::vec3(3.0f);
    }
    program.set("range_low", low);
    program.set("range_high", glm::max(high, low + 1e-6f));
}

void bind_inputs(gl::Pass& pass, gl::Program& program, const LightingInputs& inputs) {
    if (inputs.inspection != nullptr) {
        pass.bind_texture(program, "inspection", kInspectionUnit, inputs.inspection->color(0));
        return;
    }
    const std::size_t targets = inputs.gbuffer->description().colors.size();
    for (std::size_t i = 0; i < targets; ++i)
        pass.bind_texture(program, kGBufferSamplers[i], kGBufferUnit + static_cast<int>(i),
                          inputs.gbuffer->color(i));
    pass.bind_texture(program, "depth", kDepthUnit, inputs.gbuffer->depth());
}

bool has_surface_target(const LightingInputs& inputs) {
    return inputs.gbuffer != nullptr &&
           inputs.gbuffer->description().colors.size() == kGBufferSamplers.size();
}

ShaderVariant lighting_variant(const RendererState& state, const SideView& side,
                               const LightingInputs& inputs, const PictureTarget& target) {
    ShaderVariant variant{kFullScreenVertexFile, "passes/lighting.frag", {}};
    add_shading_constants(variant.constants, state, side, target);
    add_output_constants(variant.constants, side.view, target.output);
    variant.constants.push_back(shader_constant("CHANNEL", side.view.channel));
    variant.constants.push_back(
        shader_constant("CHANNEL_DISPLAY", info(side.view.channel).display));
    variant.constants.push_back(
        shader_constant("CHANNEL_IS_INSPECTION", inputs.inspection != nullptr));
    variant.constants.push_back(shader_constant("SURFACE_TARGET", has_surface_target(inputs)));
    return variant;
}

gl::State full_screen_state(const PictureTarget& target) {
    gl::State state = kFullScreenState;
    if (target.add) state.blend = gl::Blend::Add;
    return state;
}

gl::PassDescription full_screen_pass(std::string label, const PictureTarget& target) {
    return {.label = std::move(label),
            .target = target.framebuffer,
            .viewport = target.area,
            .state = full_screen_state(target)};
}

/// The program of a pass that shows light of the environment, and the tables of its terms.
struct LitProgram {
    gl::Program& program;
    const EnvironmentTables& tables;
};

Result<LitProgram> lit_program(RendererState& state, const SideView& side,
                               const ShaderVariant& variant) {
    const Result<gl::Program*> program = state.shaders.program(variant);
    if (!program) return passed_on(program);
    const auto tables = environment_tables(state, side.shading.terms);
    if (!tables) return passed_on(tables);
    return LitProgram{**program, **tables};
}

/// Pixels around a surface that an edge of it is smoothed over.
constexpr int kSmoothingReach = 4;

gl::Viewport grown_within(const gl::Viewport& area, int by, glm::ivec2 size) {
    const glm::ivec2 low = glm::max(area.offset - by, glm::ivec2(0));
    const glm::ivec2 high = glm::min(area.offset + area.size + by, size);
    return {low, glm::max(high - low, glm::ivec2(0))};
}

/// Whether nothing is drawn where there is no surface.
bool background_is_empty(const View& view, const PictureTarget& target) {
    if (view.background.kind == Background::Kind::Transparent) return true;
    return view.channel != ChannelView::Final && target.output == OutputMode::Radiance;
}

/// @param only_pixel  at least 0: every pixel shows that one of the G-buffer
Status draw_lighting(RendererState& state, const SideView& side, const FrameCamera& camera,
                     const LightingInputs& inputs, const PictureTarget& target,
                     const gl::PassDescription& description, glm::ivec2 only_pixel) {
    const Result<LitProgram> found =
        lit_program(state, side, lighting_variant(state, side, inputs, target));
    if (!found) return passed_on(found);
    const auto& [program, tables] = *found;
    const PassTimers::Scope timed = state.timers.measure(side.side, "Lighting");
    gl::Pass pass(description);
    set_camera(program, camera, target);
    set_output(program, side.view);
    set_channel_range(program, state, side.view, camera);
    program.set("gbuffer_pixel_override", only_pixel);
    bind_light(pass, program, state, {side, target, tables});
    bind_inputs(pass, program, inputs);
    pass.draw(program, state.full_screen, {.count = 3});
    return {};
}

/// Where the target's depth has no surface.
Status draw_background(RendererState& state, const SideView& side, const FrameCamera& camera,
                       const PictureTarget& target) {
    const bool of_channel = side.view.channel != ChannelView::Final;
    ShaderVariant variant{kFullScreenVertexFile, "passes/background.frag", {}};
    add_output_constants(variant.constants, side.view, target.output);
    add_background_constants(variant.constants, state, side.view);
    variant.constants.push_back(shader_constant("CHANNEL_BACKGROUND", of_channel));
    const Result<LitProgram> found = lit_program(state, side, variant);
    if (!found) return passed_on(found);
    const auto& [program, tables] = *found;
    const PassTimers::Scope timed = state.timers.measure(side.side, "Background");
    gl::PassDescription description = full_screen_pass("background", target);
    description.state.depth_test = gl::DepthTest::LessOrEqual;
    gl::Pass pass(description);
    set_camera(program, camera, target);
    set_output(program, side.view);
    set_background(pass, program, state, {side.view, tables, target.draw_index});
    pass.draw(program, state.full_screen, {.count = 3});
    return {};
}

}  // namespace

Status draw_deferred(RendererState& state, const SideView& side, const FrameCamera& camera,
                     const LightingInputs& inputs, const PictureTarget& target) {
    gl::copy_depth(*inputs.surfaces(), target.area.offset - target.picture_offset,
                   *target.framebuffer, target.area.offset, target.area.size);
    gl::PassDescription lighting = full_screen_pass("lighting", target);
    lighting.state.depth_test = gl::DepthTest::Greater;
    const bool empty = background_is_empty(side.view, target);
    if (empty && !target.add) lighting.clear_colors = {glm::vec4(0.0f)};
    if (Status lit = draw_lighting(state, side, camera, inputs, target, lighting, glm::ivec2(-1));
        !lit)
        return lit;
    return empty ? Status{} : draw_background(state, side, camera, target);
}

Status draw_lit_pixel(RendererState& state, const SideView& side, const FrameCamera& camera,
                      const LightingInputs& inputs, const PictureTarget& target, glm::ivec2 pixel) {
    return draw_lighting(state, side, camera, inputs, target, full_screen_pass("lit pixel", target),
                         pixel);
}

Status draw_forward(RendererState& state, const SideView& side, const FrameCamera& camera,
                    SurfaceSet surfaces, const PictureTarget& target) {
    ShaderVariant variant{kSurfaceVertexFile, "passes/forward.frag", {}};
    add_shading_constants(variant.constants, state, side, target);
    variant.constants.push_back(shader_constant("FILTER_NORMALS", filters_normals(side.view)));
    const auto tables = environment_tables(state, side.shading.terms);
    if (!tables) return passed_on(tables);
    const bool blended = surfaces == SurfaceSet::Blended;
    const gl::State base =
        blended ? gl::State{.write_depth = false, .blend = gl::Blend::Premultiplied} : gl::State{};
    const PassTimers::Scope timed =
        state.timers.measure(side.side, blended ? "Blended" : "Forward");
    gl::PassDescription description{.label = blended ? "blended" : "forward",
                                    .target = target.framebuffer,
                                    .viewport = gl::Viewport{target.picture_offset, camera.size},
                                    .scissor = target.area,
                                    .state = base};
    if (!blended) {
        description.clear_colors = {glm::vec4(0.0f)};
        description.clear_depth = 1.0f;
    }
    gl::Pass pass(description);
    SurfacePrograms programs(state.shaders, variant, kAllSlots, [&](gl::Program& program) {
        set_camera(program, camera, target);
        program.set("clip_from_world", camera.clip_from_world);
        program.set("level_bias", camera.level_bias);
        bind_light(pass, program, state, {side, target, **tables});
    });
    if (blended) return draw_blended_surfaces(state, pass, programs, base, side.view.camera);
    return draw_surfaces(state, pass, programs, base,
                         front_to_back(state.scene->items, side.view.camera), surfaces);
}

Status draw_post(RendererState& state, const SideView& side, const FrameCamera& camera,
                 const RadianceInput& radiance, const PictureTarget& target) {
    ShaderVariant variant{kFullScreenVertexFile, "passes/post.frag", {}};
    add_output_constants(variant.constants, side.view, target.output);
    add_background_constants(variant.constants, state, side.view);
    const Result<LitProgram> found = lit_program(state, side, variant);
    if (!found) return passed_on(found);
    const auto& [program, tables] = *found;
    const PassTimers::Scope timed = state.timers.measure(side.side, "Post");
    gl::Pass pass(full_screen_pass("post", target));
    set_camera(program, camera, target);
    set_output(program, side.view);
    set_background(pass, program, state,
                   {side.view, tables, target.draw_index, floor_draws_for(target, radiance.draws)});
    program.set("radiance_offset", radiance.picture_offset);
    program.set("radiance_share", 1.0f / static_cast<float>(radiance.draws));
    pass.bind_texture(program, "radiance", 0, radiance.sum->color(0));
    pass.draw(program, state.full_screen, {.count = 3});
    return {};
}

Status draw_difference(RendererState& state, const View& view, const SidePictures& sides,
                       const PictureTarget& target) {
    ShaderVariant variant{kFullScreenVertexFile, "passes/difference.frag", {}};
    add_output_constants(variant.constants, view, target.output);
    const Result<gl::Program*> found = state.shaders.program(variant);
    if (!found) return passed_on(found);
    gl::Program& program = **found;
    const PassTimers::Scope timed = state.timers.measure(FrameSide::Shared, "Difference");
    gl::Pass pass(full_screen_pass("difference", target));
    set_output(program, view);
    program.set("picture_offset", target.picture_offset);
    program.set("difference_range", std::max(view.difference_range, 1e-6f));
    program.set("radiance_share", 1.0f / static_cast<float>(sides.draws));
    pass.bind_texture(program, "left", 0, sides.left->color(0));
    pass.bind_texture(program, "right", 1, sides.right->color(0));
    pass.draw(program, state.full_screen, {.count = 3});
    return {};
}

Status draw_smoothed(RendererState& state, const gl::Framebuffer& picture,
                     const gl::Framebuffer& target, const std::vector<gl::Viewport>& areas) {
    const Result<gl::Program*> found =
        state.shaders.program({kFullScreenVertexFile, "passes/smooth.frag", {}});
    if (!found) return passed_on(found);
    gl::Program& program = **found;
    const PassTimers::Scope timed = state.timers.measure(FrameSide::Shared, "Anti-aliasing");
    gl::copy_color(picture, target);
    for (const gl::Viewport& area : areas) {
        gl::Pass pass({.label = "smooth",
                       .target = &target,
                       .scissor = grown_within(area, kSmoothingReach, picture.size()),
                       .state = kFullScreenState});
        program.set("texel_size", 1.0f / glm::vec2(picture.size()));
        pass.bind_texture(program, "picture", 0, picture.color(0), &state.linear);
        pass.draw(program, state.full_screen, {.count = 3});
    }
    return {};
}

}  // namespace patina::render
