// SPDX-License-Identifier: MIT
#ifndef SHARED_AREA_LIGHT_GLSL
#define SHARED_AREA_LIGHT_GLSL

#include "shared/brdf.glsl"
#include "shared/transcendental.glsl"

// Lamps that have a size: spheres and rectangles that send out the same radiance everywhere. A
// sphere of intensity I (candela) and radius r has radiance I / (pi r^2), a rectangle I / (width x
// height), so that from far away they are as bright as a point of that intensity.
//
// Shares are of the light of a uniform hemisphere: irradiance / (pi x radiance), 0..1. Places are
// seen from the lit point. All directions are unit vectors.

// What they give a surface, in closed form.

/// The share that a sphere gives, partly below the horizon or not. cosine: of the angle between the
/// normal and its middle; sine2: (radius / distance)^2, which is its share when it is overhead.
/// John Snyder, "Area light sources for real-time graphics", 1996.
Real sphere_share(Real cosine, Real sine2) {
    Real s2 = clamp(sine2, 1e-12f, 0.99999f);
    Real c2 = cosine * cosine;
    Real rest2 = 1.0f / s2 - 1.0f;  // the square of the cotangent of its radius
    Real cut2 = max(1.0f - c2 / s2, 0.0f);
    Real turn = acos_poly(-cosine * sqrt(rest2 / max(1.0f - c2, 1e-6f)));
    Real cut = s2 * (cosine * turn - sqrt(cut2 * rest2)) + atan2_poly(sqrt(cut2), sqrt(rest2));
    Real share = select(c2 < s2, cut * (1.0f / PI), max(cosine, 0.0f) * s2);
    return clamp(share, 0.0f, 1.0f);
}

/// A rectangle as the lit point sees it: its middle, the ways of its width and height, half of
/// both, and the way that it shines.
struct SeenRectangle {
    Real3 middle;
    Real3 across;
    Real3 up;
    Real3 shines;
    Real half_width;
    Real half_height;
};

/// Of the irradiance vector, what one edge from a to b adds, times 2 pi.
Real3 edge_irradiance(Real3 a, Real3 b) {
    Real3 around = cross(a, b);
    Real length_around = sqrt(max(dot(around, around), 1e-24f));
    return around * (atan2_poly(length_around, dot(a, b)) / length_around);
}

/// The share that a rectangle gives a surface that faces the way of this vector, which points
/// towards the light: J. H. Lambert's formula for polygons, 1760. 0 from behind. Where the rectangle
/// is small and the edges cancel, it is a point.
Real3 rectangle_irradiance(SeenRectangle r) {
    Real3 x = r.across * r.half_width;
    Real3 y = r.up * r.half_height;
    Real3 a = normalize(r.middle - x - y);
    Real3 b = normalize(r.middle + x - y);
    Real3 c = normalize(r.middle + x + y);
    Real3 d = normalize(r.middle - x + y);
    Real3 edges = edge_irradiance(a, b) + edge_irradiance(b, c) + edge_irradiance(c, d) +
                  edge_irradiance(d, a);
    Real distance2 = max(dot(r.middle, r.middle), 1e-12f);
    Real leaving = -dot(r.middle, r.shines) * inversesqrt(distance2);
    Real area = 4.0f * r.half_width * r.half_height;
    Real3 point = r.middle * (inversesqrt(distance2) * leaving * area / (PI * distance2));
    // Whichever way round the corners are.
    Real sign_of_edges = select(dot(edges, r.shines) > 0.0f, Real(-1.0f), Real(1.0f));
    Real3 whole = select(area < 1e-4f * distance2, point, edges * (sign_of_edges * 0.5f / PI));
    return select(leaving > 0.0f, whole, Real3(0.0f));
}

/// The share of a light whose irradiance vector is `vector`: as a sphere that has the same, which is
/// exact above the horizon. Eric Heitz, Stephen Hill and Morgan McGuire, "Real-time polygonal-light
/// shading with linearly transformed cosines", 2016.
Real share_of_vector(Real3 vector, Real3 normal) {
    Real facing = sqrt(max(dot(vector, vector), 1e-24f));
    return sphere_share(dot(vector, normal) / facing, facing);
}

// The point of a light that stands for all of it in a highlight: the one nearest to the mirrored
// eye. Brian Karis, "Real shading in Unreal Engine 4", 2013.

/// Towards that point of a sphere.
Real3 sphere_nearest(Real3 middle, Real radius, Real3 mirrored) {
    Real3 off = mirrored * dot(middle, mirrored) - middle;
    Real distance = sqrt(max(dot(off, off), 1e-24f));
    return normalize(middle + off * min(radius / distance, 1.0f));
}

