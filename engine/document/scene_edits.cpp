// SPDX-License-Identifier: MIT
#include "document/scene_edits.h"

#include <cmath>

#include "document/check.h"

namespace patina {
namespace {

Edit environment_edit(std::string label, MergeKey merge_key,
                      std::function<Status(EnvironmentSettings& copy)> change) {
    return {.label = std::move(label),
            .merge_key = std::move(merge_key),
            .apply = [change = std::move(change)](const Document& before) -> Result<Document> {
                Document after = before;
                if (Status status = change(after.environment); !status) return passed_on(status);
                return after;
            }};
}

Edit lights_edit(std::string label, MergeKey merge_key,
                 std::function<Status(std::vector<Light>& copy)> change) {
    return {.label = std::move(label),
            .merge_key = std::move(merge_key),
            .apply = [change = std::move(change)](const Document& before) -> Result<Document> {
                Document after = before;
                if (Status status = change(after.lights); !status) return passed_on(status);
                return after;
            }};
}

Status check_light_index(const std::vector<Light>& lights, int index) {
    if (index >= 0 && static_cast<std::size_t>(index) < lights.size()) return {};
    return failure("there is no light {}: the scene has {}", index, lights.size());
}

Light canonical_light(Light light) {
    const float length = glm::length(light.direction_world);
    // Left as it is when it is a unit vector already, so that doing this twice changes nothing.
    if (std::abs(length - 1.0f) >= 1e-5f) light.direction_world /= length;
    return light;
}

Status check_new_light(const Light& light) {
    if (!light.name.empty())
        if (Status status = check_name(light.name); !status) return status;
    return check_light(light);
}

std::string light_name(const Light& light) {
    return light.name.empty() ? std::string(choice(light.kind).label) + " light" : light.name;
}

}  // namespace

Edit in_one_step(std::string label, Edits edits) {
    return {.label = std::move(label),
            .merge_key = {},
            .apply = [edits = std::move(edits)](const Document& before) -> Result<Document> {
                Result<Document> document = before;
                for (const Edit& edit : edits) {
                    document = edit.apply(*document);
                    if (!document) return document;
                }
                return document;
            }};
}

Edit add_image(ImageAssetPtr image) {
    std::string label = "Add image " + image->name;
    return {.label = std::move(label),
            .merge_key = {},
            .apply = [image = std::move(image)](const Document& before) -> Result<Document> {
                Document after = before;
                after.images.emplace(image->hash, image);
                return after;
            }};
}

Edit set_environment_name(std::string name) {
    return environment_edit("Environment " + name, {}, [name](EnvironmentSettings& copy) -> Status {
        constexpr std::size_t longest_path = 4096;
        if (name.empty() || name.size() > longest_path ||
            quoted_for_message(name, name.size()) != name)
            return failure("\"{}\" is no name of an environment", quoted_for_message(name, 80));
        copy.name = name;
        return {};
    });
}

Edit set_environment_rotation(float degrees) {
    return environment_edit("Environment rotation", {"environment.rotation"},
                            [degrees](EnvironmentSettings& copy) -> Status {
                                copy.rotation_degrees = degrees;
                                return check_range(Parameter::EnvironmentRotation, degrees);
                            });
}

Edit set_environment_intensity(float intensity) {
    return environment_edit("Environment intensity", {"environment.intensity"},
                            [intensity](EnvironmentSettings& copy) -> Status {
                                copy.intensity = intensity;
                                return check_range(Parameter::EnvironmentIntensity, intensity);
                            });
}

Edit set_sun_elevation(float degrees) {
    return environment_edit("Sun height", {"environment.sun-elevation"},
                            [degrees](EnvironmentSettings& copy) -> Status {
                                copy.sun_elevation_degrees = degrees;
                                return check_range(Parameter::EnvironmentSunElevation, degrees);
                            });
}

Edit add_light(const Light& light) {
    return lights_edit("Add " + light_name(light), {},
                       [light](std::vector<Light>& lights) -> Status {
                           if (Status status = check_new_light(light); !status) return status;
                           if (lights.size() >= std::size_t{kMaxLights})
                               return failure("a scene can have at most {} lights", kMaxLights);
                           lights.push_back(canonical_light(light));
                           return {};
                       });
}

Edit remove_light(int index) {
    return lights_edit("Delete light", {}, [index](std::vector<Light>& lights) -> Status {
        if (Status status = check_light_index(lights, index); !status) return status;
        lights.erase(lights.begin() + index);
        return {};
    });
}

Edit set_light(int index, const Light& light) {
    return lights_edit("Change " + light_name(light), {"light", static_cast<std::uint64_t>(index)},
                       [index, light](std::vector<Light>& lights) -> Status {
                           if (Status status = check_light_index(lights, index); !status)
                               return status;
                           if (Status status = check_new_light(light); !status) return status;
                           lights[static_cast<std::size_t>(index)] = canonical_light(light);
                           return {};
                       });
}

}  // namespace patina
