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

/// 1 - the cosine of the angle that a sphere's radius fills.
Real cone_height(Real sine2) {
    Real s2 = clamp(sine2, 1e-12f, 1.0f);
    return s2 / (1.0f + sqrt(1.0f - s2));
}

// What they show in a highlight. A half vector h has the slope h.xy / h.z in the frame of the normal.
// Over the plane of slopes GGX lies as a cosine lobe seen from alpha above its middle lies over any
// plane: what of the lobe mirrors a light is what Lambert's formula gives for the light's slopes.
// After Eric Heitz, Jonathan Dupuy, Stephen Hill and David Neubelt, "Real-time polygonal-light shading
// with linearly transformed cosines", 2016, with the half vectors of the lobe in place of a table.

/// The part of a lobe that mirrors a light, and the slope of the half vectors that stand for it.
struct Highlight {
    Real share;  // of the lobe, 0..1
    Real2 slope;
};

/// The slope of the half vector between v and l, in a frame about the normal n. What is below the
/// horizon counts as on it.
Real2 half_slope(Real3 l, Real3 v, Real3 n, Across frame) {
    Real3 above = l - n * min(dot(l, n), 0.0f);
    Real3 h = v + above * inversesqrt(max(dot(above, above), 1e-12f));
    Real rise = max(dot(h, n), 1e-3f);
    return Real2(dot(h, frame.x_axis) / rise, dot(h, frame.y_axis) / rise);
}

/// Of a light that fills a disc of slopes. area: of the disc.
Highlight disc_highlight(Real2 middle, Real area, Real alpha) {
    Real a2 = alpha * alpha;
    Real aside = sqrt(max(dot(middle, middle), 1e-12f));
    Real radius2 = area * (1.0f / PI);
    Real radius = sqrt(radius2);
    // A circle of the plane is one of the sphere that the plane is projected from: its share is that
    // of a cap.
    Real q = a2 + aside * aside - radius2;
    Real r = sqrt(q * q + 4.0f * radius2 * a2);
    Highlight highlight;
    highlight.share = select(q > 0.0f, 2.0f * radius2 * a2 / max(r * (r + max(q, 0.0f)), 1e-20f),
                             0.5f * (r - q) / max(r, 1e-20f));
    // The middle of the cap: half way between the angles of its ends.
    Real low = aside - radius;
    Real high = aside + radius;
    Real by_low = inversesqrt(a2 + low * low);
    Real by_high = inversesqrt(a2 + high * high);
    highlight.slope =
        middle * ((low * by_low + high * by_high) / ((by_low + by_high) * aside));
    return highlight;
}

/// Of a light with corners of these slopes, one after the other.
Highlight quad_highlight(Real2 a, Real2 b, Real2 c, Real2 d, Real alpha) {
    Real3 p = normalize(Real3(a.x, a.y, alpha));
    Real3 q = normalize(Real3(b.x, b.y, alpha));
    Real3 r = normalize(Real3(c.x, c.y, alpha));
    Real3 s = normalize(Real3(d.x, d.y, alpha));
    Real3 edges =
        edge_irradiance(p, q) + edge_irradiance(q, r) + edge_irradiance(r, s) + edge_irradiance(s, p);
    // Where it is small and the edges cancel, it is a point.
    Real2 middle = (a + b + c + d) * 0.25f;
    Real2 ac = c - a;
    Real2 bd = d - b;
    Real area = 0.5f * abs(ac.x * bd.y - ac.y * bd.x);
    Real distance2 = alpha * alpha + dot(middle, middle);
    Bool is_small = area < 1e-3f * distance2;
    Real upright = select(edges.z < 0.0f, min(edges.z, -1e-12f), max(edges.z, 1e-12f));
    Highlight highlight;
    highlight.share = select(is_small, area * alpha * alpha / (PI * distance2 * distance2),
                             abs(edges.z) * (0.5f / PI));
    highlight.slope =
        select(is_small, middle, Real2(edges.x * alpha / upright, edges.y * alpha / upright));
    return highlight;
}

/// Of a sphere, as the disc whose slopes are as many, of what of it is above the horizon.
Highlight sphere_highlight(Real3 towards, Real sine2, Real3 v, Real3 n, Real alpha) {
    Real cosine = dot(towards, n);
    Real sine = sqrt(max(sine2, 1e-12f));
    // The share of a disc above a line.
    Real seen = smoothstep(0.0f, 1.0f, 0.5f + 0.5f * cosine / sine);
    Real height = 0.5f * (max(cosine - sine, 0.0f) + max(cosine + sine, 0.0f));
    Real3 middle = normalize(towards + n * (height - cosine));
    Real3 h = normalize(v + middle);
    Real rise = max(dot(h, n), 0.05f);
    Real solid_angle = 2.0f * PI * cone_height(sine2);
    Real area = seen * solid_angle / (4.0f * max(dot(v, h), 0.05f) * rise * rise * rise);
    return disc_highlight(half_slope(middle, v, n, across_of(n)), area, alpha);
}