/// Towards that point of a rectangle.
Real3 rectangle_nearest(SeenRectangle r, Real3 mirrored) {
    Real facing = -dot(mirrored, r.shines);
    Real depth = -dot(r.middle, r.shines);
    // A ray that never meets the plane tends to its far end.
    Real steps = depth / max(facing, 1e-4f);
    Real3 off = mirrored * steps - r.middle;
    Real x = clamp(dot(off, r.across), -r.half_width, r.half_width);
    Real y = clamp(dot(off, r.up), -r.half_height, r.half_height);
    return normalize(r.middle + r.across * x + r.up * y);
}

/// What the highlight at that point is multiplied by. facing: the share that the light gives a
/// surface that faces it; aspect: its width / height. Exact where GGX is mirrored by the middle of a
/// disc, and a light that covers the whole lobe shows its own radiance:
/// of GGX, s / (s + alpha^2) lies within the half vectors of a disc of share 4 s.
Real nearest_weight(Real alpha, Real facing, Real aspect) {
    Real alpha2 = alpha * alpha;
    Real wide = 0.25f * facing * aspect;
    Real high = 0.25f * facing / aspect;
    return alpha2 * inversesqrt((alpha2 + wide) * (alpha2 + high));
}

// Drawing directions towards them, with a density per steradian.

/// Two unit vectors across z, which make a right-handed frame with it. T. Duff and others, "Building
/// an orthonormal basis, revisited", 2017.
struct Across {
    Real3 x_axis;
    Real3 y_axis;
};
Across across_of(Real3 z) {
    Real side = select(z.z < 0.0f, Real(-1.0f), Real(1.0f));
    Real a = -1.0f / (side + z.z);
    Real b = z.x * z.y * a;
    Across frame;
    frame.x_axis = Real3(1.0f + side * z.x * z.x * a, side * b, -side * z.x);
    frame.y_axis = Real3(b, side + z.y * z.y * a, -z.y);
    return frame;
}

/// 1 - the cosine of the angle that a sphere's radius fills.
Real cone_height(Real sine2) {
    Real s2 = clamp(sine2, 1e-12f, 1.0f);
    return s2 / (1.0f + sqrt(1.0f - s2));
}

/// A direction towards a sphere, for u of the unit square; each as likely.
Real3 sphere_direction(Real2 u, Real3 towards, Real sine2) {
    Real height = u.y * cone_height(sine2);
    Real sine = sqrt(max(height * (2.0f - height), 0.0f));
    Real phi = u.x * (2.0f * PI);
    Across frame = across_of(towards);
    return frame.x_axis * (sine * cos_poly(phi)) + frame.y_axis * (sine * sin_poly(phi)) +
           towards * (1.0f - height);
}
Real sphere_density(Real sine2) {
    return 0.5f / (PI * cone_height(sine2));
}

/// A rectangle on the unit sphere about the lit point, in its own frame: z away from the lit point.
/// Carlos Urena, Marcos Fajardo and Alan King, "An area-preserving parametrization for spherical
/// rectangles", 2013.
struct SphericalRectangle {
    Real x0;
    Real x1;
    Real y0;
    Real y1;
    Real depth;        // of its plane
    Real low_normal;   // z of the normals of the planes through its lower and upper edge
    Real high_normal;
    Real turn;
    Real solid_angle;
};
SphericalRectangle spherical_rectangle(SeenRectangle r) {
    SphericalRectangle s;
    Real x = dot(r.middle, r.across);
    Real y = dot(r.middle, r.up);
    s.x0 = x - r.half_width;
    s.x1 = x + r.half_width;
    s.y0 = y - r.half_height;
    s.y1 = y + r.half_height;
    s.depth = max(-dot(r.middle, r.shines), 1e-6f);
    // Normals of the planes through its edges: each lies in a plane of two axes.
    Real lower = inversesqrt(s.depth * s.depth + s.y0 * s.y0);
    Real upper = inversesqrt(s.depth * s.depth + s.y1 * s.y1);
    Real left = inversesqrt(s.depth * s.depth + s.x0 * s.x0);
    Real right = inversesqrt(s.depth * s.depth + s.x1 * s.x1);
    s.low_normal = -s.y0 * lower;
    s.high_normal = s.y1 * upper;
    // The angles at its corners; z of the right and left normals is x1 right and -x0 left.
    Real low_right = acos_poly(-s.low_normal * s.x1 * right);
    Real high_right = acos_poly(-s.high_normal * s.x1 * right);
    Real high_left = acos_poly(s.high_normal * s.x0 * left);
    Real low_left = acos_poly(s.low_normal * s.x0 * left);
    s.turn = 2.0f * PI - high_left - low_left;
    s.solid_angle = low_right + high_right - s.turn;
    return s;
}

