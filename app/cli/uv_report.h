// SPDX-License-Identifier: MIT
#pragma once

/// How the triangles of each material lie in its texture, for `info` and `bake`.

#include <nlohmann/json.hpp>

#include "document/document.h"
#include "scene/uv_layout.h"

namespace patina::cli {

UvLayout uv_layout_of(const Document& document, const Material& material);
nlohmann::ordered_json uv_layout_json(const UvLayout& layout);

}  // namespace patina::cli
