// SPDX-License-Identifier: MIT
#include "editor/panels/levels_fields.h"

#include <array>

#include "editor/widgets/form.h"
#include "editor/widgets/slider.h"

namespace patina::editor {

std::optional<LevelsChange> levels_fields(Ui& ui, Rect& rest, const Levels& now) {
    struct Field {
        Parameter parameter;
        float Levels::*member;
    };
    constexpr std::array<Field, 5> kFields = {{{Parameter::LevelsInLow, &Levels::in_low},
                                               {Parameter::LevelsInHigh, &Levels::in_high},
                                               {Parameter::LevelsGamma, &Levels::gamma},
                                               {Parameter::LevelsOutLow, &Levels::out_low},
                                               {Parameter::LevelsOutHigh, &Levels::out_high}}};
    std::optional<LevelsChange> change;
    std::array<Rect, 2> boxes;
    for (std::size_t i = 0; i < kFields.size(); ++i) {
        if (i % 2 == 0) boxes = side_by_side<2>(ui, next_line(ui, rest));
        const auto next = number_field(ui, boxes[i % 2], number_spec(kFields[i].parameter),
                                       static_cast<double>(now.*kFields[i].member));
        if (!next) continue;
        change = {now, kFields[i].parameter};
        change->levels.*kFields[i].member = static_cast<float>(*next);
    }
    return change;
}

}  // namespace patina::editor
