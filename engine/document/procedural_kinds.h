// SPDX-License-Identifier: MIT
#pragma once

/// What each kind of procedural is and which of its numbers it looks at, as one table: panels show
/// those alone. The formulae are in shaders/shared/noise.glsl and pattern.glsl.

#include <array>
#include <cstdint>
#include <string_view>

#include "document/source.h"

namespace patina {

/// Which numbers of a ProceduralSource a kind looks at, beside seed, scale, contrast and balance.
using ProceduralUses = std::uint8_t;
inline constexpr ProceduralUses kUsesOctaves = 1;
inline constexpr ProceduralUses kUsesWidth = 2;
inline constexpr ProceduralUses kUsesSoftness = 4;
inline constexpr ProceduralUses kUsesVariation = 8;
inline constexpr ProceduralUses kUsesAspect = 16;

struct ProceduralKindInfo {
    ProceduralKind kind;
    std::string_view group;  ///< heading in menus
    ProceduralUses uses;
    std::string_view tooltip;
};

// The formatter would spread each row over several lines.
// clang-format off
inline constexpr std::array kProceduralKindInfos = {
    ProceduralKindInfo{ProceduralKind::ValueNoise, "Noises", kUsesOctaves, "Soft blots on a grid."},
    ProceduralKindInfo{ProceduralKind::PerlinNoise, "Noises", kUsesOctaves, "Even clouds."},
    ProceduralKindInfo{ProceduralKind::WorleyNoise, "Cells", kUsesOctaves, "Distance to the nearest of random points: pebbles, pits."},
    ProceduralKindInfo{ProceduralKind::SimplexNoise, "Noises", kUsesOctaves, "Even clouds without a grid."},
    ProceduralKindInfo{ProceduralKind::RidgedNoise, "Noises", kUsesOctaves, "Bright ridges: veins, folds."},
    ProceduralKindInfo{ProceduralKind::Turbulence, "Noises", kUsesOctaves, "Dark creases: smoke, stone."},
    ProceduralKindInfo{ProceduralKind::WorleyF2, "Cells", kUsesOctaves, "Distance to the second nearest of random points."},
    ProceduralKindInfo{ProceduralKind::WorleyEdges, "Cells", kUsesOctaves, "Dark along the borders of random cells: scales, cobbles."},
    ProceduralKindInfo{ProceduralKind::Cells, "Cells", kUsesOctaves, "A random value for each of random cells: flakes, crystals."},
    ProceduralKindInfo{ProceduralKind::GradientLinear, "Gradients", 0, "From black to white across."},
    ProceduralKindInfo{ProceduralKind::GradientRadial, "Gradients", 0, "White in the middle of each cell."},
    ProceduralKindInfo{ProceduralKind::GradientAngular, "Gradients", 0, "Once around the middle of each cell."},
    ProceduralKindInfo{ProceduralKind::Checker, "Patterns", kUsesSoftness, "Squares in turn."},
    ProceduralKindInfo{ProceduralKind::Stripes, "Patterns", kUsesWidth | kUsesSoftness | kUsesVariation, "Upright stripes."},
    ProceduralKindInfo{ProceduralKind::Bricks, "Patterns", kUsesWidth | kUsesSoftness | kUsesVariation | kUsesAspect, "A wall: rows of bricks with mortar."},
    ProceduralKindInfo{ProceduralKind::Tiles, "Patterns", kUsesWidth | kUsesSoftness | kUsesVariation, "Square tiles with joints."},
    ProceduralKindInfo{ProceduralKind::Hexagons, "Patterns", kUsesWidth | kUsesSoftness | kUsesVariation, "Six-sided tiles with joints."},
    ProceduralKindInfo{ProceduralKind::Weave, "Patterns", kUsesWidth | kUsesVariation, "Threads over and under each other: cloth."},
    ProceduralKindInfo{ProceduralKind::Spots, "Surfaces", kUsesWidth | kUsesSoftness | kUsesVariation, "A round spot in each cell."},
    ProceduralKindInfo{ProceduralKind::Scratches, "Surfaces", kUsesOctaves | kUsesWidth | kUsesVariation, "Fine straight scratches."},
    ProceduralKindInfo{ProceduralKind::Cracks, "Surfaces", kUsesWidth | kUsesSoftness | kUsesVariation, "Cracks along the borders of random cells."},
    ProceduralKindInfo{ProceduralKind::WoodRings, "Surfaces", kUsesSoftness | kUsesVariation, "The year rings of a board, along the grain."},
    ProceduralKindInfo{ProceduralKind::Marble, "Surfaces", kUsesOctaves | kUsesWidth | kUsesVariation, "Frayed veins."},
    ProceduralKindInfo{ProceduralKind::Grunge, "Surfaces", kUsesOctaves | kUsesVariation, "Blots, grain and pores of use and dirt."},
};
// clang-format on

/// The headings, in the order in which menus show them.
inline constexpr std::array<std::string_view, 5> kProceduralGroups = {
    "Noises", "Cells", "Gradients", "Patterns", "Surfaces"};

constexpr const ProceduralKindInfo& info(ProceduralKind kind) {
    return kProceduralKindInfos[static_cast<std::size_t>(kind)];
}
constexpr bool uses(ProceduralKind kind, ProceduralUses number) {
    return (info(kind).uses & number) != 0;
}

}  // namespace patina
