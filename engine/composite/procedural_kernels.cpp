// SPDX-License-Identifier: MIT
#include "composite/procedural_kernels.h"

#include "composite/kernel_targets.h"
#include "composite/tile.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "composite/procedural_kernels.cpp"
#include <hwy/foreach_target.h>

#include "composite/plane_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace patina::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using formulae::NoisePlace;
using formulae::Octave;
using formulae::Pattern;
using formulae::Real2;
using formulae::Shown;

formulae::Ramp ramp_of(const ProceduralTask& task) {
    formulae::Ramp ramp;
    ramp.count = task.stop_count;
    for (int i = 0; i < task.stop_count; ++i) {
        const float* const value = task.stop_values[i];
        ramp.stops[i] = {task.stop_positions[i], value[0], value[1], value[2]};
    }
    return ramp;
}

using Plane = float[kTileTexels];

/// Where the texels of a run lie, in cells.
struct Places {
    alignas(64) Plane x;
    alignas(64) Plane y;
    int count;
    bool is_level;  ///< y is the same in all of them, and x grows in even steps

    HWY_INLINE Real2 at(int i) const { return Real2(load(x + i), load(y + i)); }
    HWY_INLINE void set(int i, Real2 place) {
        store(place.x, x + i);
        store(place.y, y + i);
    }
};

/// Where texels from number `i` on lie, in cells.
HWY_INLINE Real2 position_at(const ProceduralTask& task, int i) {
    if (task.u != nullptr)
        return Real2(load(task.u + i) * static_cast<float>(task.columns),
                     load(task.v + i) * static_cast<float>(task.rows));
    const formulae::Int column(hn::Iota(formulae::IntLanes(), task.x + i));
    const Real u = (Real(column) + 0.5f) / task.size;
    return Real2((u * task.u_per_u + task.u_of_row) * static_cast<float>(task.columns),
                 (u * task.v_per_u + task.v_of_row) * static_cast<float>(task.rows));
}

HWY_NOINLINE HWY_FLATTEN void find_places(const ProceduralTask& task, Places& places) {
    places.count = task.count;
    places.is_level = task.u == nullptr && task.v_per_u == 0.0f && task.u_per_u > 0.0f;
    for (int i = 0; i < task.count; i += static_cast<int>(lane_count()))
        places.set(i, position_at(task, i));
}

/// What the corners of a noise's cells hang on.
struct Lattice {
    int period_x;
    int period_y;
    formulae::uint seed;
    float footprint = 0.0f;            ///< width of a texel in cells
    const Pattern* pattern = nullptr;  ///< of scratches
};

struct ValueNoise {
    using Corners = formulae::ValueCorners;
    static constexpr int kPointNumbers = 1;
    static HWY_INLINE void hash_point(formulae::Int x, formulae::Int y, const Lattice& lattice,
                                      Real (&numbers)[kPointNumbers]) {
        numbers[0] = formulae::unit_from_bits(formulae::lattice_hash(x, y, lattice.seed));
    }
    static HWY_INLINE Corners corners_of(const Real (&points)[4][kPointNumbers]) {
        return {points[0][0], points[1][0], points[2][0], points[3][0]};
    }
    static HWY_INLINE NoisePlace place(Real2 position, const Lattice&) {
        return formulae::noise_place(position);
    }
    static HWY_INLINE Corners corners(Real2 cell, const Lattice& lattice) {
        return formulae::value_corners(cell, lattice.period_x, lattice.seed);
    }
    static HWY_INLINE Real value(const Corners& corners, NoisePlace place, const Lattice&) {
        return formulae::value_between(corners, place);
    }
};

struct SimplexNoise {
    using Corners = formulae::GradientCorners;
    static HWY_INLINE NoisePlace place(Real2 position, const Lattice& lattice) {
        return formulae::simplex_place(position, lattice.period_x);
    }
    static HWY_INLINE Corners corners(Real2 cell, const Lattice& lattice) {
        return formulae::simplex_corners(cell, lattice.period_x, lattice.seed);
    }
    static HWY_INLINE Real value(const Corners& corners, NoisePlace place, const Lattice&) {
        return formulae::simplex_between(corners, place);
    }
};

