// SPDX-License-Identifier: MIT
#include "shaders/probes.h"

#include <cmath>
#include <random>

namespace patina {
namespace {

/// Values where a formula of shaders/shared/ changes its branch, and their neighbours.
std::vector<float> branch_points() {
    std::vector<float> points = {0.0f, 1.0f};
    for (const float at : {0.0031308f, 0.04045f, 0.25f, 0.5f, 0.75f}) {
        points.push_back(std::nextafter(at, 0.0f));
        points.push_back(at);
        points.push_back(std::nextafter(at, 1.0f));
    }
    return points;
}

std::vector<float> input_plane(std::mt19937& random) {
    const std::vector<float> points = branch_points();
    std::vector<float> values(kProbeInputs);
    for (float& value : values) {
        const auto bits = static_cast<std::uint32_t>(random());
        value = bits % 2 == 0 ? points[(bits / 2) % points.size()]
                              : static_cast<float>(bits >> 8) / 16777216.0f;
    }
    return values;
}

}  // namespace

const ProbeInputs& probe_inputs() {
    static const ProbeInputs inputs = [] {
        std::mt19937 random(20240607);
        ProbeInputs planes;
        for (std::vector<float>& values : planes) values = input_plane(random);
        return planes;
    }();
    return inputs;
}

}  // namespace patina
