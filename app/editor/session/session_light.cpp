// SPDX-License-Identifier: MIT

/// The light of the document: from its name to what the renderer holds.

#include "editor/session/session.h"
#include "render/environment_cache.h"

namespace patina::editor {

/// The finished light at once where it is kept from an earlier session; else the first light as
/// soon as there is one, and the finished one when it is done.
void Session::filter_environment(const EnvironmentSource& source, std::string label) {
    const int generation = ++environment_generation_;
    jobs_.start("Filtering " + label,
                [this, source, generation](const Progress& progress) -> Jobs::Delivery {
                    const Result<ImagePtr> map = read_environment(source);
                    if (!map) return [this, error = map.error()] { report_job_failure(error); };
                    auto kept = render::kept_environment(render::user_environment_cache(), **map);
                    if (kept) return light_delivery(std::move(*kept), generation);
                    auto first =
                        render::filter_environment(**map, render::FilterQuality::First, progress);
                    return [this, first = std::make_shared<decltype(first)>(std::move(first)),
                            map = *map, generation] {
                        if (generation != environment_generation_) return;
                        if (!*first) return report_job_failure(first->error());
                        picture_.set_environment(**first);
                        finish_environment(map, generation);
                    };
                });
}

void Session::finish_environment(const ImagePtr& map, int generation) {
    jobs_.start("Filtering the environment",
                [this, map, generation](const Progress& progress) -> Jobs::Delivery {
                    auto finished =
                        render::filter_environment(*map, render::FilterQuality::Finished, progress);
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
        if (generation == environment_generation_) picture_.set_environment(*light);
    };
}

/// The studio lights what names no environment that may be read.
void Session::light_with(const std::string& name) {
    environment_name_ = name;
    const Result<EnvironmentSource> source = environments_.find(name);
    if (source) return filter_environment(*source, Environments::label_of(name));
    toast(ToastKind::Error, source.error().message);
    filter_environment({.builtin = "studio"}, "Studio");
}

void Session::follow_environment() {
    const std::string& name = history_->document()->environment.name;
    if (name != environment_name_) light_with(name);
}

}  // namespace patina::editor