/// Perlin's noise and what is made of it.
enum class Shape { Plain, Ridged, Folded };
template <Shape kShape>
struct GradientNoise {
    using Corners = formulae::GradientCorners;
    static constexpr int kPointNumbers = 2;
    static HWY_INLINE void hash_point(formulae::Int x, formulae::Int y, const Lattice& lattice,
                                      Real (&numbers)[kPointNumbers]) {
        const Real2 gradient =
            formulae::lattice_gradient(formulae::lattice_hash(x, y, lattice.seed));
        numbers[0] = gradient.x;
        numbers[1] = gradient.y;
    }
    static HWY_INLINE Corners corners_of(const Real (&points)[4][kPointNumbers]) {
        return {Real2(points[0][0], points[0][1]), Real2(points[1][0], points[1][1]),
                Real2(points[2][0], points[2][1]), Real2(points[3][0], points[3][1])};
    }
    static HWY_INLINE NoisePlace place(Real2 position, const Lattice&) {
        return formulae::noise_place(position);
    }
    static HWY_INLINE Corners corners(Real2 cell, const Lattice& lattice) {
        return formulae::gradient_corners(cell, lattice.period_x, lattice.period_y, lattice.seed);
    }
    static HWY_INLINE Real value(const Corners& corners, NoisePlace place, const Lattice&) {
        const Real plain = formulae::perlin_between(corners, place);
        if constexpr (kShape == Shape::Ridged) return formulae::ridged(plain);
        if constexpr (kShape == Shape::Folded) return formulae::folded(plain);
        return plain;
    }
};
using PerlinNoise = GradientNoise<Shape::Plain>;

/// What is made of the feature points around.
enum class FeatureValue { First, Second, Edges, Cells, Border };
template <FeatureValue kValue>
struct FeatureNoise {
    using Corners = formulae::FeaturePoints;
    static HWY_INLINE NoisePlace place(Real2 position, const Lattice&) {
        return formulae::noise_place(position);
    }
    static HWY_INLINE Corners corners(Real2 cell, const Lattice& lattice) {
        return formulae::feature_points(cell, lattice.period_x, lattice.seed);
    }
    static HWY_INLINE Real value(const Corners& points, NoisePlace place, const Lattice& lattice) {
        switch (kValue) {
            case FeatureValue::First:
                return formulae::worley_between(points, place);
            case FeatureValue::Second:
                return formulae::worley_f2_between(points, place);
            case FeatureValue::Edges:
                return formulae::worley_edges_between(points, place);
            case FeatureValue::Cells:
                return formulae::cells_between(points, place, lattice.footprint);
            case FeatureValue::Border:
                return formulae::border_between(points, place);
        }
    }
};

struct ScratchNoise {
    using Corners = formulae::Scratches;
    static HWY_INLINE NoisePlace place(Real2 position, const Lattice&) {
        return formulae::noise_place(position);
    }
    static HWY_INLINE Corners corners(Real2 cell, const Lattice& lattice) {
        return formulae::scratches_around(*lattice.pattern, cell, lattice.seed);
    }
    static HWY_INLINE Real value(const Corners& scratches, NoisePlace place,
                                 const Lattice& lattice) {
        return formulae::scratches_between(*lattice.pattern, scratches, place);
    }
};

/// A noise along a run of texels. Neighbours mostly lie in the cell of those before them: its
/// corners are kept, and hashed again only where some lane comes to another cell.
template <class Noise>
class Walk {
  public:
    HWY_INLINE Walk(Real2 start, const Lattice& lattice)
        : lattice_(lattice),
          cell_(Noise::place(start, lattice).cell),
          corners_(Noise::corners(cell_, lattice)) {}

    HWY_INLINE Real at(Real2 position) {
        const NoisePlace place = Noise::place(position, lattice_);
        const formulae::Bool stays = place.cell.x == cell_.x && place.cell.y == cell_.y;
        if (!hn::AllTrue(formulae::RealLanes(), stays.mask)) {
            cell_ = place.cell;
            corners_ = Noise::corners(cell_, lattice_);
        }
        return Noise::value(corners_, place, lattice_);
    }

