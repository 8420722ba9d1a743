// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "editor/panels/viewport/parts.h"
#include "editor/widgets/popup_menu.h"
#include "editor/widgets/slider.h"

namespace patina::editor {
namespace {

constexpr float kMenuWidth = 216.0f;

/// As photographers think of it: the focal length on a frame 24 mm high.
double focal_length_mm(double fov_y_degrees) {
    return 12.0 / std::tan(glm::radians(0.5 * fov_y_degrees));
}

void fov_field(Ui& ui, const Rect& rect, render::Camera& camera) {
    const bool orthographic = camera.orthographic_height > 0.0f;
    const std::string tip = fmt::format(
        "Angle from the bottom to the top of the view, 5 to 120\u00b0; now a lens of {:.0f} mm. "
        "The model stays as large as it is",
        focal_length_mm(static_cast<double>(camera.fov_y_degrees)));
    const auto changed = number_field(ui, rect,
                                      {.label = "Field of view",
                                       .shown_label = "Field of view",
                                       .minimum = 5.0,
                                       .maximum = 120.0,
                                       .standard = 30.0,
                                       .step = 1.0,
                                       .decimals = 1,
                                       .unit = "\u00b0",
                                       .tooltip = tip,
                                       .enabled = !orthographic},
                                      static_cast<double>(camera.fov_y_degrees));
    if (changed) camera = render::with_fov(camera, static_cast<float>(*changed));
}

/// More than these would leave the window.
constexpr std::size_t kMostCameras = 12;

/// Goes to where a camera of the file stands.
void file_cameras(PopupMenu& menu, const Scene& scene, render::Camera& camera) {
    if (scene.cameras.empty()) return;
    menu.heading("Cameras of the file");
    for (std::size_t i = 0; i < std::min(scene.cameras.size(), kMostCameras); ++i) {
        const SceneCamera& of_file = scene.cameras[i];
        const std::string name = of_file.name.empty() ? fmt::format("Camera {}", i)
                                                      : quoted_for_message(of_file.name, 40);
        if (menu.item({.label = name, .tooltip = "Looks as this camera of the file does"}))
            camera = render::camera_of(of_file, scene.bounds_world);
    }
}

}  // namespace

Requests draw_camera_menu(Ui& ui, const Rect& anchor, const Shown& shown, render::Camera& camera) {
    Requests requests;
    // At the left of the tools, with its right end there however wide it turns out.
    ImGui::SetNextWindowPos(ImVec2(anchor.x0 - ui.px(6), anchor.y0), ImGuiCond_Always,
                            ImVec2(1.0f, 0.0f));
    PopupMenu menu(ui, "camera menu", kMenuWidth);
    if (!menu.open()) return requests;
    for (const ActionInfo& row : actions()) {
        if (row.menu != Menu::Camera) continue;
        if (row.separator_before) menu.separator();
        const bool ticked = row.action == Action::Orthographic && camera.orthographic_height > 0.0f;
        if (menu.item({.label = row.label,
                       .key = row.key,
                       .enabled = applies(row.action, shown),
                       .ticked = ticked}))
            requests.ask(row.action);
    }
    fov_field(ui, menu.field_row(), camera);
    if (shown.document != nullptr) file_cameras(menu, *shown.document->scene, camera);
    return requests;
}

}  // namespace patina::editor
