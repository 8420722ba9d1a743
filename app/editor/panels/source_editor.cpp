// SPDX-License-Identifier: MIT
#include "editor/panels/source_editor.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "document/check.h"
#include "document/procedural_kinds.h"
#include "document/references.h"
#include "editor/panels/choice_combo.h"
#include "editor/panels/image_range.h"
#include "editor/panels/kind_menus.h"
#include "editor/panels/surface_fields.h"
#include "editor/widgets/buttons.h"
#include "editor/widgets/color_field.h"
#include "editor/widgets/form.h"
#include "editor/widgets/number_text.h"
#include "editor/widgets/ramp_field.h"
#include "editor/widgets/slider.h"

namespace patina::editor {
namespace {

/// In the order of Source.
enum class Kind : std::uint8_t { Value, Image, Procedural, Relief, Layer, Parts };
constexpr std::array<std::string_view, 6> kKindLabels = {"Value",  "Image", "Procedural",
                                                         "Relief", "Layer", "Parts"};

std::vector<LayerPtr> readable_layers(const EditedSource& edited, const Shown& shown) {
    return referable_layers(shown.material->stack, edited.layer);
}

/// A procedural is one number too, whose ramp makes colours of it but no directions: bumps are a
/// procedural of the height. Relief and parts are one number: of masks and scalars. Parts are
/// offered to masks. Another layer is offered where there is one.
std::vector<Kind> kinds_for(const EditedSource& edited, const Shown& shown) {
    const bool normal = edited.channel && info(*edited.channel).kind == ChannelKind::Normal;
    std::vector<Kind> kinds = {Kind::Value, Kind::Image};
    if (!normal || std::holds_alternative<ProceduralSource>(edited.source))
        kinds.push_back(Kind::Procedural);
    if (!edited.channel || info(*edited.channel).kind == ChannelKind::Scalar)
        kinds.push_back(Kind::Relief);
    if (std::holds_alternative<ReferenceSource>(edited.source) ||
        !readable_layers(edited, shown).empty())
        kinds.push_back(Kind::Layer);
    if (std::holds_alternative<GeometrySource>(edited.source) || !edited.channel)
        kinds.push_back(Kind::Parts);
    return kinds;
}

glm::vec3 neutral_value(std::optional<Channel> channel) {
    return channel ? stack_bottom(*channel) : glm::vec3(1.0f);
}

bool is_color(std::optional<Channel> channel) {
    return channel && info(*channel).kind == ChannelKind::Color;
}

ImageSource new_image(const ImageAsset& image, std::optional<Channel> channel) {
    ImageSource source{.image = image.hash};
    if (is_color(channel)) source.color_space = image.color_space;
    return source;
}

/// What a channel reads of another layer at first: its own; a mask the mask.
LayerResult usual_result(std::optional<Channel> channel) {
    return channel ? result_of(*channel) : LayerResult::Mask;
}

Requests change_kind(const EditedSource& edited, Kind kind, const Shown& shown) {
    Requests requests;
    const auto& images = shown.document->images;
    switch (kind) {
        case Kind::Value:
            requests.edit(set_source(edited.place, ConstantSource{neutral_value(edited.channel)}));
            break;
        case Kind::Image:
            if (!images.empty())
                requests.edit(
                    set_source(edited.place, new_image(*images.begin()->second, edited.channel)));
            else if (edited.channel)
                requests.ask(ChooseImageFor{edited.layer, *edited.channel});
            else
                requests.ask(ChooseImageFor{edited.layer, edited.entry});
            break;
        case Kind::Procedural:
            requests.edit(set_source(edited.place, ProceduralSource{}));
            break;
        case Kind::Relief:
            requests.edit(set_source(edited.place, ReliefSource{}));
            break;
        case Kind::Layer:
            if (const auto layers = readable_layers(edited, shown); !layers.empty())
                requests.edit(set_source(edited.place,
                                         ReferenceSource{.layer = layers.front()->id,
                                                         .result = usual_result(edited.channel)}));
            break;
        case Kind::Parts: {
            GeometrySource source;
            if (const auto parts = worn_parts(*shown.document, shown.material->id); !parts.empty())
                source.meshes = {parts.front()};
            requests.edit(set_source(edited.place, std::move(source)));
            break;
        }
    }
    return requests;
}

Requests draw_image_choice(Ui& ui, Rect line_box, const EditedSource& edited,
                           const ImageSource& source, const Shown& shown) {
    Requests requests;
    const TextButton choose{.label = "Choose\u2026", .tooltip = "Take an image from disk"};
    const Rect button = line_box.cut_right(text_button_width(ui, choose));
    line_box.cut_right(ui.px(theme::kGap));
    if (text_button(ui, button, choose)) {
        if (edited.channel)
            requests.ask(ChooseImageFor{edited.layer, *edited.channel});
        else
            requests.ask(ChooseImageFor{edited.layer, edited.entry});
    }
    std::vector<ComboItem> items;
    std::vector<ImageAssetPtr> images;
    int chosen = -1;
    for (const auto& [hash, image] : shown.document->images) {
        if (hash == source.image) chosen = static_cast<int>(items.size());
        items.push_back({.label = image->name});
        images.push_back(image);
    }
    Picture thumbnail;
    if (chosen >= 0) thumbnail = shown.thumbnails->image(*images[static_cast<std::size_t>(chosen)]);
    const auto picked =
        combo(ui, line_box, {.label = "Image", .picture = &thumbnail}, items, chosen);
    if (picked) requests.edit(set_image(edited.place, images[static_cast<std::size_t>(*picked)]));
    return requests;
}

Requests draw_image_switches(Ui& ui, Rect& rest, const EditedSource& edited,
                             const ImageSource& source) {
    Requests requests;
    const auto flags = side_by_side<2>(ui, next_line(ui, rest));
    const auto toggle = [&](const Rect& rect, Parameter parameter, bool on) {
        return labelled_checkbox(ui, rect, info(parameter).label, on, info(parameter).tooltip);
    };
    if (toggle(flags[0], Parameter::ImageInvert, source.invert))
        requests.edit(set_image_invert(edited.place, !source.invert));
    if (edited.channel == Channel::Normal) {
        if (toggle(flags[1], Parameter::ImageDirectxNormal, source.directx_normal))
            requests.edit(set_image_directx_normal(edited.place, !source.directx_normal));
    } else if (toggle(flags[1], Parameter::ImageAlphaIsCoverage, source.alpha_is_coverage)) {
        requests.edit(set_image_alpha_is_coverage(edited.place, !source.alpha_is_coverage));
    }
    return requests;
}

Requests draw_image(Ui& ui, Rect& rest, const EditedSource& edited, const ImageSource& source,
                    const Shown& shown) {
    Requests requests = draw_image_choice(ui, next_line(ui, rest), edited, source, shown);
    const auto reading = side_by_side<2>(ui, next_line(ui, rest));
    if (const auto space =
            parameter_combo(ui, reading[0], Parameter::ImageColorSpace, source.color_space))
        requests.edit(set_image_color_space(edited.place, *space));
    if (const auto pick = parameter_combo(ui, reading[1], Parameter::ImagePick, source.pick))
        requests.edit(set_image_pick(edited.place, *pick));
    const auto wraps = side_by_side<2>(ui, next_line(ui, rest));
    if (const auto wrap = parameter_combo(ui, wraps[0], Parameter::ImageWrapU, source.wrap_u))
        requests.edit(set_image_wrap(edited.place, *wrap, source.wrap_v));
    if (const auto wrap = parameter_combo(ui, wraps[1], Parameter::ImageWrapV, source.wrap_v))
        requests.edit(set_image_wrap(edited.place, source.wrap_u, *wrap));
    const auto filter = parameter_combo(ui, side_by_side<2>(ui, next_line(ui, rest))[0],
                                        Parameter::ImageFilter, source.filter);
    if (filter) requests.edit(set_image_filter(edited.place, *filter));
    requests.append(draw_image_switches(ui, rest, edited, source));
    requests.append(draw_image_range(ui, rest, edited, source));
    return requests;
}

RampSpec ramp_spec(std::optional<Channel> channel) {
    const ParameterInfo& row = info(value_parameter(channel));
    return {.label = "Ramp",
            .color = is_color(channel),
            .minimum = static_cast<float>(row.minimum),
            .maximum = static_cast<float>(row.maximum)};
}

/// A stop that is dragged or recoloured is one step; one that is added or removed too.
Edit ramp_edit(const SourcePlace& place, const std::vector<RampStop>& before,
               std::vector<RampStop> after) {
    if (before.size() == after.size())
        for (std::size_t i = 0; i < after.size(); ++i)
            if (after[i] != before[i]) return set_ramp_stop(place, static_cast<int>(i), after[i]);
    return set_ramp(place, std::move(after));
}

/// A combo of all noises and patterns under their headings.
std::optional<ProceduralKind> procedural_combo(Ui& ui, const Rect& rect, ProceduralKind current) {
    const auto [items, kinds] = procedural_rows();
    const auto chosen = std::find(kinds.begin(), kinds.end(), current) - kinds.begin();
    const ParameterInfo& row = info(Parameter::ProceduralKindChoice);
    const auto picked =
        combo(ui, rect, {.label = row.label, .shown_label = row.label, .tooltip = row.tooltip},
              items, static_cast<int>(chosen));
    if (!picked) return std::nullopt;
    return kinds[static_cast<std::size_t>(*picked)];
}

/// A number that not every kind looks at.
struct ProceduralNumber {
    ProceduralUses use;
    Parameter parameter;
    float ProceduralSource::*member;
    Edit (*edit)(const SourcePlace&, float);
};
constexpr std::array kProceduralNumbers = {
    ProceduralNumber{kUsesWidth, Parameter::ProceduralWidth, &ProceduralSource::width,
                     set_procedural_width},
    ProceduralNumber{kUsesSoftness, Parameter::ProceduralSoftness, &ProceduralSource::softness,
                     set_procedural_softness},
    ProceduralNumber{kUsesVariation, Parameter::ProceduralVariation, &ProceduralSource::variation,
                     set_procedural_variation},
    ProceduralNumber{kUsesAspect, Parameter::ProceduralAspect, &ProceduralSource::aspect,
                     set_procedural_aspect},
};

/// The numbers that the kind of the source looks at, two in a line.
Requests draw_procedural_numbers(Ui& ui, Rect& rest, const SourcePlace& place,
                                 const ProceduralSource& source) {
    Requests requests;
    std::array<Rect, 2> boxes;
    int drawn = 0;
    const auto next_box = [&] {
        if (drawn % 2 == 0) boxes = side_by_side<2>(ui, next_line(ui, rest));
        return boxes[static_cast<std::size_t>(drawn++ % 2)];
    };
    const auto number = [&](Parameter parameter, double value) {
        NumberSpec spec = number_spec(parameter);
        spec.level = true;
        return number_field(ui, next_box(), spec, value);
    };
    if (uses(source.kind, kUsesOctaves))
        if (const auto v = number(Parameter::ProceduralOctaves, source.octaves))
            requests.edit(set_procedural_octaves(place, static_cast<int>(*v)));
    for (const ProceduralNumber& each : kProceduralNumbers) {
        if (!uses(source.kind, each.use)) continue;
        if (const auto v = number(each.parameter, static_cast<double>(source.*each.member)))
            requests.edit(each.edit(place, static_cast<float>(*v)));
    }
    if (const auto v = number(Parameter::ProceduralWarp, static_cast<double>(source.warp)))
        requests.edit(set_procedural_warp(place, static_cast<float>(*v)));
    if (const auto v = number(Parameter::ProceduralBalance, static_cast<double>(source.balance)))
        requests.edit(set_procedural_balance(place, static_cast<float>(*v)));
    return requests;
}

Requests draw_procedural(Ui& ui, Rect& rest, const EditedSource& edited,
                         const ProceduralSource& source) {
    Requests requests;
    const SourcePlace& place = edited.place;
    const auto kind = procedural_combo(ui, next_line(ui, rest), source.kind);
    if (kind) requests.edit(set_procedural_kind(place, *kind));
    const bool has_ramp = !edited.channel || info(*edited.channel).kind != ChannelKind::Normal;
    if (has_ramp) {
        const Rect bar = rest.cut_top(ui.px(34));
        rest.cut_top(ui.px(6));
        if (auto stops = ramp_field(ui, bar, ramp_spec(edited.channel), source.ramp))
            requests.edit(ramp_edit(place, source.ramp, std::move(*stops)));
    }
    const auto number = [&](const Rect& rect, Parameter parameter, double value) {
        NumberSpec spec = number_spec(parameter);
        spec.level = parameter != Parameter::ProceduralSeed;
        spec.drag_per_pixel = spec.level ? 0.0 : 0.2;
        return number_field(ui, rect, spec, value);
    };
    const auto first = side_by_side<3>(ui, next_line(ui, rest));
    if (const auto v =
            number(first[0], Parameter::ProceduralScale, static_cast<double>(source.scale)))
        requests.edit(set_procedural_scale(place, static_cast<float>(*v)));
    if (const auto v =
            number(first[1], Parameter::ProceduralContrast, static_cast<double>(source.contrast)))
        requests.edit(set_procedural_contrast(place, static_cast<float>(*v)));
    if (const auto v = number(first[2], Parameter::ProceduralSeed, source.seed))
        requests.edit(set_procedural_seed(place, static_cast<std::uint32_t>(*v)));
    requests.append(draw_procedural_numbers(ui, rest, place, source));
    return requests;
}

Requests draw_relief(Ui& ui, Rect& rest, const SourcePlace& place, const ReliefSource& now) {
    Requests requests;
    const auto kind =
        parameter_combo(ui, next_line(ui, rest), Parameter::ReliefKindChoice, now.kind);
    ReliefSource changed = now;
    if (kind) {
        changed.kind = *kind;
        requests.edit(set_relief(place, changed, Parameter::ReliefKindChoice));
    }
    const auto boxes = side_by_side<2>(ui, next_line(ui, rest));
    const auto number = [&](const Rect& box, Parameter parameter, float ReliefSource::*member) {
        const auto next =
            number_field(ui, box, number_spec(parameter), static_cast<double>(now.*member));
        if (!next) return;
        changed.*member = static_cast<float>(*next);
        requests.edit(set_relief(place, changed, parameter));
    };
    number(boxes[0], Parameter::ReliefStrength, &ReliefSource::strength);
    // Heights by themselves have no surroundings.
    if (now.kind != ReliefKind::Height)
        number(boxes[1], Parameter::ReliefRadius, &ReliefSource::radius_permille);
    return requests;
}

/// A combo of the layers by name; one that is gone is named by what it is.
Requests draw_layer_choice(Ui& ui, const Rect& rect, const EditedSource& edited,
                           const ReferenceSource& now, const Shown& shown) {
    Requests requests;
    const std::vector<LayerPtr> layers = readable_layers(edited, shown);
    std::vector<ComboItem> items;
    int chosen = -1;
    for (const LayerPtr& layer : layers) {
        if (layer->id == now.layer) chosen = static_cast<int>(items.size());
        items.push_back({.label = layer->name});
    }
    const ParameterInfo& row = info(Parameter::ReferenceLayer);
    const ComboSpec spec{.label = row.label,
                         .shown_label = row.label,
                         .shown_value = chosen < 0 ? "Missing layer" : std::string_view(),
                         .tooltip = row.tooltip};
    const auto picked = combo(ui, rect, spec, items, chosen);
    if (!picked) return requests;
    ReferenceSource changed = now;
    changed.layer = layers[static_cast<std::size_t>(*picked)]->id;
    requests.edit(set_source(edited.place, changed));
    return requests;
}

/// A combo of what can be read for the channel or mask.
Requests draw_result_choice(Ui& ui, const Rect& rect, const EditedSource& edited,
                            const ReferenceSource& now) {
    Requests requests;
    const auto table = choices<LayerResult>();
    std::vector<ComboItem> items;
    std::vector<LayerResult> results;
    int chosen = -1;
    for (std::size_t i = 0; i < table.size(); ++i) {
        const auto result = static_cast<LayerResult>(i);
        if (!reads_result(edited.channel, result)) continue;
        if (result == now.result) chosen = static_cast<int>(items.size());
        items.push_back({.label = table[i].label});
        results.push_back(result);
    }
    const ParameterInfo& row = info(Parameter::ReferenceResult);
    const auto picked =
        combo(ui, rect, {.label = row.label, .shown_label = row.label, .tooltip = row.tooltip},
              items, chosen);
    if (!picked) return requests;
    ReferenceSource changed = now;
    changed.result = results[static_cast<std::size_t>(*picked)];
    requests.edit(set_source(edited.place, changed));
    return requests;
}

Requests draw_direction(Ui& ui, const Rect& rect, const SourcePlace& place,
                        const glm::vec3& value) {
    constexpr std::array<std::string_view, 3> kNames = {"X", "Y", "Z"};
    Requests requests;
    const auto fields = side_by_side<3>(ui, rect);
    for (int i = 0; i < 3; ++i) {
        const auto index = static_cast<std::size_t>(i);
        NumberSpec spec = number_spec(Parameter::NormalValue);
        spec.label = kNames[index];
        spec.shown_label = rect.width() > ui.px(150) ? kNames[index] : std::string_view();
        const auto next = number_field(ui, fields[index], spec, static_cast<double>(value[i]));
        if (!next) continue;
        glm::vec3 changed = value;
        changed[i] = static_cast<float>(*next);
        requests.edit(set_constant(place, changed));
    }
    return requests;
}

}  // namespace

Requests draw_constant(Ui& ui, const Rect& rect, const EditedSource& edited, bool with_label) {
    Requests requests;
    const glm::vec3 value = std::get<ConstantSource>(edited.source).value;
    const Parameter parameter = value_parameter(edited.channel);
    if (edited.channel && info(*edited.channel).kind == ChannelKind::Normal)
        return draw_direction(ui, rect, edited.place, value);
    if (is_color(edited.channel)) {
        const auto next = color_field(
            ui, rect, {.label = info(parameter).label, .tooltip = info(parameter).tooltip}, value);
        if (next) requests.edit(set_constant(edited.place, *next));
        return requests;
    }
    NumberSpec spec = with_label ? number_spec(parameter) : compact_number_spec(parameter);
    spec.standard = static_cast<double>(neutral_value(edited.channel).x);
    if (const auto next = number_field(ui, rect, spec, static_cast<double>(value.x)))
        requests.edit(set_constant(edited.place, glm::vec3(static_cast<float>(*next))));
    return requests;
}

Requests draw_source_editor(Ui& ui, Rect& rest, const EditedSource& edited, const Shown& shown) {
    Requests requests;
    // The row above has the same value with the same name.
    const Place place(ui, "Source");
    const std::vector<Kind> kinds = kinds_for(edited, shown);
    // More than five in a line are cut short.
    const std::size_t in_line = kinds.size() > 5 ? (kinds.size() + 1) / 2 : kinds.size();
    for (std::size_t first = 0; first < kinds.size(); first += in_line) {
        std::vector<std::string_view> labels;
        int current = -1;
        for (std::size_t i = first; i < std::min(first + in_line, kinds.size()); ++i) {
            const auto kind = static_cast<std::size_t>(kinds[i]);
            if (kind == edited.source.index()) current = static_cast<int>(labels.size());
            labels.push_back(kKindLabels[kind]);
        }
        const auto chosen = segmented(ui, next_line(ui, rest), labels, current);
        if (!chosen) continue;
        const Kind kind = kinds[first + static_cast<std::size_t>(*chosen)];
        requests.append(change_kind(edited, kind, shown));
    }
    if (std::holds_alternative<ConstantSource>(edited.source))
        requests.append(draw_constant(ui, next_line(ui, rest), edited, true));
    if (const auto* image = std::get_if<ImageSource>(&edited.source))
        requests.append(draw_image(ui, rest, edited, *image, shown));
    if (const auto* procedural = std::get_if<ProceduralSource>(&edited.source))
        requests.append(draw_procedural(ui, rest, edited, *procedural));
    if (const auto* relief = std::get_if<ReliefSource>(&edited.source))
        requests.append(draw_relief(ui, rest, edited.place, *relief));
    if (const auto* reference = std::get_if<ReferenceSource>(&edited.source)) {
        requests.append(draw_layer_choice(ui, next_line(ui, rest), edited, *reference, shown));
        requests.append(draw_result_choice(ui, next_line(ui, rest), edited, *reference));
    }
    if (const auto* geometry = std::get_if<GeometrySource>(&edited.source))
        requests.append(draw_geometry(ui, rest, edited.place, *geometry, shown));
    return requests;
}

std::string source_name(const Source& source, std::optional<Channel> channel,
                        const Document& document) {
    if (const auto* image = std::get_if<ImageSource>(&source)) {
        const auto found = document.images.find(image->image);
        return found == document.images.end() ? "Missing image" : found->second->name;
    }
    if (const auto* procedural = std::get_if<ProceduralSource>(&source))
        return std::string(choice(procedural->kind).label);
    if (const auto* relief = std::get_if<ReliefSource>(&source))
        return std::string(choice(relief->kind).label);
    if (const auto* reference = std::get_if<ReferenceSource>(&source)) {
        for (const MaterialPtr& material : document.materials)
            if (const LayerPtr layer = find_layer(*material, reference->layer)) return layer->name;
        return "Missing layer";
    }
    if (const auto* geometry = std::get_if<GeometrySource>(&source)) {
        const std::size_t count = geometry->meshes.size() + geometry->materials.size();
        if (count != 1) return fmt::format("{} parts or materials", count);
        return geometry->meshes.empty() ? geometry->materials[0] : geometry->meshes[0];
    }
    const glm::vec3 value = std::get<ConstantSource>(source).value;
    return is_color(channel) ? hex_color(value) : number_text(static_cast<double>(value.x));
}

}  // namespace patina::editor
