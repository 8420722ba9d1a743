// SPDX-License-Identifier: MIT
#ifndef SHARED_RAMP_GLSL
#define SHARED_RAMP_GLSL

// A ramp of up to eight stops: straight lines between them, constant beyond the first and the last.

struct RampStop {
    float position;  // 0..1, ascending; two at one place are a step
    float x, y, z;   // a linear colour, or a scalar in x
};

struct Ramp {
    int count;  // 1 to 8
    RampStop stops[8];
};

/// How far t has come from one position to the next, 0..1. Between equal positions it steps.
Real ramp_progress(Real t, float from, float to) {
    return clamp((t - from) * (1.0f / max(to - from, 1e-6f)), 0.0f, 1.0f);
}

/// The scalar of the ramp at t. At a stop's position it is the stop's value.
Real ramp_scalar(Ramp ramp, Real t) {
    Real value = ramp.stops[0].x;
    for (int i = 1; i < ramp.count; ++i)
        value = mix(value, ramp.stops[i].x,
                    ramp_progress(t, ramp.stops[i - 1].position, ramp.stops[i].position));
    return value;
}

/// The colour of the ramp at t.
Real3 ramp_color(Ramp ramp, Real t) {
    Real3 value = Real3(ramp.stops[0].x, ramp.stops[0].y, ramp.stops[0].z);
    for (int i = 1; i < ramp.count; ++i) {
        Real3 next = Real3(ramp.stops[i].x, ramp.stops[i].y, ramp.stops[i].z);
        value =
            mix(value, next, ramp_progress(t, ramp.stops[i - 1].position, ramp.stops[i].position));
    }
    return value;
}

#endif
