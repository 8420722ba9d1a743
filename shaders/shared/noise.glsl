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

/// Perlin's gradient noise. 0.5 at every lattice point; range 0..1, mean 0.5.
/// Ken Perlin, "An image synthesizer", SIGGRAPH 1985, with the fade of 2002.
Real perlin_noise(Real2 position, int period, uint seed) {
    Real2 cell = floor(position);
    Int x0 = wrapped_cell(cell.x, period);
    Int y0 = wrapped_cell(cell.y, period);
    Int x1 = next_cell(x0, period);
    Int y1 = next_cell(y0, period);
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

/// The noise of a kind NOISE_...
Real noise(int kind, Real2 position, int period, uint seed) {
    if (kind == NOISE_VALUE) return value_noise(position, period, seed);
    if (kind == NOISE_PERLIN) return perlin_noise(position, period, seed);
    return worley_noise(position, period, seed);
}

/// The mean of a kind of noise, to which detail fades that is too small to be shown.
float noise_mean(int kind) {
    return kind == NOISE_WORLEY ? 0.4295f : 0.5f;
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
                noise(kind, position * frequency, period << octave, derived_seed(seed, octave));
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
