// SPDX-License-Identifier: MIT
#include <array>

#include "io/gltf_read.h"

namespace patina::io::gltf {
namespace {

// Sums of numbers up to 2^53 do not overflow 64 bits.
constexpr std::int64_t kLargestSize = std::int64_t{1} << 53;
constexpr std::int64_t kLargestCount = std::numeric_limits<std::int32_t>::max();

std::uint64_t size_member(const JsonPlace& place, std::string_view key, std::int64_t least) {
    return static_cast<std::uint64_t>(place.integer(key, least, {least, kLargestSize}));
}

std::optional<ComponentType> component_type(const JsonPlace& place) {
    switch (place.integer("componentType", 0)) {
        case 5120:
            return ComponentType::I8;
        case 5121:
            return ComponentType::U8;
        case 5122:
            return ComponentType::I16;
        case 5123:
            return ComponentType::U16;
        case 5125:
            return ComponentType::U32;
        case 5126:
            return ComponentType::F32;
        default:
            place.fault("componentType", "is not a component type of glTF");
            return std::nullopt;
    }
}

struct Shape {
    std::string_view name;
    int rows;
    int columns;
};
constexpr std::array<Shape, 7> kShapes = {{{"SCALAR", 1, 1},
                                           {"VEC2", 2, 1},
                                           {"VEC3", 3, 1},
                                           {"VEC4", 4, 1},
                                           {"MAT2", 2, 2},
                                           {"MAT3", 3, 3},
                                           {"MAT4", 4, 4}}};

void read_shape(const JsonPlace& place, Accessor& accessor) {
    const std::string type = place.text("type");
    for (const Shape& shape : kShapes) {
        if (shape.name != type) continue;
        accessor.rows = shape.rows;
        accessor.columns = shape.columns;
        return;
    }
    place.fault("type", "is not a type of glTF");
}

/// Bytes from the first to behind the last of `count` elements.
std::uint64_t extent(std::uint64_t count, std::uint64_t stride, std::uint64_t element) {
    return (count - 1) * stride + element;
}

void check_in_view(const JsonPlace& place, const Model& model, int view, std::uint64_t offset,
                   std::uint64_t bytes) {
    if (view < 0) return;
    const std::uint64_t length = model.views[static_cast<std::size_t>(view)].length;
    if (offset > length || bytes > length - offset)
        place.fault({}, fmt::format("ends at byte {} of bufferView {}, which has {}",
                                    offset + bytes, view, length));
}

Sparse read_sparse(const JsonPlace& place, const Model& model, const Accessor& accessor) {
    Sparse sparse;
    sparse.count = place.integer("count", 1, {1, accessor.count});
    if (!place.has("count")) place.fault("count", "is missing");
    const JsonPlace indices = place.object("indices");
    sparse.index_view = indices.required_index("bufferView", model.views.size());
    sparse.index_offset = size_member(indices, "byteOffset", 0);
    sparse.index_type = component_type(indices).value_or(ComponentType::U32);
    if (sparse.index_type != ComponentType::U8 && sparse.index_type != ComponentType::U16 &&
        sparse.index_type != ComponentType::U32)
        indices.fault("componentType", "must be an unsigned integer");
    const JsonPlace values = place.object("values");
    sparse.value_view = values.required_index("bufferView", model.views.size());
    sparse.value_offset = size_member(values, "byteOffset", 0);
    const auto count = static_cast<std::uint64_t>(sparse.count);
    check_in_view(indices, model, sparse.index_view, sparse.index_offset,
                  count * component_bytes(sparse.index_type));
    check_in_view(values, model, sparse.value_view, sparse.value_offset,
                  count * accessor.element_bytes());
    return sparse;
}

Accessor read_accessor(const JsonPlace& place, const Model& model) {
    Accessor accessor;
    accessor.view = place.index("bufferView", model.views.size());
    accessor.offset = size_member(place, "byteOffset", 0);
    accessor.type = component_type(place).value_or(ComponentType::F32);
    accessor.normalized = place.boolean("normalized", false);
    read_shape(place, accessor);
    if (!place.has("count")) place.fault("count", "is missing");
    accessor.count = place.integer("count", 1, {1, kLargestCount});
    if (accessor.view >= 0) {
        const BufferView& view = model.views[static_cast<std::size_t>(accessor.view)];
        const auto stride = static_cast<std::size_t>(view.stride);
        const std::size_t element = accessor.element_bytes();
        if (stride != 0 && stride < element)
            place.fault("bufferView", fmt::format("has a byteStride of {}, elements take {} bytes",
                                                  stride, element));
        check_in_view(place, model, accessor.view, accessor.offset,
                      extent(static_cast<std::uint64_t>(accessor.count),
                             stride != 0 ? stride : element, element));
    }
    if (place.has("sparse")) accessor.sparse = read_sparse(place.object("sparse"), model, accessor);
    return accessor;
}

}  // namespace

void read_buffers(const JsonPlace& root, Model& model) {
    for (const JsonPlace& place : root.objects("buffers")) {
        Buffer buffer;
        if (place.has("uri")) buffer.uri = place.text("uri");
        if (!place.has("byteLength")) place.fault("byteLength", "is missing");
        buffer.length = size_member(place, "byteLength", 1);
        model.buffers.push_back(std::move(buffer));
    }
    for (const JsonPlace& place : root.objects("bufferViews")) {
        BufferView view;
        view.buffer = place.required_index("buffer", model.buffers.size());
        view.offset = size_member(place, "byteOffset", 0);
        if (!place.has("byteLength")) place.fault("byteLength", "is missing");
        view.length = size_member(place, "byteLength", 1);
        view.stride = static_cast<int>(place.integer("byteStride", 0, {1, 252}));
        if (view.buffer >= 0) {
            const auto length = model.buffers[static_cast<std::size_t>(view.buffer)].length;
            if (view.offset > length || view.length > length - view.offset)
                place.fault({}, fmt::format("ends at byte {} of buffer {}, which has {}",
                                            view.offset + view.length, view.buffer, length));
        }
        model.views.push_back(view);
    }
}

void read_accessors(const JsonPlace& root, Model& model) {
    for (const JsonPlace& place : root.objects("accessors"))
        model.accessors.push_back(read_accessor(place, model));
}

}  // namespace patina::io::gltf
