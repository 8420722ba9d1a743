// SPDX-License-Identifier: MIT
#include "io/element_layout.h"

#include <array>

namespace patina::io {
namespace {

struct ElementShape {
    std::string_view name;
    int rows;
    int columns;
};
constexpr std::array<ElementShape, 7> kShapes = {{{"SCALAR", 1, 1},
                                                  {"VEC2", 2, 1},
                                                  {"VEC3", 3, 1},
                                                  {"VEC4", 4, 1},
                                                  {"MAT2", 2, 2},
                                                  {"MAT3", 3, 3},
                                                  {"MAT4", 4, 4}}};

}  // namespace

std::optional<ComponentType> component_type(std::int64_t number) {
    constexpr std::array kTypes = {ComponentType::I8,  ComponentType::U8,  ComponentType::I16,
                                   ComponentType::U16, ComponentType::U32, ComponentType::F32};
    for (const ComponentType type : kTypes)
        if (static_cast<std::int64_t>(type) == number) return type;
    return std::nullopt;
}

std::size_t component_bytes(ComponentType type) {
    switch (type) {
        case ComponentType::I8:
        case ComponentType::U8:
            return 1;
        case ComponentType::I16:
        case ComponentType::U16:
            return 2;
        case ComponentType::U32:
        case ComponentType::F32:
            return 4;
    }
    return 4;
}

bool is_unsigned(ComponentType type) {
    return type == ComponentType::U8 || type == ComponentType::U16 || type == ComponentType::U32;
}

std::size_t ElementLayout::column_bytes() const {
    const std::size_t bytes = component_bytes(type) * static_cast<std::size_t>(rows);
    return columns == 1 ? bytes : (bytes + 3) / 4 * 4;
}

bool set_shape(ElementLayout& layout, std::string_view name) {
    for (const ElementShape& shape : kShapes) {
        if (shape.name != name) continue;
        layout.rows = shape.rows;
        layout.columns = shape.columns;
        return true;
    }
    return false;
}

}  // namespace patina::io
