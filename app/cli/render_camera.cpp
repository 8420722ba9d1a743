// SPDX-License-Identifier: MIT
#include "cli/render_camera.h"

#include <charconv>

namespace patina::cli {
namespace {

std::string listed(const std::vector<SceneCamera>& cameras) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < cameras.size(); ++i)
        names.push_back(fmt::format("{} '{}'", i, quoted_for_message(cameras[i].name, 60)));
    return fmt::format("{}", fmt::join(names, ", "));
}

/// The camera of that name, or else of that number.
Result<const SceneCamera*> file_camera(const Scene& scene, const std::string& name) {
    const SceneCamera* found = nullptr;
    for (const SceneCamera& camera : scene.cameras) {
        if (camera.name != name) continue;
        if (found != nullptr)
            return failure("--camera '{}' names several: give a number of {}",
                           quoted_for_message(name), listed(scene.cameras));
        found = &camera;
    }
    if (found != nullptr) return found;
    std::size_t index = 0;
    const char* end = name.data() + name.size();
    const auto [read_to, error] = std::from_chars(name.data(), end, index);
    if (error == std::errc() && read_to == end && index < scene.cameras.size())
        return &scene.cameras[index];
    if (scene.cameras.empty())
        return failure("--camera '{}' is none: the file has no cameras; see --view",
                       quoted_for_message(name));
    return failure("--camera '{}' is none of the file's: {}", quoted_for_message(name),
                   listed(scene.cameras));
}

void set_projection(const RenderOptions& options, render::Camera& camera) {
    if (options.fov_y_degrees) {
        camera.fov_y_degrees = *options.fov_y_degrees;
        camera.orthographic_height = 0.0f;
    }
    if (options.orthographic_height) camera.orthographic_height = *options.orthographic_height;
}

}  // namespace

Status set_camera(const RenderOptions& options, const Document& document,
                  render::OffscreenRequest& request) {
    render::Camera& camera = request.view.camera;
    const Bounds& bounds = document.scene->bounds_world;
    if (options.camera) {
        const auto found = file_camera(*document.scene, *options.camera);
        if (!found) return passed_on(found);
        camera = render::camera_of(**found, bounds);
    }
    set_projection(options, camera);
    if (options.camera_up) camera.up = *options.camera_up;
    if (options.camera_position) {
        camera.position = *options.camera_position;
        camera.target = options.camera_target.value_or(bounds.center());
    }
    request.automatic_target = options.camera_target;
    if (options.camera || options.camera_position) request.automatic_camera.reset();
    return {};
}

}  // namespace patina::cli
