// SPDX-License-Identifier: MIT
// The shared texts as texts: none is forgotten by the probes or by C++, and the numbers and names
// by which tables elsewhere pick a formula are those of the texts.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "composite/scalar_modes.h"
#include "core/files.h"
#include "core/formulae/formulae.h"
#include "document/blend_mode.h"
#include "document/source.h"
#include "render/shading.h"
#include "render/view.h"

namespace patina {
namespace {

const std::filesystem::path kRoot(PATINA_SOURCE_DIR);

std::vector<std::filesystem::path> shared_texts() {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(kRoot / "shaders/shared"))
        if (entry.path().filename() != "prelude.glsl") paths.push_back(entry.path());
    return paths;
}

/// The bodies of a text's functions by name (of overloads together): from a line that begins with a
/// type, a name and a parenthesis to the next brace at the start of a line.
std::map<std::string, std::string> function_bodies(const std::string& text) {
    static const std::regex head(
        "(?:^|\n)(?:[A-Z][A-Za-z0-9]*|float|int|uint) ([a-z][a-z0-9_]*)\\(");
    std::map<std::string, std::string> bodies;
    for (std::sregex_iterator at(text.begin(), text.end(), head), end; at != end; ++at) {
        const auto start = static_cast<std::size_t>(at->position() + at->length());
        bodies[(*at)[1]] += text.substr(start, text.find("\n}", start) - start);
    }
    return bodies;
}

std::map<std::string, std::string> shared_functions() {
    std::map<std::string, std::string> all;
    for (const auto& path : shared_texts())
        for (const auto& [name, body] : function_bodies(read_text_file(path).value()))
            all[name] += body;
    return all;
}

/// Adds what `body` calls, directly or through others.
void add_reached(const std::string& body, const std::map<std::string, std::string>& functions,
                 std::set<std::string>& reached) {
    static const std::regex call("([a-z][a-z0-9_]*)\\(");
    for (std::sregex_iterator at(body.begin(), body.end(), call), end; at != end; ++at) {
        const auto function = functions.find((*at)[1]);
        if (function != functions.end() && reached.insert(function->first).second)
            add_reached(function->second, functions, reached);
    }
}

TEST(SharedTexts, EveryFunctionIsReachedByAProbe) {
    const std::map<std::string, std::string> functions = shared_functions();
    ASSERT_GT(functions.size(), 100u);
    std::set<std::string> reached;
    for (const auto& [name, body] :
         function_bodies(read_text_file(kRoot / "tests/unit/shaders/probes.glsl").value()))
        add_reached(body, functions, reached);
    for (const auto& [name, body] : functions)
        EXPECT_TRUE(reached.contains(name)) << name << " is in no probe of probes.glsl";
}

TEST(SharedTexts, EveryTextIsCompiledAsCpp) {
    const std::string list = read_text_file(kRoot / "engine/core/formulae/texts-inl.h").value();
    for (const auto& path : shared_texts()) {
        const std::string include = "#include \"shared/" + path.filename().string() + "\"";
        EXPECT_NE(list.find(include), std::string::npos) << include;
        std::string guard = "SHARED_" + path.stem().string() + "_GLSL";
        for (char& letter : guard) letter = static_cast<char>(std::toupper(letter));
        EXPECT_NE(list.find("#undef " + guard), std::string::npos) << guard;
        EXPECT_NE(read_text_file(path).value().find("#ifndef " + guard), std::string::npos)
            << guard;
    }
}

TEST(SharedTexts, EveryBlendModeOfTheTableIsAFunction) {
    const std::map<std::string, std::string> functions = shared_functions();
    for (const BlendModeInfo& mode : kBlendModes)
        EXPECT_TRUE(functions.contains(std::string(mode.formula))) << mode.formula;
}

TEST(SharedTexts, KernelsBlendScalarsByTheFormulaeOfTheTable) {
    std::set<BlendMode> held = {BlendMode::Normal, BlendMode::Replace};
#define PATINA_EXPECT_FORMULA(NAME, FORMULA)            \
    EXPECT_EQ(info(BlendMode::NAME).formula, #FORMULA); \
    held.insert(BlendMode::NAME);
    PATINA_SCALAR_MODES(PATINA_EXPECT_FORMULA)
#undef PATINA_EXPECT_FORMULA
    for (const BlendModeInfo& mode : kBlendModes)
        EXPECT_EQ(held.contains(mode.mode), (mode.kinds & kind_bit(ChannelKind::Scalar)) != 0)
            << mode.id;
}

template <typename Enum>
constexpr int number(Enum value) {
    return static_cast<int>(value);
}

TEST(SharedTexts, NumbersOfTermsAreThoseOfTheEnumerators) {
    using namespace render;
    EXPECT_EQ(number(DistributionTerm::Ggx), formulae::DISTRIBUTION_GGX);
    EXPECT_EQ(number(DistributionTerm::Beckmann), formulae::DISTRIBUTION_BECKMANN);
    EXPECT_EQ(number(DistributionTerm::BlinnPhong), formulae::DISTRIBUTION_BLINN_PHONG);
    EXPECT_EQ(number(GeometryTerm::SmithSeparable), formulae::GEOMETRY_SMITH_SEPARABLE);
    EXPECT_EQ(number(GeometryTerm::SmithCorrelated), formulae::GEOMETRY_SMITH_CORRELATED);
    EXPECT_EQ(number(GeometryTerm::SchlickGgx), formulae::GEOMETRY_SCHLICK_GGX);
    EXPECT_EQ(number(GeometryTerm::Lecture), formulae::GEOMETRY_LECTURE);
    EXPECT_EQ(number(FresnelTerm::Schlick), formulae::FRESNEL_SCHLICK);
    EXPECT_EQ(number(FresnelTerm::SphericalGaussian), formulae::FRESNEL_SPHERICAL_GAUSSIAN);
    EXPECT_EQ(number(DiffuseTerm::Lambert), formulae::DIFFUSE_LAMBERT);
    EXPECT_EQ(number(DiffuseTerm::Burley), formulae::DIFFUSE_BURLEY);
    EXPECT_EQ(number(DiffuseTerm::OrenNayar), formulae::DIFFUSE_OREN_NAYAR);
    EXPECT_EQ(number(DiffuseTerm::Lecture), formulae::DIFFUSE_LECTURE);
    EXPECT_EQ(number(ToneMap::None), formulae::TONE_MAP_NONE);
    EXPECT_EQ(number(ToneMap::Reinhard), formulae::TONE_MAP_REINHARD);
    EXPECT_EQ(number(ToneMap::Aces), formulae::TONE_MAP_ACES);
    EXPECT_EQ(number(ToneMap::Agx), formulae::TONE_MAP_AGX);
    EXPECT_EQ(number(ToneMap::PbrNeutral), formulae::TONE_MAP_PBR_NEUTRAL);
    EXPECT_EQ(number(ProceduralKind::ValueNoise), formulae::NOISE_VALUE);
    EXPECT_EQ(number(ProceduralKind::PerlinNoise), formulae::NOISE_PERLIN);
    EXPECT_EQ(number(ProceduralKind::WorleyNoise), formulae::NOISE_WORLEY);
    EXPECT_EQ(number(ProceduralKind::SimplexNoise), formulae::NOISE_SIMPLEX);
    EXPECT_EQ(number(ProceduralKind::RidgedNoise), formulae::NOISE_RIDGED);
    EXPECT_EQ(number(ProceduralKind::Turbulence), formulae::NOISE_TURBULENCE);
    EXPECT_EQ(number(ProceduralKind::WorleyF2), formulae::NOISE_WORLEY_F2);
    EXPECT_EQ(number(ProceduralKind::WorleyEdges), formulae::NOISE_WORLEY_EDGES);
    EXPECT_EQ(number(ProceduralKind::Cells), formulae::NOISE_CELLS);
    EXPECT_EQ(number(ProceduralKind::GradientLinear), formulae::PATTERN_GRADIENT_LINEAR);
    EXPECT_EQ(number(ProceduralKind::GradientRadial), formulae::PATTERN_GRADIENT_RADIAL);
    EXPECT_EQ(number(ProceduralKind::GradientAngular), formulae::PATTERN_GRADIENT_ANGULAR);
    EXPECT_EQ(number(ProceduralKind::Checker), formulae::PATTERN_CHECKER);
    EXPECT_EQ(number(ProceduralKind::Stripes), formulae::PATTERN_STRIPES);
    EXPECT_EQ(number(ProceduralKind::Bricks), formulae::PATTERN_BRICKS);
    EXPECT_EQ(number(ProceduralKind::Tiles), formulae::PATTERN_TILES);
    EXPECT_EQ(number(ProceduralKind::Hexagons), formulae::PATTERN_HEXAGONS);
    EXPECT_EQ(number(ProceduralKind::Weave), formulae::PATTERN_WEAVE);
    EXPECT_EQ(number(ProceduralKind::Spots), formulae::PATTERN_SPOTS);
    EXPECT_EQ(number(ProceduralKind::Scratches), formulae::PATTERN_SCRATCHES);
    EXPECT_EQ(number(ProceduralKind::Cracks), formulae::PATTERN_CRACKS);
    EXPECT_EQ(number(ProceduralKind::WoodRings), formulae::PATTERN_WOOD_RINGS);
    EXPECT_EQ(number(ProceduralKind::Marble), formulae::PATTERN_MARBLE);
    EXPECT_EQ(number(ProceduralKind::Grunge), formulae::PATTERN_GRUNGE);
}

}  // namespace
}  // namespace patina
