// SPDX-License-Identifier: MIT
#include "render/offscreen.h"

#include <algorithm>
#include <chrono>

#include "composite/composite.h"
#include "core/log.h"
#include "document/parts.h"
#include "gl/headless_context.h"

namespace patina::render {
namespace {

/// A still needs no cache of what lies below an edited layer.
constexpr std::size_t kNoCacheBytes = 0;

double elapsed_ms(std::chrono::steady_clock::time_point since) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - since)
        .count();
}

Result<SurfaceMaterial> composited_surface(const Document& document, const Material& material,
                                           ImageProvider& images, const Progress& progress) {
    const Program program = Program::compile(document, material);
    if (baked_maps_of(program.slots()).empty())
        return surface_of(material, program.slots(), {}, images);
    LiveComposite composite(kNoCacheBytes);
    const Result<LiveComposite::Update> update =
        composite.update(program, images, material.resolution, progress);
    if (!update) return passed_on(update);
    return surface_of(material, program.slots(), composite.maps(), images);
}

Status set_materials(Renderer& renderer, const Document& document, ImageProvider& images,
                     const Progress& progress) {
    progress.set_stage("Compositing materials");
    for (std::size_t i = 0; i < document.materials.size(); ++i) {
        const Material& material = *document.materials[i];
        const Result<SurfaceMaterial> surface =
            composited_surface(document, material, images, progress);
        if (!surface) return passed_on(surface);
        if (Status done = renderer.set_material(material.source_material.value_or(-1), *surface);
            !done)
            return done;
        progress.report(0.5f * static_cast<float>(i + 1) /
                        static_cast<float>(document.materials.size()));
    }
    return {};
}

Result<Image> builtin_or_studio(const EnvironmentSettings& environment) {
    if (is_builtin_environment(environment.name))
        return builtin_environment(environment.name, kBuiltinHeight,
                                   environment.sun_elevation_degrees);
    log_warning("environment \"{}\" is not built in and no map was given; the studio is used",
                quoted_for_message(environment.name));
    return builtin_environment(kBuiltinEnvironments.front().id);
}

Status set_environment(Renderer& renderer, const Document& document,
                       const OffscreenRequest& request, const Progress& progress) {
    progress.set_stage("Filtering the environment");
    ImagePtr map = request.environment;
    if (!map) {
        Result<Image> builtin = builtin_or_studio(document.environment);
        if (!builtin) return passed_on(builtin);
        map = std::make_shared<const Image>(std::move(*builtin));
    }
    const Result<FilteredEnvironment> filtered =
        finished_environment(request.environment_cache, *map);
    if (!filtered) return passed_on(filtered);
    return renderer.set_environment(*filtered);
}

Camera automatic_camera(const OffscreenRequest& request, const Bounds& bounds) {
    const float aspect = static_cast<float>(request.size.width) /
                         static_cast<float>(std::max(1, request.size.height));
    const bool halves = request.view.compare == CompareMode::TwoViews;
    const float side_aspect = halves ? 0.5f * aspect : aspect;
    const Camera& asked = request.view.camera;
    Camera camera = framed(bounds, side_aspect, *request.automatic_camera, asked.fov_y_degrees);
    camera.up = asked.up;
    if (request.automatic_target) {
        camera.position += *request.automatic_target - camera.target;
        camera.target = *request.automatic_target;
    }
    camera = framed_around(camera, bounds, side_aspect);
    camera.orthographic_height = asked.orthographic_height;
    return camera;
}

View view_of(const Document& document, const OffscreenRequest& request, const Bounds& bounds) {
    View view = request.view;
    view.lights.insert(view.lights.end(), document.lights.begin(), document.lights.end());
    view.environment_rotation_degrees += document.environment.rotation_degrees;
    view.environment_intensity *= document.environment.intensity;
    if (request.automatic_camera) view.camera = automatic_camera(request, bounds);
    return view;
}

