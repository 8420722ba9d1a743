// SPDX-License-Identifier: MIT
#ifndef SHARED_NOISE_GLSL
#define SHARED_NOISE_GLSL

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

/// The upper 24 bits of a hash as a number in 0..1, 1 excluded. Exact.
Real unit_from_hash(Uint hash) {
    return Real(Int(hash >> 8)) * 5.9604644775390625e-8f;  // 2^-24
}

/// Perlin's fade 6t^5 - 15t^4 + 10t^3: first and second derivatives are 0 at 0 and 1.
/// Ken Perlin, "Improving noise", SIGGRAPH 2002.
Real quintic_fade(Real t) {
    return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f);
}

/// Value noise: random values at lattice points, faded between. Range 0..1, mean 0.5.
Real value_noise(Real2 position, int period, uint seed) {
    Real2 cell = floor(position);
    Int x0 = wrapped_cell(cell.x, period);
    Int y0 = wrapped_cell(cell.y, period);
    Int x1 = next_cell(x0, period);
    Int y1 = next_cell(y0, period);
    Real u = quintic_fade(position.x - cell.x);
    Real v = quintic_fade(position.y - cell.y);
    Real v00 = unit_from_hash(lattice_hash(x0, y0, seed));
    Real v10 = unit_from_hash(lattice_hash(x1, y0, seed));
    Real v01 = unit_from_hash(lattice_hash(x0, y1, seed));
    Real v11 = unit_from_hash(lattice_hash(x1, y1, seed));
    Real top = v00 + (v10 - v00) * u;
    Real bottom = v01 + (v11 - v01) * u;
    return top + (bottom - top) * v;
}

/// The product of (x, y) with one of 16 unit gradients, at 11.25 + 22.5 k degrees: none lies along
/// the axes, where the eye would find the lattice. The hash's four upper bits pick it.
Real gradient_product(Uint hash, Real x, Real y) {
    Bool steep = Uint((hash >> 28) & 1u) == Uint(1u);
    Bool swapped = Uint((hash >> 29) & 1u) == Uint(1u);
    Real a = select(steep, 0.831469612f, 0.980785280f);  // cos 33.75, cos 11.25 degrees
    Real b = select(steep, 0.555570233f, 0.195090322f);  // their sines
    Int sign_x = Int(hash & 0x80000000u);
    Int sign_y = Int((hash << 1) & 0x80000000u);
    Real gx = intBitsToFloat(floatBitsToInt(select(swapped, b, a)) ^ sign_x);
    Real gy = intBitsToFloat(floatBitsToInt(select(swapped, a, b)) ^ sign_y);
    return gx * x + gy * y;
}

/// Perlin's gradient noise. 0.5 at every lattice point; range 0..1, mean 0.5. It may tile after
/// different numbers of cells in x and in y.
/// Ken Perlin, "An image synthesizer", SIGGRAPH 1985, with the fade of 2002.
Real perlin_noise_xy(Real2 position, int period_x, int period_y, uint seed) {
    Real2 cell = floor(position);
    Int x0 = wrapped_cell(cell.x, period_x);
    Int y0 = wrapped_cell(cell.y, period_y);
    Int x1 = next_cell(x0, period_x);
    Int y1 = next_cell(y0, period_y);
    Real x = position.x - cell.x;
    Real y = position.y - cell.y;
    Real u = quintic_fade(x);
    Real v = quintic_fade(y);
    Real n00 = gradient_product(lattice_hash(x0, y0, seed), x, y);
    Real n10 = gradient_product(lattice_hash(x1, y0, seed), x - 1.0f, y);
    Real n01 = gradient_product(lattice_hash(x0, y1, seed), x, y - 1.0f);
    Real n11 = gradient_product(lattice_hash(x1, y1, seed), x - 1.0f, y - 1.0f);
    Real top = n00 + (n10 - n00) * u;
    Real bottom = n01 + (n11 - n01) * u;
    // Unit gradients give at most sqrt(1/2), in the middle of a cell.
    return clamp(0.5f + 0.707106781f * (top + (bottom - top) * v), 0.0f, 1.0f);
}

/// Perlin's noise with the same period in x and in y.
Real perlin_noise(Real2 position, int period, uint seed) {
    return perlin_noise_xy(position, period, period, seed);
}

/// What a corner of a simplex adds: its gradient's slope, fading to nothing 0.9 cells away.
/// twice_x: twice the corner's x, which is whole; x, y: from the corner.
Real simplex_corner(Real twice_x, Real corner_y, int period, int period_y, uint seed, Real x,
                    Real y) {
    Uint hash =
        lattice_hash(wrapped_cell(twice_x, 2 * period), wrapped_cell(corner_y, period_y), seed);
    Real reach = max(0.8f - x * x - y * y, 0.0f);
    reach = reach * reach;
    return reach * reach * gradient_product(hash, x, y);
}

