// SPDX-License-Identifier: MIT
#include "render/shader_variants.h"

namespace patina::render {

ShaderVariants::ShaderVariants(std::filesystem::path folder) : folder_(std::move(folder)) {}

Result<gl::Program*> ShaderVariants::program(const ShaderVariant& variant) {
    std::string key(variant.fragment_file);
    for (const gl::ShaderDefine& constant : variant.constants)
        key += " " + constant.name + "=" + constant.value;
    if (const auto found = programs_.find(key); found != programs_.end()) return &found->second;
    Result<gl::Program> made =
        gl::Program::make({.label = key,
                           .folders = {folder_},
                           .vertex_file = std::string(variant.vertex_file),
                           .fragment_file = std::string(variant.fragment_file),
                           .defines = variant.constants,
                           .geometry_file = std::string(variant.geometry_file)});
    if (!made) return passed_on(made);
    return &programs_.emplace(std::move(key), std::move(*made)).first->second;
}

}  // namespace patina::render
