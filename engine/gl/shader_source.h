// SPDX-License-Identifier: MIT
#pragma once

/// The text of a shader, put together from files.

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace patina::gl {

/// `#define name value`, put in front of a shader. Prefer uniforms; this is for array sizes and for
/// variants that a driver must not keep registers for.
struct ShaderDefine {
    std::string name;
    std::string value;
    bool operator==(const ShaderDefine&) const = default;
};

/// Where a line of a shader's text came from.
struct ShaderLine {
    std::string file;  // empty for lines that the loader wrote
    int line = 0;      // counted from 1
    bool operator==(const ShaderLine&) const = default;
};

struct ShaderSource {
    std::string text;
    std::vector<ShaderLine> lines;  // line i of the text, counted from 0
};

/// Puts a shader together: `#version 410 core`, the defines, shared/prelude.glsl, then `file` with
/// each `#include "path"` replaced by that file, the first time that it is named. Paths are
/// relative to one of `folders`, searched in order. A file must not state a #version. Fails for a
/// missing file and for a path that leaves the folders.
Result<ShaderSource> load_shader_source(std::span<const std::filesystem::path> folders,
                                        std::string_view file,
                                        std::span<const ShaderDefine> defines);

/// A driver's log with its line numbers ("0:217(5): error") replaced by where those lines came from
/// ("shared/blend.glsl:17(5): error"). Not done with #line: Mesa names the wrong file for some
/// errors.
std::string log_with_file_names(std::string_view log, const ShaderSource& source);

}  // namespace patina::gl
