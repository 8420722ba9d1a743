// SPDX-License-Identifier: MIT
#ifndef SHARED_NOISE_GLSL
#define SHARED_NOISE_GLSL

#include "shared/sequence.glsl"

// Noises on a lattice of unit cells, 0..1, tiling after `period` cells in x and in y. The lattice
// is hashed in integers, so that a seed gives the same noise on every machine; seeds are unrelated.
//
// position: in cells, |position| < 2^20; period: 1 to 2^20 whole cells.

const int NOISE_VALUE = 0;
const int NOISE_PERLIN = 1;
const int NOISE_WORLEY = 2;
const int NOISE_SIMPLEX = 3;
const int NOISE_RIDGED = 4;
const int NOISE_TURBULENCE = 5;
const int NOISE_WORLEY_F2 = 6;
const int NOISE_WORLEY_EDGES = 7;
const int NOISE_CELLS = 8;

/// A cell coordinate wrapped into 0..period-1, for `cell` a whole number.
Int wrapped_cell(Real cell, int period) {
    float size = float(period);
    Real wrapped = cell - size * floor(cell * (1.0f / size));
    // The product may round across a whole number, which leaves one period too many or too few.
    wrapped = select(wrapped >= size, wrapped - size, wrapped);
    wrapped = select(wrapped < 0.0f, wrapped + size, wrapped);
    return Int(wrapped);
}

/// The next cell of a wrapped one, wrapped.
Int next_cell(Int cell, int period) {
    Int next = cell + 1;
    return select(next == Int(period), Int(0), next);
}

/// The cell before a wrapped one, wrapped.
Int previous_cell(Int cell, int period) {
    return select(cell == Int(0), Int(period - 1), cell - 1);
}

/// 32 well-mixed bits of a lattice point: the coordinates spread by odd constants, then the
/// finaliser "lowbias32" (Chris Wellons, "Prospecting for hash functions", 2018), of which every
/// input bit flips every output bit with a probability near one half.
Uint lattice_hash(Int x, Int y, uint seed) {
    Uint h = Uint(x) * 0x9e3779b1u + (Uint(y) * 0x85ebca77u ^ Uint(seed));
    h = h ^ (h >> 16);
    h = h * 0x7feb352du;
    h = h ^ (h >> 15);
    h = h * 0x846ca68bu;
    return h ^ (h >> 16);
}

/// The seed of an octave or another independent part of a noise.
uint derived_seed(uint seed, int part) {
    uint h = seed ^ (uint(part) * 0x9e3779b1u);
    h = (h ^ (h >> 16)) * 0x7feb352du;
    return h ^ (h >> 15);
}

/// Perlin's fade 6t^5 - 15t^4 + 10t^3: first and second derivatives are 0 at 0 and 1.
/// Ken Perlin, "Improving noise", SIGGRAPH 2002.
Real quintic_fade(Real t) {
    return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f);
}

/// Where a noise looks: the place in its own coordinates, and the corner of the cell that it lies in.
/// All that is random about a noise hangs on the cell: who walks along a row need hash each cell
/// once. So noises come in two parts, the corners of a cell and the value between them.
struct NoisePlace {
    Real2 position;
    Real2 cell;
};
NoisePlace noise_place(Real2 position) {
    NoisePlace place;
    place.position = position;
    place.cell = floor(position);
    return place;
}

/// The hashes of the four corners of a cell: column, then row.
struct CornerHashes {
    Uint h00, h10, h01, h11;
};
CornerHashes corner_hashes(Real2 cell, int period_x, int period_y, uint seed) {
    Int x0 = wrapped_cell(cell.x, period_x);
    Int y0 = wrapped_cell(cell.y, period_y);
    Int x1 = next_cell(x0, period_x);
    Int y1 = next_cell(y0, period_y);
    CornerHashes hashes;
    hashes.h00 = lattice_hash(x0, y0, seed);
    hashes.h10 = lattice_hash(x1, y0, seed);
    hashes.h01 = lattice_hash(x0, y1, seed);
    hashes.h11 = lattice_hash(x1, y1, seed);
    return hashes;
}