  private:
    const Lattice lattice_;
    Real2 cell_;
    typename Noise::Corners corners_;
};

template <class Noise>
HWY_NOINLINE HWY_FLATTEN void noise_run(const Places& places, Real2 scale, const Lattice& lattice,
                                        float* plane) {
    Walk<Noise> walk(places.at(0) * scale, lattice);
    for (int i = 0; i < places.count; i += static_cast<int>(lane_count()))
        store(walk.at(places.at(i) * scale), plane + i);
}

/// Whether points of a noise's lattice can be hashed by themselves.
template <class Noise>
concept HashesPoints = requires {
    Noise::kPointNumbers;
};

/// The lattice points above and below a level run, each hashed once: where cells are a few texels
/// wide, nearly all lanes come to new ones, and neighbours share their corners.
template <class Noise>
class LatticeRows {
  public:
    /// From the cell of the first texel to beyond that of the last; see fit().
    HWY_INLINE LatticeRows(float first_cell, Real cell_y, int columns, const Lattice& lattice)
        : first_cell_(first_cell) {
        const formulae::Int upper = formulae::wrapped_cell(cell_y, lattice.period_y);
        const formulae::Int lower = formulae::next_cell(upper, lattice.period_y);
        for (int i = 0; i < columns; i += static_cast<int>(lane_count())) {
            const Real column(hn::Iota(formulae::RealLanes(), static_cast<float>(i)));
            const formulae::Int x = formulae::wrapped_cell(first_cell + column, lattice.period_x);
            hash_points(x, upper, lattice, 0, i);
            hash_points(x, lower, lattice, 1, i);
        }
    }

    /// Whether there is room for so many columns and what lookups read beyond them.
    static HWY_INLINE bool fit(float columns) {
        return columns + 2.0f * static_cast<float>(lane_count()) < float{kTileTexels};
    }

    /// The corners of cells that lie `steps` columns, fewer than there are lanes, from the first
    /// lane's.
    HWY_INLINE typename Noise::Corners corners(float cell_of_first_lane, Real steps) const {
        const auto lanes = hn::IndicesFromVec(formulae::RealLanes(), formulae::Int(steps).lanes);
        const auto column = static_cast<int>(cell_of_first_lane - first_cell_);
        Real points[4][Noise::kPointNumbers];
        for (int corner = 0; corner < 4; ++corner)
            for (int k = 0; k < Noise::kPointNumbers; ++k) {
                const float* const row = points_[corner / 2][k] + column + corner % 2;
                points[corner][k] = Real(hn::TableLookupLanes(load(row).lanes, lanes));
            }
        return Noise::corners_of(points);
    }

  private:
    HWY_INLINE void hash_points(formulae::Int x, formulae::Int y, const Lattice& lattice, int row,
                                int column) {
        Real numbers[Noise::kPointNumbers];
        Noise::hash_point(x, y, lattice, numbers);
        for (int k = 0; k < Noise::kPointNumbers; ++k) store(numbers[k], points_[row][k] + column);
    }

    float first_cell_;
    alignas(64) Plane points_[2][Noise::kPointNumbers];
};

/// The octaves of a noise, as formulae::fbm adds them up.
struct OctavesTask {
    float scale = 1.0f;  ///< cells of the first octave for each of the places'
    int period = 1;
    formulae::uint seed = 0;
    int octaves = 1;
    float gain = 0.5f;
    float footprint = 0.0f;  ///< of the first octave
    float mean = 0.5f;
};

/// Adds an octave, as Walk or LevelWalk comes by its values.
template <class Walker, class... Ground>
HWY_NOINLINE HWY_FLATTEN void add_octave(const Places& places, const OctavesTask& task,
                                         const Octave& octave, float* sum,
                                         const Ground&... ground) {
    const auto position = [&](int i) { return places.at(i) * task.scale * octave.frequency; };
    Walker walk(position(0), ground...);
    for (int i = 0; i < places.count; i += static_cast<int>(lane_count()))
        store(formulae::with_octave(load(sum + i), octave, task.mean, walk.at(position(i))),
              sum + i);
}

