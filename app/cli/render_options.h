// SPDX-License-Identifier: MIT
#pragma once

/// What `patina render` is asked for.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/arguments.h"
#include "cli/changes.h"
#include "render/offscreen.h"

namespace patina::cli {

struct RenderOptions {
    std::filesystem::path input;
    std::filesystem::path output;
    Changes changes;
    std::optional<float> sun_elevation_degrees;  ///< unset: as the document says
    std::string environment;  ///< a built-in name or a file; empty: as the document says
    std::optional<render::Background> background;
    std::optional<std::string> camera;  ///< of the file: its name or number
    std::optional<glm::vec3> camera_position;
    std::optional<glm::vec3> camera_target;
    std::optional<glm::vec3> camera_up;
    std::optional<float> fov_y_degrees;
    std::optional<float> orthographic_height;
    std::optional<render::RenderPath> against_path;
    std::optional<render::PbrTerms> against_terms;
    std::optional<int> turntable;
    std::vector<std::function<void(render::PbrTerms&)>> term_changes;
    std::vector<render::ChannelView> channels;  ///< two or more: in one picture
    std::optional<int> columns;                 ///< of such a picture
    bool labels = true;                         ///< words on pictures
    render::OffscreenRequest request;
    WorkOptions work;
};

/// Everything that says how the picture looks: shading, channel, light, background, camera.
void add_view_options(CLI::App& command, RenderOptions& options);

}  // namespace patina::cli
