// SPDX-License-Identifier: MIT
#pragma once

/// How the triangles of each material lie in its texture, for `info` and `bake`.

#include <nlohmann/json.hpp>
#include <string>

#include "document/document.h"
#include "scene/uv_layout.h"

namespace patina::cli {

UvLayout uv_layout_of(const Document& document, const Material& material);
nlohmann::ordered_json uv_layout_json(const UvLayout& layout);
/// "41 % of the texture is used, 3 % of that by several triangles".
std::string uv_layout_words(const UvLayout& layout);

}  // namespace patina::cli
