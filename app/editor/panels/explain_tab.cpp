// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "editor/panels/panels.h"
#include "editor/widgets/color_field.h"
#include "editor/widgets/number_text.h"

namespace patina::editor {
namespace {

std::string value_words(Channel channel, const glm::vec3& value) {
    switch (info(channel).kind) {
        case ChannelKind::Color:
            return hex_color(value);
        case ChannelKind::Normal:
            return fmt::format("{} {} {}", number_text(static_cast<double>(value.x)),
                               number_text(static_cast<double>(value.y)),
                               number_text(static_cast<double>(value.z)));
        case ChannelKind::Scalar:
        case ChannelKind::Height:
            return number_text(static_cast<double>(value.x));
    }
    return {};
}

struct ExplainColumns {
    Rect layer;
    Rect value;
    Rect weight;
    Rect result;
};

ExplainColumns explain_columns(const Ui& ui, Rect row, Channel channel) {
    ExplainColumns columns;
    const float wide = ui.px(info(channel).kind == ChannelKind::Normal  ? 104
                             : info(channel).kind == ChannelKind::Color ? 62
                                                                        : 44);
    columns.result = row.cut_right(wide);
    row.cut_right(ui.px(8));
    columns.weight = row.cut_right(ui.px(42));
    row.cut_right(ui.px(8));
    columns.value = row.cut_right(wide);
    row.cut_right(ui.px(8));
    columns.layer = row;
    return columns;
}

void draw_heading(const Ui& ui, const Rect& row, Channel channel) {
    const ExplainColumns columns = explain_columns(ui, row, channel);
    const ImFont* font = ui.fonts.caption11;
    text(ui, columns.layer, font, theme::kText3, "Layer");
    text(ui, columns.value, font, theme::kText3, "Value", Align::Right);
    text(ui, columns.weight, font, theme::kText3, "Weight", Align::Right);
    text(ui, columns.result, font, theme::kText3, "Result", Align::Right);
    hairline(ui, {row.x0, row.y1 - ui.px(1), row.x1, row.y1}, theme::kTableLine);
}

void draw_step(Ui& ui, const Rect& row, const ExplainStep& step, Channel channel, ViewState& view) {
    const bool of_layer = step.layer != LayerId{};
    const bool lit = of_layer && view.layer == step.layer;
    const Tip covered{.title = step.layer_name,
                      .text = fmt::format("The group covers {} of this channel so far.",
                                          number_text(static_cast<double>(step.coverage)))};
    const Place place(ui, step.layer_name, step.layer.value);
    const Press pressed = press(ui, row,
                                {.label = step.layer_name,
                                 .kind = "step",
                                 .value = value_words(channel, step.result),
                                 .tip = step.depth > 0 ? &covered : nullptr});
    if (lit || pressed.hovered) fill(ui, row, lit ? theme::kSelected : theme::kRowHover);
    if (pressed.clicked && of_layer) view.layer = step.layer;
    ExplainColumns columns = explain_columns(ui, row, channel);
    columns.layer.x0 += ui.px(12) * static_cast<float>(step.depth);
    text(ui, columns.layer, ui.fonts.value12, lit ? theme::kText : theme::kText2, step.layer_name);
    text(ui, columns.value, ui.fonts.value12, theme::kText, value_words(channel, step.source),
         Align::Right);
    text(ui, columns.weight, ui.fonts.value12, theme::kText,
         number_text(static_cast<double>(step.weight)), Align::Right);
    text(ui, columns.result, ui.fonts.medium12, theme::kText, value_words(channel, step.result),
         Align::Right);
}

void draw_hint(const Ui& ui, Rect rect, std::string_view words) {
    paragraph(ui, rect.inset(ui.px(12), ui.px(12)), ui.fonts.body13, theme::kText3, words);
}

}  // namespace

Requests draw_explain_tab(Ui& ui, const Rect& rect, const Shown& shown, ViewState& view) {
    Requests requests;
    if (!shown.texel) {
        draw_hint(ui, rect,
                  "Take the eyedropper (I) and click the model: every layer's value, weight and "
                  "result for that texel.");
        return requests;
    }
    const TexelShown& texel = *shown.texel;
    if (!texel.channel) {
        draw_hint(ui, rect,
                  "This channel is not made by layers: show one that is, such as "
                  "Roughness.");
        return requests;
    }
    Rect rest = rect.inset(ui.px(12), ui.px(12));
    const Channel channel = *texel.channel;
    const std::string result =
        texel.steps.empty() ? "" : value_words(channel, texel.steps.back().result);
    text(ui, rest.cut_top(ui.px(18)), ui.fonts.name15, theme::kText,
         fmt::format("{} {}", info(channel).label, result));
    rest.cut_top(ui.px(4));
    const MaterialPtr material = find_material(*shown.document, texel.material);
    text(ui, rest.cut_top(ui.px(14)), ui.fonts.caption11, theme::kText3,
         fmt::format("{} \u00b7 UV {:.3f}, {:.3f} \u00b7 texel {}, {}",
                     material ? material->name : "", texel.probe.uv.x, texel.probe.uv.y,
                     texel.texel_x, texel.texel_y));
    rest.cut_top(ui.px(8));
    draw_heading(ui, rest.cut_top(ui.px(24)), channel);
    const Rect foot = rest.cut_bottom(ui.px(34));
    paragraph(
        ui, foot, ui.fonts.caption11, theme::kText3,
        "Weight is opacity \u00d7 channel opacity \u00d7 mask. Click another texel to explain "
        "it; Esc closes.");
    ScrollArea area(ui, "steps", rest);
    Rect row = area.content();
    row.y1 = row.y0 + ui.px(22);
    for (auto step = texel.steps.rbegin(); step != texel.steps.rend(); ++step) {
        draw_step(ui, row, *step, channel, view);
        row = row.moved(0, row.height());
    }
    area.set_height(static_cast<float>(texel.steps.size()) * row.height());
    return requests;
}

}  // namespace patina::editor