/// The random values at the corners of a cell.
struct ValueCorners {
    Real v00, v10, v01, v11;
};
ValueCorners value_corners(Real2 cell, int period, uint seed) {
    CornerHashes hashes = corner_hashes(cell, period, period, seed);
    ValueCorners corners;
    corners.v00 = unit_from_bits(hashes.h00);
    corners.v10 = unit_from_bits(hashes.h10);
    corners.v01 = unit_from_bits(hashes.h01);
    corners.v11 = unit_from_bits(hashes.h11);
    return corners;
}
Real value_between(ValueCorners corners, NoisePlace place) {
    Real u = quintic_fade(place.position.x - place.cell.x);
    Real v = quintic_fade(place.position.y - place.cell.y);
    Real top = corners.v00 + (corners.v10 - corners.v00) * u;
    Real bottom = corners.v01 + (corners.v11 - corners.v01) * u;
    return top + (bottom - top) * v;
}

/// Value noise: random values at lattice points, faded between. Range 0..1, mean 0.5.
Real value_noise(Real2 position, int period, uint seed) {
    NoisePlace place = noise_place(position);
    return value_between(value_corners(place.cell, period, seed), place);
}

/// One of 16 unit gradients, at 11.25 + 22.5 k degrees: none lies along the axes, where the eye would
/// find the lattice. The hash's four upper bits pick it.
Real2 lattice_gradient(Uint hash) {
    Bool steep = Uint((hash >> 28) & 1u) == Uint(1u);
    Bool swapped = Uint((hash >> 29) & 1u) == Uint(1u);
    Real a = select(steep, 0.831469612f, 0.980785280f);  // cos 33.75, cos 11.25 degrees
    Real b = select(steep, 0.555570233f, 0.195090322f);  // their sines
    Int sign_x = Int(hash & 0x80000000u);
    Int sign_y = Int((hash << 1) & 0x80000000u);
    return Real2(intBitsToFloat(floatBitsToInt(select(swapped, b, a)) ^ sign_x),
                 intBitsToFloat(floatBitsToInt(select(swapped, a, b)) ^ sign_y));
}

/// The gradients at the corners of a cell.
struct GradientCorners {
    Real2 g00, g10, g01, g11;
};
GradientCorners gradient_corners(Real2 cell, int period_x, int period_y, uint seed) {
    CornerHashes hashes = corner_hashes(cell, period_x, period_y, seed);
    GradientCorners corners;
    corners.g00 = lattice_gradient(hashes.h00);
    corners.g10 = lattice_gradient(hashes.h10);
    corners.g01 = lattice_gradient(hashes.h01);
    corners.g11 = lattice_gradient(hashes.h11);
    return corners;
}
Real perlin_between(GradientCorners corners, NoisePlace place) {
    Real x = place.position.x - place.cell.x;
    Real y = place.position.y - place.cell.y;
    Real u = quintic_fade(x);
    Real v = quintic_fade(y);
    Real n00 = corners.g00.x * x + corners.g00.y * y;
    Real n10 = corners.g10.x * (x - 1.0f) + corners.g10.y * y;
    Real n01 = corners.g01.x * x + corners.g01.y * (y - 1.0f);
    Real n11 = corners.g11.x * (x - 1.0f) + corners.g11.y * (y - 1.0f);
    Real top = n00 + (n10 - n00) * u;
    Real bottom = n01 + (n11 - n01) * u;
    // Unit gradients give at most sqrt(1/2), in the middle of a cell.
    return clamp(0.5f + 0.707106781f * (top + (bottom - top) * v), 0.0f, 1.0f);
}

/// Perlin's gradient noise. 0.5 at every lattice point; range 0..1, mean 0.5. It may tile after
/// different numbers of cells in x and in y.
/// Ken Perlin, "An image synthesizer", SIGGRAPH 1985, with the fade of 2002.
Real perlin_noise_xy(Real2 position, int period_x, int period_y, uint seed) {
    NoisePlace place = noise_place(position);
    return perlin_between(gradient_corners(place.cell, period_x, period_y, seed), place);
}

/// Perlin's noise with the same period in x and in y.
Real perlin_noise(Real2 position, int period, uint seed) {
    return perlin_noise_xy(position, period, period, seed);
}

/// Where simplex noise looks, on a lattice that is sheared to squares: `cell` is of that one. Rows of
/// triangles are a little stretched to be even in number.
NoisePlace simplex_place(Real2 position, int period) {
    int period_y = period + (period & 1);
    NoisePlace place;
    place.position =
        Real2(position.x, position.y * (float(period_y) / float(period)));
    place.cell =
        Real2(floor(place.position.x + 0.5f * place.position.y), floor(place.position.y));
    return place;
}

