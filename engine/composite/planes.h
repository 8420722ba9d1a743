// SPDX-License-Identifier: MIT
#pragma once

/// Planes of floats as kernels read them.

#include <cstddef>

namespace patina {

/// A plane of a tile, or (`step` 0) one value that stands for a whole plane, kept sixteen times.
struct ReadPlane {
    const float* data = nullptr;
    std::size_t step = 1;
};

/// A value kept once for each lane of the widest instruction set.
struct UniformPlane {
    alignas(64) float lanes[16] = {};

    UniformPlane() = default;
    explicit UniformPlane(float value) {
        for (float& lane : lanes) lane = value;
    }
    ReadPlane plane() const { return {.data = lanes, .step = 0}; }
};

/// What a source gives: three planes of a colour or normal, one of a scalar, and its own coverage.
/// They point into the planes of the tile, or at constants that live as long as the program.
struct FetchedSource {
    ReadPlane components[3] = {};
    ReadPlane coverage = {};
};

/// 1 in every texel.
inline ReadPlane uniform_one() {
    static const UniformPlane one(1.0f);
    return one.plane();
}

}  // namespace patina
