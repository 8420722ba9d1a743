// SPDX-License-Identifier: MIT
#include "editor/session/material_ball.h"

#include "render/environment.h"
#include "scene/shapes.h"

namespace patina::editor {
namespace {

constexpr int kSamples = 4;

ScenePtr ball_scene() {
    auto scene = std::make_shared<Scene>();
    scene->meshes.push_back(shape_mesh(Shape::Sphere));
    scene->instances.push_back({.name = "Ball"});
    for (const Primitive& primitive : scene->meshes.front().primitives)
        for (const glm::vec3& position : primitive.positions) scene->bounds_world.include(position);
    return scene;
}

render::View ball_view(const Bounds& bounds) {
    render::View view;
    view.camera = render::framed(bounds, 1.0f, render::ViewDirection::ThreeQuarter, 20.0f);
    // The ball fills its picture: a frame around the box would leave a broad rim.
    view.camera.orthographic_height = 1.02f * (bounds.high.y - bounds.low.y);
    view.background.kind = render::Background::Kind::Transparent;
    view.ground_shadow = false;
    view.anti_aliasing = render::AntiAliasing::None;
    return view;
}

}  // namespace

UvSurfacePtr ball_surface() {
    static const UvSurfacePtr surface = [] {
        const ScenePtr scene = ball_scene();
        std::vector<SurfacePart> parts;
        for (const Primitive& primitive : scene->meshes.front().primitives)
            parts.push_back({.primitive = &primitive});
        return std::make_shared<const UvSurface>(scene, std::move(parts), 0);
    }();
    return surface;
}

Result<MaterialBall> MaterialBall::create() {
    Result<render::Renderer> renderer = render::Renderer::create();
    if (!renderer) return passed_on(renderer);
    const ScenePtr scene = ball_scene();
    if (const Status set = renderer->set_scene(scene); !set) return passed_on(set);
    const Result<Image> studio = render::builtin_environment("studio");
    if (!studio) return passed_on(studio);
    const auto light = render::filter_environment(*studio, render::FilterQuality::First);
    if (!light) return passed_on(light);
    if (const Status set = renderer->set_environment(*light); !set) return passed_on(set);
    return MaterialBall(std::move(*renderer), ball_view(scene->bounds_world));
}

Result<Image> MaterialBall::picture(const render::SurfaceMaterial& surface, int side) {
    if (const Status set = renderer_.set_material(0, surface); !set) return passed_on(set);
    return renderer_.still_srgb(view_, {side, side}, kSamples);
}

}  // namespace patina::editor
