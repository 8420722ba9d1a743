// SPDX-License-Identifier: MIT
#ifndef SHARED_HEAT_MAP_GLSL
#define SHARED_HEAT_MAP_GLSL

/// Inferno of matplotlib (Nathaniel Smith and Stefan van der Walt, 2015, CC0): black over purple
/// and orange to pale yellow, even in lightness. sRGB-encoded. This fit by a polynomial of degree
/// six: Matt Zucker, 2019. Within 0.03 of the table. x: 0..1
Real3 heat_map_inferno(Real x) {
    Real3 c = Real3(25.13112622f, -12.24266895f, -23.07032500f);
    c = c * x + Real3(-71.31942824f, 32.62606426f, 73.20951985f);
    c = c * x + Real3(77.16293570f, -33.40235894f, -81.80730925f);
    c = c * x + Real3(-41.70399613f, 17.43639888f, 44.35414519f);
    c = c * x + Real3(11.60249308f, -3.97285396f, -15.94239411f);
    c = c * x + Real3(0.10651342f, 0.56395644f, 3.93271239f);
    c = c * x + Real3(0.00021894f, 0.00165100f, -0.01948090f);
    return clamp(c, 0.0f, 1.0f);
}

#endif