/// Simplex noise: gradients at the corners of triangles, so that no axis stands out. Range 0..1,
/// mean 0.5. Tiles at every period: rows of triangles are a little stretched to be even in number.
/// Stefan Gustavson and Ian McEwan, "Tiling simplex noise and flow noise in two and three
/// dimensions", JCGT 2022 (the lattice of psrdnoise).
Real simplex_noise(Real2 position, int period, uint seed) {
    int period_y = period + (period & 1);
    Real px = position.x;
    Real py = position.y * (float(period_y) / float(period));
    // The lattice, sheared to squares.
    Real sx = px + 0.5f * py;
    Real ix = floor(sx);
    Real iy = floor(py);
    Real fx = sx - ix;
    Real fy = py - iy;
    Real right = select(fx >= fy, Real(1.0f), Real(0.0f));  // which of the two triangles
    Real x0 = ix - 0.5f * iy;
    Real x1 = x0 + right - 0.5f * (1.0f - right);
    Real y1 = iy + (1.0f - right);
    Real x2 = x0 + 0.5f;
    Real y2 = iy + 1.0f;
    Real sum = simplex_corner(2.0f * x0, iy, period, period_y, seed, px - x0, py - iy) +
               simplex_corner(2.0f * x1, y1, period, period_y, seed, px - x1, py - y1) +
               simplex_corner(2.0f * x2, y2, period, period_y, seed, px - x2, py - y2);
    // 10.9 brings the sum to -1..1 (psrdnoise).
    return clamp(0.5f + 5.45f * sum, 0.0f, 1.0f);
}

/// The squared distance from (x, y) within a cell to the feature point of the cell at `offset`.
Real feature_distance_squared(Int cell_x, Int cell_y, uint seed, Real x, Real y) {
    Uint hash = lattice_hash(cell_x, cell_y, seed);
    Real dx = Real(Int(hash >> 16)) * 1.52587890625e-5f + x;  // 2^-16
    Real dy = Real(Int(hash & 0xffffu)) * 1.52587890625e-5f + y;
    return dx * dx + dy * dy;
}

/// The nearest feature point in a row of three cells; y from the sought point to the row's corner.
Real nearest_in_row(Int x_before, Int x_here, Int x_after, Int cell_y, uint seed, Real x, Real y) {
    Real before = feature_distance_squared(x_before, cell_y, seed, x - 1.0f, y);
    Real here = feature_distance_squared(x_here, cell_y, seed, x, y);
    Real after = feature_distance_squared(x_after, cell_y, seed, x + 1.0f, y);
    return min(min(before, here), after);
}

/// Worley noise F1: the distance to the nearest of the feature points, one in each cell, held to 1.
/// Range 0..1, 0 at the points. Steven Worley, "A cellular texture basis function", SIGGRAPH 1996;
/// the 3 x 3 cells around are searched, as is usual.
Real worley_noise(Real2 position, int period, uint seed) {
    Real2 cell = floor(position);
    Int x1 = wrapped_cell(cell.x, period);
    Int y1 = wrapped_cell(cell.y, period);
    Int x0 = previous_cell(x1, period);
    Int x2 = next_cell(x1, period);
    Real x = cell.x - position.x;
    Real y = cell.y - position.y;
    Real above = nearest_in_row(x0, x1, x2, previous_cell(y1, period), seed, x, y - 1.0f);
    Real here = nearest_in_row(x0, x1, x2, y1, seed, x, y);
    Real below = nearest_in_row(x0, x1, x2, next_cell(y1, period), seed, x, y + 1.0f);
    return min(sqrt(min(min(above, here), below)), 1.0f);
}

/// The two nearest feature points: their distances, and the number and place of each.
struct Features {
    Real first;   // squared distance
    Real second;  // of the next one
    Uint first_hash;
    Uint second_hash;
    Real first_x, first_y;  // from the sought point
    Real second_x, second_y;
};

/// Takes the feature point of one cell in; x, y: from the sought point to the cell's corner.
Features with_feature(Features near, Int cell_x, Int cell_y, uint seed, Real x, Real y) {
    Uint hash = lattice_hash(cell_x, cell_y, seed);
    Real dx = Real(Int(hash >> 16)) * 1.52587890625e-5f + x;  // 2^-16
    Real dy = Real(Int(hash & 0xffffu)) * 1.52587890625e-5f + y;
    Real distance = dx * dx + dy * dy;
    Bool is_first = distance < near.first;
    Bool is_second = distance < near.second;
    Features next;
    next.second = select(is_first, near.first, select(is_second, distance, near.second));
    next.second_hash =
        select(is_first, near.first_hash, select(is_second, hash, near.second_hash));
    next.second_x = select(is_first, near.first_x, select(is_second, dx, near.second_x));
    next.second_y = select(is_first, near.first_y, select(is_second, dy, near.second_y));
    next.first = select(is_first, distance, near.first);
    next.first_hash = select(is_first, hash, near.first_hash);
    next.first_x = select(is_first, dx, near.first_x);
    next.first_y = select(is_first, dy, near.first_y);
    return next;
}