/// The cells that a level run passes through.
struct LevelCells {
    float first = 0.0f;
    float columns = 0.0f;  ///< of lattice points: one more than there are cells
    float per_texel = 0.0f;
};
HWY_INLINE LevelCells level_cells(const Places& places, float scale, float frequency) {
    const auto cells_at = [&](int i) {
        return floor(load(places.x + i) * scale * frequency).lanes;
    };
    const int last =
        (places.count - 1) / static_cast<int>(lane_count()) * static_cast<int>(lane_count());
    const float first = hn::GetLane(cells_at(0));
    const float end = hn::GetLane(hn::MaxOfLanes(formulae::RealLanes(), cells_at(last)));
    return {first, end - first + 2.0f, (places.x[1] - places.x[0]) * scale * frequency};
}

/// Whether as many texels as there are lanes lie in fewer cells.
HWY_INLINE bool suits_lattice_rows(const LevelCells& cells) {
    const auto lanes = static_cast<float>(lane_count());
    return cells.per_texel * lanes < lanes - 1.0f;
}

/// A noise along a level run.
template <class Noise>
class LevelWalk {
  public:
    HWY_INLINE LevelWalk(Real2 start, const Lattice& lattice, const LevelCells& cells)
        : lattice_(lattice),
          y_(start.y),
          rows_(cells.first, floor(start.y), static_cast<int>(cells.columns), lattice) {}

    HWY_INLINE Real at(Real2 position) const {
        const NoisePlace place = Noise::place(Real2(position.x, y_), lattice_);
        const float first = hn::GetLane(place.cell.x.lanes);
        const Real steps = place.cell.x - first;
        const Real lanes(static_cast<float>(lane_count()));
        const bool near = hn::AllTrue(formulae::RealLanes(), (steps < lanes).mask);
        const auto corners =
            near ? rows_.corners(first, steps) : Noise::corners(place.cell, lattice_);
        return Noise::value(corners, place, lattice_);
    }

  private:
    const Lattice lattice_;
    const Real y_;
    const LatticeRows<Noise> rows_;
};

HWY_NOINLINE HWY_FLATTEN void add_mean(const OctavesTask& task, const Octave& octave, int count,
                                       float* sum) {
    for (int i = 0; i < count; i += static_cast<int>(lane_count()))
        store(formulae::with_octave(load(sum + i), octave, task.mean, task.mean), sum + i);
}

HWY_NOINLINE HWY_FLATTEN void fill(float value, int count, float* plane) {
    for (int i = 0; i < count; i += static_cast<int>(lane_count())) store(Real(value), plane + i);
}

/// A sum to its weighted mean.
HWY_NOINLINE HWY_FLATTEN void divide(float total, int count, float* sum) {
    for (int i = 0; i < count; i += static_cast<int>(lane_count()))
        store(clamp(load(sum + i) / total, 0.0f, 1.0f), sum + i);
}

template <class Noise>
void add_shown_octave(const Places& places, const OctavesTask& task, const Octave& octave,
                      const Lattice& lattice, float* sum) {
    if constexpr (HashesPoints<Noise>) {
        if (places.is_level && places.count > static_cast<int>(lane_count())) {
            const LevelCells cells = level_cells(places, task.scale, octave.frequency);
            if (suits_lattice_rows(cells) && LatticeRows<Noise>::fit(cells.columns))
                return add_octave<LevelWalk<Noise>>(places, task, octave, sum, lattice, cells);
        }
    }
    add_octave<Walk<Noise>>(places, task, octave, sum, lattice);
}

template <class Noise>
void octaves_run(const Places& places, const OctavesTask& task, float* plane) {
    fill(0.0f, places.count, plane);
    float total = 0.0f;
    Octave octave = formulae::first_octave(task.footprint);
    for (int i = 0; i < task.octaves; ++i) {
        const Lattice lattice = {task.period << i, task.period << i,
                                 formulae::derived_seed(task.seed, i),
                                 task.footprint * octave.frequency};
        if (octave.shown > 0.0f)
            add_shown_octave<Noise>(places, task, octave, lattice, plane);
        else
            add_mean(task, octave, places.count, plane);
        total = total + octave.strength;
        octave = formulae::next_octave(octave, task.gain, task.footprint);
    }
    divide(total, places.count, plane);
}

