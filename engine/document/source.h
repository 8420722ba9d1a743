// SPDX-License-Identifier: MIT
#pragma once

/// Where a layer's channel or a mask entry gets its numbers: a constant, an image, a procedural,
/// the heights below, another layer, the parts of the model. All are functions of the material's UV
/// coordinates (u right, v down, 0..1 is the texture), some by what lies there of the model.

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/hash.h"
#include "document/channel.h"

namespace patina {

/// Ids are unique within a document, stable over save, reopen, undo and redo, and never 0.
struct LayerId {
    std::uint64_t value = 0;
    auto operator<=>(const LayerId&) const = default;
};

/// Of layers and mask entries alike. Many readers of JSON hold numbers as doubles, which are exact
/// for whole numbers as far as this (RFC 8259, section 6).
inline constexpr std::int64_t kLargestId = std::int64_t{1} << 53;

/// KHR_texture_transform: uv' = offset + rotate(scale * uv). Rotation is counter-clockwise about
/// the UV origin, as that extension defines it.
struct UvTransform {
    glm::vec2 offset = glm::vec2(0.0f);
    glm::vec2 scale = glm::vec2(1.0f);
    float rotation_degrees = 0.0f;
    bool operator==(const UvTransform&) const = default;
};

enum class ProjectionKind : std::uint8_t { Uv, Planar, TriPlanar };
/// As axes are numbered in shaders/shared/projection.glsl.
enum class ProjectionAxis : std::uint8_t { X, Y, Z };

/// What the coordinates of an image or procedural are before its transform: the material's UVs, or
/// places of the model in model space (scene/uv_surface.h), where 1 is the model's longest side,
/// seen along an axis. Where no mesh is at hand they are the UVs.
struct Projection {
    ProjectionKind kind = ProjectionKind::Uv;
    ProjectionAxis axis = ProjectionAxis::Z;  ///< of a planar one: as seen from its positive end
    float blend = 0.3f;  ///< 0 to 1, of a tri-planar one: how softly one side goes over to the next
    bool operator==(const Projection&) const = default;
};

enum class Wrap : std::uint8_t { Repeat, Mirror, Clamp };
enum class Filter : std::uint8_t { Linear, Nearest };
/// How the stored numbers of an image are read. Data (roughness, normals, masks) is Linear.
enum class ColorSpace : std::uint8_t { Srgb, Linear };
/// Which part of the image feeds the channel. Scalars from Rgb read its luminance.
enum class ChannelPick : std::uint8_t { Rgb, Red, Green, Blue, Alpha };

/// One value everywhere. Colours: linear RGB; scalars: x; normals: tangent space xyz.
struct ConstantSource {
    glm::vec3 value = glm::vec3(0.0f);
    bool operator==(const ConstantSource&) const = default;
};

/// An image of the document's image table, by the hash of its pixels.
struct ImageSource {
    Hash128 image;
    ColorSpace color_space = ColorSpace::Linear;
    ChannelPick pick = ChannelPick::Rgb;
    bool invert = false;             ///< 1 - value, of the stored numbers
    bool directx_normal = false;     ///< a normal map with -Y up
    bool alpha_is_coverage = false;  ///< the image's alpha scales the weight of the layer there
    /// TEXCOORD_n, 0 or 1, of an image that a slot shows untouched (SlotImage); a bake reads every
    /// image by Material::uv_set.
    int uv_set = 0;
    Projection projection = {};
    UvTransform transform = {};
    Wrap wrap_u = Wrap::Repeat;
    Wrap wrap_v = Wrap::Repeat;
    Filter filter = Filter::Linear;
    /// value = decoded * multiply + add, where decoded is linear; for normals it is -1..1 and the
    /// sum is renormalised. glTF's factors, normal scale and occlusion strength are kept here.
    glm::vec3 multiply = glm::vec3(1.0f);
    glm::vec3 add = glm::vec3(0.0f);
    bool operator==(const ImageSource&) const = default;
};

/// In the order of NOISE_... and PATTERN_... of shaders/shared/noise.glsl and pattern.glsl.
enum class ProceduralKind : std::uint8_t {
    ValueNoise,
    PerlinNoise,
    WorleyNoise,
    SimplexNoise,
    RidgedNoise,
    Turbulence,
    WorleyF2,
    WorleyEdges,
    Cells,
    GradientLinear,
    GradientRadial,
    GradientAngular,
    Checker,
    Stripes,
    Bricks,
    Tiles,
    Hexagons,
    Weave,
    Spots,
    Scratches,
    Cracks,
    WoodRings,
    Marble,
    Grunge,
};

struct RampStop {
    float position = 0.0f;              ///< 0 to 1
    glm::vec3 value = glm::vec3(0.0f);  ///< as in ConstantSource
    bool operator==(const RampStop&) const = default;
};
inline constexpr int kMaxRampStops = 8;

/// A noise or pattern in 0..1, with contrast, mapped through a ramp. `scale` is rounded to the
/// nearest whole number of cells, so that it tiles; for checkers, weaves and rows of bricks to the
/// next even one from there. Which of the numbers a kind looks at, its row in procedural_kinds.h
/// says.
struct ProceduralSource {
    ProceduralKind kind = ProceduralKind::PerlinNoise;
    std::uint32_t seed = 0;
    float scale = 8.0f;      ///< cells across the texture, 1 to 512
    int octaves = 4;         ///< 1 to 10
    float width = 0.5f;      ///< 0 to 1: of stripes, gaps, spots, scratches, cracks, veins
    float softness = 0.1f;   ///< 0 to 1: of edges, in cells
    float variation = 0.5f;  ///< 0 to 1: how far one cell differs from the next
    float aspect = 2.0f;     ///< 0.25 to 16: how much longer a brick is than high
    float warp = 0.0f;       ///< 0 to 1: how far a noise bends the pattern, in cells
    float contrast = 0.0f;   ///< -1 to 1; 0 leaves the noise, 1 is a threshold at the balance
    float balance = 0.5f;    ///< 0 to 1; the value that contrast leaves unchanged
    Projection projection = {};
    UvTransform transform = {};
    std::vector<RampStop> ramp = {{0.0f, glm::vec3(0.0f)},
                                  {1.0f, glm::vec3(1.0f)}};  ///< 1 to 8, ascending
    bool operator==(const ProceduralSource&) const = default;
};

/// In the order of RELIEF_... of shaders/shared/height.glsl.
enum class ReliefKind : std::uint8_t { Height, Cavity, Edge, Curvature };

/// What the heights that lie below the layer in its own stack are like at a texel, 0..1: how high,
/// how far below or above their surroundings. Feeds masks and single numbers.
struct ReliefSource {
    ReliefKind kind = ReliefKind::Cavity;
    float radius_permille = 10.0f;  ///< 0.1 to 50 thousandths of the texture's side: surroundings
    float strength = 8.0f;          ///< 0.1 to 100; 1 is reached at a difference of 1 / strength
    bool operator==(const ReliefSource&) const = default;
};

/// What of a layer is read: its mask, or one of its channels, in the order of Channel.
enum class LayerResult : std::uint8_t {
    Mask,
    BaseColor,
    Metalness,
    Roughness,
    Normal,
    Height,
    Occlusion,
    Emissive,
    Opacity,
};
constexpr LayerResult result_of(Channel channel) {
    return static_cast<LayerResult>(static_cast<int>(channel) + 1);
}
/// Unset of the mask.
constexpr std::optional<Channel> channel_of(LayerResult result) {
    if (result == LayerResult::Mask) return std::nullopt;
    return static_cast<Channel>(static_cast<int>(result) - 1);
}

/// What another layer of the stack gives by itself, as if it lay alone where it is read: with its
/// own mask, opacity and children, be it hidden or not; relief and heights below count where it is
/// read. It covers no more than the layer does.
struct ReferenceSource {
    LayerId layer = {};
    LayerResult result = LayerResult::Mask;
    bool operator==(const ReferenceSource&) const = default;
};

/// Which parts of the model, out of those that wear the material: 1 on parts that are named, 0 on
/// all others, 1 everywhere where no mesh is at hand. Feeds masks and single numbers.
struct GeometrySource {
    std::vector<std::string> meshes = {};     ///< names of parts, their meshes or nodes
    std::vector<std::string> materials = {};  ///< names of materials that the file gives parts
    bool operator==(const GeometrySource&) const = default;
};
/// In each of its lists.
inline constexpr std::size_t kMaxGeometryNames = 256;

using Source = std::variant<ConstantSource, ImageSource, ProceduralSource, ReliefSource,
                            ReferenceSource, GeometrySource>;

}  // namespace patina