/// A direction towards it, for u of the unit square; each as likely.
Real3 spherical_rectangle_direction(Real2 u, SeenRectangle r, SphericalRectangle s) {
    Real angle = u.x * s.solid_angle + s.turn;
    Real sine = sin_poly(angle);
    Real away = select(abs(sine) < 1e-7f, Real(1e-7f), sine);
    Real f = (cos_poly(angle) * s.low_normal - s.high_normal) / away;
    Real side = select(f < 0.0f, Real(-1.0f), Real(1.0f));
    Real c = clamp(side * inversesqrt(max(f * f + s.low_normal * s.low_normal, 1e-12f)), -1.0f, 1.0f);
    Real x = clamp(c * s.depth * inversesqrt(max(1.0f - c * c, 1e-12f)), s.x0, s.x1);
    Real distance2 = x * x + s.depth * s.depth;
    Real low = s.y0 * inversesqrt(distance2 + s.y0 * s.y0);
    Real high = s.y1 * inversesqrt(distance2 + s.y1 * s.y1);
    Real h = low + u.y * (high - low);
    Real y = clamp(h * sqrt(distance2) * inversesqrt(max(1.0f - h * h, 1e-12f)), s.y0, s.y1);
    return normalize(r.across * x + r.up * y - r.shines * s.depth);
}

/// Below this solid angle, points of a rectangle are drawn instead of directions: the angles at its
/// corners no longer tell it from nothing, and all of it is as far away.
const float LEAST_SPHERICAL = 0.01f;

Bool is_drawn_by_area(SeenRectangle r) {
    return 4.0f * r.half_width * r.half_height < LEAST_SPHERICAL * dot(r.middle, r.middle);
}
/// A direction towards a point of a rectangle, for u of the unit square; each point as likely.
Real3 rectangle_point_direction(Real2 u, SeenRectangle r) {
    return normalize(r.middle + r.across * ((2.0f * u.x - 1.0f) * r.half_width) +
                     r.up * ((2.0f * u.y - 1.0f) * r.half_height));
}
/// Per steradian, of a direction that meets the rectangle's front.
Real rectangle_point_density(Real3 direction, SeenRectangle r) {
    Real leaving = max(-dot(direction, r.shines), 1e-6f);
    Real distance = -dot(r.middle, r.shines) / leaving;
    return distance * distance / (leaving * 4.0f * r.half_width * r.half_height);
}

/// A direction towards a rectangle, for u of the unit square.
Real3 rectangle_direction(Real2 u, SeenRectangle r) {
    Real3 by_area = rectangle_point_direction(u, r);
    Real3 by_angle = spherical_rectangle_direction(u, r, spherical_rectangle(r));
    return select(is_drawn_by_area(r), by_area, by_angle);
}
/// How densely rectangle_direction draws that direction, which meets the rectangle's front.
Real rectangle_density(Real3 direction, SeenRectangle r) {
    Real by_area = rectangle_point_density(direction, r);
    Real by_angle = 1.0f / max(spherical_rectangle(r).solid_angle, 1e-6f);
    return select(is_drawn_by_area(r), by_area, by_angle);
}

/// 1 where a ray from the lit point meets them, else 0; a rectangle from its front.
Real sphere_is_met(Real3 direction, Real3 middle, Real radius) {
    Real along = dot(direction, middle);
    Real3 off = middle - direction * along;
    return select(along > 0.0f, select(dot(off, off) <= radius * radius, Real(1.0f), Real(0.0f)),
                  Real(0.0f));
}
Real rectangle_is_met(Real3 direction, SeenRectangle r) {
    Real leaving = -dot(direction, r.shines);
    Real depth = -dot(r.middle, r.shines);
    Real3 off = direction * (depth / max(leaving, 1e-6f)) - r.middle;
    Real x = select(abs(dot(off, r.across)) <= r.half_width, Real(1.0f), Real(0.0f));
    Real y = select(abs(dot(off, r.up)) <= r.half_height, Real(1.0f), Real(0.0f));
    Real front = select(min(leaving, depth) > 1e-6f, Real(1.0f), Real(0.0f));
    return x * y * front;
}

#endif
