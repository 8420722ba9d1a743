// SPDX-License-Identifier: MIT
#include "io/map_packing.h"

#include <algorithm>

namespace patina::io {
namespace {

constexpr PackedValue of(Channel channel, int component = 0) {
    return {.channel = channel, .component = component};
}
constexpr PackedValue inverted(Channel channel, int component = 0) {
    return {.channel = channel, .component = component, .invert = true};
}

constexpr PackedMap rgb(std::string_view id, Channel channel) {
    return {.id = id, .channels = 3, .values = {of(channel, 0), of(channel, 1), of(channel, 2)}};
}
constexpr PackedMap grey(std::string_view id, Channel channel) {
    return {.id = id, .channels = 1, .values = {of(channel)}};
}
/// Colour and, where it varies, opacity.
constexpr PackedMap color_with_opacity(std::string_view id) {
    PackedMap map = rgb(id, Channel::BaseColor);
    map.channels = 4;
    map.values[3] = of(Channel::Opacity);
    return map;
}
constexpr PackedMap packed(std::string_view id, PackedValue red, PackedValue green,
                           PackedValue blue) {
    return {.id = id, .channels = 3, .values = {red, green, blue}};
}

constexpr std::array kGltf = {
    color_with_opacity("base-color"),
    packed("occlusion-roughness-metalness", of(Channel::Occlusion), of(Channel::Roughness),
           of(Channel::Metalness)),
    rgb("normal", Channel::Normal),
    rgb("emissive", Channel::Emissive),
};
constexpr std::array kSeparate = {
    rgb("base-color", Channel::BaseColor), grey("metalness", Channel::Metalness),
    grey("roughness", Channel::Roughness), rgb("normal", Channel::Normal),
    grey("height", Channel::Height),       grey("occlusion", Channel::Occlusion),
    rgb("emissive", Channel::Emissive),    grey("opacity", Channel::Opacity),
};
constexpr std::array kUnreal = {
    color_with_opacity("BaseColor"),
    packed("OcclusionRoughnessMetallic", of(Channel::Occlusion), of(Channel::Roughness),
           of(Channel::Metalness)),
    packed("NormalDX", of(Channel::Normal, 0), inverted(Channel::Normal, 1),
           of(Channel::Normal, 2)),
    rgb("Emissive", Channel::Emissive),
};
constexpr std::array kUnity = {
    color_with_opacity("AlbedoTransparency"),
    PackedMap{.id = "MetallicSmoothness",
              .channels = 4,
              .values = {of(Channel::Metalness), of(Channel::Metalness), of(Channel::Metalness),
                         inverted(Channel::Roughness)}},
    rgb("Normal", Channel::Normal),
    grey("Occlusion", Channel::Occlusion),
    grey("Height", Channel::Height),
    rgb("Emission", Channel::Emissive),
};
constexpr std::array kUnityHdrp = {
    color_with_opacity("BaseMap"),
    PackedMap{.id = "MaskMap",
              .channels = 4,
              .values = {of(Channel::Metalness), of(Channel::Occlusion),
                         PackedValue{.constant = 0.0f}, inverted(Channel::Roughness)}},
    rgb("NormalMap", Channel::Normal),
    rgb("EmissionMap", Channel::Emissive),
};

constexpr std::array kPackings = {
    MapPacking{"gltf", "as glTF has them: colour + opacity, occlusion-roughness-metalness, normal",
               kGltf},
    MapPacking{"separate", "a file for each channel, height too", kSeparate},
    MapPacking{"unreal", "occlusion-roughness-metallic, normals with -Y up", kUnreal},
    MapPacking{"unity", "metallic with smoothness in alpha, occlusion and height apart", kUnity},
    MapPacking{"unity-hdrp", "mask map of metallic, occlusion, detail mask 0 and smoothness",
               kUnityHdrp},
};

}  // namespace

bool PackedMap::is_color() const {
    return values[0].channel == Channel::BaseColor || values[0].channel == Channel::Emissive;
}

bool PackedMap::has_normals() const {
    return std::any_of(values.begin(), values.end(),
                       [](const PackedValue& value) { return value.channel == Channel::Normal; });
}

std::span<const MapPacking> map_packings() {
    return kPackings;
}

const MapPacking& default_packing() {
    return kPackings.front();
}

}  // namespace patina::io