/// A kind of noise by itself.
template <class Noise>
void plain_octaves(const Pattern& pattern, const Places& places, float* plane) {
    octaves_run<Noise>(places,
                       {.period = pattern.columns,
                        .seed = pattern.seed,
                        .octaves = pattern.octaves,
                        .footprint = pattern.footprint,
                        .mean = formulae::noise_mean(pattern.kind)},
                       plane);
}

template <class Noise>
void side_octaves(const formulae::SideOctaves& side, const Pattern& pattern, const Places& places,
                  float* plane) {
    octaves_run<Noise>(places,
                       {.scale = side.scale,
                        .period = formulae::side_period(side, pattern),
                        .seed = side.seed,
                        .octaves = side.octaves,
                        .gain = side.gain,
                        .footprint = pattern.footprint * side.scale,
                        .mean = formulae::noise_mean(side.kind)},
                       plane);
}

void side_noise(const formulae::SideNoise& side, const Places& places, float* plane) {
    noise_run<PerlinNoise>(places, Real2(side.scale_x, side.scale_y),
                           {side.period_x, side.period_y, side.seed}, plane);
}

HWY_NOINLINE HWY_FLATTEN void warp(const Pattern& pattern, Places& places) {
    alignas(64) Plane noise_x, noise_y;
    side_noise(formulae::warp_x(pattern), places, noise_x);
    side_noise(formulae::warp_y(pattern), places, noise_y);
    places.is_level = false;
    for (int i = 0; i < places.count; i += static_cast<int>(lane_count()))
        places.set(i, formulae::warped_by(pattern, places.at(i),
                                          Real2(load(noise_x + i), load(noise_y + i))));
}

HWY_NOINLINE HWY_FLATTEN void wood_run(const Pattern& pattern, const Places& places, float* plane) {
    alignas(64) Plane slow, faster, fibre;
    side_noise(formulae::wood_bend(pattern, 0), places, slow);
    side_noise(formulae::wood_bend(pattern, 1), places, faster);
    if (formulae::wood_fibre_shown(pattern) > 0.0f)
        side_noise(formulae::wood_fibre(pattern), places, fibre);
    else
        fill(0.5f, places.count, fibre);
    for (int i = 0; i < places.count; i += static_cast<int>(lane_count()))
        store(formulae::wood_rings_of(pattern, places.at(i), load(slow + i), load(faster + i),
                                      load(fibre + i)),
              plane + i);
}

HWY_NOINLINE HWY_FLATTEN void marble_run(const Pattern& pattern, const Places& places,
                                         float* plane) {
    alignas(64) Plane slow;
    side_noise(formulae::marble_bend(pattern), places, slow);
    side_octaves<GradientNoise<Shape::Folded>>(formulae::marble_fray(pattern), pattern, places,
                                               plane);
    for (int i = 0; i < places.count; i += static_cast<int>(lane_count()))
        store(formulae::marble_of(pattern, places.at(i), load(slow + i), load(plane + i)),
              plane + i);
}

HWY_NOINLINE HWY_FLATTEN void grunge_run(const Pattern& pattern, const Places& places,
                                         float* plane) {
    alignas(64) Plane pores, veins;
    side_octaves<PerlinNoise>(formulae::grunge_clouds(pattern), pattern, places, plane);
    side_octaves<FeatureNoise<FeatureValue::First>>(formulae::grunge_pores(pattern), pattern,
                                                    places, pores);
    side_octaves<GradientNoise<Shape::Ridged>>(formulae::grunge_veins(pattern), pattern, places,
                                               veins);
    for (int i = 0; i < places.count; i += static_cast<int>(lane_count()))
        store(formulae::grunge_of(pattern, load(plane + i), load(pores + i), load(veins + i)),
              plane + i);
}

/// One of the patterns that fade to their mean as a whole.
template <int kKind>
HWY_NOINLINE HWY_FLATTEN void sharp_run(const Pattern& unbent, const Places& places, float* plane) {
    const Shown shown = formulae::pattern_shown(unbent);
    if (shown.share == 0.0f) return fill(shown.mean, places.count, plane);
    Pattern pattern = formulae::bent_pattern(unbent);
    pattern.kind = kKind;  // a constant: no lane asks which kind it is
    for (int i = 0; i < places.count; i += static_cast<int>(lane_count()))
        store(formulae::faded_pattern(shown, formulae::sharp_pattern(pattern, places.at(i))),
              plane + i);
}

