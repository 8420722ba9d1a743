// SPDX-License-Identifier: MIT
#ifndef SHARED_PATTERN_GLSL
#define SHARED_PATTERN_GLSL

#include "shared/noise.glsl"
#include "shared/sequence.glsl"
#include "shared/transcendental.glsl"

// Patterns of cells, 0..1, tiling after whole numbers of columns and rows. Each is limited to what a
// texel can show: edges are never sharper than a texel, and a pattern whose cells are smaller than
// two texels fades to its mean, as octave_visibility says for noises. What names no source is
// Patina's own; that these hold for every kind is what pattern_test.cpp asks.
//
// position: in cells, x to the right and y down.

const int PATTERN_GRADIENT_LINEAR = 9;
const int PATTERN_GRADIENT_RADIAL = 10;
const int PATTERN_GRADIENT_ANGULAR = 11;
const int PATTERN_CHECKER = 12;
const int PATTERN_STRIPES = 13;
const int PATTERN_BRICKS = 14;
const int PATTERN_TILES = 15;
const int PATTERN_HEXAGONS = 16;
const int PATTERN_WEAVE = 17;
const int PATTERN_SPOTS = 18;
const int PATTERN_SCRATCHES = 19;
const int PATTERN_CRACKS = 20;
const int PATTERN_WOOD_RINGS = 21;
const int PATTERN_MARBLE = 22;
const int PATTERN_GRUNGE = 23;

/// What is the same in every texel.
struct Pattern {
    int kind;     // NOISE_... or PATTERN_...
    int columns;  // cells across the texture
    int rows;     // cells down
    uint seed;
    int octaves;      // of noises, 1 to 10; of scratches: whether there are twice as many
    float width;      // 0..1: of lines, gaps, spots
    float softness;   // 0..1: of edges, in cells
    float variation;  // 0..1: how far one cell differs from another
    float warp;       // 0..1: how far the place is bent, in cells
    float footprint;  // width of a texel in cells
};

/// How much of a pattern's detail about its mean is shown.
struct Shown {
    float share;  // 0..1
    float mean;   // what it fades to
};
Shown shown_about(float mean, float share) {
    Shown shown;
    shown.mean = mean;
    shown.share = share;
    return shown;
}
Real faded_pattern(Shown shown, Real value) {
    return shown.mean + (value - shown.mean) * shown.share;
}

/// 0 outside an edge, 1 inside, from `distance` inside (negative outside), over `width`.
Real soft_edge(Real distance, float width) {
    return smoothstep(0.0f, 1.0f, distance / width + 0.5f);
}

/// The width of an edge: as soft as asked, and a texel at least.
float edge_width(Pattern pattern) {
    return max(max(pattern.softness, pattern.footprint), 1e-4f);
}

/// 1 in odd cells, 0 in even ones.
Real odd(Real cell) {
    return cell - 2.0f * floor(cell * 0.5f);
}

/// A random number of a cell, 0..1; `part` tells apart those of one cell.
Real cell_value(Pattern pattern, Real cell_x, Real cell_y, int part) {
    return unit_from_bits(lattice_hash(wrapped_cell(cell_x, pattern.columns),
                                       wrapped_cell(cell_y, pattern.rows),
                                       derived_seed(pattern.seed, part)));
}

/// 1 less what the variation takes off in that cell.
Real cell_shade(Pattern pattern, Real cell_x, Real cell_y) {
    return 1.0f - pattern.variation * cell_value(pattern, cell_x, cell_y, 7);
}

/// A ramp of 0..1 across a cell that falls back to 0 within a texel.
Real wrapped_ramp(Real t, Real texel) {
    return min(t, (1.0f - t) / max(texel, 1e-4f));
}

/// From 0 to 1 across each cell.
Real linear_gradient(Pattern pattern, Real2 position) {
    return wrapped_ramp(fract(position.x), Real(pattern.footprint));
}

/// 1 in the middle of each cell, 0 from its border on.
Real radial_gradient(Pattern pattern, Real2 position) {
    Real2 from_middle = fract(position) - Real2(0.5f, 0.5f);
    return max(1.0f - 2.0f * sqrt(dot(from_middle, from_middle)), 0.0f);
}

