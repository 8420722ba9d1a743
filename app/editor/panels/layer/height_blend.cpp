// SPDX-License-Identifier: MIT
#include <array>

#include "document/edits.h"
#include "editor/panels/layer/parts.h"
#include "editor/widgets/buttons.h"
#include "editor/widgets/form.h"
#include "editor/widgets/slider.h"

namespace patina::editor {

Requests draw_height_blend(Ui& ui, Rect& rest, const LayerSubject& subject) {
    struct Field {
        Parameter parameter;
        float HeightBlend::*member;
    };
    constexpr std::array<Field, 3> kFields = {
        {{Parameter::HeightBlendOffset, &HeightBlend::offset},
         {Parameter::HeightBlendRadius, &HeightBlend::radius},
         {Parameter::HeightBlendContrast, &HeightBlend::contrast}}};
    Requests requests;
    const Place place(ui, "Height blend");
    const HeightBlend& now = subject.layer.height_blend;
    const auto change = [&](const HeightBlend& changed, Parameter parameter) {
        requests.edit(set_layer_height_blend(subject.material, subject.layer, changed, parameter));
    };
    const ParameterInfo& enabled = info(Parameter::HeightBlendEnabled);
    const Rect box = rest.cut_top(ui.px(theme::kFieldHeight)).inset(ui.px(12), 0);
    if (labelled_checkbox(ui, box, enabled.label, now.enabled, enabled.tooltip)) {
        HeightBlend changed = now;
        changed.enabled = !now.enabled;
        change(changed, Parameter::HeightBlendEnabled);
    }
    if (!now.enabled) return requests;
    // Three in a line would leave no room for their names.
    rest.cut_top(ui.px(theme::kGap));
    Rect rows = rest.cut_top(ui.px(2 * theme::kFieldHeight + theme::kGap)).inset(ui.px(12), 0);
    const auto first = side_by_side<2>(ui, next_line(ui, rows));
    const std::array<Rect, 3> boxes = {first[0], first[1], rows};
    for (std::size_t i = 0; i < kFields.size(); ++i) {
        const auto next = number_field(ui, boxes[i], number_spec(kFields[i].parameter),
                                       static_cast<double>(now.*kFields[i].member));
        if (!next) continue;
        HeightBlend changed = now;
        changed.*kFields[i].member = static_cast<float>(*next);
        change(changed, kFields[i].parameter);
    }
    return requests;
}

}  // namespace patina::editor
