// SPDX-License-Identifier: MIT
#pragma once

/// All that decides a picture of a scene beside the scene itself, as one value: camera, shading at
/// either side, what is shown, light, exposure. Equal views of an unchanged scene are equal
/// pictures, so a frame is drawn only when the view or the scene has changed.

#include <array>
#include <glm/glm.hpp>
#include <string_view>
#include <vector>

#include "render/camera.h"
#include "render/channel_view.h"
#include "render/shading.h"
#include "scene/scene.h"

namespace patina::render {

enum class CompareMode {
    Single,      ///< `left` alone
    Split,       ///< `left` and `right` at either side of the divider, one picture
    TwoViews,    ///< `left` and `right` beside each other, each in half of the width
    Difference,  ///< |luminance left - luminance right|, linear and exposed, as a heat map
};

enum class ToneMap { None, Reinhard, Aces, Agx, PbrNeutral };

inline constexpr std::array<Choice<ToneMap>, 5> kToneMaps = {{
    {ToneMap::None, "none", "None", "Values above 1 are cut"},
    {ToneMap::Reinhard, "reinhard", "Reinhard", "x / (1 + x)"},
    {ToneMap::Aces, "aces", "ACES", "Filmic contrast, fitted"},
    {ToneMap::Agx, "agx", "AgX", "Soft, highlights lose their colour"},
    {ToneMap::PbrNeutral, "pbr-neutral", "PBR Neutral",
     "Khronos: keeps base colours, compresses only highlights"},
}};
inline constexpr std::array<Choice<CompareMode>, 4> kCompareModes = {{
    {CompareMode::Single, "single", "Single", "One view"},
    {CompareMode::Split, "split", "Split", "Two shadings at either side of a divider"},
    {CompareMode::TwoViews, "two-views", "Two views", "Two shadings side by side"},
    {CompareMode::Difference, "difference", "Difference", "Where two shadings differ, as heat"},
}};

inline constexpr std::array<Choice<ViewDirection>, 7> kViewDirections = {{
    {ViewDirection::ThreeQuarter, "three-quarter", "Three-quarter", "From the front right, above"},
    {ViewDirection::Front, "front", "Front", "Along -Z"},
    {ViewDirection::Back, "back", "Back", "Along +Z"},
    {ViewDirection::Left, "left", "Left", "Along +X"},
    {ViewDirection::Right, "right", "Right", "Along -X"},
    {ViewDirection::Top, "top", "Top", "Downwards"},
    {ViewDirection::Bottom, "bottom", "Bottom", "Upwards"},
}};

struct Background {
    enum class Kind {
        Studio,              ///< a dark grey backdrop with a floor
        Environment,         ///< the environment, sharp
        BlurredEnvironment,  ///< the environment, out of focus
        Color,               ///< one plain colour
        Transparent,         ///< alpha 0; colours are premultiplied
    };
    Kind kind = Kind::Studio;
    glm::vec3 color_srgb = glm::vec3(0.1f);  ///< Kind::Color: as on screen, not tone-mapped, 0 to 1
    bool operator==(const Background&) const = default;
};
inline constexpr std::array<Choice<Background::Kind>, 5> kBackgrounds = {{
    {Background::Kind::Studio, "studio", "Studio", "A dark grey backdrop with a floor"},
    {Background::Kind::Environment, "environment", "Environment", "The environment, sharp"},
    {Background::Kind::BlurredEnvironment, "blurred", "Blurred", "The environment, out of focus"},
    {Background::Kind::Color, "color", "Colour", "One plain colour"},
    {Background::Kind::Transparent, "none", "None", "Transparent"},
}};

/// What serves against jagged edges in one draw. Stills average several draws instead.
enum class AntiAliasing { None, Fast };

struct View {
    Camera camera;
    CompareMode compare = CompareMode::Single;
    float divider = 0.5f;  ///< 0 to 1 of the width; Split only
    Shading left;
    Shading right = {.model = ShadingModel::Phong};
    ChannelView channel = ChannelView::Final;
    bool difference_beside = false;  ///< TwoViews only: the difference as a third view
    float difference_range = 1.0f;   ///< the luminance difference that is the top of the heat map

    float environment_rotation_degrees = 0.0f;  ///< about +Y, counter-clockwise from above
    float environment_intensity = 1.0f;         ///< times the radiance of the map
    /// At most kMaxLights. The channels D, F and G show the terms of the first; without any, those
    /// of the environment's strongest EnvironmentKey.
    std::vector<Light> lights;

    Background background;
    bool ground_shadow = true;  ///< the model's shadow on the floor, where there is one
    /// Suns of the environment, the strongest EnvironmentKey of the traditional models and the
    /// strongest lamps cast shadows on the model: six lights at most.
    bool shadows = true;
    float exposure_ev = 0.0f;  ///< radiance is multiplied by 2^EV
    ToneMap tone_map = ToneMap::PbrNeutral;
    AntiAliasing anti_aliasing = AntiAliasing::Fast;
    bool wires = false;  ///< edges of the triangles over the picture; not in stills, see lay_wires
    /// Roughness takes in what of the normal map is finer than a pixel, against glints. Not where
    /// the environment is sampled: the many draws of such a picture see the normal map itself.
    bool filter_normals = true;
    /// What a surface mirrors of the environment is held back by the occlusion map as far as that
    /// hides the lobe, and where a normal map would mirror what lies below the surface. False: by
    /// the occlusion map alone, as much as diffuse light.
    bool occlude_reflections = true;
    bool operator==(const View&) const = default;
};

/// Whether the model leaves a shadow on what it stands on in its picture: the studio's floor, or a
/// ground in the environment that is seen by its shadow alone.
inline bool shades_floor(const View& view) {
    return view.ground_shadow && view.background.kind != Background::Kind::Color &&
           view.background.kind != Background::Kind::Transparent;
}
/// Whether a side that is on screen is shaded physically.
inline bool shows_pbr(const View& view) {
    return view.left.model == ShadingModel::Pbr ||
           (view.compare != CompareMode::Single && view.right.model == ShadingModel::Pbr);
}
/// Whether one is shaded by a traditional model.
inline bool shows_traditional(const View& view) {
    return view.left.model != ShadingModel::Pbr ||
           (view.compare != CompareMode::Single && view.right.model != ShadingModel::Pbr);
}

/// Whether the finished picture has three parts: left, right and their difference.
inline bool shows_difference_beside(const View& view) {
    return view.compare == CompareMode::TwoViews && view.difference_beside &&
           view.channel == ChannelView::Final;
}

/// The entry of `choices` whose id is `id`, or null.
template <typename Enum, std::size_t N>
constexpr const Choice<Enum>* choice_from_id(const std::array<Choice<Enum>, N>& choices,
                                             std::string_view id) {
    for (const Choice<Enum>& choice : choices)
        if (choice.id == id) return &choice;
    return nullptr;
}

}  // namespace patina::render
