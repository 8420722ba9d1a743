// SPDX-License-Identifier: MIT
#include "io/map_export.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "composite/composite.h"
#include "io/image_decode.h"
#include "io/save.h"
#include "save_fixture.h"

namespace patina::io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> names_of(const std::vector<fs::path>& files) {
    std::vector<std::string> names;
    for (const fs::path& file : files) names.push_back(file.filename().string());
    return names;
}

const MapPacking* packing_of(std::string_view id) {
    const auto packings = map_packings();
    const auto found = std::find_if(packings.begin(), packings.end(),
                                    [&](const MapPacking& packing) { return packing.id == id; });
    return found == packings.end() ? nullptr : &*found;
}

Image decoded(const fs::path& file) {
    return **decode_image(*read_file(file), file.filename().string());
}

class MapExport : public Save {
  protected:
    MapExport() : base_(quad(true)) {
        Material material = *with_noise_layer(*base_.document, 0).materials[0];
        Layer layer = *material.stack.back();
        ChannelSettings& height = at(layer.channels, Channel::Height);
        height.enabled = true;
        height.source = noise(3);
        ChannelSettings& metalness = at(layer.channels, Channel::Metalness);
        metalness.enabled = true;
        metalness.source = noise(4);
        material.stack.back() = std::make_shared<const Layer>(layer);
        document_ = with_material(*base_.document, 0, material);
    }
    std::vector<fs::path> exported(const MapExportOptions& options) {
        const fs::path folder = folder_ / fmt::format("maps-{}", ++exports_);
        return export_maps(document_, *base_.images, folder, options).value();
    }

    LoadedDocument base_;
    Document document_;
    int exports_ = 0;
};

TEST_F(MapExport, OfEightBitsIsTheBakeOfTheFile) {
    const auto files = exported({});
    ASSERT_THAT(names_of(files),
                ElementsAre("Quad_base-color.png", "Quad_occlusion-roughness-metalness.png",
                            "Quad_normal.png"));
    const Program program = Program::compile(*document_.materials[0]);
    const auto maps = bake_maps(program, *base_.images, 256, maps_of(program)).value();
    for (std::size_t i = 0; i < files.size(); ++i) {
        const Image file = decoded(files[i]);
        const Image& map = *maps.maps[i];
        ASSERT_EQ(file.channels, 3);
        for (std::size_t texel = 0; texel < 256 * 256; ++texel)
            for (std::size_t c = 0; c < 3; ++c)
                ASSERT_EQ(file.data[3 * texel + c], map.data[4 * texel + c])
                    << files[i] << " texel " << texel;
    }
}

TEST_F(MapExport, OfWhatASaveHasBakedIsWhatItWouldBakeItself) {
    const SaveReport saved =
        save_document(document_, *base_.images, folder_ / "kept.glb", {.keep_maps = true}).value();
    ASSERT_EQ(saved.maps.size(), 1u);
    for (const MapPacking& packing : map_packings())
        for (const ImageFormat format : {ImageFormat::Png, ImageFormat::Tiff}) {
            MapExportOptions options{.format = format, .packing = &packing};
            const auto anew = exported(options);
            options.baked = &saved.maps;
            const auto reused = exported(options);
            ASSERT_EQ(names_of(reused), names_of(anew)) << packing.id;
            for (std::size_t i = 0; i < anew.size(); ++i) {
                const Image a = decoded(anew[i]), b = decoded(reused[i]);
                ASSERT_EQ(a.channels, b.channels) << packing.id;
                ASSERT_EQ(a.data, b.data) << packing.id << " " << anew[i];
            }
        }
}

TEST_F(MapExport, AsJpegKeepsNormalsAsPngUnlessTheyAreNamed) {
    const MapExportOptions options{.format = ImageFormat::Jpeg};
    EXPECT_THAT(names_of(exported(options)),
                ElementsAre("Quad_base-color.jpg", "Quad_occlusion-roughness-metalness.jpg",
                            "Quad_normal.png"));
    EXPECT_THAT(warnings_of(options), ElementsAre(HasSubstr("normal stays png")));
    const MapExportOptions insisting{.format_of_map = {{"normal", ImageFormat::Jpeg}}};
    EXPECT_THAT(names_of(exported(insisting)),
                ElementsAre("Quad_base-color.png", "Quad_occlusion-roughness-metalness.png",
                            "Quad_normal.jpg"));
    EXPECT_THAT(warnings_of(insisting), ElementsAre(HasSubstr("normal as jpg")));
}

TEST_F(MapExport, RefusesFormatsThatCannotHoldWhatIsAskedOfThem) {
    EXPECT_FALSE(check_map_options({.format = ImageFormat::Jpeg, .bits = 16}));
    EXPECT_FALSE(check_map_options({.format_of_map = {{"normal", ImageFormat::Exr}}}));
    EXPECT_FALSE(check_map_options({.format_of_map = {{"height", ImageFormat::Png}}}));
    EXPECT_FALSE(
        check_map_options({.format = ImageFormat::Jpeg, .packing = packing_of("unity-hdrp")}));
    EXPECT_TRUE(check_map_options({.format = ImageFormat::Jpeg,
                                   .format_of_map = {{"MaskMap", ImageFormat::Png}},
                                   .packing = packing_of("unity-hdrp")}));
}

TEST_F(MapExport, OfEachPngLevelHoldsTheSameNumbers) {
    const auto quick = exported({.png_level = 1});
    const auto hard = exported({.png_level = 3});
    EXPECT_NE(*read_file(quick.at(0)), *read_file(hard.at(0)));
    EXPECT_EQ(decoded(quick.at(0)), decoded(hard.at(0)));
}

