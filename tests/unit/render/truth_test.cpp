// SPDX-License-Identifier: MIT

/// How near the renderer's picture is to the integral that it stands for: spheres of every
/// roughness in real and built-in light, against a sum over all texels of the environment.

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <random>

#include "core/files.h"
#include "core/parallel.h"
#include "io/image_decode.h"
#include "render/reflected_light.h"
#include "render/render_test.h"

namespace patina::render {
namespace {

namespace fs = std::filesystem;

/// Of the map that both sides are given: the sum over its texels is what takes the time.
constexpr int kMapWidth = 256;
constexpr int kPixelsPerSphere = 40;
constexpr glm::vec3 kSphereCenter(0.0f, 0.5f, 0.0f);
constexpr float kSphereRadius = 0.5f;

/// So fine that what stands for its faces differs from a sphere by less than what is looked for.
Mesh fine_sphere() {
    constexpr int kAround = 256;
    constexpr int kDown = 128;
    Primitive sphere;
    sphere.source_material = 0;
    for (int y = 0; y <= kDown; ++y)
        for (int x = 0; x <= kAround; ++x) {
            const glm::vec3 normal =
                direction_at(static_cast<float>(x) / kAround, static_cast<float>(y) / kDown);
            sphere.positions.push_back(kSphereCenter + kSphereRadius * normal);
            sphere.normals.push_back(normal);
        }
    for (std::uint32_t y = 0; y < kDown; ++y)
        for (std::uint32_t x = 0; x < kAround; ++x) {
            const std::uint32_t corner = y * (kAround + 1) + x;
            const std::uint32_t below = corner + kAround + 1;
            for (const std::uint32_t index :
                 {corner, corner + 1, below, corner + 1, below + 1, below})
                sphere.indices.push_back(index);
        }
    return {"sphere", {sphere}};
}

/// How the sphere is looked at.
struct Shot {
    Camera camera;
    PictureSize size;
};

struct SpherePoint {
    Pixel pixel;
    glm::vec3 normal;
    glm::vec3 to_eye;
};

/// The sphere where a pixel's point (x, y from its upper left corner, 0 to 1) looks.
std::optional<SpherePoint> sphere_at(const Shot& shot, Pixel pixel, glm::vec2 within) {
    const Camera& camera = shot.camera;
    const glm::vec3 forward = glm::normalize(camera.target - camera.position);
    const glm::vec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::vec3 up = glm::cross(right, forward);
    const float half = std::tan(glm::radians(camera.fov_y_degrees) * 0.5f);
    const float x =
        (static_cast<float>(pixel.x) + within.x) / static_cast<float>(shot.size.width) * 2.0f -
        1.0f;
    const float y = 1.0f - (static_cast<float>(pixel.y) + within.y) /
                               static_cast<float>(shot.size.height) * 2.0f;
    const glm::vec3 direction = glm::normalize(forward + half * (x * right + y * up));
    const glm::vec3 from_center = camera.position - kSphereCenter;
    const float b = glm::dot(from_center, direction);
    const float root = b * b - glm::dot(from_center, from_center) + kSphereRadius * kSphereRadius;
    if (root < 0.0f) return std::nullopt;
    const glm::vec3 hit = camera.position + (-b - std::sqrt(root)) * direction;
    return SpherePoint{pixel, (hit - kSphereCenter) / kSphereRadius, -direction};
}

bool wholly_covered(const Shot& shot, Pixel pixel) {
    for (const glm::vec2 corner : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(0, 1), glm::vec2(1)})
        if (!sphere_at(shot, pixel, corner)) return false;
    return true;
}

/// The same well spread pixels in every run.
std::vector<Pixel> chosen_pixels(const Shot& shot) {
    std::mt19937 random(7);
    const auto below = [&](int side) {
        return static_cast<int>(random() % static_cast<unsigned>(side));
    };
    std::vector<Pixel> pixels;
    while (pixels.size() < kPixelsPerSphere) {
        const Pixel pixel{below(shot.size.width), below(shot.size.height)};
        if (wholly_covered(shot, pixel)) pixels.push_back(pixel);
    }
    return pixels;
}

/// The mean over a grid of points of a pixel.
template <typename Radiance>
glm::dvec3 mean_over_pixel(const Shot& shot, Pixel pixel, int side, const Radiance& radiance) {
    glm::dvec3 sum(0.0);
    int count = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const glm::vec2 within((glm::vec2(x, y) + 0.5f) / static_cast<float>(side));
            const auto point = sphere_at(shot, pixel, within);
            if (!point) continue;
            sum += radiance(*point);
            ++count;
        }
    return sum / static_cast<double>(count);
}

/// What a mirror shows varies within a pixel the most.
constexpr int kMirroredSide = 32;

