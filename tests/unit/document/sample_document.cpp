// SPDX-License-Identifier: MIT
#include "unit/document/sample_document.h"

#include <algorithm>
#include <functional>
#include <limits>

#include "document/preset.h"
#include "document/small_layers.h"

namespace patina::test_support {
namespace {

Layer named(Layer layer, std::string name, std::uint64_t id) {
    layer.name = std::move(name);
    layer.id = LayerId{id};
    return layer;
}

Layer masked_layer() {
    Layer layer = named(procedural_layer(ProceduralKind::WorleyNoise), "Verdigris", 4);
    layer.opacity = 0.92f;
    layer.mode = BlendMode::Multiply;
    at(layer.channels, Channel::Height).enabled = true;
    at(layer.channels, Channel::Height).opacity = 0.35f;
    MaskEntry drips = procedural_mask_entry(ProceduralKind::PerlinNoise);
    drips.id = MaskEntryId{5};
    drips.name = "Drips";
    drips.levels.gamma = 2.2f;
    MaskEntry cavities = image_mask_entry(*sample_image());
    cavities.id = MaskEntryId{6};
    cavities.combine = BlendMode::Subtract;
    layer.mask.entries = {drips, cavities};
    return layer;
}

Layer group_of(std::vector<LayerPtr> children, std::string name, std::uint64_t id) {
    Layer group = named(group_layer(), std::move(name), id);
    group.content = GroupContent{.children = std::move(children), .open = true};
    return group;
}

Material first_material() {
    Material material;
    material.id = MaterialId{1};
    material.name = "Bonnet";
    material.source_material = 0;
    const LayerPtr inner = shared(group_of({shared(named(value_layer(), "Salt", 9))}, "Inner", 8));
    material.stack = {
        shared(named(image_layer(*sample_image()), "Imported textures", 3)),
        shared(group_of({shared(masked_layer()), inner}, "Weathering", 7)),
        shared(named(value_layer(), "Edge polish", 10)),
    };
    return material;
}

Material second_material() {
    Material material;
    material.id = MaterialId{2};
    material.name = "Glass";
    material.source_material = 1;
    material.resolution = 512;
    material.alpha_mode = AlphaMode::Blend;
    material.stack = {shared(named(value_layer(), "Fill", 11))};
    return material;
}

/// Two parts, one of each material.
ScenePtr sample_scene() {
    Mesh mesh{.name = "Helmet", .primitives = {}};
    for (int i = 0; i < 2; ++i) {
        Primitive part;
        part.positions.assign(3, glm::vec3(0.0f));
        part.indices = {0, 1, 2};
        part.source_material = i;
        part.source = {.mesh = 0, .primitive = i};
        mesh.primitives.push_back(part);
    }
    Scene scene;
    scene.meshes = {mesh};
    scene.instances = {{.mesh = 0, .world_from_local = glm::mat4(1.0f), .name = "Helmet"}};
    return std::make_shared<const Scene>(std::move(scene));
}

Preset small_preset(int layers) {
    Preset preset;
    preset.name = "Two coats";
    for (int i = 0; i < layers; ++i) preset.layers.push_back(shared(value_layer()));
    return preset;
}

/// What an edit may be about.
struct Target {
    const Document& document;
    MaterialPtr material;
    LayerPtr layer;
    Choices& choices;