/// Once around the middle of each cell, from 0 to 1.
Real angular_gradient(Pattern pattern, Real2 position) {
    Real2 from_middle = fract(position) - Real2(0.5f, 0.5f);
    Real turn = atan2_poly(from_middle.y, from_middle.x) * (0.5f / PI) + 0.5f;
    Real radius = sqrt(dot(from_middle, from_middle));
    return wrapped_ramp(turn, pattern.footprint * (0.5f / PI) / max(radius, 1e-4f));
}

/// +1 in even cells, -1 in odd ones, with soft borders.
Real alternating(Pattern pattern, Real t) {
    Real cell = floor(t);
    Real inside = 0.5f - abs(t - cell - 0.5f);
    Real height = clamp(2.0f * inside / edge_width(pattern), 0.0f, 1.0f);
    return height * (1.0f - 2.0f * odd(cell));
}

/// Squares of 0 and 1 in turn.
Real checker(Pattern pattern, Real2 position) {
    return 0.5f + 0.5f * alternating(pattern, position.x) * alternating(pattern, position.y);
}

/// Upright stripes, `width` of each cell.
Real stripes(Pattern pattern, Real2 position) {
    Real cell = floor(position.x);
    Real inside = 0.5f * pattern.width - abs(position.x - cell - 0.5f);
    return soft_edge(inside, edge_width(pattern)) * cell_shade(pattern, cell, Real(0.0f));
}

/// The height of a block with rounded edges: 0 in the gap, 1 from `softness` inside the edge on.
/// x, y: from the middle of the block, in row heights; half_x, half_y: half its sides.
Real rounded_block(Pattern pattern, Real x, Real y, float half_x, float half_y) {
    float bevel = max(edge_width(pattern), 0.02f);
    float gap = 0.1f * pattern.width;
    Real dx = max(abs(x) - (half_x - gap - bevel), 0.0f);
    Real dy = max(abs(y) - (half_y - gap - bevel), 0.0f);
    return smoothstep(0.0f, 1.0f, 1.0f - sqrt(dx * dx + dy * dy) / bevel);
}

/// Bricks: every second row is moved by half a brick. 0 in the mortar; `width` is that of the gaps.
Real bricks(Pattern pattern, Real2 position) {
    Real row = floor(position.y);
    Real x = position.x + 0.5f * odd(row);
    Real column = floor(x);
    float aspect = float(pattern.rows) / float(pattern.columns);
    Real block = rounded_block(pattern, (x - column - 0.5f) * aspect, position.y - row - 0.5f,
                               0.5f * aspect, 0.5f);
    return block * cell_shade(pattern, column, row);
}

/// Square tiles; 0 in the joints.
Real tiles(Pattern pattern, Real2 position) {
    Real2 cell = floor(position);
    Real block = rounded_block(pattern, position.x - cell.x - 0.5f, position.y - cell.y - 0.5f,
                               0.5f, 0.5f);
    return block * cell_shade(pattern, cell.x, cell.y);
}

/// How far inside the hexagon around (middle_x, row) the place is; rows are sqrt(3)/2 apart.
Real inside_hexagon(Real x, Real y, Real middle_x, Real row) {
    Real dx = abs(x - middle_x);
    Real dy = abs(y - row) * 0.866025404f;
    return 0.5f - max(dx, 0.5f * dx + 0.866025404f * dy);
}

/// Hexagons that stand on a corner; 0 in the joints. There are some 1.15 rows for each column.
Real hexagons(Pattern pattern, Real2 position) {
    Real row_above = floor(position.y);
    Real row_below = row_above + 1.0f;
    Real shift_above = 0.5f * odd(row_above);
    Real shift_below = 0.5f - shift_above;
    Real x_above = floor(position.x - shift_above + 0.5f) + shift_above;
    Real x_below = floor(position.x - shift_below + 0.5f) + shift_below;
    Real above = inside_hexagon(position.x, position.y, x_above, row_above);
    Real below = inside_hexagon(position.x, position.y, x_below, row_below);
    Real inside = max(above, below) - 0.1f * pattern.width;
    Real block = smoothstep(0.0f, 1.0f, inside / max(edge_width(pattern), 0.02f));
    Real row = select(above >= below, row_above, row_below);
    Real column = floor(select(above >= below, x_above, x_below));
    return block * cell_shade(pattern, column, row);
}