HWY_NOINLINE HWY_FLATTEN void cracks_run(const Pattern& unbent, const Places& places,
                                         float* plane) {
    const Shown shown = formulae::pattern_shown(unbent);
    if (shown.share == 0.0f) return fill(shown.mean, places.count, plane);
    const Pattern pattern = formulae::bent_pattern(unbent);
    alignas(64) Plane slow;
    side_noise(formulae::cracks_slow(pattern), places, slow);
    noise_run<FeatureNoise<FeatureValue::Border>>(
        places, Real2(1.0f, 1.0f), {pattern.columns, pattern.columns, pattern.seed}, plane);
    for (int i = 0; i < places.count; i += static_cast<int>(lane_count()))
        store(formulae::faded_pattern(
                  shown, formulae::cracks_of(pattern, load(plane + i), load(slow + i))),
              plane + i);
}

HWY_NOINLINE HWY_FLATTEN void scratches_run(const Pattern& unbent, const Places& places,
                                            float* plane) {
    const Shown shown = formulae::pattern_shown(unbent);
    if (shown.share == 0.0f) return fill(shown.mean, places.count, plane);
    const Pattern pattern = formulae::bent_pattern(unbent);
    const auto layer_run = [&](int layer, float* values) {
        noise_run<ScratchNoise>(places, Real2(1.0f, 1.0f),
                                {.period_x = pattern.columns,
                                 .period_y = pattern.rows,
                                 .seed = formulae::scratches_seed(pattern, layer),
                                 .pattern = &pattern},
                                values);
    };
    alignas(64) Plane other;
    layer_run(0, plane);
    if (formulae::scratches_layers(pattern) > 1)
        layer_run(1, other);
    else
        fill(0.0f, places.count, other);
    for (int i = 0; i < places.count; i += static_cast<int>(lane_count()))
        store(formulae::faded_pattern(shown, max(load(plane + i), load(other + i))), plane + i);
}

/// The pattern of a kind at places that are bent already, as formulae::pattern_at gives it.
void pattern_run(ProceduralKind kind, const Pattern& pattern, const Places& at, float* plane) {
    switch (kind) {
        case ProceduralKind::ValueNoise:
            return plain_octaves<ValueNoise>(pattern, at, plane);
        case ProceduralKind::PerlinNoise:
            return plain_octaves<PerlinNoise>(pattern, at, plane);
        case ProceduralKind::WorleyNoise:
            return plain_octaves<FeatureNoise<FeatureValue::First>>(pattern, at, plane);
        case ProceduralKind::SimplexNoise:
            return plain_octaves<SimplexNoise>(pattern, at, plane);
        case ProceduralKind::RidgedNoise:
            return plain_octaves<GradientNoise<Shape::Ridged>>(pattern, at, plane);
        case ProceduralKind::Turbulence:
            return plain_octaves<GradientNoise<Shape::Folded>>(pattern, at, plane);
        case ProceduralKind::WorleyF2:
            return plain_octaves<FeatureNoise<FeatureValue::Second>>(pattern, at, plane);
        case ProceduralKind::WorleyEdges:
            return plain_octaves<FeatureNoise<FeatureValue::Edges>>(pattern, at, plane);
        case ProceduralKind::Cells:
            return plain_octaves<FeatureNoise<FeatureValue::Cells>>(pattern, at, plane);
        case ProceduralKind::GradientLinear:
            return sharp_run<formulae::PATTERN_GRADIENT_LINEAR>(pattern, at, plane);
        case ProceduralKind::GradientRadial:
            return sharp_run<formulae::PATTERN_GRADIENT_RADIAL>(pattern, at, plane);
        case ProceduralKind::GradientAngular:
            return sharp_run<formulae::PATTERN_GRADIENT_ANGULAR>(pattern, at, plane);
        case ProceduralKind::Checker:
            return sharp_run<formulae::PATTERN_CHECKER>(pattern, at, plane);
        case ProceduralKind::Stripes:
            return sharp_run<formulae::PATTERN_STRIPES>(pattern, at, plane);
        case ProceduralKind::Bricks:
            return sharp_run<formulae::PATTERN_BRICKS>(pattern, at, plane);
        case ProceduralKind::Tiles:
            return sharp_run<formulae::PATTERN_TILES>(pattern, at, plane);
        case ProceduralKind::Hexagons:
            return sharp_run<formulae::PATTERN_HEXAGONS>(pattern, at, plane);
        case ProceduralKind::Weave:
            return sharp_run<formulae::PATTERN_WEAVE>(pattern, at, plane);
        case ProceduralKind::Spots:
            return sharp_run<formulae::PATTERN_SPOTS>(pattern, at, plane);
        case ProceduralKind::Scratches:
            return scratches_run(pattern, at, plane);
        case ProceduralKind::Cracks:
            return cracks_run(pattern, at, plane);
        case ProceduralKind::WoodRings:
            return wood_run(pattern, at, plane);
        case ProceduralKind::Marble:
            return marble_run(pattern, at, plane);
        case ProceduralKind::Grunge:
            return grunge_run(pattern, at, plane);
    }
}