    LayerPtr other_layer() const {
        const std::vector<LayerPtr> layers = all_layers(material->stack);
        if (layers.empty()) return layer;
        return layers[static_cast<std::size_t>(choices.below(static_cast<int>(layers.size())))];
    }
    Channel channel() const { return static_cast<Channel>(choices.below(kChannelCount)); }
    MaskEntry entry() const {
        const auto& entries = layer->mask.entries;
        if (entries.empty()) return procedural_mask_entry(ProceduralKind::ValueNoise);
        return entries[static_cast<std::size_t>(choices.below(static_cast<int>(entries.size())))];
    }
    SourcePlace source() const {
        if (!layer->mask.entries.empty() && choices.coin())
            return source_place(*material, *layer, entry());
        return source_place(*material, *layer, channel());
    }
    LayerPlace place() const {
        return {static_cast<LayerPlace::Kind>(choices.below(5)), other_layer()->id};
    }
    glm::vec3 color() const {
        return {choices.number(0, 1), choices.number(0, 1), choices.number(0, 1)};
    }
    glm::vec2 pair() const { return {choices.number(-4, 4), choices.number(-4, 4)}; }
    BlendMode mode() const {
        return static_cast<BlendMode>(choices.below(static_cast<int>(kBlendModes.size())));
    }
    std::string name() const {
        switch (choices.below(4)) {
            case 0:
                return "";
            case 1:
                return "bad\x1b[2J";
            case 2:
                return "Größe \xF0\x9F\x8E\xA8";
            default:
                return "Salt \"bloom\"";
        }
    }
};

using EditOf = std::function<Edit(const Target&)>;

Source some_source(const Target& t) {
    switch (t.choices.below(6)) {
        case 5:
            return GeometrySource{.meshes = {"Helmet, 1"}, .materials = {t.name()}};
        case 0:
            return ConstantSource{t.color()};
        case 4:
            return ReferenceSource{.layer = t.other_layer()->id,
                                   .result = static_cast<LayerResult>(t.choices.below(9))};
        case 2:
            return ReliefSource{.kind = static_cast<ReliefKind>(t.choices.below(4)),
                                .radius_permille = t.choices.number(0, 60)};
        case 1: {
            ImageSource image;
            image.image = t.choices.coin() ? sample_image()->hash : Hash128{1, 2};
            return image;
        }
        default: {
            ProceduralSource noise;
            noise.seed = static_cast<std::uint32_t>(t.choices.below(1000));
            return noise;
        }
    }
}

std::vector<RampStop> some_ramp(const Target& t) {
    std::vector<RampStop> stops(static_cast<std::size_t>(t.choices.below(kMaxRampStops + 2)));
    for (RampStop& stop : stops) stop = {t.choices.number(0, 1), t.color()};
    if (t.choices.below(4) > 0)
        std::sort(stops.begin(), stops.end(),
                  [](const RampStop& a, const RampStop& b) { return a.position < b.position; });
    return stops;
}

Light some_light(const Target& t) {
    Light light;
    light.kind = static_cast<Light::Kind>(t.choices.below(5));
    light.color_linear = t.color();
    light.intensity = t.choices.number(0, 1000);
    light.direction_world = t.color();
    light.radius_m = t.choices.number(0, 10);
    light.width_m = t.choices.number(0, 10);
    light.height_m = t.choices.number(0, 10);
    light.turn_radians = t.choices.number(-4, 4);
    return light;
}

Levels some_levels(const Target& t) {
    return {.in_low = t.choices.number(0, 0.5f),
            .in_high = t.choices.number(0.4f, 1),
            .gamma = t.choices.number(0.1f, 10),
            .out_low = t.choices.number(0, 1),
            .out_high = t.choices.number(0, 1)};
}

AdjustmentSettings some_adjustment(const Target& t) {
    AdjustmentSettings settings;
    settings.kind = static_cast<AdjustmentKind>(t.choices.below(11));
    settings.levels = some_levels(t);
    settings.curve = {{0.0f, t.choices.number(0, 1)}, {t.choices.number(0, 1), 0.5f}};
    settings.hue_degrees = t.choices.number(-190, 190);
    settings.saturation = t.choices.number(-1, 1);
    settings.contrast = t.choices.number(-1, 1);
    settings.steps = 1 + t.choices.below(20);
    settings.gradient = some_ramp(t);
    settings.low = t.choices.number(0, 0.6f);
    settings.high = t.choices.number(0.5f, 1);
    settings.radius_permille = t.choices.number(0.1f, 51);
    settings.amount = t.choices.number(0, 5);
    settings.distance_permille = t.choices.number(0, 100);
    settings.scale = t.choices.number(1, 128);
    settings.seed = static_cast<std::uint32_t>(t.choices.below(99));
    return settings;
}

Edit some_add(const Target& t) {
    switch (t.choices.below(5)) {
        case 0:
            return add_layer(*t.material, value_layer(), t.place());
        case 1:
            return add_layer(*t.material, image_layer(*sample_image()), t.place());
        case 2:
            return add_layer(*t.material, procedural_layer(ProceduralKind::ValueNoise), t.place());
        case 3:
            return add_layer(*t.material,
                             adjustment_layer(static_cast<AdjustmentKind>(t.choices.below(11))),
                             t.place());
        default:
            return add_layer(*t.material, group_layer(), t.place());
    }
}

const std::vector<EditOf>& edits_of_layers() {
    static const std::vector<EditOf> edits = {
        some_add,
        [](const Target& t) { return move_layer(*t.material, *t.layer, t.place()); },
        [](const Target& t) { return remove_layer(*t.material, *t.layer); },
        [](const Target& t) { return duplicate_layer(*t.material, *t.layer); },
        [](const Target& t) {
            return group_layers(*t.material, {t.layer, t.other_layer()});
        },
        [](const Target& t) { return ungroup_layer(*t.material, *t.layer); },
        [](const Target& t) {
            return add_layers(*t.material, {t.layer, t.other_layer()}, t.place(), "Add two");
        },
        [](const Target& t) { return replace_stack(*t.material, {t.layer}, "Replace"); },
        [](const Target& t) { return rename_layer(*t.material, *t.layer, t.name()); },
        [](const Target& t) { return set_layer_visible(*t.material, *t.layer, t.choices.coin()); },
        [](const Target& t) { return set_layer_clipped(*t.material, *t.layer, t.choices.coin()); },
        [](const Target& t) {
            return set_adjustment(*t.material, *t.layer, some_adjustment(t),
                                  Parameter::AdjustmentKindChoice);
        },
        [](const Target& t) {
            return set_layer_locked(*t.material, *t.layer, t.choices.below(4) == 1);
        },
        [](const Target& t) {
            return set_layer_opacity(*t.material, *t.layer, t.choices.number(0, 1));
        },
        [](const Target& t) { return set_layer_mode(*t.material, *t.layer, t.mode()); },
        [](const Target& t) {
            return set_layer_blend_space(*t.material, *t.layer,
                                         static_cast<BlendSpace>(t.choices.below(2)));
        },
        [](const Target& t) {
            return set_layer_height_blend(*t.material, *t.layer,
                                          {.enabled = t.choices.coin(),
                                           .offset = t.choices.number(-1.1f, 1),
                                           .radius = t.choices.number(0, 1),
                                           .contrast = t.choices.number(0, 1)},
                                          Parameter::HeightBlendRadius);
        },
        [](const Target& t) { return set_group_open(*t.material, *t.layer, t.choices.coin()); },
        [](const Target& t) {
            return set_channel_enabled(*t.material, *t.layer, t.channel(), t.choices.coin());
        },
        [](const Target& t) {
            return set_channel_mode(*t.material, *t.layer, t.channel(),
                                    t.choices.coin() ? std::optional(t.mode()) : std::nullopt);
        },
        [](const Target& t) {
            return set_channel_opacity(*t.material, *t.layer, t.channel(), t.choices.number(0, 1));
        },
    };
    return edits;
}

const std::vector<EditOf>& edits_of_sources() {
    static const std::vector<EditOf> edits = {
        [](const Target& t) { return set_source(t.source(), some_source(t)); },
        [](const Target& t) { return set_constant(t.source(), t.color()); },
        [](const Target& t) {
            return set_procedural_kind(t.source(), static_cast<ProceduralKind>(t.choices.below(3)));
        },
        [](const Target& t) {
            return set_procedural_seed(t.source(), static_cast<std::uint32_t>(t.choices.below(99)));
        },
        [](const Target& t) { return set_procedural_scale(t.source(), t.choices.number(1, 512)); },
        [](const Target& t) { return set_procedural_octaves(t.source(), t.choices.below(12)); },
        [](const Target& t) {
            return set_procedural_contrast(t.source(), t.choices.number(-1, 1));
        },
        [](const Target& t) { return set_procedural_balance(t.source(), t.choices.number(0, 1)); },
        [](const Target& t) { return set_ramp(t.source(), some_ramp(t)); },
        [](const Target& t) {
            return set_ramp_stop(t.source(), t.choices.below(4) - 1,
                                 {t.choices.number(0, 1), t.color()});
        },
        [](const Target& t) { return set_image(t.source(), sample_image()); },
        [](const Target& t) {
            return set_relief(t.source(),
                              {.kind = ReliefKind::Edge, .strength = t.choices.number(0, 100)},
                              Parameter::ReliefStrength);
        },
        [](const Target& t) {
            return set_image_color_space(t.source(), static_cast<ColorSpace>(t.choices.below(2)));
        },
        [](const Target& t) {
            return set_image_pick(t.source(), static_cast<ChannelPick>(t.choices.below(5)));
        },
        [](const Target& t) { return set_image_invert(t.source(), t.choices.coin()); },
        [](const Target& t) { return set_image_directx_normal(t.source(), t.choices.coin()); },
        [](const Target& t) { return set_image_alpha_is_coverage(t.source(), t.choices.coin()); },
        [](const Target& t) { return set_image_uv_set(t.source(), t.choices.below(4) - 1); },
        [](const Target& t) {
            return set_projection(t.source(),
                                  {.kind = static_cast<ProjectionKind>(t.choices.below(3)),
                                   .axis = static_cast<ProjectionAxis>(t.choices.below(3)),
                                   .blend = t.choices.number(-0.1f, 1)},
                                  Parameter::ProjectionBlend);
        },
        [](const Target& t) {
            return set_geometry(t.source(), {.meshes = {t.name(), "Helmet"}, .materials = {}},
                                Parameter::GeometryMeshes);
        },
        [](const Target& t) {
            return set_image_wrap(t.source(), static_cast<Wrap>(t.choices.below(3)),
                                  static_cast<Wrap>(t.choices.below(3)));
        },
        [](const Target& t) {
            return set_image_filter(t.source(), static_cast<Filter>(t.choices.below(2)));
        },
        [](const Target& t) { return set_image_range(t.source(), t.color(), t.color()); },
        [](const Target& t) { return set_uv_offset(t.source(), t.pair()); },
        [](const Target& t) { return set_uv_scale(t.source(), t.pair()); },
        [](const Target& t) { return set_uv_rotation(t.source(), t.choices.number(-360, 360)); },
        [](const Target& t) {
            return set_uv_transform(t.source(), {t.pair(), t.pair(), t.choices.number(-360, 360)});
        },
    };
    return edits;
}

const std::vector<EditOf>& edits_of_masks() {
    static const std::vector<EditOf> edits = {
        [](const Target& t) {
            return add_mask_entry(
                *t.material, *t.layer,
                procedural_mask_entry(static_cast<ProceduralKind>(t.choices.below(3))));
        },
        [](const Target& t) {
            return add_mask_entry(*t.material, *t.layer, image_mask_entry(*sample_image()));
        },
        [](const Target& t) { return add_mask_entry(*t.material, *t.layer, value_mask_entry()); },
        [](const Target& t) { return set_mask_enabled(*t.material, *t.layer, t.choices.coin()); },
        [](const Target& t) { return set_mask_invert(*t.material, *t.layer, t.choices.coin()); },
        [](const Target& t) {
            return set_mask_base(*t.material, *t.layer, t.choices.number(0, 1));
        },
        [](const Target& t) { return clear_mask(*t.material, *t.layer); },
        [](const Target& t) { return remove_mask_entry(*t.material, *t.layer, t.entry()); },
        [](const Target& t) { return duplicate_mask_entry(*t.material, *t.layer, t.entry()); },
        [](const Target& t) {
            return move_mask_entry(*t.material, *t.layer, t.entry(), t.choices.below(5) - 1);
        },
        [](const Target& t) {
            return rename_mask_entry(*t.material, *t.layer, t.entry(), t.name());
        },
        [](const Target& t) {
            return set_mask_entry_visible(*t.material, *t.layer, t.entry(), t.choices.coin());
        },
        [](const Target& t) {
            return set_mask_entry_combine(*t.material, *t.layer, t.entry(),
                                          t.choices.coin() ? BlendMode::Difference : t.mode());
        },
        [](const Target& t) {
            return add_mask_entry(
                *t.material, *t.layer,
                adjustment_mask_entry(static_cast<AdjustmentKind>(t.choices.below(11))));
        },
        [](const Target& t) {
            return set_mask_entry_adjustment(*t.material, *t.layer, t.entry(), some_adjustment(t),
                                             Parameter::AdjustmentKindChoice);
        },
        [](const Target& t) {
            return set_mask_entry_opacity(*t.material, *t.layer, t.entry(), t.choices.number(0, 1));
        },
        [](const Target& t) {
            return set_mask_entry_invert(*t.material, *t.layer, t.entry(), t.choices.coin());
        },
        [](const Target& t) {
            return set_mask_entry_levels(*t.material, *t.layer, t.entry(), some_levels(t));
        },
    };
    return edits;
}

const std::vector<EditOf>& edits_of_materials() {
    static const std::vector<EditOf> edits = {
        [](const Target& t) { return rename_material(*t.material, t.name()); },
        [](const Target& t) {
            return set_material_resolution(*t.material, 128 << t.choices.below(8));
        },
        [](const Target& t) { return set_material_uv_set(*t.material, t.choices.below(4) - 1); },
        [](const Target& t) {
            return set_material_height_scale(*t.material, t.choices.number(0, 1));
        },
        [](const Target& t) {
            return set_material_padding(*t.material, static_cast<Padding>(t.choices.below(3)));
        },
        [](const Target& t) {
            return set_material_alpha_mode(*t.material, static_cast<AlphaMode>(t.choices.below(3)));
        },
        [](const Target& t) {
            return set_material_alpha_cutoff(*t.material, t.choices.number(0, 1));
        },
        [](const Target& t) { return set_material_double_sided(*t.material, t.choices.coin()); },
        [](const Target& t) { return set_material_unlit(*t.material, t.choices.coin()); },
        [](const Target& t) { return set_material_ior(*t.material, t.choices.number(1, 4)); },
        [](const Target& t) {
            return set_material_specular_factor(*t.material, t.choices.number(0, 1));
        },
        [](const Target& t) { return set_material_specular_color(*t.material, t.color()); },
        [](const Target& t) {
            return set_material_emissive_strength(*t.material, t.choices.number(0, 100));
        },
        [](const Target& t) {
            return apply_preset(*t.material, small_preset(1 + t.choices.below(2)), t.place());
        },
        [](const Target& t) { return replace_stack_by_preset(*t.material, small_preset(2)); },
        [](const Target& t) {
            return paste_layers(*t.material, copied_layers({t.layer, t.other_layer()}), t.place());
        },
        [](const Target& t) { return paste_layers(*t.material, "not layers", t.place()); },
        [](const Target& t) { return add_material(t.name()); },
        [](const Target& t) { return duplicate_material(*t.material); },
        [](const Target& t) { return remove_material(*t.material); },
        [](const Target& t) {
            const Part part{.ref = {.mesh = 0, .primitive = t.choices.below(3)},
                            .name = "Helmet",
                            .material = nullptr,
                            .material_of_file = nullptr};
            return assign_material(*t.material, part);
        },
    };
    return edits;
}

const std::vector<EditOf>& edits_of_scenes() {
    static const std::vector<EditOf> edits = {
        [](const Target&) { return add_image(sample_image()); },
        [](const Target& t) { return set_environment_name(t.name()); },
        [](const Target& t) { return set_environment_rotation(t.choices.number(-360, 360)); },
        [](const Target& t) { return set_sun_elevation(t.choices.number(0, 90)); },
        [](const Target& t) { return set_environment_intensity(t.choices.number(0, 100)); },
        [](const Target& t) { return add_light(some_light(t)); },
        [](const Target& t) { return remove_light(t.choices.below(3) - 1); },
        [](const Target& t) { return set_light(t.choices.below(3) - 1, some_light(t)); },
        [](const Target& t) {
            return in_one_step("Two things",
                               {set_layer_visible(*t.material, *t.layer, false),
                                set_layer_opacity(*t.material, *t.layer, t.choices.number(0, 1))});
        },
    };
    return edits;
}

}  // namespace

ImageAssetPtr sample_image() {
    static const ImageAssetPtr image = std::make_shared<const ImageAsset>(
        ImageAsset{.hash = hash_text("sample"),
                   .name = "crust.png",
                   .mime_type = "image/png",
                   .encoded = std::make_shared<const Bytes>(Bytes(1000)),
                   .width = 64,
                   .height = 32,
                   .channels = 3,
                   .type = SampleType::U8,
                   .source_image = {}});
    return image;
}

Document sample_document() {
    Document document;
    document.materials = {std::make_shared<const Material>(first_material()),
                          std::make_shared<const Material>(second_material())};
    document.images[sample_image()->hash] = sample_image();
    document.scene = sample_scene();
    document.lights = {Light{}};
    document.next_id = 12;
    return document;
}

int Choices::below(int count) {
    return static_cast<int>(draw() % static_cast<std::uint32_t>(count));
}

float Choices::number(float low, float high) {
    const std::uint32_t drawn = draw();
    switch (drawn % 16) {
        case 1:
            return low;
        case 2:
            return high;
        case 3:
            return high + 1.0f;
        case 4:
            return std::numeric_limits<float>::quiet_NaN();
        default:
            return low + (high - low) * static_cast<float>(drawn >> 8) / 16777216.0f;
    }
}

Edit random_edit(const Document& document, Choices& choices) {
    const MaterialPtr material = document.materials[static_cast<std::size_t>(
        choices.below(static_cast<int>(document.materials.size())))];
    const std::vector<LayerPtr> layers = all_layers(material->stack);
    const LayerPtr layer =
        layers.empty()
            ? shared(named(value_layer(), "Gone", 999'999))
            : layers[static_cast<std::size_t>(choices.below(static_cast<int>(layers.size())))];
    const std::vector<EditOf>* const families[] = {&edits_of_layers(), &edits_of_sources(),
                                                   &edits_of_masks(), &edits_of_materials(),
                                                   &edits_of_scenes()};
    const std::vector<EditOf>& family = *families[choices.below(5)];
    const EditOf& make =
        family[static_cast<std::size_t>(choices.below(static_cast<int>(family.size())))];
    return make(Target{document, material, layer, choices});
}

std::vector<LayerPtr> all_layers(const std::vector<LayerPtr>& stack) {
    std::vector<LayerPtr> layers;
    for (const LayerPtr& layer : stack) {
        layers.push_back(layer);
        if (const auto* group = std::get_if<GroupContent>(&layer->content)) {
            const std::vector<LayerPtr> below = all_layers(group->children);
            layers.insert(layers.end(), below.begin(), below.end());
        }
    }
    return layers;
}

std::vector<std::uint64_t> all_ids(const Document& document) {
    std::vector<std::uint64_t> ids;
    for (const MaterialPtr& material : document.materials)
        for (const LayerPtr& layer : all_layers(material->stack)) {
            ids.push_back(layer->id.value);
            for (const MaskEntry& entry : layer->mask.entries) ids.push_back(entry.id.value);
        }
    return ids;
}

}  // namespace patina::test_support
