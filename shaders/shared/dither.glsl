// SPDX-License-Identifier: MIT
#ifndef SHARED_DITHER_GLSL
#define SHARED_DITHER_GLSL

// Noise that hides steps.

/// Interleaved gradient noise, 0..1 and 1 excluded, of a pixel in whole numbers: evenly spread among
/// any 3 x 3 pixels, and the same in every frame. Jorge Jimenez, "Next Generation Post Processing in
/// Call of Duty: Advanced Warfare", SIGGRAPH 2014.
Real interleaved_gradient_noise(Real2 pixel) {
    return fract(52.9829189f * fract(dot(pixel, Real2(0.06711056f, 0.00583715f))));
}

#endif