/// The gradients at the corners of two triangles, which share an edge: two of the upper row, and two
/// of the lower one, half a cell further left. Corners of a row have whole or half x.
GradientCorners simplex_corners(Real2 cell, int period, uint seed) {
    int period_y = period + (period & 1);
    Int x = wrapped_cell(2.0f * cell.x - cell.y, 2 * period);  // twice the upper left corner's x
    Int y0 = wrapped_cell(cell.y, period_y);
    Int y1 = next_cell(y0, period_y);
    Int after = next_cell(x, 2 * period);
    GradientCorners corners;
    corners.g00 = lattice_gradient(lattice_hash(x, y0, seed));
    corners.g10 = lattice_gradient(lattice_hash(next_cell(after, 2 * period), y0, seed));
    corners.g01 = lattice_gradient(lattice_hash(previous_cell(x, 2 * period), y1, seed));
    corners.g11 = lattice_gradient(lattice_hash(after, y1, seed));
    return corners;
}

/// What a corner of a simplex adds: its gradient's slope, fading to nothing 0.9 cells away.
/// x, y: from the corner.
Real simplex_corner(Real2 gradient, Real x, Real y) {
    Real reach = max(0.8f - x * x - y * y, 0.0f);
    reach = reach * reach;
    return reach * reach * (gradient.x * x + gradient.y * y);
}
Real simplex_between(GradientCorners corners, NoisePlace place) {
    Real px = place.position.x;
    Real py = place.position.y;
    Real fx = (px + 0.5f * py) - place.cell.x;
    Real fy = py - place.cell.y;
    Bool is_right = fx >= fy;  // which of the two triangles
    Real right = select(is_right, Real(1.0f), Real(0.0f));
    Real x0 = place.cell.x - 0.5f * place.cell.y;
    Real x1 = x0 + right - 0.5f * (1.0f - right);
    Real y1 = place.cell.y + (1.0f - right);
    Real x2 = x0 + 0.5f;
    Real y2 = place.cell.y + 1.0f;
    Real2 second = Real2(select(is_right, corners.g10.x, corners.g01.x),
                         select(is_right, corners.g10.y, corners.g01.y));
    Real sum = simplex_corner(corners.g00, px - x0, py - place.cell.y) +
               simplex_corner(second, px - x1, py - y1) +
               simplex_corner(corners.g11, px - x2, py - y2);
    // 10.9 brings the sum to -1..1 (psrdnoise).
    return clamp(0.5f + 5.45f * sum, 0.0f, 1.0f);
}

/// Simplex noise: gradients at the corners of triangles, so that no axis stands out. Range 0..1,
/// mean 0.5. Tiles at every period.
/// Stefan Gustavson and Ian McEwan, "Tiling simplex noise and flow noise in two and three
/// dimensions", JCGT 2022 (the lattice of psrdnoise).
Real simplex_noise(Real2 position, int period, uint seed) {
    NoisePlace place = simplex_place(position, period);
    return simplex_between(simplex_corners(place.cell, period, seed), place);
}

/// The feature points of the 3 x 3 cells around a place, one in each: the cell itself, those left,
/// right, above and below it, then the corners. x, y: from the corner of its own cell, 0..1.
struct FeaturePoints {
    Uint hash[9];
    Real x[9];
    Real y[9];
};

/// The upper and the lower half of a hash, 0..1, 1 excluded. Exact.
Real upper_unit(Uint hash) {
    return Real(Int(hash >> 16)) * 1.52587890625e-5f;  // 2^-16
}
Real lower_unit(Uint hash) {
    return Real(Int(hash & 0xffffu)) * 1.52587890625e-5f;
}

FeaturePoints feature_points(Real2 cell, int period, uint seed) {
    Int x1 = wrapped_cell(cell.x, period);
    Int y1 = wrapped_cell(cell.y, period);
    Int x0 = previous_cell(x1, period);
    Int x2 = next_cell(x1, period);
    Int y0 = previous_cell(y1, period);
    Int y2 = next_cell(y1, period);
    FeaturePoints points;
    points.hash[0] = lattice_hash(x1, y1, seed);
    points.hash[1] = lattice_hash(x0, y1, seed);
    points.hash[2] = lattice_hash(x2, y1, seed);
    points.hash[3] = lattice_hash(x1, y0, seed);
    points.hash[4] = lattice_hash(x1, y2, seed);
    points.hash[5] = lattice_hash(x0, y0, seed);
    points.hash[6] = lattice_hash(x2, y0, seed);
    points.hash[7] = lattice_hash(x0, y2, seed);
    points.hash[8] = lattice_hash(x2, y2, seed);
    for (int i = 0; i < 9; ++i) {
        points.x[i] = upper_unit(points.hash[i]);
        points.y[i] = lower_unit(points.hash[i]);
    }
    return points;
}

