// SPDX-License-Identifier: MIT
#pragma once

/// How the elements of a glTF accessor lie in memory: glTF 2.0, section 3.6.2.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace patina::io {

enum class ComponentType { I8 = 5120, U8, I16, U16, U32 = 5125, F32 };

/// The type with that number in files; nothing for a number that glTF does not have.
std::optional<ComponentType> component_type(std::int64_t number);
std::size_t component_bytes(ComponentType type);
bool is_unsigned(ComponentType type);

struct ElementLayout {
    ComponentType type = ComponentType::F32;
    int rows = 1;
    int columns = 1;  ///< above 1 for matrices

    int components() const { return rows * columns; }
    /// Columns of matrices start at multiples of four bytes.
    std::size_t column_bytes() const;
    std::size_t element_bytes() const { return column_bytes() * static_cast<std::size_t>(columns); }
};

/// Sets rows and columns for "SCALAR", "VEC3" ...; false for a name that glTF does not have.
bool set_shape(ElementLayout& layout, std::string_view name);

}  // namespace patina::io
