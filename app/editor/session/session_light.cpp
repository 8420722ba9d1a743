// SPDX-License-Identifier: MIT

/// The light of the document: from its name to what the renderer holds.

#include "editor/session/session.h"
#include "render/environment_cache.h"

namespace patina::editor {

/// The finished light at once where it is kept from an earlier session; else the first light as
/// soon as there is one, and the finished one when it is done.
void Session::filter_environment(const EnvironmentSource& source, std::string label) {
    jobs_.cancel(finishing_light_);
    const int generation = ++environment_generation_;
    first_light_pending_ = true;
    jobs_.start("Filtering " + label,
                [this, source, generation](const Progress& progress) -> Jobs::Delivery {
                    const Result<ImagePtr> map = read_environment(source);
                    if (!map) return light_failure(map.error(), generation);
                    auto kept = render::kept_environment(render::user_environment_cache(), **map);
                    if (kept) return light_delivery(std::move(*kept), generation);
                    auto first =
                        render::filter_environment(**map, render::FilterQuality::First, progress);
                    if (!first) return light_failure(first.error(), generation);
                    return [this, first = std::make_shared<decltype(first)>(std::move(first)),
                            map = *map, generation] {
                        if (generation != environment_generation_) return;
                        first_light_pending_ = false;
                        picture_.set_environment(**first);
                        finish_environment(map, generation);
                    };
                });
}

void Session::finish_environment(const ImagePtr& map, int generation) {
    finishing_light_ =
        jobs_.start("Filtering the environment",
                    [this, map, generation](const Progress& progress) -> Jobs::Delivery {
                        auto finished = render::filter_environment(
                            *map, render::FilterQuality::Finished, progress);
                        if (!finished) return [] {};
                        render::keep_environment(render::user_environment_cache(), *finished);
                        return light_delivery(std::move(*finished), generation);
                    });
}

/// Called by workers: with it comes all that refining the picture reads.
Jobs::Delivery Session::light_delivery(render::FilteredEnvironment light, int generation) {
    light.sampling = render::environment_sampling(light.map);
    return [this, light = std::make_shared<render::FilteredEnvironment>(std::move(light)),
            generation] {
        if (generation != environment_generation_) return;
        first_light_pending_ = false;
        picture_.set_environment(*light);
    };
}

Jobs::Delivery Session::light_failure(const Error& error, int generation) {
    return [this, error, generation] {
        report_job_failure(error);
        if (generation == environment_generation_) first_light_pending_ = false;
    };
}

/// The studio lights what names no environment that may be read.
void Session::light_with(const EnvironmentChoice& chosen) {
    lit_ = chosen;
    Result<EnvironmentSource> source = environments_.find(chosen.name);
    if (source) {
        source->sun_elevation_degrees = chosen.sun_elevation_degrees;
        return filter_environment(*source, Environments::label_of(chosen.name));
    }
    toast(ToastKind::Error, source.error().message);
    filter_environment({.builtin = "studio"}, "Studio");
}

void Session::follow_environment() {
    const EnvironmentSettings& settings = history_->document()->environment;
    EnvironmentChoice wanted{.name = settings.name};
    if (wanted.name == render::kSkyEnvironment)
        wanted.sun_elevation_degrees = settings.sun_elevation_degrees;
    if (wanted == lit_) return;
    // While its sun is dragged a sky is shown as often as it is ready, not begun anew every frame.
    if (wanted.name == lit_.name && first_light_pending_) return;
    light_with(wanted);
}

}  // namespace patina::editor