/// The height of a thread: `across` from its middle line, -0.5..0.5; `level` 0..1 where it goes over
/// and under.
Real thread(Pattern pattern, Real across, Real level) {
    float half_width = 0.25f + 0.25f * pattern.width;
    Real t = across * (1.0f / half_width);
    Real arch = max(1.0f - t * t, 0.0f);
    Real cover = clamp((half_width - abs(across)) / max(pattern.footprint, 1e-4f) + 0.5f, 0.0f, 1.0f);
    return cover * (0.35f + 0.65f * sqrt(arch)) * (0.45f + 0.55f * level);
}

/// A plain weave: threads that go over and under each other in turn. 0 where none is.
Real weave(Pattern pattern, Real2 position) {
    Real2 cell = floor(position);
    Real x = position.x - cell.x - 0.5f;
    Real y = position.y - cell.y - 0.5f;
    Real over = 1.0f - 2.0f * odd(cell.x + cell.y);
    Real level_x = 0.5f + 0.5f * over * (1.0f - 4.0f * x * x);
    Real level_y = 0.5f - 0.5f * over * (1.0f - 4.0f * y * y);
    Real weft = thread(pattern, y, level_x) * cell_shade(pattern, Real(0.0f), cell.y);
    Real warp = thread(pattern, x, level_y) * cell_shade(pattern, cell.x, Real(1.0f));
    return max(weft, warp);
}

/// Eight of a hash's bits as a number in 0..1.
Real byte_from_hash(Uint hash, int first_bit) {
    return Real(Int((hash >> first_bit) & 0xffu)) * 0.00392156863f;  // 1/255
}

/// The cells around a place, wrapped, and the way from the place to the corner of its own.
struct Surroundings {
    Int x0, x1, x2;
    Int y0, y1, y2;
    Real x, y;
};
Surroundings surroundings(Pattern pattern, Real2 position) {
    Real2 cell = floor(position);
    Surroundings around;
    around.x1 = wrapped_cell(cell.x, pattern.columns);
    around.y1 = wrapped_cell(cell.y, pattern.rows);
    around.x0 = previous_cell(around.x1, pattern.columns);
    around.x2 = next_cell(around.x1, pattern.columns);
    around.y0 = previous_cell(around.y1, pattern.rows);
    around.y2 = next_cell(around.y1, pattern.rows);
    around.x = cell.x - position.x;
    around.y = cell.y - position.y;
    return around;
}

/// The spot of one cell; x, y: from the sought point to the cell's corner.
Real spot(Pattern pattern, Int cell_x, Int cell_y, Real x, Real y) {
    Uint hash = lattice_hash(cell_x, cell_y, pattern.seed);
    Real dx = x + 0.5f + pattern.variation * (byte_from_hash(hash, 24) - 0.5f);
    Real dy = y + 0.5f + pattern.variation * (byte_from_hash(hash, 16) - 0.5f);
    Real size = 1.0f - pattern.variation * byte_from_hash(hash, 8);
    return 0.5f * pattern.width * size - sqrt(dx * dx + dy * dy);
}

/// How far inside the nearest spot of a row of three cells.
Real spots_of_row(Pattern pattern, Surroundings around, Int cell_y, Real y) {
    Real before = spot(pattern, around.x0, cell_y, around.x - 1.0f, y);
    Real here = spot(pattern, around.x1, cell_y, around.x, y);
    Real after = spot(pattern, around.x2, cell_y, around.x + 1.0f, y);
    return max(max(before, here), after);
}