/// @param side  of the grid of points at which the whole environment is summed
glm::dvec3 true_radiance(const ReflectedLight& light, const Shot& shot, Pixel pixel,
                         const ReflectingMaterial& material, int side) {
    const glm::dvec3 sum = mean_over_pixel(shot, pixel, side, [&](const SpherePoint& point) {
        return light.summed(point.normal, point.to_eye, material);
    });
    if (!material.is_smooth()) return sum;
    return sum + mean_over_pixel(shot, pixel, kMirroredSide, [&](const SpherePoint& point) {
               return light.mirrored(point.normal, point.to_eye, material);
           });
}

/// Roughness in sixths and metalness in halves.
std::vector<ReflectingMaterial> sphere_materials() {
    std::vector<ReflectingMaterial> result;
    for (const float metalness : {0.0f, 0.5f, 1.0f})
        for (int sixth = 0; sixth <= 6; ++sixth)
            result.push_back(
                {glm::vec3(0.9f, 0.6f, 0.3f), metalness, static_cast<float>(sixth) / 6.0f});
    return result;
}

std::string_view group_of(const ReflectingMaterial& material) {
    if (material.metalness == 0.0f) return "non-metals";
    if (material.metalness < 1.0f) return "half-metals";
    return material.roughness == 0.0f ? "mirror" : "metals";
}

class TruthTest : public RenderTest {
  protected:
    void SetUp() override {
        RenderTest::SetUp();
        show(scene_of(fine_sphere()));
    }
    /// The geometric mean of the error of each group.
    std::map<std::string_view, double> errors(
        const Image& environment, int samples,
        const std::vector<ReflectingMaterial>& shown = sphere_materials()) {
        const RadianceMap map = reduced_to_width(value_of(radiance_map(environment)), kMapWidth);
        const FilteredEnvironment filtered =
            value_of(filter_environment(image_of(map), FilterQuality::Finished));
        EXPECT_TRUE(renderer().set_environment(filtered));
        const ReflectedLight light(map);
        view_.camera = framed(renderer().bounds_world(), 1.0f, ViewDirection::ThreeQuarter);
        const std::vector<Pixel> pixels = chosen_pixels(shot());
        std::map<std::string_view, std::vector<double>> cells;
        for (const ReflectingMaterial& material : shown) {
            const double error = error_of(light, pixels, material, samples);
            cells[group_of(material)].push_back(error);
            std::printf("  metalness %.1f roughness %.3f: %.4f\n",
                        static_cast<double>(material.metalness),
                        static_cast<double>(material.roughness), error);
        }
        std::map<std::string_view, double> means;
        for (const auto& [group, values] : cells) {
            double logs = 0.0;
            for (const double value : values) logs += std::log(value);
            means[group] = std::exp(logs / static_cast<double>(values.size()));
            std::printf("%-12s %.4f\n", std::string(group).c_str(), means[group]);
        }
        return means;
    }

    PictureSize size_ = {192, 192};
    int summed_side_ = 1;  ///< see true_radiance

  private:
    Shot shot() const { return {view_.camera, size_}; }

    static Image image_of(const RadianceMap& map) {
        Image image{.width = map.width,
                    .height = map.height,
                    .channels = 3,
                    .type = SampleType::F32,
                    .data = {}};
        image.data.resize(image.row_bytes() * static_cast<std::size_t>(map.height));
        std::memcpy(image.data.data(), map.texels.data(), image.data.size());
        return image;
    }

    double error_of(const ReflectedLight& light, const std::vector<Pixel>& pixels,
                    const ReflectingMaterial& material, int samples) {
        EXPECT_TRUE(renderer().set_material(
            0,
            constant_surface(material.base_color_linear, material.metalness, material.roughness)));
        const Image picture = value_of(renderer().still_linear(view_, size_, samples));
        std::vector<glm::dvec3> truth(pixels.size());
        parallel_for(0, static_cast<std::int64_t>(pixels.size()), 1,
                     [&](std::int64_t first, std::int64_t last) {
                         for (auto i = static_cast<std::size_t>(first);
                              i < static_cast<std::size_t>(last); ++i)
                             truth[i] =
                                 true_radiance(light, shot(), pixels[i], material, summed_side_);
                     });
        RelativeError error;
        for (std::size_t i = 0; i < pixels.size(); ++i)
            error.add(glm::dvec3(pixel_of(picture, pixels[i].x, pixels[i].y)), truth[i]);
        return error.value();
    }
};

struct Scenery {
    const char* name;
    /// The most that the geometric mean of a group's errors may be.
    double mirror;
    double metals;
    double half_metals;
    double non_metals;
};

std::string name_of(const testing::TestParamInfo<Scenery>& info) {
    return info.param.name;
}

void expect_below(const std::map<std::string_view, double>& means, const Scenery& most) {
    EXPECT_LT(means.at("mirror"), most.mirror);
    EXPECT_LT(means.at("metals"), most.metals);
    EXPECT_LT(means.at("half-metals"), most.half_metals);
    EXPECT_LT(means.at("non-metals"), most.non_metals);
}

constexpr int kSamplesPerPixel = 4;