/// The squared distance to a feature point; x, y: from the sought point to the corner of its cell.
Real feature_distance_squared(Real point_x, Real point_y, Real x, Real y) {
    Real dx = point_x + x;
    Real dy = point_y + y;
    return dx * dx + dy * dy;
}

Real worley_between(FeaturePoints points, NoisePlace place) {
    Real x = place.cell.x - place.position.x;
    Real y = place.cell.y - place.position.y;
    Real left = x - 1.0f, right = x + 1.0f;
    Real up = y - 1.0f, down = y + 1.0f;
    Real here = min(min(feature_distance_squared(points.x[0], points.y[0], x, y),
                        feature_distance_squared(points.x[1], points.y[1], left, y)),
                    feature_distance_squared(points.x[2], points.y[2], right, y));
    Real above = min(min(feature_distance_squared(points.x[3], points.y[3], x, up),
                         feature_distance_squared(points.x[5], points.y[5], left, up)),
                     feature_distance_squared(points.x[6], points.y[6], right, up));
    Real below = min(min(feature_distance_squared(points.x[4], points.y[4], x, down),
                         feature_distance_squared(points.x[7], points.y[7], left, down)),
                     feature_distance_squared(points.x[8], points.y[8], right, down));
    return min(sqrt(min(min(above, here), below)), 1.0f);
}

/// Worley noise F1: the distance to the nearest of the feature points, one in each cell, held to 1.
/// Range 0..1, 0 at the points. Steven Worley, "A cellular texture basis function", SIGGRAPH 1996;
/// the 3 x 3 cells around are searched, as is usual.
Real worley_noise(Real2 position, int period, uint seed) {
    NoisePlace place = noise_place(position);
    return worley_between(feature_points(place.cell, period, seed), place);
}

/// The two nearest feature points: the distance and the place of each.
struct Features {
    Real first;   // squared distance
    Real second;  // of the next one
    Real first_x, first_y;  // from the sought point
    Real second_x, second_y;
};

/// Takes the feature point of one cell in; x, y: from the sought point to the cell's corner.
Features with_feature(Features near, Real point_x, Real point_y, Real x, Real y) {
    Real dx = point_x + x;
    Real dy = point_y + y;
    Real distance = dx * dx + dy * dy;
    Bool is_first = distance < near.first;
    Bool is_second = distance < near.second;
    Features next;
    next.second = min(near.second, max(near.first, distance));
    next.second_x = select(is_first, near.first_x, select(is_second, dx, near.second_x));
    next.second_y = select(is_first, near.first_y, select(is_second, dy, near.second_y));
    next.first = min(near.first, distance);
    next.first_x = select(is_first, dx, near.first_x);
    next.first_y = select(is_first, dy, near.first_y);
    return next;
}

/// The two nearest of the feature points around.
Features nearest_features(FeaturePoints points, NoisePlace place) {
    Real x = place.cell.x - place.position.x;
    Real y = place.cell.y - place.position.y;
    Real left = x - 1.0f, right = x + 1.0f;
    Real up = y - 1.0f, down = y + 1.0f;
    Features near;
    near.first = near.second = Real(100.0f);
    near.first_x = near.first_y = near.second_x = near.second_y = Real(0.0f);
    near = with_feature(near, points.x[0], points.y[0], x, y);
    near = with_feature(near, points.x[1], points.y[1], left, y);
    near = with_feature(near, points.x[2], points.y[2], right, y);
    near = with_feature(near, points.x[3], points.y[3], x, up);
    near = with_feature(near, points.x[4], points.y[4], x, down);
    near = with_feature(near, points.x[5], points.y[5], left, up);
    near = with_feature(near, points.x[6], points.y[6], right, up);
    near = with_feature(near, points.x[7], points.y[7], left, down);
    return with_feature(near, points.x[8], points.y[8], right, down);
}

/// The distance from the sought point to the border between the cells of the two nearest feature
/// points: to the line that is as far from one as from the other. 0 on every border. Inigo Quilez,
/// "Voronoi edges", 2012, his second way.
Real feature_border_distance(Features near) {
    Real dx = near.second_x - near.first_x;
    Real dy = near.second_y - near.first_y;
    return 0.5f * (near.second - near.first) * inversesqrt(max(dx * dx + dy * dy, 1e-8f));
}

