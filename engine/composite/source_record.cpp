// SPDX-License-Identifier: MIT
#include "composite/source_record.h"

#include <cmath>
#include <map>
#include <vector>

#include "composite/procedural.h"
#include "composite/stack_hash.h"
#include "composite/uniform_values.h"
#include "document/uv_rows.h"

namespace patina {
namespace {

void set_transform(const UvTransform& transform, SourceRecord& record) {
    const UvRows rows = uv_rows(transform);
    record.to_u = rows.u;
    record.to_v = rows.v;
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

void number_patterns(ProgramData& program) {
    std::map<Hash128, std::vector<SourceRecord*>> readers;
    for (SourceRecord& record : program.sources) {
        const auto* const procedural = std::get_if<ProceduralSource>(&record.source);
        if (procedural != nullptr) readers[pattern_hash(*procedural)].push_back(&record);
    }
    const bool with_heights = (program.touched & channel_bit(Channel::Height)) != 0;
    std::int32_t next = 0;
    for (const auto& [hash, records] : readers) {
        if (records.size() == 1 && !with_heights) continue;
        for (SourceRecord* record : records) record->pattern = next;
        ++next;
    }
}

}  // namespace patina