/// Round spots, one for each cell, of 1 on 0; variation scatters them and makes some small.
Real spots(Pattern pattern, Real2 position) {
    Surroundings around = surroundings(pattern, position);
    Real above = spots_of_row(pattern, around, around.y0, around.y - 1.0f);
    Real here = spots_of_row(pattern, around, around.y1, around.y);
    Real below = spots_of_row(pattern, around, around.y2, around.y + 1.0f);
    return soft_edge(max(max(above, here), below), edge_width(pattern));
}

/// The hashes of 3 x 3 cells, row by row.
struct NineHashes {
    Uint of[9];
};

/// The scratches of the 3 x 3 cells around a place, row by row: the middle of each (from a quarter
/// inside the corner of its own cell), its direction, half its length squared, and how strong it is.
struct Scratches {
    Real middle_x[9];
    Real middle_y[9];
    Real cosine[9];
    Real sine[9];
    Real reach[9];
    Real strength[9];
};
Scratches scratches_around(Pattern pattern, Real2 cell, uint seed) {
    Surroundings around = surroundings(pattern, cell);
    NineHashes hashes;
    hashes.of[0] = lattice_hash(around.x0, around.y0, seed);
    hashes.of[1] = lattice_hash(around.x1, around.y0, seed);
    hashes.of[2] = lattice_hash(around.x2, around.y0, seed);
    hashes.of[3] = lattice_hash(around.x0, around.y1, seed);
    hashes.of[4] = lattice_hash(around.x1, around.y1, seed);
    hashes.of[5] = lattice_hash(around.x2, around.y1, seed);
    hashes.of[6] = lattice_hash(around.x0, around.y2, seed);
    hashes.of[7] = lattice_hash(around.x1, around.y2, seed);
    hashes.of[8] = lattice_hash(around.x2, around.y2, seed);
    Scratches scratches;
    for (int i = 0; i < 9; ++i) {
        Real strength = byte_from_hash(hashes.of[i], 0);
        // A direction within the spread, its sine by a parabola: exact where it counts, at 0 and 90.
        Real angle = (byte_from_hash(hashes.of[i], 8) - 0.5f) * pattern.variation;  // of half a turn
        Real sine = 4.0f * angle * (1.0f - abs(angle));
        // Never longer than the cells around reach.
        Real half_length = 0.25f + 0.75f * strength;
        scratches.middle_x[i] = 0.5f * byte_from_hash(hashes.of[i], 24);
        scratches.middle_y[i] = 0.5f * byte_from_hash(hashes.of[i], 16);
        scratches.cosine[i] = sqrt(1.0f - sine * sine);
        scratches.sine[i] = sine;
        scratches.reach[i] = half_length * half_length;
        scratches.strength[i] = 0.3f + 0.7f * strength;
    }
    return scratches;
}

/// The strongest scratch at a place.
Real scratches_between(Pattern pattern, Scratches scratches, NoisePlace place) {
    float texel = max(pattern.footprint, 1e-4f);
    // Nothing is seen from there on, whatever the taper.
    float beyond = 0.04f * pattern.width + 0.51f * texel;
    Real most = 0.0f;
    for (int i = 0; i < 9; ++i) {
        Real x = place.cell.x - place.position.x + float(i % 3 - 1) + 0.25f + scratches.middle_x[i];
        Real y = place.cell.y - place.position.y + float(i / 3 - 1) + 0.25f + scratches.middle_y[i];
        Real along = x * scratches.cosine[i] + y * scratches.sine[i];
        Real across = abs(y * scratches.cosine[i] - x * scratches.sine[i]);
        if (any_lane(across < beyond)) {
            Real taper = max(1.0f - (along * along) / scratches.reach[i], 0.0f);
            // Thinner than a texel, a line is as faint as the share of the texel that it covers.
            Real half_width = 0.04f * pattern.width * taper;
            Real cover = clamp((half_width - across) * (1.0f / texel) + 0.5f, 0.0f, 1.0f) *
                         min(half_width * (2.0f / texel), 1.0f);
            most = max(most, cover * scratches.strength[i]);
        }
    }
    return most;
}