/// The two nearest feature points of Worley's noise among the 3 x 3 cells around.
Features nearest_features(Real2 position, int period, uint seed) {
    Real2 cell = floor(position);
    Int x1 = wrapped_cell(cell.x, period);
    Int y1 = wrapped_cell(cell.y, period);
    Int x0 = previous_cell(x1, period);
    Int x2 = next_cell(x1, period);
    Int y0 = previous_cell(y1, period);
    Int y2 = next_cell(y1, period);
    Real x = cell.x - position.x;
    Real y = cell.y - position.y;
    Features near;
    near.first = near.second = Real(100.0f);
    near.first_hash = near.second_hash = Uint(0u);
    near.first_x = near.first_y = near.second_x = near.second_y = Real(0.0f);
    near = with_feature(near, x1, y1, seed, x, y);
    near = with_feature(near, x0, y1, seed, x - 1.0f, y);
    near = with_feature(near, x2, y1, seed, x + 1.0f, y);
    near = with_feature(near, x1, y0, seed, x, y - 1.0f);
    near = with_feature(near, x1, y2, seed, x, y + 1.0f);
    near = with_feature(near, x0, y0, seed, x - 1.0f, y - 1.0f);
    near = with_feature(near, x2, y0, seed, x + 1.0f, y - 1.0f);
    near = with_feature(near, x0, y2, seed, x - 1.0f, y + 1.0f);
    return with_feature(near, x2, y2, seed, x + 1.0f, y + 1.0f);
}

/// The distance from the sought point to the border between the cells of the two nearest feature
/// points: to the line that is as far from one as from the other. 0 on every border.
Real feature_border_distance(Features near) {
    Real dx = near.second_x - near.first_x;
    Real dy = near.second_y - near.first_y;
    return 0.5f * (near.second - near.first) * inversesqrt(max(dx * dx + dy * dy, 1e-8f));
}

/// Worley noise F2: the distance to the second nearest feature point, held to 1. Range 0..1.
Real worley_noise_f2(Real2 position, int period, uint seed) {
    return min(sqrt(nearest_features(position, period, seed).second), 1.0f);
}

/// Worley noise F2 - F1: 0 on the borders of the cells. Range 0..1. Distances are held to 1 first,
/// beyond which the 3 x 3 cells do not say which point is the second nearest.
Real worley_noise_edges(Real2 position, int period, uint seed) {
    Features near = nearest_features(position, period, seed);
    return min(sqrt(near.second), 1.0f) - min(sqrt(near.first), 1.0f);
}

/// A random number for each cell of Worley's noise, 0..1, mean 0.5. Borders are as soft as the
/// footprint (the width of a texel in cells), where two cells share a texel.
Real cell_noise(Real2 position, int period, uint seed, float footprint) {
    Features near = nearest_features(position, period, seed);
    Real own = unit_from_hash(near.first_hash * 0x9e3779b1u);
    Real next = unit_from_hash(near.second_hash * 0x9e3779b1u);
    Real share = clamp(0.5f - feature_border_distance(near) / max(footprint, 1e-4f), 0.0f, 0.5f);
    return mix(own, next, share);
}

/// How far a noise of 0..1 is from its middle, 0..1: the octaves of turbulence (Perlin, 1985).
Real folded(Real noise) {
    return abs(noise + noise - 1.0f);
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
    // Ridges: F. Kenton Musgrave, in "Texturing and Modeling", 1994, without the feedback.
    Real ridge = 1.0f - folded(perlin_noise(position, period, seed));
    return ridge * ridge;
}

/// The mean of a kind of noise, to which detail fades that is too small to be shown.
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

/// Fractional Brownian motion: octaves of a noise, each of twice the frequency and `gain` times the
/// strength of the one before, as their weighted mean. Range 0..1; with one octave it is the noise.
/// footprint: the width of a texel in cells of the first octave (0: show everything); octaves that
/// are too fine fade to their mean, so that every resolution shows the same noise, only sharper.
/// Tiles as the first octave does. B. Mandelbrot and J. Van Ness, 1968; octaves after Perlin, 1985.
Real fbm(int kind, Real2 position, int period, uint seed, int octaves, float gain,
         float footprint) {
    float total = 0.0f;
    float strength = 1.0f;
    float frequency = 1.0f;
    Real sum = 0.0f;
    for (int octave = 0; octave < octaves; ++octave) {
        float shown = strength * octave_visibility(footprint * frequency);
        float mean = noise_mean(kind);
        if (shown > 0.0f) {
            Real value =
                noise(kind, position * frequency, period << octave, derived_seed(seed, octave),
                      footprint * frequency);
            sum = sum + shown * (value - mean);
        }
        total = total + strength;
        sum = sum + strength * mean;
        strength = strength * gain;
        frequency = frequency * 2.0f;
    }
    return clamp(sum / total, 0.0f, 1.0f);
}

#endif
