// SPDX-License-Identifier: MIT
#pragma once

/// The source tree as text, and what one file includes. Paths are relative to the root of the tree
/// and use '/'.

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace patina::structure {

/// The text of each file by its path.
using SourceTree = std::map<std::string, std::string>;

/// Reads what is written by hand: app/, engine/, shaders/, presets/, tests/, .ci/ and the files at
/// the top. Build folders and pictures are left out.
SourceTree read_source_tree(const std::filesystem::path& root);

struct Include {
    std::string text;  ///< between the quotes or brackets
    bool quoted = false;
    int line = 0;  ///< 1 is the first
};

/// The #include lines of a C++ or GLSL file, in order.
std::vector<Include> includes_of(std::string_view source);

/// The file of the tree that a quoted include names ("core/log.h" is engine/core/log.h); empty if
/// there is none.
std::string resolved_include(const SourceTree& tree, std::string_view text);

/// "engine/core" for "engine/core/log.h".
std::string folder_of(std::string_view path);

bool has_extension(std::string_view path, std::initializer_list<std::string_view> extensions);

}  // namespace patina::structure