/// Which seed a layer of scratches has, and how many layers there are.
uint scratches_seed(Pattern pattern, int layer) {
    return derived_seed(pattern.seed, layer);
}
int scratches_layers(Pattern pattern) {
    return pattern.octaves < 2 ? 1 : 2;
}

/// Straight scratches of 1 on 0, one or (two octaves and more) two for each cell: all along x
/// without variation, in any direction with it.
Real scratches(Pattern pattern, Real2 position) {
    NoisePlace place = noise_place(position);
    Real most = 0.0f;
    for (int layer = 0; layer < scratches_layers(pattern); ++layer)
        most = max(most, scratches_between(pattern,
                                           scratches_around(pattern, place.cell,
                                                            scratches_seed(pattern, layer)),
                                           place));
    return most;
}

/// A Perlin noise beside a pattern: where it looks, in cells of its own.
struct SideNoise {
    float scale_x;  // its cells for each of the pattern's
    float scale_y;
    int period_x;
    int period_y;
    uint seed;
};
SideNoise side_noise(float scale_x, float scale_y, int period_x, int period_y, uint seed) {
    SideNoise side;
    side.scale_x = scale_x;
    side.scale_y = scale_y;
    side.period_x = period_x;
    side.period_y = period_y;
    side.seed = seed;
    return side;
}
Real side_noise_value(SideNoise side, Real2 position) {
    return perlin_noise_xy(Real2(position.x * side.scale_x, position.y * side.scale_y),
                           side.period_x, side.period_y, side.seed);
}

/// How far it is to the border of a random cell, of which the feature points are given.
Real border_between(FeaturePoints points, NoisePlace place) {
    return feature_border_distance(nearest_features(points, place));
}

/// What makes cracks thin out.
SideNoise cracks_slow(Pattern pattern) {
    return side_noise(1.0f, 1.0f, pattern.columns, pattern.columns,
                      derived_seed(pattern.seed, 3));
}

/// Cracks from the distance to the border of a cell and that noise.
Real cracks_of(Pattern pattern, Real border_distance, Real slow) {
    Real thin = 1.0f - pattern.variation * slow * 1.6f;
    Real half_width = 0.12f * pattern.width * max(thin, 0.0f);
    float texel = edge_width(pattern) * 0.25f + pattern.footprint;
    Real cover = clamp((half_width - border_distance) / texel + 0.5f, 0.0f, 1.0f);
    return cover * min(2.0f * half_width / texel, 1.0f);
}

/// Cracks along the borders of random cells, of 1 on 0; variation makes them thin out in places.
Real cracks(Pattern pattern, Real2 position) {
    NoisePlace place = noise_place(position);
    FeaturePoints points = feature_points(place.cell, pattern.columns, pattern.seed);
    return cracks_of(pattern, border_between(points, place),
                     side_noise_value(cracks_slow(pattern), position));
}

/// What bends the year rings: a slow noise, `octave` 0, and one of twice its frequency.
SideNoise wood_bend(Pattern pattern, int octave) {
    int bends_y = pattern.rows < 8 ? 1 : pattern.rows / 4;
    int bends_x = pattern.columns < 8 ? 1 : pattern.columns / 4;
    return side_noise(float(bends_x << octave) / float(pattern.columns),
                      float(bends_y << octave) / float(pattern.rows), bends_x << octave,
                      bends_y << octave, derived_seed(pattern.seed, 1 + octave));
}
SideNoise wood_fibre(Pattern pattern) {
    return side_noise(1.0f, 8.0f, pattern.columns, pattern.rows * 8,
                      derived_seed(pattern.seed, 4));
}
/// How much of the fibres is shown.
float wood_fibre_shown(Pattern pattern) {
    return octave_visibility(pattern.footprint * 8.0f);
}

/// The width of a texel among the rings: the bend makes them denser in places, by at most some four
/// times.
float ring_texel(Pattern pattern) {
    return max(pattern.footprint * (1.0f + 3.0f * pattern.variation), 1e-4f);
}
Shown rings_shown(Pattern pattern) {
    return shown_about(0.25f, octave_visibility(ring_texel(pattern)));
}

