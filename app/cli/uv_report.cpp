// SPDX-License-Identifier: MIT
#include "cli/uv_report.h"

#include <fmt/format.h>

#include <cmath>

#include "document/worn_surface.h"

namespace patina::cli {
namespace {

/// Nothing is "0 %" but nothing, and nothing "100 %" but all.
std::string percent(double share) {
    if (share > 0.0 && share < 0.01) return "less than 1 %";
    return fmt::format("{:.0f} %", share < 1.0 ? std::floor(100.0 * share) : 100.0);
}

}  // namespace

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

std::string uv_layout_words(const UvLayout& layout) {
    if (layout.triangles == 0) return "no triangle is made of it";
    if (layout.without_uvs == layout.triangles) return "its triangles have no UVs";
    std::string text =
        layout.measured ? fmt::format("{} of the texture is used", percent(layout.used))
                        : fmt::format("too many large triangles to measure ({})", layout.triangles);
    if (layout.overlapped > 0.0)
        text += fmt::format(", {} of that by several triangles", percent(layout.overlapped));
    if (!layout.within_a_tile())
        text += fmt::format(", from ({:.3g}, {:.3g}) to ({:.3g}, {:.3g})", layout.low.x,
                            layout.low.y, layout.high.x, layout.high.y);
    if (layout.without_uvs > 0)
        text += fmt::format(", {} triangles have no UVs", layout.without_uvs);
    return text;
}

}  // namespace patina::cli
