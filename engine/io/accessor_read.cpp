// SPDX-License-Identifier: MIT
#include "io/accessor_read.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace patina::io {
namespace {

using gltf::Accessor;
using gltf::ComponentType;
using ByteSpan = std::span<const std::byte>;

template <typename T>
T load(const std::byte* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

/// glTF 2.0, section 3.6.2.2: f = max(c / largest, -1).
template <typename T>
float as_float(const std::byte* at, bool normalized) {
    const auto value = static_cast<float>(load<T>(at));
    if (!normalized) return value;
    return std::max(value / static_cast<float>(std::numeric_limits<T>::max()), -1.0f);
}

float component_as_float(const std::byte* at, ComponentType type, bool normalized) {
    switch (type) {
        case ComponentType::I8:
            return as_float<std::int8_t>(at, normalized);
        case ComponentType::U8:
            return as_float<std::uint8_t>(at, normalized);
        case ComponentType::I16:
            return as_float<std::int16_t>(at, normalized);
        case ComponentType::U16:
            return as_float<std::uint16_t>(at, normalized);
        case ComponentType::U32:
            return as_float<std::uint32_t>(at, normalized);
        case ComponentType::F32:
            return load<float>(at);
    }
    return 0.0f;
}

std::uint32_t component_as_unsigned(const std::byte* at, ComponentType type) {
    switch (type) {
        case ComponentType::U8:
            return load<std::uint8_t>(at);
        case ComponentType::U16:
            return load<std::uint16_t>(at);
        default:
            return load<std::uint32_t>(at);
    }
}

bool is_unsigned(ComponentType type) {
    return type == ComponentType::U8 || type == ComponentType::U16 || type == ComponentType::U32;
}

/// The bytes of a view, from `offset` on.
Result<ByteSpan> view_bytes(const GltfData& data, int index, std::uint64_t offset) {
    const auto& view = data.model.views[static_cast<std::size_t>(index)];
    const ByteSpan buffer = data.buffers[static_cast<std::size_t>(view.buffer)];
    if (buffer.size() < view.offset + view.length)
        return failure("/buffers/{}: has no data", view.buffer);
    return buffer.subspan(view.offset, view.length).subspan(offset);
}

/// Calls `store(index of the component, its address)` for each of `count` elements.
template <typename Store>
void for_each_component(const Accessor& accessor, ByteSpan bytes, std::size_t stride,
                        std::size_t element, Store&& store) {
    const auto rows = static_cast<std::size_t>(accessor.rows);
    const std::size_t component = gltf::component_bytes(accessor.type);
    std::size_t out = element * static_cast<std::size_t>(accessor.components());
    const std::byte* at = bytes.data() + stride;
    for (std::size_t column = 0; column < static_cast<std::size_t>(accessor.columns); ++column)
        for (std::size_t row = 0; row < rows; ++row)
            store(out++, at + column * accessor.column_bytes() + row * component);
}

/// Visits all components of the dense part, then those that the sparse part replaces.
template <typename Store>
Status visit_components(const GltfData& data, int index, Store&& store) {
    const Accessor& accessor = data.model.accessors[static_cast<std::size_t>(index)];
    const std::size_t element_bytes = accessor.element_bytes();
    if (accessor.view >= 0) {
        const auto bytes = view_bytes(data, accessor.view, accessor.offset);
        if (!bytes) return passed_on(bytes);
        const int view_stride = data.model.views[static_cast<std::size_t>(accessor.view)].stride;
        const std::size_t stride =
            view_stride != 0 ? static_cast<std::size_t>(view_stride) : element_bytes;
        for (std::size_t i = 0; i < static_cast<std::size_t>(accessor.count); ++i)
            for_each_component(accessor, *bytes, i * stride, i, store);
    }
    if (!accessor.sparse) return {};
    const gltf::Sparse& sparse = *accessor.sparse;
    const auto indices = view_bytes(data, sparse.index_view, sparse.index_offset);
    if (!indices) return passed_on(indices);
    const auto values = view_bytes(data, sparse.value_view, sparse.value_offset);
    if (!values) return passed_on(values);
    const std::size_t index_bytes = gltf::component_bytes(sparse.index_type);
    std::int64_t previous = -1;
    for (std::size_t i = 0; i < static_cast<std::size_t>(sparse.count); ++i) {
        const std::int64_t element =
            component_as_unsigned(indices->data() + i * index_bytes, sparse.index_type);
        if (element <= previous || element >= accessor.count)
            return failure(
                "/accessors/{}/sparse/indices: index {} is {}, must ascend and be below {}", index,
                i, element, accessor.count);
        previous = element;
        for_each_component(accessor, *values, i * element_bytes, static_cast<std::size_t>(element),
                           store);
    }
    return {};
}

std::size_t number_count(const Accessor& accessor) {
    return static_cast<std::size_t>(accessor.count) *
           static_cast<std::size_t>(accessor.components());
}

}  // namespace

Result<std::vector<float>> read_floats(const GltfData& data, int accessor_index,
                                       std::size_t& not_finite) {
    const Accessor& accessor = data.model.accessors[static_cast<std::size_t>(accessor_index)];
    std::vector<float> numbers(number_count(accessor));
    const auto status =
        visit_components(data, accessor_index, [&](std::size_t i, const std::byte* at) {
            const float value = component_as_float(at, accessor.type, accessor.normalized);
            numbers[i] = value;
        });
    if (!status) return passed_on(status);
    for (float& number : numbers) {
        if (std::isfinite(number)) continue;
        number = 0.0f;
        ++not_finite;
    }
    return numbers;
}

Result<std::vector<std::uint32_t>> read_unsigned(const GltfData& data, int accessor_index) {
    const Accessor& accessor = data.model.accessors[static_cast<std::size_t>(accessor_index)];
    if (!is_unsigned(accessor.type))
        return failure("/accessors/{}: must hold unsigned integers", accessor_index);
    std::vector<std::uint32_t> numbers(number_count(accessor));
    const auto status =
        visit_components(data, accessor_index, [&](std::size_t i, const std::byte* at) {
            numbers[i] = component_as_unsigned(at, accessor.type);
        });
    if (!status) return passed_on(status);
    return numbers;
}

}  // namespace patina::io
