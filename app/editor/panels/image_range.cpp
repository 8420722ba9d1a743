// SPDX-License-Identifier: MIT
#include "editor/panels/image_range.h"

#include "editor/widgets/color_field.h"
#include "editor/widgets/form.h"
#include "editor/widgets/slider.h"

namespace patina::editor {
namespace {

std::optional<float> open_ended(Ui& ui, const Rect& rect, Parameter parameter, float value) {
    NumberSpec spec = number_spec(parameter);
    spec.level = false;
    spec.drag_per_pixel = spec.step;
    const auto next = number_field(ui, rect, spec, static_cast<double>(value));
    return next ? std::optional(static_cast<float>(*next)) : std::nullopt;
}

Requests draw_color_range(Ui& ui, const Rect& rect, const SourcePlace& place,
                          const ImageSource& source) {
    Requests requests;
    const auto boxes = side_by_side<2>(ui, rect);
    const auto color = [&](const Rect& box, Parameter parameter, const glm::vec3& value) {
        return color_field(
            ui, box, {.label = info(parameter).label, .tooltip = info(parameter).tooltip}, value);
    };
    if (const auto multiply = color(boxes[0], Parameter::ImageMultiply, source.multiply))
        requests.edit(set_image_range(place, *multiply, source.add));
    if (const auto add = color(boxes[1], Parameter::ImageAdd, source.add))
        requests.edit(set_image_range(place, source.multiply, *add));
    return requests;
}

/// What is added when the strength becomes `next`: of a height so much that the number which was
/// the surface (multiplied and added to, 0) is the surface still.
float added_at(const ImageSource& source, std::optional<Channel> channel, float next) {
    if (channel != Channel::Height || source.multiply.x == 0.0f) return source.add.x;
    return source.add.x * next / source.multiply.x;
}

}  // namespace

Requests draw_image_range(Ui& ui, Rect& rest, const EditedSource& edited,
                          const ImageSource& source) {
    const SourcePlace& place = edited.place;
    if (edited.channel && info(*edited.channel).kind == ChannelKind::Color)
        return draw_color_range(ui, next_line(ui, rest), place, source);
    Requests requests;
    const auto boxes = side_by_side<2>(ui, next_line(ui, rest));
    const auto strength = open_ended(ui, boxes[0], Parameter::ImageMultiply, source.multiply.x);
    if (edited.channel == Channel::Normal) {
        if (strength)
            requests.edit(
                set_image_range(place, {*strength, *strength, source.multiply.z}, source.add));
        return requests;
    }
    if (strength)
        requests.edit(set_image_range(place, glm::vec3(*strength),
                                      glm::vec3(added_at(source, edited.channel, *strength))));
    if (const auto add = open_ended(ui, boxes[1], Parameter::ImageAdd, source.add.x))
        requests.edit(set_image_range(place, source.multiply, glm::vec3(*add)));
    return requests;
}

}  // namespace patina::editor
