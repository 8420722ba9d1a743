// SPDX-License-Identifier: MIT
#include "document/material_warnings.h"

#include <fmt/format.h>

#include <algorithm>

#include "document/worn_surface.h"

namespace patina {
namespace {

/// Whether a layer that shows makes opacity anything but 1.
bool sets_opacity(const std::vector<LayerPtr>& layers) {
    return std::any_of(layers.begin(), layers.end(), [](const LayerPtr& layer) {
        const ChannelSettings& opacity = at(layer->channels, Channel::Opacity);
        if (!layer->visible || layer->opacity <= 0.0f || !opacity.enabled) return false;
        if (const auto* const group = std::get_if<GroupContent>(&layer->content))
            return sets_opacity(group->children);
        const auto* const constant = std::get_if<ConstantSource>(&opacity.source);
        return layer->is_adjustment() || constant == nullptr || constant->value.x < 1.0f;
    });
}

}  // namespace

std::vector<std::string> warnings_of(const Document& document, const Material& material,
                                     const UvSurfacePtr& last) {
    std::vector<std::string> lines;
    if (const UvSurfacePtr surface = surface_read(document, material, last))
        lines = missing_of_surface(material, *surface);
    if (material.alpha_mode == AlphaMode::Opaque && sets_opacity(material.stack))
        lines.emplace_back(
            "layers set its opacity, but its alpha mode is opaque, which shows clear parts as "
            "solid; set alpha-mode to mask or blend");
    for (std::string& line : lines)
        line = fmt::format("material \"{}\": {}", quoted_for_message(material.name, 60), line);
    return lines;
}

}  // namespace patina
