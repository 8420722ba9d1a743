// SPDX-License-Identifier: MIT

/// Every channel, shading model, comparison, background and shape as a small picture, against one
/// that a person has looked at.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>
#include <string>

#include "core/files.h"
#include "io/image_decode.h"
#include "io/image_file.h"
#include "render/render_test.h"

namespace patina::render {
namespace {

constexpr PictureSize kGoldenSize = {96, 96};
constexpr int kSamples = 4;

// What another version of the rasteriser may change: rounding everywhere, coverage at few edges.
constexpr double kMeanTolerance = 1.0;   // of 255
constexpr int kPixelTolerance = 6;       // of 255 ...
constexpr double kPixelsBeyond = 0.005;  // ... in all but this share of the pixels

struct Difference {
    double mean = 0.0;
    double share_beyond = 0.0;
};

int sample_difference(const Image& a, const Image& b, std::size_t i) {
    return std::abs(std::to_integer<int>(a.data[i]) - std::to_integer<int>(b.data[i]));
}

Difference difference_of(const Image& a, const Image& b) {
    double sum = 0.0;
    std::size_t beyond = 0;
    for (std::size_t i = 0; i < a.data.size(); i += 4) {
        int largest = 0;
        for (std::size_t c = 0; c < 4; ++c) {
            sum += sample_difference(a, b, i + c);
            largest = std::max(largest, sample_difference(a, b, i + c));
        }
        beyond += largest > kPixelTolerance ? 1u : 0u;
    }
    const auto pixels = static_cast<double>(a.data.size() / 4);
    return {sum / (4.0 * pixels), static_cast<double>(beyond) / pixels};
}

/// Expected, actual and ten times their difference, beside each other.
Image sheet_of(const Image& expected, const Image& actual) {
    Image sheet = expected;
    sheet.width = 3 * expected.width;
    sheet.data.resize(3 * expected.data.size());
    const std::size_t row = expected.row_bytes();
    for (std::size_t y = 0; y < static_cast<std::size_t>(expected.height); ++y)
        for (std::size_t i = 0; i < row; ++i) {
            const std::size_t from = y * row + i;
            std::byte* out = sheet.data.data() + 3 * y * row + i;
            out[0] = expected.data[from];
            out[row] = actual.data[from];
            const int enlarged = std::min(255, 10 * sample_difference(expected, actual, from));
            out[2 * row] = i % 4 == 3 ? std::byte{255} : static_cast<std::byte>(enlarged);
        }
    return sheet;
}

class Golden : public RenderTest {
  protected:
    void SetUp() override {
        RenderTest::SetUp();
        show(scene_of(shape_mesh(Shape::ShaderBall)));
        ASSERT_TRUE(renderer().set_environment(filtered_builtin("studio")));
        ASSERT_TRUE(
            renderer().set_material(0, constant_surface({0.75f, 0.3f, 0.12f}, 0.0f, 0.35f)));
        ASSERT_TRUE(renderer().set_material(1, constant_surface({0.9f, 0.75f, 0.4f}, 1.0f, 0.25f)));
        view_ = {};
        view_.camera = framed(renderer().bounds_world(), 1.0f);
        view_.lights = {{.name = "key",
                         .intensity = 0.8f,
                         .direction_world = glm::normalize(glm::vec3(-1.0f, -2.0f, -1.5f))}};
    }