/// The pattern, before contrast and ramp.
void show_pattern(const ProceduralTask& task, float* plane) {
    const auto pattern = pattern_of<Pattern>(task);
    Places places;
    find_places(task, places);
    if (task.warp != 0.0f) warp(pattern, places);
    pattern_run(task.kind, pattern, places, plane);
}

HWY_INLINE Real contrasted_at(const ProceduralTask& task, const Shown& shown, const float* plane,
                              int i) {
    const Real value = formulae::spread_pattern(shown, load(plane + i));
    if (task.contrast == 0.0f) return value;
    return formulae::contrasted(value, task.contrast, task.balance);
}

HWY_NOINLINE HWY_FLATTEN void scalar_ramp(const ProceduralTask& task, const Shown& shown,
                                          const float* pattern, float* plane) {
    const formulae::Ramp ramp = ramp_of(task);
    for (int i = 0; i < task.count; i += static_cast<int>(lane_count())) {
        const Real value = formulae::ramp_scalar(ramp, contrasted_at(task, shown, pattern, i));
        store(formulae::faded_result(shown, value, task.mean[0]), plane + i);
    }
}

HWY_INLINE Real3 faded_color(const Shown& shown, const Real3& value, const float (&mean)[3]) {
    return {formulae::faded_result(shown, value.x, mean[0]),
            formulae::faded_result(shown, value.y, mean[1]),
            formulae::faded_result(shown, value.z, mean[2])};
}

HWY_NOINLINE HWY_FLATTEN void vector_ramp(const ProceduralTask& task, const Shown& shown,
                                          const float* pattern, float* const* planes) {
    const formulae::Ramp ramp = ramp_of(task);
    for (int i = 0; i < task.count; i += static_cast<int>(lane_count())) {
        Real3 value = formulae::ramp_color(ramp, contrasted_at(task, shown, pattern, i));
        value = faded_color(shown, value, task.mean);
        if (task.encode) value = formulae::srgb_from_linear(value);
        if (task.normalise) value = formulae::unit_normal(value);
        store(value, planes, static_cast<std::size_t>(i));
    }
}

void lay_ramp(const ProceduralTask& task, const float* pattern, float* const* planes) {
    const Shown shown = formulae::pattern_shown(pattern_of<Pattern>(task));
    task.scalar ? scalar_ramp(task, shown, pattern, planes[0])
                : vector_ramp(task, shown, pattern, planes);
}

}  // namespace

}  // namespace patina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace patina {

HWY_EXPORT(show_pattern);
HWY_EXPORT(lay_ramp);

void run_pattern(const ProceduralTask& task, float* plane) {
    HWY_DYNAMIC_DISPATCH(show_pattern)(task, plane);
}

void run_ramp(const ProceduralTask& task, const float* pattern, float* const planes[3]) {
    HWY_DYNAMIC_DISPATCH(lay_ramp)(task, pattern, planes);
}

}  // namespace patina
#endif
