// SPDX-License-Identifier: MIT
#pragma once

/// Every number, switch and choice of a document as one table: what the editor's controls show,
/// what the command line's --set takes, which ranges edits and files are held to, and what
/// presets/schema.json states (a test compares them).
///
/// To add a parameter: an enumerator here, a row in kParameters at the same place.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/result.h"
#include "document/choices.h"

namespace patina {

/// What a parameter belongs to.
enum class Subject : std::uint8_t {
    Layer,
    HeightBlend,  ///< of a layer
    Channel,      ///< of a layer
    Value,        ///< of a constant or a ramp's stop, by what it feeds
    Image,        ///< an image source
    UvTransform,  ///< of an image or procedural source
    Projection,   ///< of an image or procedural source
    Procedural,   ///< a procedural source
    Relief,       ///< a relief source
    Reference,    ///< a source that reads another layer
    Geometry,     ///< a source that picks parts of the model
    Mask,
    MaskEntry,
    Levels,  ///< of a mask entry or an adjustment
    Adjustment,
    Material,
    Environment,
    Light,
};

enum class ParameterKind : std::uint8_t {
    Switch,
    Integer,
    Number,
    Choice,
    Color,   ///< three numbers, linear light
    Vector,  ///< two or three numbers
    Text,
};

enum class Parameter : std::uint8_t {
    LayerName,
    LayerVisible,
    LayerLocked,
    LayerClipped,
    LayerOpacity,
    LayerMode,
    LayerBlendSpace,

    HeightBlendEnabled,
    HeightBlendOffset,
    HeightBlendRadius,
    HeightBlendContrast,

    ChannelEnabled,
    ChannelMode,
    ChannelOpacity,

    ColorValue,
    EmissiveValue,
    ScalarValue,
    HeightValue,
    NormalValue,

    ImageColorSpace,
    ImagePick,
    ImageInvert,
    ImageDirectxNormal,
    ImageAlphaIsCoverage,
    ImageUvSet,
    ImageWrapU,
    ImageWrapV,
    ImageFilter,
    ImageMultiply,
    ImageAdd,

    UvOffset,
    UvScale,
    UvRotation,

    ProjectionKindChoice,
    ProjectionAxisChoice,
    ProjectionBlend,

    ProceduralKindChoice,
    ProceduralSeed,
    ProceduralScale,
    ProceduralOctaves,
    ProceduralContrast,
    ProceduralBalance,
    ProceduralWidth,
    ProceduralSoftness,
    ProceduralVariation,
    ProceduralAspect,
    ProceduralWarp,
    RampPosition,

    ReliefKindChoice,
    ReliefRadius,
    ReliefStrength,

    ReferenceLayer,
    ReferenceResult,

    GeometryMeshes,
    GeometryMaterials,

    MaskEnabled,
    MaskInvert,
    MaskBase,

    MaskEntryName,
    MaskEntryVisible,
    MaskEntryCombine,
    MaskEntryOpacity,
    MaskEntryInvert,

    LevelsInLow,
    LevelsInHigh,
    LevelsGamma,
    LevelsOutLow,
    LevelsOutHigh,

    AdjustmentKindChoice,
    AdjustmentHue,
    AdjustmentSaturation,
    AdjustmentLightness,
    AdjustmentBrightness,
    AdjustmentContrast,
    AdjustmentSteps,
    AdjustmentLow,
    AdjustmentHigh,
    AdjustmentRadius,
    AdjustmentAmount,
    AdjustmentDistance,
    AdjustmentScale,
    AdjustmentOctaves,
    AdjustmentSeed,
    CurveX,
    CurveY,

    MaterialName,
    MaterialResolution,
    MaterialUvSet,
    MaterialHeightScale,
    MaterialPadding,
    MaterialAlphaMode,
    MaterialAlphaCutoff,
    MaterialDoubleSided,
    MaterialUnlit,
    MaterialIor,
    MaterialSpecularFactor,
    MaterialSpecularColor,
    MaterialEmissiveStrength,

    EnvironmentName,
    EnvironmentRotation,
    EnvironmentIntensity,
    EnvironmentSunElevation,

    LightKind,
    LightColor,
    LightIntensity,
    LightPosition,
    LightDirection,
    LightRange,
    LightInnerCone,
    LightOuterCone,
    LightRadius,
    LightWidth,
    LightHeight,
    LightTurn,
};

/// How a slider's width stands for the range.
enum class SliderCurve : std::uint8_t { Linear, Logarithmic };

struct ParameterInfo {
    Parameter parameter;
    Subject subject;
    std::string_view id;     ///< in files and on the command line; unique within the subject
    std::string_view label;  ///< in the interface
    ParameterKind kind;
    /// Of numbers, and of each component of colours and vectors; in the unit that is stored.
    double minimum = 0.0;
    double maximum = 1.0;
    double standard = 0.0;  ///< what a new one has
    double step = 0.01;     ///< of the wheel and the arrow keys
    /// What is shown is the stored number times this, with that many decimals and the unit after
    /// it.
    double display_scale = 1.0;
    int decimals = 2;
    std::string_view unit = "";
    SliderCurve curve = SliderCurve::Linear;
    std::span<const Choice> choices = {};  ///< of a Choice; empty for blend modes and resolutions
    std::string_view tooltip;
};

std::span<const ParameterInfo> parameters();
const ParameterInfo& info(Parameter parameter);
/// The parameter of `subject` with that id, if there is one.
std::optional<Parameter> parameter_from_id(Subject subject, std::string_view id);

/// The parameter that the value of a channel's source is one of; of a mask's when unset.
Parameter value_parameter(std::optional<Channel> channel);

/// Whether a number (or one component) is in the parameter's range, and whole where the parameter
/// is; NaN is not. The failure says "Opacity must be 0 to 1, got 3".
Status check_range(Parameter parameter, double value);

}  // namespace patina