TEST_F(MapExport, OfSixteenBitsIsWithinOneStepOfTheEightBitOne) {
    const auto eight = exported({});
    for (const ImageFormat format : {ImageFormat::Png, ImageFormat::Tiff}) {
        const auto sixteen = exported({.format = format, .bits = 16});
        ASSERT_EQ(sixteen.size(), eight.size());
        for (std::size_t i = 0; i < eight.size(); ++i) {
            const Image fine = decoded(sixteen[i]);
            const Image coarse = decoded(eight[i]);
            ASSERT_EQ(fine.type, SampleType::U16);
            bool finer = false;
            for (std::size_t k = 0; k < coarse.data.size(); ++k) {
                const int value = reinterpret_cast<const std::uint16_t*>(fine.data.data())[k];
                ASSERT_NEAR(value / 257.0, static_cast<double>(coarse.data[k]), 0.51);
                finer = finer || value % 257 != 0;
            }
            EXPECT_TRUE(finer) << "8 bits in the clothes of 16";
        }
    }
}

TEST_F(MapExport, OfFloatsHoldsLinearColours) {
    const auto eight = exported({});
    for (const int bits : {16, 32}) {
        const auto floats = exported({.format = ImageFormat::Exr, .bits = bits});
        const Image color = decoded(floats.at(0));
        const Image encoded = decoded(eight.at(0));
        ASSERT_EQ(color.type, SampleType::F32);
        const auto* const numbers = reinterpret_cast<const float*>(color.data.data());
        for (std::size_t k = 0; k < encoded.data.size(); k += 97) {
            const double stored = static_cast<double>(encoded.data[k]) / 255.0;
            const double linear =
                stored <= 0.04045 ? stored / 12.92 : std::pow((stored + 0.055) / 1.055, 2.4);
            ASSERT_NEAR(static_cast<double>(numbers[k]), linear, 0.005);
        }
    }
}

TEST_F(MapExport, PacksAsTheNamedProgramWants) {
    const auto gltf = exported({});
    const auto unreal = exported({.packing = packing_of("unreal")});
    const Image up = decoded(gltf.at(2));
    const Image down = decoded(unreal.at(2));
    for (std::size_t k = 0; k < up.data.size(); k += 3) {
        ASSERT_EQ(up.data[k], down.data[k]);
        ASSERT_NEAR(static_cast<int>(up.data[k + 1]) + static_cast<int>(down.data[k + 1]), 255, 1);
    }
    const auto unity = exported({.packing = packing_of("unity")});
    ASSERT_THAT(names_of(unity),
                ElementsAre("Quad_AlbedoTransparency.png", "Quad_MetallicSmoothness.png",
                            "Quad_Normal.png", "Quad_Height.png"));
    const Image packed = decoded(gltf.at(1));
    const Image smooth = decoded(unity.at(1));
    for (std::size_t texel = 0; texel < 256 * 256; ++texel) {
        ASSERT_EQ(smooth.data[4 * texel], packed.data[3 * texel + 2]);
        ASSERT_NEAR(static_cast<int>(smooth.data[4 * texel + 3]),
                    255 - static_cast<int>(packed.data[3 * texel + 1]), 1);
    }
    EXPECT_THAT(names_of(exported({.packing = packing_of("separate")})),
                ElementsAre("Quad_base-color.png", "Quad_metalness.png", "Quad_roughness.png",
                            "Quad_normal.png", "Quad_height.png"));
}

TEST_F(MapExport, WritesTheMapsThatASaveDoesNotBakeToo) {
    const fs::path file = folder_ / "textured.glb";
    saved(document_, *base_.images, file);
    // Reopened, its textures are what they are: nothing is left to bake.
    const LoadedDocument reopened = loaded(file);
    const auto files = export_maps(*reopened.document, *reopened.images, folder_ / "again").value();
    EXPECT_EQ(files.size(), 3u);
}

TEST_F(MapExport, GivesMaterialsOfOneNameFilesOfTheirOwn) {
    const auto two = quad(true, {{.name = "../Body \xC3\xA9/x"}, {.name = "__/Body \xC3\xA9/x"}});
    const Document noisy = with_noise_layer(with_noise_layer(*two.document, 0), 1, 2);
    const auto files = export_maps(noisy, *two.images, folder_ / "maps").value();
    EXPECT_THAT(names_of(files), ElementsAre("_._Body____x_base-color.png",
                                             "_._Body____x_occlusion-roughness-metalness.png",
                                             "___Body____x_base-color.png",
                                             "___Body____x_occlusion-roughness-metalness.png"));
}

TEST(MapExportOptions, ThatNoFileCanHoldAreRefused) {
    EXPECT_THAT(check_map_options({.format = ImageFormat::Png, .bits = 32}).error().message,
                HasSubstr("use tif or exr"));
    EXPECT_THAT(check_map_options({.format = ImageFormat::Exr, .bits = 8}).error().message,
                HasSubstr("use png or tif"));
    EXPECT_THAT(check_map_options({.format = ImageFormat::Exr, .packing = packing_of("unity")})
                    .error()
                    .message,
                HasSubstr("alpha"));
    for (const MapPacking& packing : map_packings())
        EXPECT_TRUE(check_map_options({.packing = &packing}).has_value());
}

}  // namespace
}  // namespace patina::io