Real worley_f2_between(FeaturePoints points, NoisePlace place) {
    return min(sqrt(nearest_features(points, place).second), 1.0f);
}

/// Worley noise F2: the distance to the second nearest feature point, held to 1. Range 0..1.
Real worley_noise_f2(Real2 position, int period, uint seed) {
    NoisePlace place = noise_place(position);
    return worley_f2_between(feature_points(place.cell, period, seed), place);
}

Real worley_edges_between(FeaturePoints points, NoisePlace place) {
    Features near = nearest_features(points, place);
    return min(sqrt(near.second), 1.0f) - min(sqrt(near.first), 1.0f);
}

/// Worley noise F2 - F1: 0 on the borders of the cells. Range 0..1. Distances are held to 1 first,
/// beyond which the 3 x 3 cells do not say which point is the second nearest.
Real worley_noise_edges(Real2 position, int period, uint seed) {
    NoisePlace place = noise_place(position);
    return worley_edges_between(feature_points(place.cell, period, seed), place);
}

/// The ways from the sought point to the feature points around, squared lengths beside.
struct FeatureWays {
    Real x[9];
    Real y[9];
    Real squared[9];
};
FeatureWays feature_ways(FeaturePoints points, NoisePlace place) {
    Real x = place.cell.x - place.position.x;
    Real y = place.cell.y - place.position.y;
    Real left = x - 1.0f, right = x + 1.0f;
    Real up = y - 1.0f, down = y + 1.0f;
    FeatureWays ways;
    ways.x[0] = points.x[0] + x;
    ways.x[1] = points.x[1] + left;
    ways.x[2] = points.x[2] + right;
    ways.x[3] = points.x[3] + x;
    ways.x[4] = points.x[4] + x;
    ways.x[5] = points.x[5] + left;
    ways.x[6] = points.x[6] + right;
    ways.x[7] = points.x[7] + left;
    ways.x[8] = points.x[8] + right;
    ways.y[0] = points.y[0] + y;
    ways.y[1] = points.y[1] + y;
    ways.y[2] = points.y[2] + y;
    ways.y[3] = points.y[3] + up;
    ways.y[4] = points.y[4] + down;
    ways.y[5] = points.y[5] + up;
    ways.y[6] = points.y[6] + up;
    ways.y[7] = points.y[7] + down;
    ways.y[8] = points.y[8] + down;
    for (int i = 0; i < 9; ++i)
        ways.squared[i] = ways.x[i] * ways.x[i] + ways.y[i] * ways.y[i];
    return ways;
}

/// The random number of a feature point's cell.
Real feature_value(Uint hash) {
    return unit_from_bits(hash * 0x9e3779b1u);
}

Real cells_between(FeaturePoints points, NoisePlace place, float footprint) {
    FeatureWays ways = feature_ways(points, place);
    Real first = ways.squared[0];
    Real second = 100.0f;
    Uint own = points.hash[0];
    for (int i = 1; i < 9; ++i) {
        own = select(ways.squared[i] < first, points.hash[i], own);
        second = min(second, max(first, ways.squared[i]));
        first = min(first, ways.squared[i]);
    }
    // The border is at least half of what the second point is farther away than the first; from
    // half a footprint on the cell has the texel to itself.
    if (!any_lane(sqrt(second) - sqrt(first) < 1.01f * footprint + 1e-3f))
        return feature_value(own);
    Uint next = points.hash[0];
    Features near;
    near.first = first;
    near.second = second;
    near.first_x = near.second_x = ways.x[0];
    near.first_y = near.second_y = ways.y[0];
    for (int i = 1; i < 9; ++i) {
        Bool is_first = ways.squared[i] == first;
        Bool is_second = ways.squared[i] == second;
        near.first_x = select(is_first, ways.x[i], near.first_x);
        near.first_y = select(is_first, ways.y[i], near.first_y);
        near.second_x = select(is_second, ways.x[i], near.second_x);
        near.second_y = select(is_second, ways.y[i], near.second_y);
        next = select(is_second, points.hash[i], next);
    }
    Real share = clamp(0.5f - feature_border_distance(near) / max(footprint, 1e-4f), 0.0f, 0.5f);
    return mix(feature_value(own), feature_value(next), share);
}

