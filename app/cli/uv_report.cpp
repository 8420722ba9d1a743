// SPDX-License-Identifier: MIT
#include "cli/uv_report.h"

#include "document/worn_surface.h"

namespace patina::cli {

UvLayout uv_layout_of(const Document& document, const Material& material) {
    return uv_layout(*worn_surface(document, material));
}

nlohmann::ordered_json uv_layout_json(const UvLayout& layout) {
    const auto known = [&](double share) {
        return layout.measured ? nlohmann::ordered_json(share) : nlohmann::ordered_json();
    };
    return {{"used", known(layout.used)},          {"overlapped", known(layout.overlapped)},
            {"low", {layout.low.x, layout.low.y}}, {"high", {layout.high.x, layout.high.y}},
            {"triangles", layout.triangles},       {"triangles_without_uvs", layout.without_uvs}};
}

}  // namespace patina::cli