/// Year rings from the values of those noises.
Real wood_rings_of(Pattern pattern, Real2 position, Real slow, Real faster, Real fibre) {
    Real bend = slow - 0.5f + 0.25f * (faster - 0.5f);
    Real ring = position.y + pattern.variation * 6.0f * bend;
    Real year = ring - floor(ring);
    float fall = max(pattern.softness, ring_texel(pattern));
    Real value = min(year * year * (0.35f + 0.65f * year), (1.0f - year) / fall);
    value = faded_pattern(rings_shown(pattern), value);
    return clamp(value + wood_fibre_shown(pattern) * 0.35f * (fibre - 0.5f), 0.0f, 1.0f);
}

/// The year rings of a board, sawn along x: slowly darker (towards 1) through each year, then light
/// again at once; with fibres. The warp of the board grows with the variation.
Real wood_rings(Pattern pattern, Real2 position) {
    return wood_rings_of(pattern, position, side_noise_value(wood_bend(pattern, 0), position),
                         side_noise_value(wood_bend(pattern, 1), position),
                         side_noise_value(wood_fibre(pattern), position));
}

/// What bends the veins of marble.
SideNoise marble_bend(Pattern pattern) {
    int bends = pattern.columns < 4 ? 1 : pattern.columns / 2;
    float scale = float(bends) / float(pattern.columns);
    return side_noise(scale, scale, bends, bends, derived_seed(pattern.seed, 2));
}

/// How fast a vein falls off from its middle: narrow ones fast.
float vein_fall(Pattern pattern) {
    return 1.0f / (0.1f + 0.9f * pattern.width);
}
Shown veins_shown(Pattern pattern) {
    return shown_about(0.333f / vein_fall(pattern),
                       octave_visibility(pattern.footprint * (1.0f + 3.0f * pattern.variation)));
}

/// Marble from that noise and from turbulence.
Real marble_of(Pattern pattern, Real2 position, Real slow, Real fray) {
    Real bend = slow - 0.5f;
    Real t = position.x + pattern.variation * (3.0f * bend + 1.5f * fray);
    Real ridge = abs(2.0f * fract(t) - 1.0f);
    Real vein = clamp(1.0f - (1.0f - ridge) * vein_fall(pattern), 0.0f, 1.0f);
    return faded_pattern(veins_shown(pattern), vein * vein);
}

/// Octaves of a noise beside a pattern.
struct SideOctaves {
    int kind;     // NOISE_...
    float scale;  // cells of its first octave for each of the pattern's
    uint seed;
    int octaves;
    float gain;
};
SideOctaves side_octaves(int kind, float scale, uint seed, int octaves, float gain) {
    SideOctaves side;
    side.kind = kind;
    side.scale = scale;
    side.seed = seed;
    side.octaves = octaves;
    side.gain = gain;
    return side;
}
int side_period(SideOctaves side, Pattern pattern) {
    return int(float(pattern.columns) * side.scale);
}
Real side_octaves_value(SideOctaves side, Pattern pattern, Real2 position) {
    return fbm(side.kind, position * side.scale, side_period(side, pattern), side.seed,
               side.octaves, side.gain, pattern.footprint * side.scale);
}

SideOctaves marble_fray(Pattern pattern) {
    return side_octaves(NOISE_TURBULENCE, 1.0f, derived_seed(pattern.seed, 1), pattern.octaves,
                        0.5f);
}

/// Marble: veins of 1 along y, bent by slow noise and frayed by turbulence, the more, the greater
/// the variation. Layers moved by turbulence: Ken Perlin, "An image synthesizer", SIGGRAPH 1985.
Real marble(Pattern pattern, Real2 position) {
    return marble_of(pattern, position, side_noise_value(marble_bend(pattern), position),
                     side_octaves_value(marble_fray(pattern), pattern, position));
}

