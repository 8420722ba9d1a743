// SPDX-License-Identifier: MIT
#include "cli/render_options.h"

#include <array>

#include "core/hex_color.h"
#include "core/stored_values.h"
#include "render/environment.h"

namespace patina::cli {
namespace {

/// What --shading names: one model, or two against each other.
struct PictureKind {
    std::string_view id;
    render::CompareMode compare;
    render::ShadingModel left;
};
constexpr std::array kPictureKinds = {
    PictureKind{"pbr", render::CompareMode::Single, render::ShadingModel::Pbr},
    PictureKind{"phong", render::CompareMode::Single, render::ShadingModel::Phong},
    PictureKind{"blinn-phong", render::CompareMode::Single, render::ShadingModel::BlinnPhong},
    PictureKind{"split", render::CompareMode::Split, render::ShadingModel::Pbr},
    PictureKind{"two-views", render::CompareMode::TwoViews, render::ShadingModel::Pbr},
    PictureKind{"difference", render::CompareMode::Difference, render::ShadingModel::Pbr},
};

struct TermSet {
    std::string_view id;
    render::PbrTerms terms;
};
constexpr std::array kTermSets = {TermSet{"gltf", {}}, TermSet{"lecture", render::kLectureTerms}};

void add_picture_options(CLI::App& command, RenderOptions& options) {
    render::View& view = options.request.view;
    add_size_option(command, "--size", options.request.size.width, options.request.size.height,
                    "Size of the picture, or of each channel where several are shown");
    command
        .add_option("--samples", options.request.samples,
                    "Samples that are averaged; from 64 on the environment is sampled too")
        ->check(CLI::Range(1, 65536))
        ->type_name("N")
        ->capture_default_str();
    command
        .add_option_function<int>(
            "--bits",
            [&options](int bits) {
                options.request.sample_type = bits == 16 ? SampleType::U16 : SampleType::U8;
            },
            "Of each number of a .png or .tif")
        ->check(CLI::IsMember({8, 16}))
        ->type_name("8|16")
        ->default_str("8");
    command.add_option("--exposure", view.exposure_ev, "Exposure; light is multiplied by 2^EV")
        ->check(CLI::Range(-20.0, 20.0))
        ->type_name("EV")
        ->capture_default_str();
    add_choice_option(
        command, "--tone-map", render::kToneMaps,
        [&view](const auto& entry) { view.tone_map = entry.value; }, "How light becomes colour")
        ->default_str("pbr-neutral");
    command.add_flag("--wires", view.wires, "Draw the edges of the triangles over the picture");
}

/// Terms by themselves, which go over those of --terms.
void add_term_options(CLI::App& command, RenderOptions& options) {
    using render::PbrTerms;
    const auto add = [&]<typename Table, typename Term>(const std::string& flag, const Table& table,
                                                        Term PbrTerms::*term,
                                                        const std::string& help) {
        add_choice_option(
            command, flag, table,
            [&options, term](const auto& entry) {
                options.term_changes.push_back(
                    [term, value = entry.value](PbrTerms& terms) { terms.*term = value; });
            },
            help);
    };
    add("--distribution", render::kDistributionTerms, &PbrTerms::distribution, "D of PBR");
    add("--geometry", render::kGeometryTerms, &PbrTerms::geometry, "G of PBR");
    add("--fresnel", render::kFresnelTerms, &PbrTerms::fresnel, "F of PBR");
    add("--diffuse", render::kDiffuseTerms, &PbrTerms::diffuse, "The diffuse term of PBR");
    command.add_flag_callback(
        "--multiple-scattering",
        [&options] {
            options.term_changes.push_back(
                [](PbrTerms& terms) { terms.multiple_scattering = true; });
        },
        "Give back the energy that single scattering loses");
}

/// What the traditional models would take from the material; both sides, where both are such.
void add_phong_options(CLI::App& command, RenderOptions& options) {
    render::View& view = options.request.view;
    const auto set = [&view](const auto& change) {
        change(view.left.phong);
        change(view.right.phong);
    };
    command
        .add_option_function<float>(
            "--phong-exponent",
            [set](float exponent) {
                set([exponent](render::PhongSettings& phong) { phong.exponent = exponent; });
            },
            "Specular power of the traditional models; from roughness if unset")
        ->check(CLI::Range(render::kLeastPhongExponent, render::kMostPhongExponent))
        ->type_name("E");
    const auto add_color = [&](const std::string& flag,
                               std::optional<glm::vec3> render::PhongSettings::*color,
                               const std::string& help) {
        const auto choose = [set, flag, color](const std::string& text) {
            const auto rgb = rgb_from_html(text);
            if (!rgb)
                throw CLI::ValidationError(flag,
                                           fmt::format("'{}' is no colour such as #ff8000", text));
            set([&](render::PhongSettings& phong) { phong.*color = linear_of_rgb(*rgb); });
        };
        command.add_option_function<std::string>(flag, choose, help)->type_name("#rrggbb");
    };
    add_color("--phong-specular", &render::PhongSettings::specular_color_linear,
              "Their specular colour; from the material if unset");
    add_color("--phong-ambient", &render::PhongSettings::ambient_linear,
              "Their ambient light; the mean of the environment if unset");
    command
        .add_option_function<float>(
            "--phong-strength",
            [set](float strength) {
                set([strength](render::PhongSettings& phong) {
                    phong.specular_strength = strength;
                });
            },
            "Times their specular colour")
        ->check(CLI::Range(0.0f, render::kMostPhongStrength))
        ->type_name("X")
        ->default_str("1");
}

void add_shading_options(CLI::App& command, RenderOptions& options) {
    render::View& view = options.request.view;
    add_choice_option(
        command, "--shading", kPictureKinds,
        [&view](const PictureKind& kind) {
            view.compare = kind.compare;
            view.left.model = kind.left;
        },
        "How surfaces are lit; the last three compare --left with --against")
        ->default_str("pbr");
    command.add_option("--divider", view.divider, "Where the split is, of the width")
        ->check(CLI::Range(0.0, 1.0))
        ->type_name("0-1")
        ->capture_default_str();
    command
        .add_option_function<float>(
            "--split",
            [&view](float divider) {
                view.compare = render::CompareMode::Split;
                view.divider = divider;
            },
            "As --shading split --divider X")
        ->check(CLI::Range(0.0, 1.0))
        ->type_name("X");
    add_choice_option(
        command, "--path", render::kRenderPaths,
        [&view](const auto& entry) { view.left.path = view.right.path = entry.value; },
        "How the picture is made: the same shading, at another cost")
        ->default_str("deferred");
    add_choice_option(
        command, "--terms", kTermSets,
        [&view](const TermSet& set) { view.left.terms = view.right.terms = set.terms; },
        "The terms of PBR; the lecture's lack 1/pi and energy balance")
        ->default_str("gltf");
    add_term_options(command, options);
    add_phong_options(command, options);
}

/// What stands against what in a comparison.
void add_side_options(CLI::App& command, RenderOptions& options) {
    render::View& view = options.request.view;
    add_choice_option(
        command, "--left", render::kShadingModels,
        [&view](const auto& entry) { view.left.model = entry.value; },
        "How the left side of a comparison is lit")
        ->default_str("pbr");
    add_choice_option(
        command, "--against", render::kShadingModels,
        [&view](const auto& entry) { view.right.model = entry.value; }, "How the right side is lit")
        ->default_str("phong, or pbr with --against-terms");
    add_choice_option(
        command, "--against-terms", kTermSets,
        [&command, &options](const TermSet& set) {
            options.against_terms = set.terms;
            if (command.count("--against") == 0)
                options.request.view.right.model = render::ShadingModel::Pbr;
        },
        "The terms of its PBR; --terms and those by themselves are then the left side's alone");
    add_choice_option(
        command, "--against-path", render::kRenderPaths,
        [&options](const auto& entry) { options.against_path = entry.value; },
        "How the right side is made; as --path if unset");
}

void add_difference_options(CLI::App& command, RenderOptions& options) {
    command
        .add_option("--difference-range", options.request.view.difference_range,
                    "The difference of exposed luminance that is the top of the heat map")
        ->check(CLI::Range(1e-6, 1e6))
        ->type_name("X")
        ->capture_default_str();
}

/// What one word of --channel stands for.
std::vector<render::ChannelView> channels_named(const std::string& word) {
    const std::size_t count = word == "strip" ? render::kStripChannelCount
                              : word == "all" ? render::kChannelViews.size()
                                              : 0;
    std::vector<render::ChannelView> channels;
    for (std::size_t i = 0; i < count; ++i) channels.push_back(render::kChannelViews[i].view);
    if (const auto channel = render::channel_view_from_id(word)) channels.push_back(*channel);
    if (channels.empty())
        throw CLI::ValidationError("--channel", fmt::format("'{}' is no channel", word));
    return channels;
}

/// --channel takes ids of channels, "strip" for the editor's ten and "all".
void add_channel_options(CLI::App& command, RenderOptions& options) {
    std::string ids = "strip|all";
    for (const render::ChannelViewInfo& entry : render::kChannelViews)
        ids += fmt::format("|{}", entry.id);
    const auto choose = [&options](const std::vector<std::string>& words) {
        for (const std::string& word : words)
            for (const render::ChannelView channel : channels_named(word))
                options.channels.push_back(channel);
        options.request.view.channel = options.channels.front();
    };
    command
        .add_option_function<std::vector<std::string>>(
            "--channel", choose,
            "One channel, or several with commas between them: those in one picture, each with\n"
            "its name, up to ten in a row; strip is the first ten")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name(ids)
        ->default_str("final");
    command.add_option("--columns", options.columns, "Channels in a row of that picture")
        ->check(CLI::Range(1, render::kChannelViewCount))
        ->type_name("N");
    add_off_flag(command, "--no-labels", options.labels,
                 "Write nothing on pictures: no names of channels, no scale of a difference");
}

void add_light_options(CLI::App& command, RenderOptions& options) {
    render::View& view = options.request.view;
    std::string names;
    for (const render::BuiltinEnvironment& entry : render::kBuiltinEnvironments)
        names += fmt::format("{}|", entry.id);
    command
        .add_option(
            "--environment", options.environment,
            "An equirectangular .hdr or .exr file, or a built-in; as the file says if unset")
        ->type_name(names + "FILE");
    command
        .add_option("--environment-rotation", view.environment_rotation_degrees,
                    "Turn it about +Y, counter-clockwise from above")
        ->type_name("DEG")
        ->capture_default_str();
    command
        .add_option("--sun-elevation", options.sun_elevation_degrees,
                    "How high the sun of the built-in sky stands above the horizon")
        ->check(CLI::Range(0.0, 90.0))
        ->type_name("DEG");
    command
        .add_option("--environment-intensity", view.environment_intensity,
                    "Multiply its light by this")
        ->check(CLI::Range(0.0, 100.0))
        ->type_name("X")
        ->capture_default_str();
    add_off_flag(command, "--no-normal-filter", view.filter_normals,
                 "Leave out of roughness what of normal maps is finer than a pixel; from 64 "
                 "samples on it is left out anyway");
    add_off_flag(command, "--no-reflection-occlusion", view.occlude_reflections,
                 "Hold mirrored light back by the occlusion map as much as diffuse light, and "
                 "mirror what lies below the surface");
    add_off_flag(command, "--no-ground-shadow", view.ground_shadow,
                 "Leave the floor or ground of the background without the model's shadow");
    add_off_flag(command, "--no-shadows", view.shadows,
                 "Let suns of the environment, the strongest lamps and the light of the "
                 "traditional models cast none");
}

void add_background_option(CLI::App& command, RenderOptions& options) {
    const auto choose = [&options](const std::string& text) {
        if (const auto rgb = rgb_from_html(text)) {
            options.background = {.kind = render::Background::Kind::Color,
                                  .color_srgb = {unit_value((*rgb)[0]), unit_value((*rgb)[1]),
                                                 unit_value((*rgb)[2])}};
            return;
        }
        const auto* choice = render::choice_from_id(render::kBackgrounds, text);
        if (choice == nullptr || choice->value == render::Background::Kind::Color)
            throw CLI::ValidationError("--background", fmt::format("'{}' is no background", text));
        options.background = {.kind = choice->value};
    };
    command
        .add_option_function<std::string>(
            "--background", choose,
            "What is behind the model. The studio's backdrop and a colour are as on a screen, no\n"
            "light of the scene, so that an .exr has them only where they are asked for")
        ->type_name("studio|environment|blurred|none|#rrggbb")
        ->default_str("studio, or none in an .exr");
}

void add_projection_options(CLI::App& command, RenderOptions& options) {
    auto* fov =
        command.add_option("--fov-y", options.fov_y_degrees, "Field of view from top to bottom")
            ->check(CLI::Range(1.0, 160.0))
            ->type_name("DEG")
            ->default_str("30, or as --camera has it");
    command
        .add_option("--orthographic", options.orthographic_height,
                    "No perspective: metres from the bottom of the picture to its top")
        ->check(CLI::PositiveNumber)
        ->type_name("HEIGHT")
        ->excludes(fov);
}

void add_camera_options(CLI::App& command, RenderOptions& options) {
    auto* camera = command
                       .add_option("--camera", options.camera,
                                   "A camera of the file, by its name or the number that 'patina "
                                   "info' lists it with")
                       ->type_name("NAME");
    auto* position = add_vector_option(command, "--camera-position", options.camera_position,
                                       "Where the camera stands; it frames the scene if unset")
                         ->excludes(camera);
    add_vector_option(command, "--camera-target", options.camera_target,
                      "What it looks at; the middle of the scene if unset")
        ->excludes(camera);
    add_vector_option(command, "--camera-up", options.camera_up, "What is up in the picture")
        ->default_str("0,1,0")
        ->excludes(camera);
    add_projection_options(command, options);
    command
        .add_option("--turntable", options.turntable,
                    "So many pictures all around the target: OUT-000.png, OUT-001.png ...")
        ->check(CLI::Range(1, 999))
        ->type_name("N");
    add_choice_option(
        command, "--view", render::kViewDirections,
        [&options](const auto& entry) { options.request.automatic_camera = entry.value; },
        "From where the scene is framed")
        ->default_str("three-quarter")
        ->excludes(position)
        ->excludes(camera);
}

}  // namespace

void add_view_options(CLI::App& command, RenderOptions& options) {
    add_picture_options(command, options);
    add_shading_options(command, options);
    add_side_options(command, options);
    add_difference_options(command, options);
    add_channel_options(command, options);
    add_light_options(command, options);
    add_background_option(command, options);
    add_camera_options(command, options);
}

}  // namespace patina::cli
