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

/// Waits for every image that a program reads. One that cannot be decoded is shown as a
/// placeholder by the composite, which also says so in the log.
void await_images(const Program& program, ImageProvider& images) {
    for (const Hash128& image : program.images()) (void)images.pixels(image);
}

Result<SurfaceMaterial> composited_surface(const Document& document, const Material& material,
                                           ImageProvider& images, int max_map_size,
                                           const Progress& progress) {
    const Program program = Program::compile(document, material);
    if (baked_maps_of(program.slots()).empty())
        return surface_of(material, program.slots(), {}, images);
    await_images(program, images);
    LiveComposite composite(kNoCacheBytes);
    const Result<LiveComposite::Update> update =
        composite.update(program, images, std::min(material.resolution, max_map_size), progress);
    if (!update) return passed_on(update);
    return surface_of(material, program.slots(), composite.maps(), images);
}

Status set_materials(Renderer& renderer, const Document& document, ImageProvider& images,
                     const OffscreenRequest& request, const Progress& progress) {
    progress.set_stage("Compositing materials");
    for (std::size_t i = 0; i < document.materials.size(); ++i) {
        const Material& material = *document.materials[i];
        const Result<SurfaceMaterial> surface =
            composited_surface(document, material, images, request.max_map_size, progress);
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

View view_of(const Document& document, const OffscreenRequest& request, const Bounds& bounds) {
    View view = request.view;
    view.lights.insert(view.lights.end(), document.lights.begin(), document.lights.end());
    view.environment_rotation_degrees += document.environment.rotation_degrees;
    view.environment_intensity *= document.environment.intensity;
    if (request.automatic_camera) {
        const float aspect = static_cast<float>(request.size.width) /
                             static_cast<float>(std::max(1, request.size.height));
        const bool halves = view.compare == CompareMode::TwoViews;
        const float orthographic_height = view.camera.orthographic_height;
        view.camera = framed(bounds, halves ? 0.5f * aspect : aspect, *request.automatic_camera,
                             view.camera.fov_y_degrees);
        view.camera.orthographic_height = orthographic_height;
    }
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
    if (Status done = set_materials(*renderer, document, images, request, progress); !done)
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

}  // namespace

Result<RenderedImage> render_offscreen(const Document& document, ImageProvider& images,
                                       const OffscreenRequest& request, const Progress& progress) {
    RenderedImage result;
    const auto keep = [&result](int, RenderedImage& picture) -> Status {
        result = std::move(picture);
        return {};
    };
    if (Status drawn = render_turntable_offscreen(document, images, request, 1, keep, progress);
        !drawn)
        return passed_on(drawn);
    return result;
}

Status render_turntable_offscreen(const Document& document, ImageProvider& images,
                                  const OffscreenRequest& request, int pictures,
                                  const EachPicture& each, const Progress& progress) {
    const Result<gl::HeadlessContext> context = context_that_logs();
    if (!context) return passed_on(context);
    RenderedImage result;
    Result<Renderer> renderer = prepared(document, images, request, progress, result);
    if (!renderer) return passed_on(renderer);
    progress.set_stage("Rendering");
    View view = view_of(document, request, renderer->bounds_world());
    const Camera first = view.camera;
    for (int i = 0; i < pictures; ++i) {
        if (i > 0)
            view.camera =
                turned(first, 360.0f * static_cast<float>(i) / static_cast<float>(pictures));
        const auto start = std::chrono::steady_clock::now();
        Result<Image> image =
            request.linear
                ? renderer->still_linear(view, request.size, request.samples)
                : renderer->still_srgb(view, request.size, request.samples, request.sample_type);
        if (!image) return passed_on(image);
        result.image = std::move(*image);
        result.render_ms = elapsed_ms(start);
        result.stats = renderer->stats();
        if (Status done = each(i, result); !done) return done;
        progress.report(0.75f + 0.25f * static_cast<float>(i + 1) / static_cast<float>(pictures));
    }
    return {};
}

Result<RenderedImage> render_strip_offscreen(const Document& document, ImageProvider& images,
                                             const OffscreenRequest& request, PictureSize thumbnail,
                                             const Progress& progress) {
    const Result<gl::HeadlessContext> context = context_that_logs();
    if (!context) return passed_on(context);
    RenderedImage result;
    Result<Renderer> renderer = prepared(document, images, request, progress, result);
    if (!renderer) return passed_on(renderer);
    OffscreenRequest thumbnail_request = request;
    thumbnail_request.size = thumbnail;
    const View view = view_of(document, thumbnail_request, renderer->bounds_world());
    const auto start = std::chrono::steady_clock::now();
    if (Status done = renderer->draw_strip(view, thumbnail); !done) return passed_on(done);
    Result<Image> image = renderer->read_strip();
    if (!image) return passed_on(image);
    result.image = std::move(*image);
    result.render_ms = elapsed_ms(start);
    progress.report(1.0f);
    return result;
}

}  // namespace patina::render
