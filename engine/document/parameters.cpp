// SPDX-License-Identifier: MIT
#include "document/parameters.h"

#include <algorithm>
#include <cmath>

namespace patina {
namespace {

using enum ParameterKind;
constexpr double kDegreesPerRadian = 57.295779513082323;
// A cone is at most a half space; pi/2 as a float lies a little above pi/2.
constexpr double kQuarterTurn = 1.5707964;

// The formatter would spread each row over a dozen lines.
// clang-format off
constexpr std::array kParameters = {
    ParameterInfo{.parameter = Parameter::LayerName, .subject = Subject::Layer, .id = "name", .label = "Name", .kind = Text,
        .tooltip = "What the layer is called."},
    ParameterInfo{.parameter = Parameter::LayerVisible, .subject = Subject::Layer, .id = "visible", .label = "Visible", .kind = Switch, .standard = 1.0,
        .tooltip = "A hidden layer is left out of the picture and of the bake."},
    ParameterInfo{.parameter = Parameter::LayerLocked, .subject = Subject::Layer, .id = "locked", .label = "Locked", .kind = Switch,
        .tooltip = "A locked layer, and all that a locked group holds, cannot be changed."},
    ParameterInfo{.parameter = Parameter::LayerClipped, .subject = Subject::Layer, .id = "clipped", .label = "Clip to layer below", .kind = Switch,
        .tooltip = "Covers only where the next unclipped layer below does: by opacity, mask and content."},
    ParameterInfo{.parameter = Parameter::LayerOpacity, .subject = Subject::Layer, .id = "opacity", .label = "Opacity", .kind = Number, .standard = 1.0, .display_scale = 100.0, .decimals = 0, .unit = "%",
        .tooltip = "How strongly the layer covers what lies below, in all channels. 0 to 100 %."},
    ParameterInfo{.parameter = Parameter::LayerMode, .subject = Subject::Layer, .id = "mode", .label = "Blend mode", .kind = ParameterKind::Choice,
        .tooltip = "How the colours of the layer join those below."},
    ParameterInfo{.parameter = Parameter::LayerBlendSpace, .subject = Subject::Layer, .id = "blend-space", .label = "Blend colours in", .kind = ParameterKind::Choice, .choices = kBlendSpaces,
        .tooltip = "Linear light mixes as light does; sRGB-encoded mixes as raster editors do."},

    ParameterInfo{.parameter = Parameter::HeightBlendEnabled, .subject = Subject::HeightBlend, .id = "enabled", .label = "Blend by height", .kind = Switch,
        .tooltip = "All channels show where the layer's height is above the height below."},
    ParameterInfo{.parameter = Parameter::HeightBlendOffset, .subject = Subject::HeightBlend, .id = "offset", .label = "Raise", .kind = Number, .minimum = -1.0,
        .tooltip = "Raises the layer before heights are compared: more of it shows. -1 to 1."},
    ParameterInfo{.parameter = Parameter::HeightBlendRadius, .subject = Subject::HeightBlend, .id = "radius", .label = "Radius", .kind = Number, .standard = 0.1,
        .tooltip = "Within this difference of heights both are seen; 0 is a hard edge. 0 to 1."},
    ParameterInfo{.parameter = Parameter::HeightBlendContrast, .subject = Subject::HeightBlend, .id = "contrast", .label = "Contrast", .kind = Number, .display_scale = 100.0, .decimals = 0, .unit = "%",
        .tooltip = "How hard the change-over within the radius is. 0 to 100 %, an edge."},

    ParameterInfo{.parameter = Parameter::ChannelEnabled, .subject = Subject::Channel, .id = "enabled", .label = "Enabled", .kind = Switch,
        .tooltip = "Whether the layer changes this channel."},
    ParameterInfo{.parameter = Parameter::ChannelMode, .subject = Subject::Channel, .id = "mode", .label = "Blend", .kind = ParameterKind::Choice,
        .tooltip = "How the channel joins what lies below. Unset follows the layer or the channel's habit."},
    ParameterInfo{.parameter = Parameter::ChannelOpacity, .subject = Subject::Channel, .id = "opacity", .label = "Opacity", .kind = Number, .standard = 1.0, .display_scale = 100.0, .decimals = 0, .unit = "%",
        .tooltip = "How strongly the layer changes this channel, times the layer's opacity. 0 to 100 %."},

    ParameterInfo{.parameter = Parameter::ColorValue, .subject = Subject::Value, .id = "color", .label = "Colour", .kind = Color, .standard = 0.5,
        .tooltip = "Linear light, each component 0 to 1."},
    ParameterInfo{.parameter = Parameter::EmissiveValue, .subject = Subject::Value, .id = "emissive", .label = "Colour", .kind = Color,
        .tooltip = "Light sent out, linear, each component 0 to 1. Brighter: the material's emission."},
    ParameterInfo{.parameter = Parameter::ScalarValue, .subject = Subject::Value, .id = "scalar", .label = "Value", .kind = Number,
        .tooltip = "0 to 1."},
    ParameterInfo{.parameter = Parameter::HeightValue, .subject = Subject::Value, .id = "height", .label = "Height", .kind = Number, .minimum = -1.0,
        .tooltip = "-1 to 1 of the material's height scale; 0 is the surface."},
    ParameterInfo{.parameter = Parameter::NormalValue, .subject = Subject::Value, .id = "normal", .label = "Direction", .kind = Vector, .minimum = -1.0,
        .tooltip = "Direction in tangent space, +Y up; 0, 0, 1 is flat."},

    ParameterInfo{.parameter = Parameter::ImageColorSpace, .subject = Subject::Image, .id = "color-space", .label = "Colour space", .kind = ParameterKind::Choice, .standard = 1.0, .choices = kColorSpaces,
        .tooltip = "sRGB for pictures of colour; linear for data such as roughness, normals, masks."},
    ParameterInfo{.parameter = Parameter::ImagePick, .subject = Subject::Image, .id = "pick", .label = "Read", .kind = ParameterKind::Choice, .choices = kChannelPicks,
        .tooltip = "Which part of the image is read. Single numbers from RGB are its luminance."},
    ParameterInfo{.parameter = Parameter::ImageInvert, .subject = Subject::Image, .id = "invert", .label = "Invert", .kind = Switch,
        .tooltip = "Reads 1 minus the stored number."},
    ParameterInfo{.parameter = Parameter::ImageDirectxNormal, .subject = Subject::Image, .id = "directx-normal", .label = "DirectX normals", .kind = Switch,
        .tooltip = "For normal maps whose green points down."},
    ParameterInfo{.parameter = Parameter::ImageAlphaIsCoverage, .subject = Subject::Image, .id = "alpha-is-coverage", .label = "Alpha covers", .kind = Switch,
        .tooltip = "Where the image is clear, the layer does nothing."},
    ParameterInfo{.parameter = Parameter::ImageUvSet, .subject = Subject::Image, .id = "uv-set", .label = "UV set", .kind = Integer, .maximum = 1.0, .step = 1.0, .decimals = 0,
        .tooltip = "Which texture coordinates of the model are used, 0 or 1."},
    ParameterInfo{.parameter = Parameter::ImageWrapU, .subject = Subject::Image, .id = "wrap-u", .label = "Wrap across", .kind = ParameterKind::Choice, .choices = kWraps,
        .tooltip = "What is left and right of the image."},
    ParameterInfo{.parameter = Parameter::ImageWrapV, .subject = Subject::Image, .id = "wrap-v", .label = "Wrap down", .kind = ParameterKind::Choice, .choices = kWraps,
        .tooltip = "What is above and below the image."},
    ParameterInfo{.parameter = Parameter::ImageFilter, .subject = Subject::Image, .id = "filter", .label = "Filter", .kind = ParameterKind::Choice, .choices = kFilters,
        .tooltip = "Between pixels: smooth, or the nearest pixel as it is."},
    ParameterInfo{.parameter = Parameter::ImageMultiply, .subject = Subject::Image, .id = "multiply", .label = "Strength", .kind = Vector, .minimum = -1000.0, .maximum = 1000.0, .standard = 1.0, .unit = "×",
        .tooltip = "The image's numbers are multiplied by this; of a normal map, its slopes. -1000 to 1000."},
    ParameterInfo{.parameter = Parameter::ImageAdd, .subject = Subject::Image, .id = "add", .label = "Add", .kind = Vector, .minimum = -1000.0, .maximum = 1000.0,
        .tooltip = "Added to the image's numbers after they are multiplied. -1000 to 1000."},

    ParameterInfo{.parameter = Parameter::UvOffset, .subject = Subject::UvTransform, .id = "offset", .label = "Offset", .kind = Vector, .minimum = -1000.0, .maximum = 1000.0, .decimals = 3,
        .tooltip = "Moves the source; 1 is the width of the texture."},
    ParameterInfo{.parameter = Parameter::UvScale, .subject = Subject::UvTransform, .id = "scale", .label = "Scale", .kind = Vector, .minimum = -1000.0, .maximum = 1000.0, .standard = 1.0, .step = 0.1,
        .tooltip = "How often the source repeats across and down. Negative mirrors it."},
    ParameterInfo{.parameter = Parameter::UvRotation, .subject = Subject::UvTransform, .id = "rotation", .label = "Rotation", .kind = Number, .minimum = -360.0, .maximum = 360.0, .step = 1.0, .decimals = 1, .unit = "°",
        .tooltip = "Turns the source counter-clockwise about the UV origin. -360 to 360°."},

    ParameterInfo{.parameter = Parameter::ProjectionKindChoice, .subject = Subject::Projection, .id = "kind", .label = "Projection", .kind = ParameterKind::Choice, .choices = kProjectionKinds,
        .tooltip = "By the model's UVs, or onto its surface: from one side, or from all sides."},
    ParameterInfo{.parameter = Parameter::ProjectionAxisChoice, .subject = Subject::Projection, .id = "axis", .label = "Along", .kind = ParameterKind::Choice, .standard = 2.0, .choices = kProjectionAxes,
        .tooltip = "The axis of the model that a planar projection looks along."},
    ParameterInfo{.parameter = Parameter::ProjectionBlend, .subject = Subject::Projection, .id = "blend", .label = "Blend", .kind = Number, .standard = 0.3, .display_scale = 100.0, .decimals = 0, .unit = "%",
        .tooltip = "How softly one side of a tri-planar projection goes over to the next. 0 to 100 %."},

    ParameterInfo{.parameter = Parameter::ProceduralKindChoice, .subject = Subject::Procedural, .id = "kind", .label = "Pattern", .kind = ParameterKind::Choice, .standard = 1.0, .choices = kProceduralKinds,
        .tooltip = "The noise or pattern, from black to white before its ramp."},
    ParameterInfo{.parameter = Parameter::ProceduralSeed, .subject = Subject::Procedural, .id = "seed", .label = "Seed", .kind = Integer, .maximum = 4294967295.0, .step = 1.0, .decimals = 0,
        .tooltip = "Another number, another pattern of the same kind."},
    ParameterInfo{.parameter = Parameter::ProceduralScale, .subject = Subject::Procedural, .id = "scale", .label = "Scale", .kind = Integer, .minimum = 1.0, .maximum = 512.0, .standard = 8.0, .step = 1.0, .decimals = 0, .curve = SliderCurve::Logarithmic,
        .tooltip = "Cells across the texture, 1 to 512: a whole number, so that it tiles."},
    ParameterInfo{.parameter = Parameter::ProceduralOctaves, .subject = Subject::Procedural, .id = "octaves", .label = "Octaves", .kind = Integer, .minimum = 1.0, .maximum = 10.0, .standard = 4.0, .step = 1.0, .decimals = 0,
        .tooltip = "Layers of finer and finer detail, 1 to 10."},
    ParameterInfo{.parameter = Parameter::ProceduralContrast, .subject = Subject::Procedural, .id = "contrast", .label = "Contrast", .kind = Number, .minimum = -1.0,
        .tooltip = "0 leaves the noise, 1 makes it a hard edge at the balance, -1 flat grey."},
    ParameterInfo{.parameter = Parameter::ProceduralBalance, .subject = Subject::Procedural, .id = "balance", .label = "Balance", .kind = Number, .standard = 0.5,
        .tooltip = "The value that contrast leaves unchanged, 0 to 1."},
    ParameterInfo{.parameter = Parameter::ProceduralWidth, .subject = Subject::Procedural, .id = "width", .label = "Width", .kind = Number, .standard = 0.5,
        .tooltip = "Of stripes, gaps, threads, spots, scratches, cracks or veins, 0 to 1."},
    ParameterInfo{.parameter = Parameter::ProceduralSoftness, .subject = Subject::Procedural, .id = "softness", .label = "Softness", .kind = Number, .standard = 0.1,
        .tooltip = "How soft or rounded edges are, in cells, 0 to 1."},
    ParameterInfo{.parameter = Parameter::ProceduralVariation, .subject = Subject::Procedural, .id = "variation", .label = "Variation", .kind = Number, .standard = 0.5,
        .tooltip = "How far one cell differs from the next in shade, size or direction, 0 to 1."},
    ParameterInfo{.parameter = Parameter::ProceduralAspect, .subject = Subject::Procedural, .id = "aspect", .label = "Length", .kind = Number, .minimum = 0.25, .maximum = 16.0, .standard = 2.0, .step = 0.25, .unit = "×", .curve = SliderCurve::Logarithmic,
        .tooltip = "How much longer a brick is than high, 0.25 to 16."},
    ParameterInfo{.parameter = Parameter::ProceduralWarp, .subject = Subject::Procedural, .id = "warp", .label = "Warp", .kind = Number,
        .tooltip = "How far the pattern is bent by a noise, in cells, 0 to 1."},
    ParameterInfo{.parameter = Parameter::RampPosition, .subject = Subject::Procedural, .id = "position", .label = "Position", .kind = Number,
        .tooltip = "Where in the noise, from 0 to 1, the ramp has this value."},

    ParameterInfo{.parameter = Parameter::ReliefKindChoice, .subject = Subject::Relief, .id = "kind", .label = "Relief", .kind = ParameterKind::Choice, .standard = 1.0, .choices = kReliefKinds,
        .tooltip = "What of the heights below the layer: how high, hollow or proud a texel is."},
    ParameterInfo{.parameter = Parameter::ReliefRadius, .subject = Subject::Relief, .id = "radius", .label = "Radius", .kind = Number, .minimum = 0.1, .maximum = 50.0, .standard = 10.0, .step = 0.1, .decimals = 1, .unit = "‰", .curve = SliderCurve::Logarithmic,
        .tooltip = "How far the surroundings reach, in thousandths of the texture's side: 0.1 to 50 ‰."},
    ParameterInfo{.parameter = Parameter::ReliefStrength, .subject = Subject::Relief, .id = "strength", .label = "Strength", .kind = Number, .minimum = 0.1, .maximum = 100.0, .standard = 8.0, .step = 0.5, .decimals = 1, .curve = SliderCurve::Logarithmic,
        .tooltip = "What the difference of heights is multiplied by, 0.1 to 100."},

    ParameterInfo{.parameter = Parameter::ReferenceLayer, .subject = Subject::Reference, .id = "layer", .label = "Layer", .kind = ParameterKind::Integer, .minimum = 1.0, .maximum = 9007199254740992.0, .standard = 1.0, .step = 1.0, .decimals = 0,
        .tooltip = "The layer that is read, hidden or not. Those that depend on this one cannot be."},
    ParameterInfo{.parameter = Parameter::ReferenceResult, .subject = Subject::Reference, .id = "result", .label = "Result", .kind = ParameterKind::Choice, .choices = kLayerResults,
        .tooltip = "What of the layer is read: where it covers, or one of its channels."},

    ParameterInfo{.parameter = Parameter::GeometryMeshes, .subject = Subject::Geometry, .id = "meshes", .label = "Parts", .kind = Text,
        .tooltip = "Parts of the model by their names, or by those of their meshes or nodes."},
    ParameterInfo{.parameter = Parameter::GeometryMaterials, .subject = Subject::Geometry, .id = "materials", .label = "Materials", .kind = Text,
        .tooltip = "Parts to which the file gives materials of these names."},

    ParameterInfo{.parameter = Parameter::MaskEnabled, .subject = Subject::Mask, .id = "enabled", .label = "Enabled", .kind = Switch, .standard = 1.0,
        .tooltip = "Without its mask the layer covers everything."},
    ParameterInfo{.parameter = Parameter::MaskInvert, .subject = Subject::Mask, .id = "invert", .label = "Invert", .kind = Switch,
        .tooltip = "Covers what was left free, and the other way round."},
    ParameterInfo{.parameter = Parameter::MaskBase, .subject = Subject::Mask, .id = "base", .label = "Start from", .kind = Number, .standard = 1.0,
        .tooltip = "The mask before its first entry: 0 black, covers nothing; 1 white, covers everything."},

    ParameterInfo{.parameter = Parameter::MaskEntryName, .subject = Subject::MaskEntry, .id = "name", .label = "Name", .kind = Text,
        .tooltip = "What the mask entry is called."},
    ParameterInfo{.parameter = Parameter::MaskEntryVisible, .subject = Subject::MaskEntry, .id = "visible", .label = "Visible", .kind = Switch, .standard = 1.0,
        .tooltip = "A hidden entry is left out of the mask."},
    ParameterInfo{.parameter = Parameter::MaskEntryCombine, .subject = Subject::MaskEntry, .id = "combine", .label = "Combine", .kind = ParameterKind::Choice,
        .tooltip = "How the entry joins what the entries before it made."},
    ParameterInfo{.parameter = Parameter::MaskEntryOpacity, .subject = Subject::MaskEntry, .id = "opacity", .label = "Opacity", .kind = Number, .standard = 1.0, .display_scale = 100.0, .decimals = 0, .unit = "%",
        .tooltip = "How much of the entry's effect is kept. 0 to 100 %."},
    ParameterInfo{.parameter = Parameter::MaskEntryInvert, .subject = Subject::MaskEntry, .id = "invert", .label = "Invert", .kind = Switch,
        .tooltip = "Black becomes white before the entry is combined."},

    ParameterInfo{.parameter = Parameter::LevelsInLow, .subject = Subject::Levels, .id = "in-low", .label = "Black at", .kind = Number,
        .tooltip = "What is darker becomes black. 0 to 1, below white."},
    ParameterInfo{.parameter = Parameter::LevelsInHigh, .subject = Subject::Levels, .id = "in-high", .label = "White at", .kind = Number, .standard = 1.0,
        .tooltip = "What is lighter becomes white. 0 to 1, above black."},
    ParameterInfo{.parameter = Parameter::LevelsGamma, .subject = Subject::Levels, .id = "gamma", .label = "Gamma", .kind = Number, .minimum = 0.1, .maximum = 10.0, .standard = 1.0, .step = 0.05, .curve = SliderCurve::Logarithmic,
        .tooltip = "Above 1 lightens the middle, below 1 darkens it. 0.1 to 10."},
    ParameterInfo{.parameter = Parameter::LevelsOutLow, .subject = Subject::Levels, .id = "out-low", .label = "Lowest", .kind = Number,
        .tooltip = "What black becomes. 0 to 1."},
    ParameterInfo{.parameter = Parameter::LevelsOutHigh, .subject = Subject::Levels, .id = "out-high", .label = "Highest", .kind = Number, .standard = 1.0,
        .tooltip = "What white becomes. 0 to 1."},

    ParameterInfo{.parameter = Parameter::AdjustmentKindChoice, .subject = Subject::Adjustment, .id = "kind", .label = "Adjustment", .kind = ParameterKind::Choice, .choices = kAdjustmentKinds,
        .tooltip = "What is done to the channels below that are on."},
    ParameterInfo{.parameter = Parameter::AdjustmentHue, .subject = Subject::Adjustment, .id = "hue", .label = "Hue", .kind = Number, .minimum = -180.0, .maximum = 180.0, .step = 1.0, .decimals = 1, .unit = "°",
        .tooltip = "Turns every hue around the colour circle. -180 to 180°."},
    ParameterInfo{.parameter = Parameter::AdjustmentSaturation, .subject = Subject::Adjustment, .id = "saturation", .label = "Saturation", .kind = Number, .minimum = -1.0, .display_scale = 100.0, .decimals = 0, .unit = "%",
        .tooltip = "-100 % is grey, 0 leaves it, 100 % doubles it."},
    ParameterInfo{.parameter = Parameter::AdjustmentLightness, .subject = Subject::Adjustment, .id = "lightness", .label = "Lightness", .kind = Number, .minimum = -1.0, .display_scale = 100.0, .decimals = 0, .unit = "%",
        .tooltip = "-100 % is black, 0 leaves it, 100 % is white."},
    ParameterInfo{.parameter = Parameter::AdjustmentBrightness, .subject = Subject::Adjustment, .id = "brightness", .label = "Brightness", .kind = Number, .minimum = -1.0, .display_scale = 100.0, .decimals = 0, .unit = "%",
        .tooltip = "Added to every value. -100 to 100 %."},
    ParameterInfo{.parameter = Parameter::AdjustmentContrast, .subject = Subject::Adjustment, .id = "contrast", .label = "Contrast", .kind = Number, .minimum = -1.0, .display_scale = 100.0, .decimals = 0, .unit = "%",
        .tooltip = "-100 % is flat grey, 0 leaves it, 100 % is black and white."},
    ParameterInfo{.parameter = Parameter::AdjustmentSteps, .subject = Subject::Adjustment, .id = "steps", .label = "Steps", .kind = Integer, .minimum = 2.0, .maximum = 64.0, .standard = 4.0, .step = 1.0, .decimals = 0,
        .tooltip = "How many different values are left, 2 to 64."},
    ParameterInfo{.parameter = Parameter::AdjustmentLow, .subject = Subject::Adjustment, .id = "low", .label = "Least", .kind = Number,
        .tooltip = "Nothing is less than this. 0 to 1, at most the greatest."},
    ParameterInfo{.parameter = Parameter::AdjustmentHigh, .subject = Subject::Adjustment, .id = "high", .label = "Greatest", .kind = Number, .standard = 1.0,
        .tooltip = "Nothing is more than this. 0 to 1, at least the least."},
    ParameterInfo{.parameter = Parameter::AdjustmentRadius, .subject = Subject::Adjustment, .id = "radius", .label = "Radius", .kind = Number, .minimum = 0.1, .maximum = 50.0, .standard = 5.0, .step = 0.1, .decimals = 1, .unit = "‰", .curve = SliderCurve::Logarithmic,
        .tooltip = "How far the blur reaches, in thousandths of the texture's side: 0.1 to 50 ‰."},
    ParameterInfo{.parameter = Parameter::AdjustmentAmount, .subject = Subject::Adjustment, .id = "amount", .label = "Amount", .kind = Number, .maximum = 5.0, .standard = 1.0, .step = 0.05, .display_scale = 100.0, .decimals = 0, .unit = "%",
        .tooltip = "How strongly differences within the radius are raised. 0 to 500 %."},
    ParameterInfo{.parameter = Parameter::AdjustmentDistance, .subject = Subject::Adjustment, .id = "distance", .label = "Distance", .kind = Number, .maximum = 100.0, .standard = 10.0, .step = 0.5, .decimals = 1, .unit = "‰",
        .tooltip = "How far a texel moves at most, in thousandths of the texture's side: 0 to 100 ‰."},
    ParameterInfo{.parameter = Parameter::AdjustmentScale, .subject = Subject::Adjustment, .id = "scale", .label = "Scale", .kind = Integer, .minimum = 1.0, .maximum = 128.0, .standard = 8.0, .step = 1.0, .decimals = 0, .curve = SliderCurve::Logarithmic,
        .tooltip = "Cells of the noise across the texture, 1 to 128, in whole numbers."},
    ParameterInfo{.parameter = Parameter::AdjustmentOctaves, .subject = Subject::Adjustment, .id = "octaves", .label = "Octaves", .kind = Integer, .minimum = 1.0, .maximum = 10.0, .standard = 3.0, .step = 1.0, .decimals = 0,
        .tooltip = "Layers of finer and finer bends, 1 to 10."},
    ParameterInfo{.parameter = Parameter::AdjustmentSeed, .subject = Subject::Adjustment, .id = "seed", .label = "Seed", .kind = Integer, .maximum = 4294967295.0, .step = 1.0, .decimals = 0,
        .tooltip = "Another number, other bends of the same kind."},
    ParameterInfo{.parameter = Parameter::CurveX, .subject = Subject::Adjustment, .id = "x", .label = "Input", .kind = Number,
        .tooltip = "The value that a point of the curve changes, 0 to 1."},
    ParameterInfo{.parameter = Parameter::CurveY, .subject = Subject::Adjustment, .id = "y", .label = "Output", .kind = Number,
        .tooltip = "What the curve makes of it, 0 to 1."},

    ParameterInfo{.parameter = Parameter::MaterialName, .subject = Subject::Material, .id = "name", .label = "Name", .kind = Text,
        .tooltip = "What the material is called, here and in the file."},
    ParameterInfo{.parameter = Parameter::MaterialResolution, .subject = Subject::Material, .id = "resolution", .label = "Size", .kind = Integer, .minimum = kMinResolution, .maximum = kMaxResolution, .standard = 2048.0, .step = 1.0, .decimals = 0, .unit = "px",
        .tooltip = "Side of the baked maps: 256, 512, 1024, 2048, 4096 or 8192 px."},
    ParameterInfo{.parameter = Parameter::MaterialUvSet, .subject = Subject::Material, .id = "uv-set", .label = "UV set", .kind = Integer, .maximum = 1.0, .step = 1.0, .decimals = 0,
        .tooltip = "Which texture coordinates of the model the baked maps use, 0 or 1."},
    ParameterInfo{.parameter = Parameter::MaterialHeightScale, .subject = Subject::Material, .id = "height-scale", .label = "Height scale", .kind = Number, .standard = 0.02, .step = 0.001, .decimals = 3,
        .tooltip = "Depth of height 1 as a share of the texture's side, 0 to 1."},
    ParameterInfo{.parameter = Parameter::MaterialPadding, .subject = Subject::Material, .id = "padding", .label = "Padding", .kind = ParameterKind::Choice, .choices = kPaddings,
        .tooltip = "What baked maps hold beside the UV islands. Automatic dilates where layers read the model."},
    ParameterInfo{.parameter = Parameter::MaterialAlphaMode, .subject = Subject::Material, .id = "alpha-mode", .label = "Alpha", .kind = ParameterKind::Choice, .choices = kAlphaModes,
        .tooltip = "Opaque ignores opacity, mask cuts at the cutoff, blend is see-through."},
    ParameterInfo{.parameter = Parameter::MaterialAlphaCutoff, .subject = Subject::Material, .id = "alpha-cutoff", .label = "Alpha cutoff", .kind = Number, .standard = 0.5,
        .tooltip = "With alpha mode mask: what is less opaque is cut away. 0 to 1."},
    ParameterInfo{.parameter = Parameter::MaterialDoubleSided, .subject = Subject::Material, .id = "double-sided", .label = "Double-sided", .kind = Switch,
        .tooltip = "Shows the back of the surface too."},
    ParameterInfo{.parameter = Parameter::MaterialUnlit, .subject = Subject::Material, .id = "unlit", .label = "Unlit", .kind = Switch,
        .tooltip = "Shows the base colour as it is, without any light."},
    ParameterInfo{.parameter = Parameter::MaterialIor, .subject = Subject::Material, .id = "ior", .label = "IOR", .kind = Number, .minimum = 1.0, .maximum = 4.0, .standard = 1.5,
        .tooltip = "Index of refraction of non-metals: water 1.33, plastic and glass 1.5, diamond 2.42."},
    ParameterInfo{.parameter = Parameter::MaterialSpecularFactor, .subject = Subject::Material, .id = "specular", .label = "Specular", .kind = Number, .standard = 1.0,
        .tooltip = "How strongly non-metals reflect, 0 to 1. 1 is physical."},
    ParameterInfo{.parameter = Parameter::MaterialSpecularColor, .subject = Subject::Material, .id = "specular-color", .label = "Specular colour", .kind = Color, .standard = 1.0,
        .tooltip = "Tints the reflections of non-metals; linear, each component 0 to 1."},
    ParameterInfo{.parameter = Parameter::MaterialEmissiveStrength, .subject = Subject::Material, .id = "emissive-strength", .label = "Emission", .kind = Number, .maximum = 100.0, .standard = 1.0, .step = 0.1, .unit = "×",
        .tooltip = "What the emissive channel is multiplied by, 0 to 100."},

    ParameterInfo{.parameter = Parameter::EnvironmentName, .subject = Subject::Environment, .id = "name", .label = "Environment", .kind = Text,
        .tooltip = "The light all around: a built-in or an .hdr or .exr panorama."},
    ParameterInfo{.parameter = Parameter::EnvironmentRotation, .subject = Subject::Environment, .id = "rotation", .label = "Rotation", .kind = Number, .minimum = -360.0, .maximum = 360.0, .step = 1.0, .decimals = 1, .unit = "°",
        .tooltip = "Turns the surroundings about the vertical. -360 to 360°."},
    ParameterInfo{.parameter = Parameter::EnvironmentIntensity, .subject = Subject::Environment, .id = "intensity", .label = "Intensity", .kind = Number, .maximum = 100.0, .standard = 1.0, .step = 0.1, .unit = "×",
        .tooltip = "Multiplies the light of the surroundings, 0 to 100."},
    ParameterInfo{.parameter = Parameter::EnvironmentSunElevation, .subject = Subject::Environment, .id = "sun-elevation", .label = "Sun height", .kind = Number, .maximum = 90.0, .standard = 38.0, .step = 1.0, .decimals = 1, .unit = "°",
        .tooltip = "How high the sun of the sky stands above the horizon, 0 to 90°; a low one is red."},

    ParameterInfo{.parameter = Parameter::LightKind, .subject = Subject::Light, .id = "kind", .label = "Kind", .kind = ParameterKind::Choice, .choices = kLightKinds,
        .tooltip = "Directional: far away, like the sun. Spot: a cone. Sphere, rectangle: lamps of some size."},
    ParameterInfo{.parameter = Parameter::LightColor, .subject = Subject::Light, .id = "color", .label = "Colour", .kind = Color, .standard = 1.0,
        .tooltip = "Linear light, each component 0 to 1."},
    ParameterInfo{.parameter = Parameter::LightIntensity, .subject = Subject::Light, .id = "intensity", .label = "Intensity", .kind = Number, .maximum = 1e9, .standard = 1.0, .step = 0.1,
        .tooltip = "Lux of a directional light, candela of all others. Any positive number."},
    ParameterInfo{.parameter = Parameter::LightPosition, .subject = Subject::Light, .id = "position", .label = "Position", .kind = Vector, .minimum = -1e9, .maximum = 1e9, .step = 0.1, .unit = "m",
        .tooltip = "Where the light stands (its middle), in metres; +Y is up."},
    ParameterInfo{.parameter = Parameter::LightDirection, .subject = Subject::Light, .id = "direction", .label = "Direction", .kind = Vector, .minimum = -1e9, .maximum = 1e9,
        .tooltip = "The way the light travels; its length does not matter."},
    ParameterInfo{.parameter = Parameter::LightRange, .subject = Subject::Light, .id = "range", .label = "Range", .kind = Number, .maximum = 1e9, .step = 0.1, .unit = "m",
        .tooltip = "How far the light reaches, in metres; 0 is without end."},
    ParameterInfo{.parameter = Parameter::LightInnerCone, .subject = Subject::Light, .id = "inner-cone", .label = "Inner cone", .kind = Number, .maximum = kQuarterTurn, .step = 0.0174533, .display_scale = kDegreesPerRadian, .decimals = 1, .unit = "°",
        .tooltip = "Full brightness within this angle from the axis. 0 to 90°."},
    ParameterInfo{.parameter = Parameter::LightOuterCone, .subject = Subject::Light, .id = "outer-cone", .label = "Outer cone", .kind = Number, .maximum = kQuarterTurn, .standard = 0.785398, .step = 0.0174533, .display_scale = kDegreesPerRadian, .decimals = 1, .unit = "°",
        .tooltip = "No light beyond this angle from the axis. 0 to 90°."},
    ParameterInfo{.parameter = Parameter::LightRadius, .subject = Subject::Light, .id = "radius", .label = "Radius", .kind = Number, .minimum = 1e-3, .maximum = 1e6, .standard = 0.1, .step = 0.01, .unit = "m",
        .tooltip = "Of a sphere, in metres. Larger: softer highlights of the same light."},
    ParameterInfo{.parameter = Parameter::LightWidth, .subject = Subject::Light, .id = "width", .label = "Width", .kind = Number, .minimum = 1e-3, .maximum = 1e6, .standard = 1.0, .step = 0.1, .unit = "m",
        .tooltip = "Of a rectangle, in metres. Larger: softer highlights of the same light."},
    ParameterInfo{.parameter = Parameter::LightHeight, .subject = Subject::Light, .id = "height", .label = "Height", .kind = Number, .minimum = 1e-3, .maximum = 1e6, .standard = 1.0, .step = 0.1, .unit = "m",
        .tooltip = "Of a rectangle, in metres. Larger: softer highlights of the same light."},
    ParameterInfo{.parameter = Parameter::LightTurn, .subject = Subject::Light, .id = "turn", .label = "Turn", .kind = Number, .minimum = -2.0 * kQuarterTurn, .maximum = 2.0 * kQuarterTurn, .step = 0.0174533, .display_scale = kDegreesPerRadian, .decimals = 1, .unit = "°",
        .tooltip = "Turns a rectangle about its direction; at 0 its width lies level. -180 to 180°."},
};
// clang-format on

constexpr bool rows_match_enumerators() {
    for (std::size_t i = 0; i < kParameters.size(); ++i)
        if (static_cast<std::size_t>(kParameters[i].parameter) != i) return false;
    return kParameters.back().parameter == Parameter::LightTurn;
}
static_assert(rows_match_enumerators(), "kParameters has one row per enumerator, in their order");

/// What a file has a number in, to be written behind it. Angles of lights are radians, as glTF has
/// them, and shown in degrees.
std::string_view stored_unit(const ParameterInfo& row) {
    if (row.display_scale == kDegreesPerRadian) return " radians";
    if (row.display_scale != 1.0) return "";
    if (row.unit == "°") return " degrees";
    return row.unit == "m" ? " metres" : "";
}

}  // namespace

std::span<const ParameterInfo> parameters() {
    return kParameters;
}

const ParameterInfo& info(Parameter parameter) {
    return kParameters[static_cast<std::size_t>(parameter)];
}

std::optional<Parameter> parameter_from_id(Subject subject, std::string_view id) {
    for (const ParameterInfo& row : kParameters)
        if (row.subject == subject && row.id == id) return row.parameter;
    return std::nullopt;
}

Parameter value_parameter(std::optional<Channel> channel) {
    if (!channel) return Parameter::ScalarValue;
    if (*channel == Channel::Emissive) return Parameter::EmissiveValue;
    switch (info(*channel).kind) {
        case ChannelKind::Color:
            return Parameter::ColorValue;
        case ChannelKind::Scalar:
            return Parameter::ScalarValue;
        case ChannelKind::Normal:
            return Parameter::NormalValue;
        case ChannelKind::Height:
            return Parameter::HeightValue;
    }
    return Parameter::ScalarValue;
}

Status check_range(Parameter parameter, double value) {
    const ParameterInfo& row = info(parameter);
    const bool within = value >= row.minimum && value <= row.maximum;  // false for NaN
    if (row.kind == ParameterKind::Integer && within && value != std::round(value))
        return failure("{} must be a whole number, got {}", row.label, value);
    if (within) return {};
    return failure("{} must be {} to {}{}, got {}", row.label, row.minimum, row.maximum,
                   stored_unit(row), value);
}

}  // namespace patina
