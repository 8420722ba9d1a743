// SPDX-License-Identifier: MIT
#include "io/accessor_read.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace patina::io {
namespace {

using tinygltf::Accessor;
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

/// The bytes of a view, from `offset` on.
Result<ByteSpan> view_bytes(const GltfData& data, int index, std::size_t offset) {
    const auto& view = data.model.bufferViews[static_cast<std::size_t>(index)];
    const ByteSpan buffer = data.buffers[static_cast<std::size_t>(view.buffer)];
    if (buffer.size() < view.byteOffset + view.byteLength)
        return failure("/buffers/{}: has no data", view.buffer);
    return buffer.subspan(view.byteOffset, view.byteLength).subspan(offset);
}

/// Calls `store(index of the component, its address)` for each of `count` elements.
template <typename Store>
void for_each_component(const ElementLayout& layout, ByteSpan bytes, std::size_t stride,
                        std::size_t element, Store&& store) {
    const auto rows = static_cast<std::size_t>(layout.rows);
    const std::size_t component = component_bytes(layout.type);
    std::size_t out = element * static_cast<std::size_t>(layout.components());
    const std::byte* at = bytes.data() + stride;
    for (std::size_t column = 0; column < static_cast<std::size_t>(layout.columns); ++column)
        for (std::size_t row = 0; row < rows; ++row)
            store(out++, at + column * layout.column_bytes() + row * component);
}

/// Visits all components of the dense part, then those that the sparse part replaces.
template <typename Store>
Status visit_components(const GltfData& data, int index, Store&& store) {
    const Accessor& accessor = data.model.accessors[static_cast<std::size_t>(index)];
    const ElementLayout layout = layout_of(accessor);
    const std::size_t element_bytes = layout.element_bytes();
    if (accessor.bufferView >= 0) {
        const auto bytes = view_bytes(data, accessor.bufferView, accessor.byteOffset);
        if (!bytes) return passed_on(bytes);
        const std::size_t view_stride =
            data.model.bufferViews[static_cast<std::size_t>(accessor.bufferView)].byteStride;
        const std::size_t stride = view_stride != 0 ? view_stride : element_bytes;
        for (std::size_t i = 0; i < accessor.count; ++i)
            for_each_component(layout, *bytes, i * stride, i, store);
    }
    if (!accessor.sparse.isSparse) return {};
    const auto& sparse = accessor.sparse;
    const auto indices = view_bytes(data, sparse.indices.bufferView, sparse.indices.byteOffset);
    if (!indices) return passed_on(indices);
    const auto values = view_bytes(data, sparse.values.bufferView, sparse.values.byteOffset);
    if (!values) return passed_on(values);
    const ComponentType index_type =
        component_type(sparse.indices.componentType).value_or(ComponentType::U32);
    const std::size_t index_bytes = component_bytes(index_type);
    const auto count = static_cast<std::int64_t>(accessor.count);
    std::int64_t previous = -1;
    for (std::size_t i = 0; i < static_cast<std::size_t>(sparse.count); ++i) {
        const std::int64_t element =
            component_as_unsigned(indices->data() + i * index_bytes, index_type);
        if (element <= previous || element >= count)
            return failure(
                "/accessors/{}/sparse/indices: index {} is {}, must ascend and be below {}", index,
                i, element, count);
        previous = element;
        for_each_component(layout, *values, i * element_bytes, static_cast<std::size_t>(element),
                           store);
    }
    return {};
}

std::size_t number_count(const Accessor& accessor) {
    return accessor.count * static_cast<std::size_t>(layout_of(accessor).components());
}

}  // namespace

Result<std::vector<float>> read_floats(const GltfData& data, int accessor_index,
                                       std::size_t& not_finite) {
    const Accessor& accessor = data.model.accessors[static_cast<std::size_t>(accessor_index)];
    std::vector<float> numbers(number_count(accessor));
    const ComponentType type = layout_of(accessor).type;
    const auto status =
        visit_components(data, accessor_index, [&](std::size_t i, const std::byte* at) {
            numbers[i] = component_as_float(at, type, accessor.normalized);
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
    const ComponentType type = layout_of(accessor).type;
    if (!is_unsigned(type))
        return failure("/accessors/{}: must hold unsigned integers", accessor_index);
    std::vector<std::uint32_t> numbers(number_count(accessor));
    const auto status = visit_components(
        data, accessor_index,
        [&](std::size_t i, const std::byte* at) { numbers[i] = component_as_unsigned(at, type); });
    if (!status) return passed_on(status);
    return numbers;
}

}  // namespace patina::io
