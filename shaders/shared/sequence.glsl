// SPDX-License-Identifier: MIT
#ifndef SHARED_SEQUENCE_GLSL
#define SHARED_SEQUENCE_GLSL

// Numbers of 0..1 from bits, and points that are spread evenly over the unit square.

/// The upper 24 bits as a number in 0..1, 1 excluded. Exact.
Real unit_from_bits(Uint bits) {
    return Real(Int(bits >> 8)) * 5.9604644775390625e-8f;  // 2^-24
}

/// The first bit last. Twice returns the bits.
Uint mirrored_bits(Uint bits) {
    Uint b = (bits << 16) | (bits >> 16);
    b = ((b & 0x00ff00ffu) << 8) | ((b & 0xff00ff00u) >> 8);
    b = ((b & 0x0f0f0f0fu) << 4) | ((b & 0xf0f0f0f0u) >> 4);
    b = ((b & 0x33333333u) << 2) | ((b & 0xccccccccu) >> 2);
    return ((b & 0x55555555u) << 1) | ((b & 0xaaaaaaaau) >> 1);
}

/// Point i of a set of `count` in the unit square. J. M. Hammersley, 1960; the second coordinate is
/// van der Corput's: the bits of i mirrored about the binary point (exact for 2^23 points).
Real2 hammersley(Uint i, uint count) {
    return Real2(Real(Int(i)) / float(count), unit_from_bits(mirrored_bits(i)));
}

#endif
