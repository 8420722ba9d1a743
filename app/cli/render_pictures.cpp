// SPDX-License-Identifier: MIT
#include "cli/render_pictures.h"

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "cli/difference_scale.h"
#include "cli/input.h"
#include "cli/render_camera.h"
#include "core/log.h"
#include "io/image_decode.h"
#include "io/image_file.h"
#include "render/environment.h"

namespace patina::cli {
namespace {

/// A row or two over is how some programs write them.
void warn_unless_equirectangular(const std::string& name, const Image& map) {
    if (std::abs(map.width - 2 * map.height) <= map.height / 50) return;
    log_warning(
        "{} is {}x{}, not twice as wide as high: it is read as an equirectangular map all "
        "the same, its light is stretched",
        quoted_for_message(name), map.width, map.height);
}

Result<ImagePtr> environment_map(const std::filesystem::path& path) {
    const auto bytes = read_file(path);
    if (!bytes) return passed_on(bytes);
    auto map = io::decode_image(*bytes, path.string());
    if (!map) return failure("{}: {}", quoted_for_message(path.string()), map.error().message);
    warn_unless_equirectangular(path.string(), **map);
    return map;
}

/// Puts the environment that was asked for into the document or the request.
Status set_environment(const RenderOptions& options, io::LoadedDocument& loaded,
                       render::OffscreenRequest& request) {
    Document document = *loaded.document;
    std::string& name = document.environment.name;
    if (render::is_builtin_environment(options.environment)) {
        name = options.environment;
    } else if (!options.environment.empty()) {
        const auto map = environment_map(options.environment);
        if (!map) return passed_on(map);
        request.environment = *map;
    } else if (!render::is_builtin_environment(name)) {
        // A file may not make this program read another one.
        log_warning("{} was lit by '{}': give it with --environment; the studio is used",
                    quoted_for_message(options.input.string()), quoted_for_message(name));
        name = render::kBuiltinEnvironments.front().id;
    }
    if (options.sun_elevation_degrees) {
        if (request.environment || name != render::kSkyEnvironment)
            return failure("--sun-elevation moves the sun of the sky: add --environment {}",
                           render::kSkyEnvironment);
        document.environment.sun_elevation_degrees = *options.sun_elevation_degrees;
    }
    loaded.document = std::make_shared<const Document>(std::move(document));
    return {};
}

/// Linear radiance has no place for a backdrop that is painted for a screen.
render::Background default_background(const render::OffscreenRequest& request) {
    using Kind = render::Background::Kind;
    return {.kind = request.linear ? Kind::Transparent : Kind::Studio};
}

/// Terms by themselves go over those of a set; a set of the right side's own stays as it is.
void set_sides(const RenderOptions& options, render::View& view) {
    for (const auto& change : options.term_changes) {
        change(view.left.terms);
        change(view.right.terms);
    }
    if (options.against_terms) view.right.terms = *options.against_terms;
    if (options.against_path) view.right.path = *options.against_path;
}

/// Letters that are read easily in a picture of this height.
int em_pixels_for(int height) {
    return std::clamp(height / 24, 11, 30);
}

/// What writes on pictures; none where that was not asked for, or where there is no font.
std::optional<Lettering> lettering_for(const RenderOptions& options) {
    if (!options.labels) return std::nullopt;
    auto lettering = Lettering::make(em_pixels_for(options.request.size.height));
    if (lettering) return std::move(*lettering);
    log_warning("{}; the picture has no words", lettering.error().message);
    return std::nullopt;
}

/// All channels in one picture, whose costs are those of the first.
Status draw_sheet(const RenderOptions& options, const ContactSheet& sheet,
                  const io::LoadedDocument& loaded, const render::OffscreenRequest& request,
                  const render::EachPicture& each, const Progress& progress) {
    auto image = sheet.blank(request.sample_type);
    if (!image) return passed_on(image);
    const std::optional<Lettering> lettering = lettering_for(options);
    render::RenderedImage whole;
    const auto put = [&](int index, const render::RenderedImage& picture) -> Status {
        put_cell(*image, sheet, index, picture.image, lettering ? &*lettering : nullptr);
        const double drawn_before_ms = whole.render_ms;
        if (index == 0) whole = picture;
        whole.render_ms = drawn_before_ms + picture.render_ms;
        return {};
    };
    if (const Status drawn = render::render_channels_offscreen(
            *loaded.document, *loaded.images, request, sheet.channels, put, progress);
        !drawn)
        return drawn;
    whole.image = std::move(*image);
    return each(0, whole);
}

/// Hands on pictures of a difference with what their heat stands for.
render::EachPicture with_scale(const RenderOptions& options, const render::EachPicture& each) {
    return [&options, &each,
            lettering = std::make_shared<std::optional<Lettering>>(lettering_for(options))](
               int index, render::RenderedImage& drawn) {
        if (*lettering)
            draw_difference_scale(drawn.image, options.request.view.difference_range, **lettering);
        return each(index, drawn);
    };
}

}  // namespace

bool is_heat_map(const RenderOptions& options) {
    return options.request.view.compare == render::CompareMode::Difference;
}

std::optional<ContactSheet> sheet_of(const RenderOptions& options) {
    if (options.channels.size() < 2) return std::nullopt;
    return ContactSheet{.channels = options.channels,
                        .cell = options.request.size,
                        .columns = options.columns.value_or(columns_for(options.channels.size()))};
}

Status draw_pictures(const RenderOptions& options, const render::EachPicture& each,
                     const Progress& progress) {
    auto loaded = changed_document(options.input, options.changes, options.work.quiet, progress);
    if (!loaded) return passed_on(loaded);
    render::OffscreenRequest request = options.request;
    request.costs_wanted = options.work.json;
    request.environment_cache = render::user_environment_cache();
    request.linear = io::image_format_of(options.output) == io::ImageFormat::Exr;
    request.view.background = options.background.value_or(default_background(request));
    if (const Status lit = set_environment(options, *loaded, request); !lit) return lit;
    if (const Status placed = set_camera(options, *loaded->document, request); !placed)
        return placed;
    set_sides(options, request.view);
    if (const auto sheet = sheet_of(options))
        return draw_sheet(options, *sheet, *loaded, request, each, progress);
    const bool scaled = is_heat_map(options) && !request.linear;
    return render::render_turntable_offscreen(*loaded->document, *loaded->images, request,
                                              options.turntable.value_or(1),
                                              scaled ? with_scale(options, each) : each, progress);
}

}  // namespace patina::cli