    /// Compares the picture of a view with images/NAME.png.
    void expect_picture(const View& view, const std::string& name) {
        const Image actual = value_of(renderer().still_srgb(view, kGoldenSize, kSamples));
        const std::filesystem::path path =
            std::filesystem::path(PATINA_GOLDEN_IMAGES) / (name + ".png");
        if (std::getenv("PATINA_UPDATE_GOLDEN") != nullptr) {
            ASSERT_TRUE(io::write_image_file(path, actual));
            return;
        }
        const Bytes encoded = value_of(read_file(path));
        const ImagePtr expected = value_of(io::decode_image(encoded, name + ".png"));
        ASSERT_EQ(expected->data.size(), actual.data.size()) << name;
        const Difference difference = difference_of(*expected, actual);
        if (difference.mean <= kMeanTolerance && difference.share_beyond <= kPixelsBeyond) return;
        const std::filesystem::path sheet =
            std::filesystem::path(PATINA_GOLDEN_SHEETS) / (name + "-mismatch.png");
        EXPECT_TRUE(io::write_image_file(sheet, sheet_of(*expected, actual)));
        ADD_FAILURE() << name << " differs by " << difference.mean << " on average, and "
                      << 100.0 * difference.share_beyond << " % of its pixels by more than "
                      << kPixelTolerance << "; look at " << sheet;
    }
};

TEST_F(Golden, EveryChannelLooksAsItDid) {
    for (const ChannelViewInfo& channel : kChannelViews) {
        View view = view_;
        view.channel = channel.view;
        expect_picture(view, "channel-" + std::string(channel.id));
    }
}

TEST_F(Golden, EveryShadingModelLooksAsItDid) {
    for (const Choice<ShadingModel>& model : kShadingModels) {
        View view = view_;
        view.left.model = model.value;
        expect_picture(view, "shading-" + std::string(model.id));
    }
    View lecture = view_;
    lecture.left.terms = kLectureTerms;
    expect_picture(lecture, "shading-lecture");
}

TEST_F(Golden, EveryComparisonLooksAsItDid) {
    for (const Choice<CompareMode>& mode : kCompareModes) {
        View view = view_;
        view.compare = mode.value;
        expect_picture(view, "compare-" + std::string(mode.id));
    }
}

TEST_F(Golden, EveryToneMapLooksAsItDid) {
    for (const Choice<ToneMap>& tone_map : kToneMaps) {
        View view = view_;
        view.tone_map = tone_map.value;
        view.exposure_ev = 1.0f;
        expect_picture(view, "tone-map-" + std::string(tone_map.id));
    }
}

TEST_F(Golden, EveryEnvironmentAndBackgroundLooksAsItDid) {
    for (const BuiltinEnvironment& environment : kBuiltinEnvironments) {
        ASSERT_TRUE(renderer().set_environment(filtered_builtin(environment.id)));
        for (const Choice<Background::Kind>& background : kBackgrounds) {
            View view = view_;
            view.background.kind = background.value;
            expect_picture(view, "environment-" + std::string(environment.id) + "-" +
                                     std::string(background.id));
        }
    }
}

TEST_F(Golden, EveryShapeLooksAsItDid) {
    for (const ShapeInfo& shape : kShapes) {
        show(scene_of(shape_mesh(shape.shape)));
        View view = view_;
        view.camera = framed(renderer().bounds_world(), 1.0f);
        expect_picture(view, "shape-" + std::string(shape.id));
    }
}

TEST_F(Golden, BallsOfGlassInOneAnotherLookAsTheyDid) {
    auto scene = std::make_shared<Scene>();
    scene->meshes = {shape_mesh(Shape::Sphere), shape_mesh(Shape::Torus)};
    scene->meshes[1].primitives[0].source_material = 1;
    const auto place = [](const glm::vec3& at, float size) {
        return glm::scale(glm::translate(glm::mat4(1.0f), at), glm::vec3(size));
    };
    scene->instances = {
        {.mesh = 0, .world_from_local = place({0.0f, 0.0f, 0.0f}, 1.0f), .name = "outer"},
        {.mesh = 0, .world_from_local = place({0.1f, 0.05f, 0.0f}, 0.5f), .name = "inner"},
        {.mesh = 1, .world_from_local = place({0.7f, 0.0f, 0.5f}, 0.8f), .name = "ring"}};
    show(scene);
    SurfaceMaterial glass = constant_surface({0.15f, 0.45f, 0.75f}, 0.0f, 0.1f);
    glass[Slot::BaseColor].multiply.a = 0.4f;
    glass.alpha_mode = AlphaMode::Blend;
    glass.double_sided = true;
    ASSERT_TRUE(renderer().set_material(0, glass));
    glass[Slot::BaseColor].multiply = glm::vec4(0.8f, 0.25f, 0.1f, 0.6f);
    ASSERT_TRUE(renderer().set_material(1, glass));
    View view = view_;
    view.camera = framed(renderer().bounds_world(), 1.0f);
    view.background.kind = Background::Kind::Studio;
    expect_picture(view, "blend-glass");
}

}  // namespace
}  // namespace patina::render
