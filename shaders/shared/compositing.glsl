// SPDX-License-Identifier: MIT
#ifndef SHARED_COMPOSITING_GLSL
#define SHARED_COMPOSITING_GLSL

// How a blended source is laid over what is below it, for one scalar of one channel.
// W3C Compositing and Blending Level 1, https://www.w3.org/TR/compositing-1/#generalformula, with
// the source-over operator (Porter and Duff, "Compositing digital images", 1984).
//
// weight: the source's coverage `as`, 0..1: layer opacity x channel opacity x mask x source alpha.
// Colours are not premultiplied, but where a name says so.

/// The coverage of source over backdrop, as + ab - as ab. Commutative; 0 is neutral, 1 gives 1.
Real over_coverage(Real backdrop_coverage, Real weight) {
    return backdrop_coverage + weight - backdrop_coverage * weight;
}

/// The premultiplied result co = as (1 - ab) Cs + as ab B + (1 - as) ab Cb of source over backdrop,
/// where `blended` is B(Cb, Cs). Divide by over_coverage (see unpremultiplied) for the colour.
/// With backdrop_coverage 1 it is over_opaque; with 0 it is as Cs: nothing of Cb or B is seen.
Real over_premultiplied(Real backdrop, Real backdrop_coverage, Real source, Real blended,
                        Real weight) {
    Real laid = mix(source, blended, backdrop_coverage);
    return weight * laid + (1.0f - weight) * (backdrop_coverage * backdrop);
}

/// The colour of a premultiplied value; 0 where nothing covers.
Real unpremultiplied(Real premultiplied, Real coverage) {
    return select(coverage > 0.0f, premultiplied / max(coverage, 1e-30f), 0.0f);
}

/// The premultiplied result of a source that takes the place of the backdrop by the weight, with its
/// own coverage: where the source is clear, the backdrop is cleared. What covers then is
/// replaced_coverage. GIMP, "replace" of its layer modes; Porter and Duff's "source" at weight 1.
Real replaced_premultiplied(Real backdrop, Real backdrop_coverage, Real source,
                            Real source_coverage, Real weight) {
    return weight * source_coverage * source + (1.0f - weight) * (backdrop_coverage * backdrop);
}

/// The coverage that a replacing source leaves.
Real replaced_coverage(Real backdrop_coverage, Real source_coverage, Real weight) {
    return mix(backdrop_coverage, source_coverage, weight);
}

/// Source over an opaque backdrop: from the backdrop to `blended` = B(Cb, Cs) by the weight.
/// Exactly the backdrop at weight 0 and exactly `blended` at 1.
Real over_opaque(Real backdrop, Real blended, Real weight) {
    return mix(backdrop, blended, weight);
}

#endif