class TruthOfShipped : public TruthTest, public testing::WithParamInterface<Scenery> {};

TEST_P(TruthOfShipped, PrefilteredLightIsNearTheIntegral) {
    const Image map = value_of(builtin_environment(GetParam().name, 256));
    expect_below(errors(map, kSamplesPerPixel), GetParam());
}
INSTANTIATE_TEST_SUITE_P(Builtin, TruthOfShipped,
                         testing::Values(Scenery{"studio", 0.07, 0.078, 0.039, 0.0165},
                                         Scenery{"sky", 0.025, 0.024, 0.0125, 0.0075}),
                         name_of);

/// Null where the shared models are not there.
ImagePtr asset(const std::string& name) {
    const fs::path file =
        fs::path(PATINA_SOURCE_DIR) / "../shared/assets/environments" / (name + ".hdr");
    if (!fs::exists(file)) return nullptr;
    return value_of(io::decode_image(value_of(read_file(file)), file.string()));
}

class TruthOfAssets : public TruthTest, public testing::WithParamInterface<Scenery> {};

TEST_P(TruthOfAssets, PrefilteredLightIsNearTheIntegral) {
    const ImagePtr map = asset(GetParam().name);
    if (map == nullptr) GTEST_SKIP() << "the shared environments are not there";
    expect_below(errors(*map, kSamplesPerPixel), GetParam());
}
INSTANTIATE_TEST_SUITE_P(Assets, TruthOfAssets,
                         testing::Values(Scenery{"chinese_garden_1k", 0.072, 0.034, 0.0215, 0.0165},
                                         Scenery{"noon_grass_1k", 0.042, 0.024, 0.0135, 0.0075}),
                         name_of);

class TruthOfStills : public TruthTest {};

TEST_F(TruthOfStills, ManySamplesConvergeToTheIntegral) {
    const glm::vec3 base(0.9f, 0.6f, 0.3f);
    const std::vector<ReflectingMaterial> shown = {
        {base, 1.0f, 0.0f}, {base, 1.0f, 0.1667f}, {base, 1.0f, 1.0f}, {base, 0.0f, 0.5f}};
    const Image map = value_of(builtin_environment("studio", 256));
    const auto means = errors(map, 256, shown);
    EXPECT_LT(means.at("mirror"), 0.003);
    EXPECT_LT(means.at("metals"), 0.013);
    EXPECT_LT(means.at("non-metals"), 0.01);
}

/// What many samples reach; minutes each.
class NightlyTruth : public TruthTest, public testing::WithParamInterface<const char*> {
  protected:
    /// A quarter of the pixels, of which as many are looked at; in each the highlight of a sun on
    /// smooth metal varies.
    void SetUp() override {
        TruthTest::SetUp();
        size_ = {96, 96};
        summed_side_ = 4;
    }
    ImagePtr map() {
        const std::string name = GetParam();
        if (name != "sky") return asset(name);
        return std::make_shared<const Image>(value_of(builtin_environment(name, 256)));
    }
};

TEST_P(NightlyTruth, AThousandSamplesAreNearTheIntegral) {
    const ImagePtr environment = map();
    if (environment == nullptr) GTEST_SKIP() << "the shared environments are not there";
    expect_below(errors(*environment, 1024), {GetParam(), 0.005, 0.015, 0.012, 0.012});
}

TEST_P(NightlyTruth, FourThousandSamplesAreWithinSixTenthsOfWhatAThousandMayMiss) {
    const ImagePtr environment = map();
    if (environment == nullptr) GTEST_SKIP() << "the shared environments are not there";
    const glm::vec3 base(0.9f, 0.6f, 0.3f);
    const std::vector<ReflectingMaterial> some = {
        {base, 1.0f, 0.0f},        {base, 1.0f, 1.0f / 6.0f}, {base, 1.0f, 0.5f},
        {base, 1.0f, 1.0f},        {base, 0.5f, 1.0f / 6.0f}, {base, 0.5f, 2.0f / 3.0f},
        {base, 0.0f, 1.0f / 6.0f}, {base, 0.0f, 2.0f / 3.0f}};
    expect_below(errors(*environment, 4096, some), {GetParam(), 0.003, 0.009, 0.0072, 0.0072});
}

TEST_P(NightlyTruth, SixtyFourThousandSamplesAreTheIntegral) {
    const ImagePtr environment = map();
    if (environment == nullptr) GTEST_SKIP() << "the shared environments are not there";
    const glm::vec3 base(0.9f, 0.6f, 0.3f);
    for (const auto& [group, error] :
         errors(*environment, 65536, {{base, 1.0f, 1.0f / 3.0f}, {base, 0.0f, 0.5f}}))
        EXPECT_LT(error, 0.0025) << group;
}

INSTANTIATE_TEST_SUITE_P(Environments, NightlyTruth,
                         testing::Values("sky", "chinese_garden_1k", "noon_grass_1k"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace patina::render
