// SPDX-License-Identifier: MIT
#pragma once

/// What a view can show: the finished picture, each target of the G-buffer and each number in it,
/// what an inspection pass draws on demand, and each term of the lighting. One table feeds the
/// strip, the menus, the command line, the probe and the tests.

#include <array>
#include <optional>
#include <string_view>

namespace patina::render {

enum class ChannelView {
    Final,
    BaseColor,
    Metalness,
    Roughness,
    NormalWorld,
    F0,
    Position,
    Depth,
    Occlusion,
    Emissive,
    Alpha,
    NormalView,
    Tangent,
    GeometricNormal,
    Ior,
    Uv0,
    Uv1,
    DiffuseDirect,
    SpecularDirect,
    DiffuseAmbient,
    SpecularAmbient,
    DistributionTerm,
    FresnelTerm,
    GeometryTerm,
    UvChecker,
};
inline constexpr int kChannelViewCount = 25;
/// The first ten have the keys 0 to 9 and stand in the strip.
inline constexpr int kStripChannelCount = 10;

/// How the numbers become a picture.
enum class ChannelDisplay {
    Picture,    ///< exposed, tone-mapped, sRGB
    Color,      ///< linear colour, sRGB-encoded
    Scalar,     ///< 0 to 1 shown as sRGB-encoded bytes of that value, black to white
    Direction,  ///< n * 0.5 + 0.5
    Range,      ///< fitted between the least and the largest of the scene
    Light,      ///< radiance, exposed and tone-mapped like the picture
};

/// Where the numbers come from, which is what showing them costs.
enum class ChannelOrigin { Lighting, GBuffer, Inspection };

struct ChannelViewInfo {
    ChannelView view;
    std::string_view id;     ///< on the command line, such as "base-color"
    std::string_view label;  ///< in the interface
    /// Where it is stored in frames, such as "albedo.rgb, RGBA8 sRGB" (stills and probes keep
    /// albedo in RGBA16F).
    std::string_view target;
    int components;         ///< numbers to show in a probe: 1, 2 or 3
    std::string_view unit;  ///< "" or such as "m"
    ChannelDisplay display;
    ChannelOrigin origin;
    std::string_view tooltip;
};

inline constexpr std::array<ChannelViewInfo, kChannelViewCount> kChannelViews = {{
    {ChannelView::Final, "final", "Final", "picture", 3, "", ChannelDisplay::Picture,
     ChannelOrigin::Lighting, "The finished picture."},
    {ChannelView::BaseColor, "base-color", "Base colour", "albedo.rgb, RGBA8 sRGB", 3, "",
     ChannelDisplay::Color, ChannelOrigin::GBuffer,
     "Colour of diffuse light for non-metals, of reflections for metals."},
    {ChannelView::Metalness, "metalness", "Metalness", "albedo.a, RGBA8 sRGB", 1, "",
     ChannelDisplay::Scalar, ChannelOrigin::GBuffer, "1 is bare metal, 0 is everything else."},
    {ChannelView::Roughness, "roughness", "Roughness", "normal_roughness.a, RGBA16F", 1, "",
     ChannelDisplay::Scalar, ChannelOrigin::GBuffer, "0 is a mirror, 1 is fully matt."},
    {ChannelView::NormalWorld, "normal", "Normal", "normal_roughness.rgb, RGBA16F", 3, "",
     ChannelDisplay::Direction, ChannelOrigin::GBuffer,
     "Shading normal in the world: red +X, green +Y, blue +Z."},
    {ChannelView::F0, "f0", "F0", "specular_ior.rgb, RGBA16F", 3, "", ChannelDisplay::Color,
     ChannelOrigin::GBuffer, "What is mirrored head-on: 0.04 for most non-metals."},
    {ChannelView::Position, "position", "Position", "from depth, 32F", 3, "m",
     ChannelDisplay::Range, ChannelOrigin::GBuffer, "Place in the world, fitted to the scene."},
    {ChannelView::Depth, "depth", "Depth", "from depth, 32F", 1, "m", ChannelDisplay::Range,
     ChannelOrigin::GBuffer, "Distance along the view, near is dark, fitted to the scene."},
    {ChannelView::Occlusion, "occlusion", "Occlusion", "emissive_occlusion.a, RGBA16F", 1, "",
     ChannelDisplay::Scalar, ChannelOrigin::GBuffer,
     "How much ambient light reaches the surface; 1 is all of it."},
    {ChannelView::Emissive, "emissive", "Emissive", "emissive_occlusion.rgb, RGBA16F", 3, "",
     ChannelDisplay::Color, ChannelOrigin::GBuffer, "Light that the surface sends out itself."},
    {ChannelView::Alpha, "alpha", "Alpha", "inspection", 1, "", ChannelDisplay::Scalar,
     ChannelOrigin::Inspection, "Coverage of the surface; 1 is solid."},
    {ChannelView::NormalView, "normal-view", "Normal, view", "normal_roughness.rgb, RGBA16F", 3, "",
     ChannelDisplay::Direction, ChannelOrigin::GBuffer,
     "Shading normal as the camera sees it: blue faces the camera."},
    {ChannelView::Tangent, "tangent", "Tangent", "inspection", 3, "", ChannelDisplay::Direction,
     ChannelOrigin::Inspection, "Direction of +U along the surface, in the world."},
    {ChannelView::GeometricNormal, "geometric-normal", "Geometric normal", "inspection", 3, "",
     ChannelDisplay::Direction, ChannelOrigin::Inspection,
     "Normal of the flat triangle, in the world."},
    {ChannelView::Ior, "ior", "IOR", "specular_ior.a, RGBA16F", 1, "", ChannelDisplay::Range,
     ChannelOrigin::GBuffer, "Index of refraction; 1 to 3 from black to white."},
    {ChannelView::Uv0, "uv", "UV 0", "inspection", 2, "", ChannelDisplay::Color,
     ChannelOrigin::Inspection, "First texture coordinates, repeating: red u, green v."},
    {ChannelView::Uv1, "uv1", "UV 1", "inspection", 2, "", ChannelDisplay::Color,
     ChannelOrigin::Inspection, "Second texture coordinates, repeating: red u, green v."},
    {ChannelView::DiffuseDirect, "diffuse-direct", "Diffuse, direct", "lighting", 3, "",
     ChannelDisplay::Light, ChannelOrigin::Lighting, "Diffuse light from lamps."},
    {ChannelView::SpecularDirect, "specular-direct", "Specular, direct", "lighting", 3, "",
     ChannelDisplay::Light, ChannelOrigin::Lighting, "Highlights of lamps."},
    {ChannelView::DiffuseAmbient, "diffuse-ambient", "Diffuse, ambient", "lighting", 3, "",
     ChannelDisplay::Light, ChannelOrigin::Lighting, "Diffuse light from the environment."},
    {ChannelView::SpecularAmbient, "specular-ambient", "Specular, ambient", "lighting", 3, "",
     ChannelDisplay::Light, ChannelOrigin::Lighting, "Reflections of the environment."},
    {ChannelView::DistributionTerm, "term-d", "D", "lighting", 1, "", ChannelDisplay::Light,
     ChannelOrigin::Lighting, "Distribution of facets, for the key light."},
    {ChannelView::FresnelTerm, "term-f", "F", "lighting", 3, "", ChannelDisplay::Color,
     ChannelOrigin::Lighting, "Fresnel reflectance, for the key light."},
    {ChannelView::GeometryTerm, "term-g", "G", "lighting", 1, "", ChannelDisplay::Scalar,
     ChannelOrigin::Lighting, "Masking and shadowing of facets, for the key light."},
    {ChannelView::UvChecker, "uv-checker", "UV checker", "inspection", 3, "", ChannelDisplay::Color,
     ChannelOrigin::Inspection,
     "Squares of 1/8 of UV 0: stretched, turned or mirrored where the mapping is."},
}};

constexpr const ChannelViewInfo& info(ChannelView view) {
    return kChannelViews[static_cast<std::size_t>(view)];
}
constexpr std::optional<ChannelView> channel_view_from_id(std::string_view id) {
    for (const ChannelViewInfo& entry : kChannelViews)
        if (entry.id == id) return entry.view;
    return std::nullopt;
}

}  // namespace patina::render