/// A renderer that has all of the document, in the context that is current.
Result<Renderer> prepared(const Document& document, ImageProvider& images,
                          const OffscreenRequest& request, const Progress& progress,
                          RenderedImage& result) {
    Result<Renderer> renderer = Renderer::create();
    if (!renderer) return renderer;
    if (!document.scene) return failure("the document has no scene to render");
    if (Status done = renderer->set_scene(document.scene); !done) return passed_on(done);
    renderer->assign_materials(assigned_numbers(document));
    const auto bake_start = std::chrono::steady_clock::now();
    if (Status done = set_materials(*renderer, document, images, progress); !done)
        return passed_on(done);
    result.bake_ms = elapsed_ms(bake_start);
    const auto environment_start = std::chrono::steady_clock::now();
    if (Status done = set_environment(*renderer, document, request, progress); !done)
        return passed_on(done);
    result.environment_ms = elapsed_ms(environment_start);
    progress.report(0.75f);
    return renderer;
}

Result<gl::HeadlessContext> context_that_logs() {
    return gl::HeadlessContext::make(
        [](std::string_view message) { log_warning("OpenGL: {}", message); });
}

Result<Image> still_of(Renderer& renderer, const View& view, const OffscreenRequest& request) {
    if (request.linear) return renderer.still_linear(view, request.size, request.samples);
    Result<Image> still =
        renderer.still_srgb(view, request.size, request.samples, request.sample_type);
    if (still && view.wires)
        if (Status laid = renderer.lay_wires(view, *still); !laid) return passed_on(laid);
    return still;
}

/// Pictures of one scene in one light.
struct Series {
    int count = 1;
    std::function<View(const View& first, int index)> view;
};

Status render_series(const Document& document, ImageProvider& images,
                     const OffscreenRequest& request, const Series& series, const EachPicture& each,
                     const Progress& progress) {
    const Result<gl::HeadlessContext> context = context_that_logs();
    if (!context) return passed_on(context);
    RenderedImage result;
    Result<Renderer> renderer = prepared(document, images, request, progress, result);
    if (!renderer) return passed_on(renderer);
    progress.set_stage("Rendering");
    const View first = view_of(document, request, renderer->bounds_world());
    if (request.costs_wanted && request.samples == 1)
        if (const auto warmed = still_of(*renderer, series.view(first, 0), request); !warmed)
            return passed_on(warmed);
    for (int i = 0; i < series.count; ++i) {
        const View view = series.view(first, i);
        const auto start = std::chrono::steady_clock::now();
        Result<Image> image = still_of(*renderer, view, request);
        if (!image) return passed_on(image);
        result.image = std::move(*image);
        result.render_ms = elapsed_ms(start);
        result.stats = renderer->stats();
        if (Status done = each(i, result); !done) return done;
        progress.report(0.75f +
                        0.25f * static_cast<float>(i + 1) / static_cast<float>(series.count));
    }
    return {};
}

}  // namespace

Status render_turntable_offscreen(const Document& document, ImageProvider& images,
                                  const OffscreenRequest& request, int pictures,
                                  const EachPicture& each, const Progress& progress) {
    const auto turned_view = [pictures](const View& first, int i) {
        View view = first;
        if (i == 0) return view;
        view.camera =
            turned(first.camera, 360.0f * static_cast<float>(i) / static_cast<float>(pictures));
        return view;
    };
    return render_series(document, images, request, {pictures, turned_view}, each, progress);
}

Status render_channels_offscreen(const Document& document, ImageProvider& images,
                                 const OffscreenRequest& request,
                                 std::span<const ChannelView> channels, const EachPicture& each,
                                 const Progress& progress) {
    const auto shown = [channels](const View& first, int i) {
        View view = first;
        view.channel = channels[static_cast<std::size_t>(i)];
        return view;
    };
    return render_series(document, images, request, {static_cast<int>(channels.size()), shown},
                         each, progress);
}

}  // namespace patina::render