SideOctaves grunge_clouds(Pattern pattern) {
    return side_octaves(NOISE_PERLIN, 1.0f, pattern.seed, pattern.octaves, 0.65f);
}
SideOctaves grunge_pores(Pattern pattern) {
    return side_octaves(NOISE_WORLEY, 2.0f, derived_seed(pattern.seed, 11), 1, 0.5f);
}
SideOctaves grunge_veins(Pattern pattern) {
    return side_octaves(NOISE_RIDGED, 1.0f, derived_seed(pattern.seed, 12), 3, 0.6f);
}

/// Grunge from those.
Real grunge_of(Pattern pattern, Real clouds, Real pores, Real veins) {
    Real value = 0.5f + 2.2f * (clouds - 0.5f) + pattern.variation * (0.9f * (pores - 0.43f) -
                                                                      0.7f * (veins - 0.55f));
    return clamp(value, 0.0f, 1.0f);
}

/// Grunge: blots, grain and pores of use and dirt, blended.
Real grunge(Pattern pattern, Real2 position) {
    return grunge_of(pattern, side_octaves_value(grunge_clouds(pattern), pattern, position),
                     side_octaves_value(grunge_pores(pattern), pattern, position),
                     side_octaves_value(grunge_veins(pattern), pattern, position));
}

/// About the mean of a pattern of cells, to which it fades where they are too small to be shown: a
/// test holds it to within 0.09.
float pattern_mean(Pattern pattern) {
    float shade = 1.0f - 0.5f * pattern.variation;
    float edge = 0.2f * pattern.width + pattern.softness;
    float inside = max(1.0f - edge, 0.0f);
    if (pattern.kind == PATTERN_GRADIENT_RADIAL) return 0.2618f;
    if (pattern.kind == PATTERN_STRIPES) return pattern.width * shade;
    if (pattern.kind == PATTERN_BRICKS)
        return shade * inside *
               max(1.0f - edge * float(pattern.columns) / float(pattern.rows), 0.0f);
    if (pattern.kind == PATTERN_TILES || pattern.kind == PATTERN_HEXAGONS)
        return shade * inside * inside;
    if (pattern.kind == PATTERN_WEAVE) return 0.72f * shade;
    if (pattern.kind == PATTERN_SPOTS)
        return 0.785398163f * pattern.width * pattern.width * shade * shade;
    if (pattern.kind == PATTERN_SCRATCHES) return 0.043f * pattern.width;
    if (pattern.kind == PATTERN_CRACKS) return 0.36f * pattern.width * shade;
    return 0.5f;
}

/// The two noises that bend a place, of the pattern's own period.
SideNoise warp_x(Pattern pattern) {
    return side_noise(1.0f, 1.0f, pattern.columns, pattern.rows, derived_seed(pattern.seed, 21));
}
SideNoise warp_y(Pattern pattern) {
    return side_noise(1.0f, 1.0f, pattern.columns, pattern.rows, derived_seed(pattern.seed, 22));
}
/// The place bent by them.
Real2 warped_by(Pattern pattern, Real2 position, Real2 noise) {
    float reach = 2.0f * pattern.warp * octave_visibility(pattern.footprint);
    return Real2(position.x + reach * (noise.x - 0.5f), position.y + reach * (noise.y - 0.5f));
}

/// The place bent by a noise of the same period: domain warp, after Perlin, 1985. Unbent where the
/// warp is 0.
Real2 warped_position(Pattern pattern, Real2 position) {
    if (pattern.warp == 0.0f) return position;
    return warped_by(pattern, position,
                     Real2(side_noise_value(warp_x(pattern), position),
                           side_noise_value(warp_y(pattern), position)));
}

/// The pattern of cells at a place that is bent already, whatever a texel can show.
Real sharp_pattern(Pattern pattern, Real2 position) {
    if (pattern.kind == PATTERN_GRADIENT_LINEAR) return linear_gradient(pattern, position);
    if (pattern.kind == PATTERN_GRADIENT_RADIAL) return radial_gradient(pattern, position);
    if (pattern.kind == PATTERN_GRADIENT_ANGULAR) return angular_gradient(pattern, position);
    if (pattern.kind == PATTERN_CHECKER) return checker(pattern, position);
    if (pattern.kind == PATTERN_STRIPES) return stripes(pattern, position);
    if (pattern.kind == PATTERN_BRICKS) return bricks(pattern, position);
    if (pattern.kind == PATTERN_TILES) return tiles(pattern, position);
    if (pattern.kind == PATTERN_HEXAGONS) return hexagons(pattern, position);
    if (pattern.kind == PATTERN_WEAVE) return weave(pattern, position);
    if (pattern.kind == PATTERN_SPOTS) return spots(pattern, position);
    if (pattern.kind == PATTERN_SCRATCHES) return scratches(pattern, position);
    return cracks(pattern, position);
}