/// A random number for each cell of Worley's noise, 0..1, mean 0.5. Borders are as soft as the
/// footprint (the width of a texel in cells), where two cells share a texel.
Real cell_noise(Real2 position, int period, uint seed, float footprint) {
    NoisePlace place = noise_place(position);
    return cells_between(feature_points(place.cell, period, seed), place, footprint);
}

/// How far a noise of 0..1 is from its middle, 0..1: the octaves of turbulence (Perlin, 1985).
Real folded(Real noise) {
    return abs(noise + noise - 1.0f);
}

/// A ridge where a noise of 0..1 is in its middle: the octaves of ridged noise. F. Kenton Musgrave,
/// in "Texturing and Modeling", 1994, without the feedback.
Real ridged(Real noise) {
    Real ridge = 1.0f - folded(noise);
    return ridge * ridge;
}

/// The noise of a kind NOISE_...
Real noise(int kind, Real2 position, int period, uint seed, float footprint) {
    if (kind == NOISE_VALUE) return value_noise(position, period, seed);
    if (kind == NOISE_PERLIN) return perlin_noise(position, period, seed);
    if (kind == NOISE_WORLEY) return worley_noise(position, period, seed);
    if (kind == NOISE_SIMPLEX) return simplex_noise(position, period, seed);
    if (kind == NOISE_TURBULENCE) return folded(perlin_noise(position, period, seed));
    if (kind == NOISE_WORLEY_F2) return worley_noise_f2(position, period, seed);
    if (kind == NOISE_WORLEY_EDGES) return worley_noise_edges(position, period, seed);
    if (kind == NOISE_CELLS) return cell_noise(position, period, seed, footprint);
    return ridged(perlin_noise(position, period, seed));
}

/// The mean of a kind of noise, to which detail fades that is too small to be shown. A test
/// holds it to within 0.01 of a picture's.
float noise_mean(int kind) {
    if (kind == NOISE_WORLEY) return 0.4295f;
    if (kind == NOISE_RIDGED) return 0.595f;
    if (kind == NOISE_TURBULENCE) return 0.2487f;
    if (kind == NOISE_WORLEY_F2) return 0.6958f;
    if (kind == NOISE_WORLEY_EDGES) return 0.266f;
    return 0.5f;
}

/// How much of an octave is shown when a texel is `footprint` cells wide: all while a cell covers
/// four texels, nothing from two texels down, where it would alias.
float octave_visibility(float footprint) {
    return clamp(2.0f - 4.0f * footprint, 0.0f, 1.0f);
}

/// One octave of a sum: how often the first one's cells fit into its own, its part of the sum, and
/// how much of that is shown.
struct Octave {
    float frequency;
    float strength;
    float shown;
};
Octave first_octave(float footprint) {
    Octave octave;
    octave.frequency = 1.0f;
    octave.strength = 1.0f;
    octave.shown = octave_visibility(footprint);
    return octave;
}
Octave next_octave(Octave octave, float gain, float footprint) {
    Octave next;
    next.frequency = octave.frequency * 2.0f;
    next.strength = octave.strength * gain;
    next.shown = next.strength * octave_visibility(footprint * next.frequency);
    return next;
}

/// A sum of octaves with one more, `value`, of a noise of that mean.
Real with_octave(Real sum, Octave octave, float mean, Real value) {
    return sum + octave.shown * (value - mean) + octave.strength * mean;
}

/// Fractional Brownian motion: octaves of a noise, each of twice the frequency and `gain` times the
/// strength of the one before, as their weighted mean. Range 0..1; with one octave it is the noise.
/// footprint: the width of a texel in cells of the first octave (0: show everything); octaves that
/// are too fine fade to their mean, so that every resolution shows the same noise, only sharper.
/// Tiles as the first octave does. B. Mandelbrot and J. Van Ness, 1968; octaves after Perlin, 1985.
Real fbm(int kind, Real2 position, int period, uint seed, int octaves, float gain,
         float footprint) {
    float total = 0.0f;
    float mean = noise_mean(kind);
    Octave octave = first_octave(footprint);
    Real sum = 0.0f;
    for (int i = 0; i < octaves; ++i) {
        Real value = mean;
        if (octave.shown > 0.0f)
            value = noise(kind, position * octave.frequency, period << i, derived_seed(seed, i),
                          footprint * octave.frequency);
        sum = with_octave(sum, octave, mean, value);
        total = total + octave.strength;
        octave = next_octave(octave, gain, footprint);
    }
    return clamp(sum / total, 0.0f, 1.0f);
}

#endif