/// A corner of a rectangle, or where the edges that lead to it cross the horizon when it is below.
Real3 corner_above(Real3 corner, Real3 before, Real3 after, Real3 n) {
    Real height = dot(corner, n);
    Real height_before = max(dot(before, n), 0.0f);
    Real height_after = max(dot(after, n), 0.0f);
    Real3 on_before = corner + (before - corner) * (-height / max(height_before - height, 1e-6f));
    Real3 on_after = corner + (after - corner) * (-height / max(height_after - height, 1e-6f));
    Real both = height_before + height_after;
    Real3 crossing =
        (on_before * height_before + on_after * height_after) * (1.0f / max(both, 1e-6f));
    return select(height < 0.0f, select(both > 0.0f, crossing, corner), corner);
}

/// Of a rectangle, as the quadrilateral of its corners' slopes.
Highlight rectangle_highlight(SeenRectangle r, Real3 v, Real3 n, Real alpha) {
    Across frame = across_of(n);
    Real3 x = r.across * r.half_width;
    Real3 y = r.up * r.half_height;
    Real3 a = r.middle - x - y;
    Real3 b = r.middle + x - y;
    Real3 c = r.middle + x + y;
    Real3 d = r.middle - x + y;
    Real3 p = corner_above(a, d, b, n);
    Real3 q = corner_above(b, a, c, n);
    Real3 s = corner_above(c, b, d, n);
    Real3 t = corner_above(d, c, a, n);
    // One whose neighbours are below too has no edge above.
    Real least = -1e-4f * dot(r.middle, r.middle);
    p = select(dot(p, n) < least, (q + t) * 0.5f, p);
    q = select(dot(q, n) < least, (p + s) * 0.5f, q);
    s = select(dot(s, n) < least, (q + t) * 0.5f, s);
    t = select(dot(t, n) < least, (p + s) * 0.5f, t);
    Highlight highlight = quad_highlight(
        half_slope(normalize(p), v, n, frame), half_slope(normalize(q), v, n, frame),
        half_slope(normalize(s), v, n, frame), half_slope(normalize(t), v, n, frame), alpha);
    Real highest = max(max(dot(a, n), dot(b, n)), max(dot(c, n), dot(d, n)));
    highlight.share = select(highest > 0.0f, highlight.share, Real(0.0f));
    return highlight;
}

/// Towards the point of the light that stands for it.
Real3 highlight_direction(Highlight highlight, Real3 v, Real3 n) {
    Across frame = across_of(n);
    Real3 h =
        normalize(n + frame.x_axis * highlight.slope.x + frame.y_axis * highlight.slope.y);
    return reflect(-v, h);
}

/// What a surface mirrors of a light of radiance 1, the other terms being those of one direction. Of
/// distributions but GGX the share is that of GGX times how they compare there.
Real3 brdf_of_highlight(BrdfTerms terms, ReflectionAngles angles, Real share, Real3 f0, Real f90,
                        Real roughness) {
    Real worth = mirrored_worth(terms, angles, alpha_from_roughness(roughness));
    return fresnel(terms.fresnel, angles.v_dot_h, f0, f90) * (share * worth);
}

// Drawing directions towards them, with a density per steradian.

/// A direction towards a sphere, for u of the unit square; each as likely. Peter Shirley, Changyaw
/// Wang and Kurt Zimmerman, "Monte Carlo techniques for direct lighting calculations", 1996.
Real3 sphere_direction(Real2 u, Real3 towards, Real sine2) {
    Real height = u.y * cone_height(sine2);
    Real sine = sqrt(max(height * (2.0f - height), 0.0f));
    Real phi = u.x * (2.0f * PI);
    Across frame = across_of(towards);
    return frame.x_axis * (sine * cos_poly(phi)) + frame.y_axis * (sine * sin_poly(phi)) +
           towards * (1.0f - height);
}
/// 1 / the solid angle of its cone.
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
/// A point of a rectangle, for u of the unit square; each as likely.
Real3 rectangle_point(Real2 u, SeenRectangle r) {
    return r.middle + r.across * ((2.0f * u.x - 1.0f) * r.half_width) +
           r.up * ((2.0f * u.y - 1.0f) * r.half_height);
}
/// The direction towards it.
Real3 rectangle_point_direction(Real2 u, SeenRectangle r) {
    return normalize(rectangle_point(u, r));
}
/// Per steradian, of a direction that meets the rectangle's front: distance^2 / (cosine x area), as
/// Shirley, Wang and Zimmerman have it.
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
