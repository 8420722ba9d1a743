// SPDX-License-Identifier: MIT
#include "composite/source_record.h"

#include <cmath>
#include <numbers>

#include "composite/procedural.h"
#include "composite/uniform_values.h"

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

/// KHR_texture_transform: offset + rotation * scale * uv, with the signs of its specification.
void set_transform(const UvTransform& transform, SourceRecord& record) {
    const SineCosine turn = sine_cosine(static_cast<double>(transform.rotation_degrees));
    const auto row = [](double u, double v, double one) { return glm::vec3(u, v, one); };
    const double scale_u = static_cast<double>(transform.scale.x);
    const double scale_v = static_cast<double>(transform.scale.y);
    record.to_u =
        row(turn.cosine * scale_u, turn.sine * scale_v, static_cast<double>(transform.offset.x));
    record.to_v =
        row(-turn.sine * scale_u, turn.cosine * scale_v, static_cast<double>(transform.offset.y));
}

glm::vec3 constant_value(const glm::vec3& value, Reading reading) {
    switch (reading) {
        case Reading::EncodedColor:
            return encoded_color(value);
        case Reading::Normal: {
            const float length = std::sqrt(glm::dot(value, value));
            return length > 0.0f ? value / length : glm::vec3(0.0f, 0.0f, 1.0f);
        }
        case Reading::LinearColor:
        case Reading::Scalar:
        case Reading::Height:
            return value;
    }
    return value;
}

}  // namespace

SourceRecord source_record(const Source& source, Reading reading) {
    SourceRecord record{.source = source, .reading = reading};
    if (const auto* const constant = std::get_if<ConstantSource>(&source)) {
        const glm::vec3 value = constant_value(constant->value, reading);
        record.constant = {UniformPlane(value.x), UniformPlane(value.y), UniformPlane(value.z)};
    }
    if (const auto* const image = std::get_if<ImageSource>(&source))
        set_transform(image->transform, record);
    if (const auto* const procedural = std::get_if<ProceduralSource>(&source)) {
        set_transform(procedural->transform, record);
        record.mean = procedural_mean(*procedural, !is_vector(reading));
    }
    return record;
}

}  // namespace patina
