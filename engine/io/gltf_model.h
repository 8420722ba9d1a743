// SPDX-License-Identifier: MIT
#pragma once

/// A glTF file's model as tinygltf parses it, and how Patina reads tinygltf's types.
///
/// tinygltf parses everything but the bytes. Buffers and images stay Patina's (gltf_files.h): it
/// reads files by its own rules of where they may lie, holds what it read for the splicing save,
/// and needs no second copy of each buffer, which is what tinygltf makes of a binary chunk, a file
/// or base64. `buffers[].data` and `images[].image` are therefore empty.

#include <tiny_gltf.h>

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/result.h"
#include "io/element_layout.h"

namespace patina::io {

/// Has tinygltf parse a JSON that check_gltf passed; every index, size and count in the result is
/// what was checked. `defaultScene` is the scene to show, -1 when there is none. Animations, which
/// Patina does not play, and extensions and extras that it does not show are left out.
/// @param json  used up
Result<tinygltf::Model> parse_gltf(nlohmann::json json);

/// extras.patina of a material or a scene, where that is a string.
std::optional<std::string> record_text(const tinygltf::Value& extras);

ElementLayout layout_of(const tinygltf::Accessor& accessor);

/// A member of an extension: its object, or an empty one.
const tinygltf::Value& extension_of(const tinygltf::ExtensionMap& extensions, const char* name);
double number_in(const tinygltf::Value& object, const char* key, double fallback);
/// An index in an extension; -1 where it is absent.
int index_in(const tinygltf::Value& object, const char* key);
/// Fills `numbers`, as many as there are; they are left alone where the member is absent.
void numbers_in(const tinygltf::Value& object, const char* key, std::span<float> numbers);

}  // namespace patina::io
