// SPDX-License-Identifier: MIT

/// Frames of the renderer and the filtering of environments. `frame/bare` draws the same passes by
/// themselves; `frame/moving` is what is drawn while something moves, half the size.

#include <benchmark/benchmark.h>
#include <epoxy/gl.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>

#include "core/program_folders.h"
#include "gl/headless_context.h"
#include "render/frame.h"
#include "render/renderer.h"
#include "scene/shapes.h"

namespace patina::render {
namespace {

constexpr PictureSize kSize = {1280, 720};

/// Without a context or the shaders there is nothing to measure.
template <typename T>
T value_or_exit(Result<T> result) {
    if (result) return std::move(*result);
    std::fprintf(stderr, "patina_bench: %s\n", result.error().message.c_str());
    std::exit(1);
}

ScenePtr shader_ball_scene() {
    auto scene = std::make_shared<Scene>();
    scene->meshes.push_back(shape_mesh(Shape::ShaderBall));
    scene->instances.push_back({.mesh = 0, .world_from_local = glm::mat4(1.0f), .name = "ball"});
    return scene;
}

const Image& studio_map() {
    static const Image map = value_or_exit(builtin_environment("studio"));
    return map;
}

View view_of(const Bounds& bounds) {
    View view;
    view.camera =
        framed(bounds, static_cast<float>(kSize.width) / static_cast<float>(kSize.height));
    return view;
}

gl::HeadlessContext headless() {
    return value_or_exit(gl::HeadlessContext::make(
        [](std::string_view message) { std::fprintf(stderr, "OpenGL: %s\n", message.data()); }));
}

/// In the studio.
Renderer ready_renderer(const ScenePtr& scene = shader_ball_scene()) {
    Renderer renderer = value_or_exit(Renderer::create());
    value_or_exit(renderer.set_scene(scene).map([] { return 0; }));
    value_or_exit(
        renderer
            .set_environment(value_or_exit(filter_environment(studio_map(), FilterQuality::First)))
            .map([] { return 0; }));
    return renderer;
}

/// Times frames in which the camera moves and `change` is made; the first, which compiles the
/// shaders, is not among them.
template <typename Change>
void time_frames(benchmark::State& run, Renderer& renderer, View& view, PictureSize size,
                 const Change& change) {
    const auto draw = [&] {
        view.camera = orbited(view.camera, 1.0f, 0.0f);
        change();
        benchmark::DoNotOptimize(value_or_exit(renderer.draw(view, size)));
        glFinish();
    };
    draw();
    for (auto _ : run) draw();
}

void draw_through_renderer(benchmark::State& run, PictureSize size) {
    const gl::HeadlessContext context = headless();
    Renderer renderer = ready_renderer();
    View view = view_of(renderer.bounds_world());
    time_frames(run, renderer, view, size, [] {});
}

void frame(benchmark::State& run) {
    draw_through_renderer(run, kSize);
}
BENCHMARK(frame)->Name("frame/1280x720")->Unit(benchmark::kMillisecond);

void frame_moving(benchmark::State& run) {
    draw_through_renderer(run, {kSize.width / 2, kSize.height / 2});
}
BENCHMARK(frame_moving)->Name("frame/moving/1280x720")->Unit(benchmark::kMillisecond);

/// A model of some ten thousand triangles with textures that covers a quarter of the picture, as it
/// is opened in the editor.
void frame_quarter(benchmark::State& run, AntiAliasing anti_aliasing) {
    const gl::HeadlessContext context = headless();
    auto scene = std::make_shared<Scene>();
    scene->meshes.push_back(shape_mesh(Shape::Sphere));
    scene->instances.push_back({.mesh = 0, .world_from_local = glm::mat4(1.0f), .name = "sphere"});
    Renderer renderer = ready_renderer(scene);
    View view = view_of(renderer.bounds_world());
    // Of the height: a quarter of 16:9 is a disc of this diameter.
    const float share = 2.0f * std::sqrt(0.25f * (16.0f / 9.0f) / 3.14159265f);
    const glm::vec3 target = renderer.bounds_world().center();
    const float radius = 0.5f * (renderer.bounds_world().high.y - renderer.bounds_world().low.y);
    const float angle = std::atan(share * std::tan(glm::radians(0.5f * view.camera.fov_y_degrees)));
    view.camera.position = target + radius / std::sin(angle) *
                                        glm::normalize(view.camera.position - view.camera.target);
    view.camera.target = target;
    view.anti_aliasing = anti_aliasing;
    time_frames(run, renderer, view, kSize, [] {});
}
BENCHMARK_CAPTURE(frame_quarter, plain, AntiAliasing::None)
    ->Name("frame/quarter/1280x720")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(frame_quarter, smoothed, AntiAliasing::Fast)
    ->Name("frame/quarter-smoothed/1280x720")
    ->Unit(benchmark::kMillisecond);

void frame_bare(benchmark::State& run) {
    const gl::HeadlessContext context = headless();
    const ScenePtr scene = shader_ball_scene();
    RendererState state(value_or_exit(resource_folder("shaders")),
                        value_or_exit(upload_ground_shadow({.side = 1, .hidden = {HiddenSky{}}})));
    state.scene = upload_scene(scene);
    state.environment = value_or_exit(
        upload_environment(value_or_exit(filter_environment(studio_map(), FilterQuality::First))));
    const glm::ivec2 size(kSize.width, kSize.height);
    const gl::Framebuffer* picture = value_or_exit(state.picture.at(size));
    const gl::Framebuffer* smoothed = value_or_exit(state.smoothed.at(size));
    View view = view_of(state.scene->bounds_world);
    const auto draw = [&] {
        view.camera = orbited(view.camera, 1.0f, 0.0f);
        const bool drawn =
            draw_frame(state, view, size, {.framebuffer = picture}) &&
            draw_smoothed(state, *picture, *smoothed, surface_areas(state, view, size));
        glFinish();
        return drawn;
    };
    if (!draw()) return run.SkipWithError("a pass failed");
    for (auto _ : run)
        if (!draw()) return run.SkipWithError("a pass failed");
}
BENCHMARK(frame_bare)->Name("frame/bare/1280x720")->Unit(benchmark::kMillisecond);

/// Points all around the model, which together are as bright as one.
std::vector<Light> ring_of_lights(const Bounds& bounds, int count) {
    std::vector<Light> lights;
    for (int i = 0; i < count; ++i) {
        const float turn = 2.399963f * static_cast<float>(i);  // the golden angle
        const glm::vec3 offset(std::cos(turn), 1.0f, std::sin(turn));
        lights.push_back({.kind = Light::Kind::Point,
                          .name = "point",
                          .intensity = 4.0f / static_cast<float>(count),
                          .position_world = bounds.center() + 2.0f * bounds.radius() * offset});
    }
    return lights;
}

/// A model under many lamps, by way of the G-buffer or lit as it is drawn.
void lights(benchmark::State& run, RenderPath path) {
    const gl::HeadlessContext context = headless();
    Renderer renderer = ready_renderer();
    View view = view_of(renderer.bounds_world());
    view.left.path = path;
    view.lights = ring_of_lights(renderer.bounds_world(), static_cast<int>(run.range(0)));
    time_frames(run, renderer, view, {kSize.width / 2, kSize.height / 2}, [] {});
}
BENCHMARK_CAPTURE(lights, deferred, RenderPath::Deferred)
    ->Name("lights/deferred/640x360")
    ->RangeMultiplier(4)
    ->Range(1, kMaxLights)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(lights, forward, RenderPath::Forward)
    ->Name("lights/forward/640x360")
    ->RangeMultiplier(4)
    ->Range(1, kMaxLights)
    ->Unit(benchmark::kMillisecond);

/// A model whose lamps cast shadows: drawn once and kept (`shadows/kept`), as while the camera
/// moves, or drawn anew in every frame (`shadows/moving`), as while a lamp moves.
void shadows(benchmark::State& run, bool cast, float lamp_step) {
    const gl::HeadlessContext context = headless();
    Renderer renderer = ready_renderer();
    View view = view_of(renderer.bounds_world());
    view.shadows = cast;
    view.lights = ring_of_lights(renderer.bounds_world(), 2);
    time_frames(run, renderer, view, kSize, [&] {
        for (Light& light : view.lights) light.position_world.y += lamp_step;
    });
}
BENCHMARK_CAPTURE(shadows, none, false, 0.0f)
    ->Name("shadows/none/1280x720")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(shadows, kept, true, 0.0f)
    ->Name("shadows/kept/1280x720")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(shadows, moving, true, 1e-5f)
    ->Name("shadows/moving/1280x720")
    ->Unit(benchmark::kMillisecond);

void filter(benchmark::State& run, FilterQuality quality) {
    for (auto _ : run)
        benchmark::DoNotOptimize(value_or_exit(filter_environment(studio_map(), quality)));
}
BENCHMARK_CAPTURE(filter, first, FilterQuality::First)
    ->Name("ibl/first")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(filter, finished, FilterQuality::Finished)
    ->Name("ibl/finished")
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace patina::render
