// SPDX-License-Identifier: MIT
#include "document/uv_rows.h"

#include <cmath>
#include <numbers>

namespace patina {
namespace {

struct SineCosine {
    double sine;
    double cosine;
};

/// Exact at the quarter turns. Elsewhere libm's last digit in double is far below the float that
/// is kept, so that every machine resolves the same matrix.
SineCosine sine_cosine(double degrees) {
    const double turn = std::remainder(degrees, 360.0);
    if (turn == 0.0) return {0.0, 1.0};
    if (turn == 90.0) return {1.0, 0.0};
    if (turn == -90.0) return {-1.0, 0.0};
    if (std::abs(turn) == 180.0) return {0.0, -1.0};
    const double radians = turn * std::numbers::pi / 180.0;
    return {std::sin(radians), std::cos(radians)};
}

}  // namespace

UvRows uv_rows(const UvTransform& transform) {
    const SineCosine turn = sine_cosine(static_cast<double>(transform.rotation_degrees));
    const auto row = [](double u, double v, double one) { return glm::vec3(u, v, one); };
    const double scale_u = static_cast<double>(transform.scale.x);
    const double scale_v = static_cast<double>(transform.scale.y);
    return {.u = row(turn.cosine * scale_u, turn.sine * scale_v,
                     static_cast<double>(transform.offset.x)),
            .v = row(-turn.sine * scale_u, turn.cosine * scale_v,
                     static_cast<double>(transform.offset.y))};
}

}  // namespace patina