/// The same of octaves: they vary independently, so what is left of their deviation is the root of
/// what is left of their squares.
Shown octaves_shown(int kind, int octaves, float gain, float footprint) {
    float whole = 0.0f;
    float left = 0.0f;
    Octave octave = first_octave(footprint);
    for (int i = 0; i < octaves; ++i) {
        whole = whole + octave.strength * octave.strength;
        left = left + octave.shown * octave.shown;
        octave = next_octave(octave, gain, footprint);
    }
    return shown_about(noise_mean(kind), sqrt(left / whole));
}

/// What `pattern_at` shows of a pattern.
Shown pattern_shown(Pattern pattern) {
    if (pattern.kind < PATTERN_GRADIENT_LINEAR)
        return octaves_shown(pattern.kind, pattern.octaves, 0.5f, pattern.footprint);
    if (pattern.kind == PATTERN_WOOD_RINGS) return rings_shown(pattern);
    if (pattern.kind == PATTERN_MARBLE) return veins_shown(pattern);
    if (pattern.kind == PATTERN_GRUNGE) {
        SideOctaves clouds = grunge_clouds(pattern);
        return octaves_shown(clouds.kind, clouds.octaves, clouds.gain, pattern.footprint);
    }
    return shown_about(pattern_mean(pattern), octave_visibility(pattern.footprint));
}
// Contrast and ramp come after the pattern. A value that has faded would pass them as another: what
// lies on both sides of a threshold, faded, lies on one. So the value is spread again to the
// deviation that the whole pattern has, and what contrast and ramp make of it fades to the mean of
// what they make of the whole pattern. So every resolution shows the same on the whole.

/// A value that has faded, spread again; the mean where nothing of it is shown.
Real spread_pattern(Shown shown, Real value) {
    if (shown.share == 1.0f) return value;
    float spread = 1.0f / max(shown.share, 1e-3f);
    return clamp(shown.mean + (value - shown.mean) * spread, 0.0f, 1.0f);
}
/// What contrast and ramp made of it, faded to the mean of what they make of the whole pattern.
Real faded_result(Shown shown, Real value, float mean) {
    if (shown.share == 1.0f) return value;
    return mean + (value - mean) * shown.share;
}

/// A bend makes the pattern denser in places, and a texel wider in it.
Pattern bent_pattern(Pattern pattern) {
    Pattern bent = pattern;
    bent.footprint = pattern.footprint * (1.0f + 2.0f * pattern.warp);
    return bent;
}

/// A noise or pattern at a place that is bent already.
Real pattern_at(Pattern pattern, Real2 place) {
    if (pattern.kind < PATTERN_GRADIENT_LINEAR)
        return fbm(pattern.kind, place, pattern.columns, pattern.seed, pattern.octaves, 0.5f,
                   pattern.footprint);
    if (pattern.kind == PATTERN_WOOD_RINGS) return wood_rings(pattern, place);
    if (pattern.kind == PATTERN_MARBLE) return marble(pattern, place);
    if (pattern.kind == PATTERN_GRUNGE) return grunge(pattern, place);
    Shown shown = pattern_shown(pattern);
    if (shown.share == 0.0f) return Real(shown.mean);
    return faded_pattern(shown, sharp_pattern(bent_pattern(pattern), place));
}

/// A noise or pattern, 0..1. position: in cells, |position| < 2^20.
Real pattern_value(Pattern pattern, Real2 position) {
    return pattern_at(pattern, warped_position(pattern, position));
}

#endif
