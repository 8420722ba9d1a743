// SPDX-License-Identifier: MIT
#include "editor/widgets/heat.h"

#include "core/formulae/formulae.h"

namespace patina::editor {

void heat_bar(const Ui& ui, const Rect& rect) {
    constexpr int kSteps = 64;
    const auto color_at = [](int step) {
        const formulae::Real3 srgb =
            formulae::heat_map_inferno(static_cast<float>(step) / static_cast<float>(kSteps));
        return ImGui::ColorConvertFloat4ToU32(ImVec4(srgb.x, srgb.y, srgb.z, 1.0f));
    };
    for (int i = 0; i < kSteps; ++i) {
        const float left = rect.x0 + rect.width() * static_cast<float>(i) / kSteps;
        const float right = rect.x0 + rect.width() * static_cast<float>(i + 1) / kSteps;
        const ImU32 a = with_alpha(color_at(i), ui.alpha);
        const ImU32 b = with_alpha(color_at(i + 1), ui.alpha);
        ImGui::GetWindowDrawList()->AddRectFilledMultiColor(ImVec2(left, rect.y0),
                                                            ImVec2(right, rect.y1), a, b, b, a);
    }
}

}  // namespace patina::editor
