// SPDX-License-Identifier: MIT
#include <array>

#include "io/gltf_check.h"

namespace patina::io {
namespace {

// Sums of numbers up to 2^53 do not overflow 64 bits.
constexpr std::int64_t kLargestSize = std::int64_t{1} << 53;
constexpr std::int64_t kLargestCount = std::numeric_limits<std::int32_t>::max();

std::uint64_t size_member(const JsonPlace& place, std::string_view key, std::int64_t least,
                          std::int64_t largest = kLargestSize) {
    return static_cast<std::uint64_t>(place.integer(key, least, {least, largest}));
}

std::uint64_t required_size(const JsonPlace& place, std::string_view key) {
    if (!place.has(key)) place.fault(key, "is missing");
    return size_member(place, key, 1);
}

ComponentType checked_component_type(const JsonPlace& place) {
    const auto type = component_type(place.integer("componentType", 0));
    if (!type) place.fault("componentType", "is not a component type of glTF");
    return type.value_or(ComponentType::U32);
}

/// Bytes from the first to behind the last of `count` elements.
std::uint64_t extent(std::uint64_t count, std::uint64_t stride, std::uint64_t element) {
    return (count - 1) * stride + element;
}

void check_in_view(const JsonPlace& place, const CheckedGltf& checked, int view,
                   std::uint64_t offset, std::uint64_t bytes) {
    if (view < 0) return;
    const std::uint64_t length = checked.views[static_cast<std::size_t>(view)].bytes;
    if (offset > length || bytes > length - offset)
        place.fault({}, fmt::format("ends at byte {} of bufferView {}, which has {}",
                                    offset + bytes, view, length));
}

/// The part of an accessor that replaces some of its elements.
void check_sparse(const JsonPlace& place, const CheckedGltf& checked,
                  const CheckedAccessor& accessor) {
    // tinygltf holds these offsets in 32 bits.
    constexpr std::int64_t kLargestOffset = std::numeric_limits<std::int32_t>::max();
    const std::int64_t count = place.integer("count", 1, {1, accessor.count});
    if (!place.has("count")) place.fault("count", "is missing");
    const JsonPlace indices = place.object("indices");
    const int index_view = indices.required_index("bufferView", checked.views.size());
    const std::uint64_t index_offset = size_member(indices, "byteOffset", 0, kLargestOffset);
    const ComponentType index_type = checked_component_type(indices);
    if (!is_unsigned(index_type)) indices.fault("componentType", "must be an unsigned integer");
    const JsonPlace values = place.object("values");
    const int value_view = values.required_index("bufferView", checked.views.size());
    const std::uint64_t value_offset = size_member(values, "byteOffset", 0, kLargestOffset);
    const auto elements = static_cast<std::uint64_t>(count);
    check_in_view(indices, checked, index_view, index_offset,
                  elements * component_bytes(index_type));
    check_in_view(values, checked, value_view, value_offset,
                  elements * accessor.layout.element_bytes());
}

CheckedAccessor check_accessor(const JsonPlace& place, const CheckedGltf& checked) {
    CheckedAccessor accessor;
    const int view_index = place.index("bufferView", checked.views.size());
    const std::uint64_t offset = size_member(place, "byteOffset", 0);
    accessor.layout.type = checked_component_type(place);
    place.boolean("normalized", false);
    if (!set_shape(accessor.layout, place.text("type")))
        place.fault("type", "is not a type of glTF");
    if (!place.has("count")) place.fault("count", "is missing");
    accessor.count = place.integer("count", 1, {1, kLargestCount});
    if (view_index >= 0) {
        const CheckedView& view = checked.views[static_cast<std::size_t>(view_index)];
        const std::size_t element = accessor.layout.element_bytes();
        if (view.stride != 0 && view.stride < element)
            place.fault("bufferView", fmt::format("has a byteStride of {}, elements take {} bytes",
                                                  view.stride, element));
        check_in_view(place, checked, view_index, offset,
                      extent(static_cast<std::uint64_t>(accessor.count),
                             view.stride != 0 ? view.stride : element, element));
    }
    if (place.has("sparse")) check_sparse(place.object("sparse"), checked, accessor);
    return accessor;
}

CheckedView check_view(const JsonPlace& place, const CheckedGltf& checked) {
    CheckedView view;
    const int buffer = place.required_index("buffer", checked.buffer_bytes.size());
    const std::uint64_t offset = size_member(place, "byteOffset", 0);
    view.bytes = required_size(place, "byteLength");
    view.stride = static_cast<std::size_t>(place.integer("byteStride", 0, {1, 252}));
    if (buffer < 0) return view;
    const std::uint64_t length = checked.buffer_bytes[static_cast<std::size_t>(buffer)];
    if (offset > length || view.bytes > length - offset)
        place.fault({}, fmt::format("ends at byte {} of buffer {}, which has {}",
                                    offset + view.bytes, buffer, length));
    return view;
}

}  // namespace

void check_buffers(const JsonPlace& root, CheckedGltf& checked) {
    for (const JsonPlace& place : root.objects("buffers")) {
        if (place.has("uri") && place.text("uri").empty()) place.fault("uri", "is empty");
        checked.buffer_bytes.push_back(required_size(place, "byteLength"));
    }
    for (const JsonPlace& place : root.objects("bufferViews"))
        checked.views.push_back(check_view(place, checked));
}

void check_accessors(const JsonPlace& root, CheckedGltf& checked) {
    for (const JsonPlace& place : root.objects("accessors"))
        checked.accessors.push_back(check_accessor(place, checked));
}

}  // namespace patina::io
