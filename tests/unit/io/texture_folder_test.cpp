// SPDX-License-Identifier: MIT
#include "io/texture_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <set>

#include "io/image_decode.h"
#include "io/image_file.h"
#include "io/map_packing.h"
#include "sample_gltf.h"
#include "temporary_folder.h"

namespace patina::io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TextureChannel whole(Channel channel) {
    return {.channel = channel};
}
TextureChannel red(Channel channel) {
    return {.channel = channel, .pick = ChannelPick::Red};
}

TEST(TextureNames, AreReadAsTheSourcesOfTexturesWriteThem) {
    struct Row {
        const char* name;
        std::vector<TextureChannel> channels;
    };
    const std::vector<Row> rows = {
        {"wood_albedo.png", {whole(Channel::BaseColor)}},
        {"wood_basecolor.png", {whole(Channel::BaseColor)}},
        {"Suzanne_BaseColor.png", {whole(Channel::BaseColor)}},
        {"wood_floor_diff_2k.jpg", {whole(Channel::BaseColor)}},
        {"Wood062_2K-JPG_Color.jpg", {whole(Channel::BaseColor)}},
        {"wood_col.tif", {whole(Channel::BaseColor)}},
        {"wood_rough_4k.exr", {red(Channel::Roughness)}},
        {"Wood062_2K_Roughness.jpg", {red(Channel::Roughness)}},
        {"wood_metal.png", {red(Channel::Metalness)}},
        {"wood_Metalness.png", {red(Channel::Metalness)}},
        {"wood_ao_1k.png", {red(Channel::Occlusion)}},
        {"Wood062_2K_AmbientOcclusion.jpg", {red(Channel::Occlusion)}},
        {"wood_disp_4k.png", {red(Channel::Height)}},
        {"Wood062_Displacement.tif", {red(Channel::Height)}},
        {"wood_nrm.png", {whole(Channel::Normal)}},
        {"T_Rock_N.tga", {whole(Channel::Normal)}},
        {"T_Rock_D.tga", {whole(Channel::BaseColor)}},
        {"lamp-emissive.png", {whole(Channel::Emissive)}},
        {"leaf_opacity.png", {red(Channel::Opacity)}},
        {"wood_orm.png",
         {red(Channel::Occlusion),
          {.channel = Channel::Roughness, .pick = ChannelPick::Green},
          {.channel = Channel::Metalness, .pick = ChannelPick::Blue}}},
        {"Avocado_roughnessMetallic.png",
         {{.channel = Channel::Roughness, .pick = ChannelPick::Green},
          {.channel = Channel::Metalness, .pick = ChannelPick::Blue}}},
        {"wood_gloss.png",
         {{.channel = Channel::Roughness, .pick = ChannelPick::Red, .invert = true}}},
        {"Body_AlbedoTransparency.png", {whole(Channel::BaseColor)}},
        {"Body_MetallicSmoothness.png",
         {red(Channel::Metalness),
          {.channel = Channel::Roughness, .pick = ChannelPick::Alpha, .invert = true}}},
        {"Body_MaskMap.png",
         {red(Channel::Metalness),
          {.channel = Channel::Occlusion, .pick = ChannelPick::Green},
          {.channel = Channel::Roughness, .pick = ChannelPick::Alpha, .invert = true}}},
        {"x_ao_rough_metal.png",
         {red(Channel::Occlusion),
          {.channel = Channel::Roughness, .pick = ChannelPick::Green},
          {.channel = Channel::Metalness, .pick = ChannelPick::Blue}}},
        {"leaf_mask.png", {}},
        {"readme.png", {}},
        {"DSC_0123.jpg", {}},
        {"d.png", {}},
    };
    for (const Row& row : rows)
        EXPECT_EQ(guess_texture(row.name).channels, row.channels) << row.name;
}

TEST(TextureNames, TellDirectxNormalsFromOpenglOnes) {
    EXPECT_FALSE(guess_texture("wood_nor_gl_2k.exr").directx_normal);
    EXPECT_TRUE(guess_texture("wood_nor_dx_2k.exr").directx_normal);
    EXPECT_FALSE(guess_texture("Wood062_2K_NormalGL.jpg").directx_normal);
    EXPECT_TRUE(guess_texture("Wood062_2K_NormalDX.jpg").directx_normal);
}

/// What a texture of that name would be read as, by component of the file; unset where nothing is.
std::array<PackedValue, 4> as_read(const std::string& name) {
    std::array<PackedValue, 4> values = {};
    const TextureGuess guess = guess_texture(name);
    for (const TextureChannel& channel : guess.channels) {
        if (channel.pick == ChannelPick::Rgb)
            for (int k = 0; k < 3; ++k)
                values[static_cast<std::size_t>(k)] = {
                    .channel = channel.channel,
                    .component = k,
                    .invert = channel.channel == Channel::Normal && k == 1 && guess.directx_normal};
        else
            values[static_cast<std::size_t>(channel.pick) -
                   static_cast<std::size_t>(ChannelPick::Red)] = {.channel = channel.channel,
                                                                  .invert = channel.invert};
    }
    return values;
}

TEST(TextureNames, OfEveryExportPackingAreReadBackAsWhatTheyHold) {
    for (const MapPacking& packing : map_packings())
        for (const PackedMap& map : packing.maps) {
            const std::string name = fmt::format("Body_{}.png", map.id);
            SCOPED_TRACE(fmt::format("{} {}", packing.id, name));
            EXPECT_EQ(guess_texture(name).stem(), "body");
            const std::array<PackedValue, 4> read = as_read(name);
            std::set<Channel> seen;
            for (std::size_t i = 0; i < static_cast<std::size_t>(map.channels); ++i) {
                const PackedValue& held = map.values[i];
                // Alpha of a colour is looked at when the file is read; grey may be said thrice.
                if (!held.channel || held.channel == Channel::Opacity) continue;
                if (info(*held.channel).kind == ChannelKind::Scalar &&
                    !seen.insert(*held.channel).second)
                    continue;
                EXPECT_EQ(read[i].channel, held.channel) << i;
                EXPECT_EQ(read[i].component, held.component) << i;
                EXPECT_EQ(read[i].invert, held.invert) << i;
            }
        }
}

TEST(TextureNames, AreOfOneMaterialWhereTheWordsBeforeTheirUseAreTheSame) {
    EXPECT_EQ(guess_texture("Metal-Plate_rough_2k.png").stem(), "metal_plate");
    EXPECT_EQ(guess_texture("metal_plate_nor_gl_4k.exr").stem(), "metal_plate");
    EXPECT_EQ(guess_texture("Wood062_2K-JPG_AmbientOcclusion.jpg").stem(), "wood_062");
    EXPECT_EQ(guess_texture("T_Rock_N.tga").stem(), "t_rock");
    EXPECT_EQ(guess_texture("albedo_brick.png").stem(), "brick");
    EXPECT_EQ(guess_texture("albedo_4096.png").stem(), "");
}

class TextureFolderTest : public testing::Test {
  protected:
    void put(const std::string& name, std::uint8_t grey, int channels = 3,
             SampleType type = SampleType::U8) {
        Image image{.width = 4, .height = 4, .channels = channels, .type = type};
        image.data.resize(image.row_bytes() * 4);
        for (std::size_t i = 0; i < image.data.size() / sample_bytes(type); ++i) {
            if (type == SampleType::U8) image.data[i] = std::byte{grey};
            if (type == SampleType::U16)
                reinterpret_cast<std::uint16_t*>(image.data.data())[i] =
                    static_cast<std::uint16_t>(grey * 257);
            if (type == SampleType::F32)
                reinterpret_cast<float*>(image.data.data())[i] = static_cast<float>(grey) / 255.0f;
        }
        ASSERT_TRUE(write_image_file(folder() / name, image).has_value());
    }
    std::filesystem::path folder() const { return folder_.path() / "oak"; }
    void SetUp() override { std::filesystem::create_directory(folder()); }

    TextureFolder read() {
        auto result = read_texture_folder(folder(), store_);
        EXPECT_TRUE(result.has_value()) << result.error().message;
        return *result;
    }
    static const ImageSource& source(const Layer& layer, Channel channel) {
        return std::get<ImageSource>(at(layer.channels, channel).source);
    }

    TemporaryFolder folder_;
    ImageStore store_;
};

TEST_F(TextureFolderTest, BecomesALayerThatReadsEachChannelAsItsFileIsMeant) {
    put("oak_albedo.png", 100);
    put("oak_nor_dx.png", 128);
    put("oak_gloss.png", 200);
    put("oak_disp.tif", 90, 1, SampleType::U16);
    const TextureFolder oak = read();
    EXPECT_EQ(oak.layer.name, "oak");
    EXPECT_EQ(oak.images.size(), 4u);
    EXPECT_EQ(source(oak.layer, Channel::BaseColor).color_space, ColorSpace::Srgb);
    EXPECT_TRUE(source(oak.layer, Channel::Normal).directx_normal);
    EXPECT_EQ(source(oak.layer, Channel::Normal).color_space, ColorSpace::Linear);
    EXPECT_TRUE(source(oak.layer, Channel::Roughness).invert);
    EXPECT_EQ(source(oak.layer, Channel::Height).add.x, -0.5f);
    EXPECT_FALSE(at(oak.layer.channels, Channel::Metalness).enabled);
    EXPECT_FALSE(at(oak.layer.channels, Channel::Opacity).enabled);
}

TEST_F(TextureFolderTest, PrefersFilesOfOneChannelAndOpenglNormalsAndSaysSo) {
    put("oak_arm.png", 10);
    put("oak_rough.png", 20);
    put("oak_nor_dx.png", 128);
    put("oak_nor_gl.png", 127);
    put("notes.png", 1);
    const TextureFolder oak = read();
    std::vector<std::string> lines;
    for (const TextureUseOfFile& file : oak.files) lines.push_back(file.described);
    EXPECT_THAT(
        lines,
        ElementsAre("notes.png: not used, its name does not say what it is",
                    "oak_arm.png: occlusion from red, metalness from blue (\"arm\")",
                    "oak_nor_dx.png: not used, another file suits better (\"nordx\")",
                    "oak_nor_gl.png: normal (\"norgl\")", "oak_rough.png: roughness (\"rough\")"));
    EXPECT_EQ(source(oak.layer, Channel::Metalness).pick, ChannelPick::Blue);
    EXPECT_FALSE(source(oak.layer, Channel::Normal).directx_normal);
}

TEST_F(TextureFolderTest, TakesOpacityFromItsOwnFileElseFromAlphaAndSaysSo) {
    put("oak_albedo.png", 100, 4);
    const TextureFolder oak = read();
    EXPECT_EQ(source(oak.layer, Channel::Opacity).pick, ChannelPick::Alpha);
    EXPECT_EQ(oak.files[0].described,
              "oak_albedo.png: base-color, opacity from alpha (\"albedo\")");
    put("oak_opacity.png", 50, 1);
    EXPECT_EQ(source(read().layer, Channel::Opacity).pick, ChannelPick::Red);
}

TEST_F(TextureFolderTest, TakesNoOpacityFromAnAlphaThatIsOneEverywhere) {
    put("oak_albedo.png", 255, 4);
    EXPECT_FALSE(at(read().layer.channels, Channel::Opacity).enabled);
}

TEST_F(TextureFolderTest, RefusesTheTexturesOfTwoMaterialsAndTakesTheOneThatIsNamed) {
    put("wood_albedo.png", 10);
    put("wood_rough.png", 20, 1);
    put("metal_plate_albedo.png", 30);
    const auto both = read_texture_folder(folder(), store_);
    ASSERT_FALSE(both.has_value());
    EXPECT_THAT(both.error().message, HasSubstr("metal_plate, wood"));
    const auto wood = read_texture_folder(folder() / "wood", store_);
    ASSERT_TRUE(wood.has_value()) << wood.error().message;
    EXPECT_EQ(wood->layer.name, "wood");
    EXPECT_EQ(wood->files.size(), 2u);
    const auto stone = read_texture_folder(folder() / "stone", store_);
    ASSERT_FALSE(stone.has_value());
    EXPECT_THAT(stone.error().message, HasSubstr("no folder"));
}

TEST_F(TextureFolderTest, TakesAPictureOfTheMaterialForNoTexture) {
    put("Metal032.png", 200);
    put("Metal032_2K_Color.png", 10);
    put("Metal032_2K_Metalness.png", 20, 1);
    put("roughness.png", 30, 1);  // names no material: of the one that is there
    const TextureFolder metal = read();
    EXPECT_TRUE(metal.files[0].used.empty());
    EXPECT_EQ(metal.images.size(), 3u);
}

TEST_F(TextureFolderTest, ReadsFloatsAsLinearThoughTheyAreCarriedAsIntegers) {
    put("oak_albedo.exr", 100, 3, SampleType::F32);
    const TextureFolder oak = read();
    EXPECT_EQ(source(oak.layer, Channel::BaseColor).color_space, ColorSpace::Linear);
    EXPECT_EQ(oak.images[0]->type, SampleType::U16);
    EXPECT_EQ(oak.images[0]->mime_type, "image/png");
}

TEST_F(TextureFolderTest, OfNothingThatIsKnownIsAFailureThatSaysWhatNamesAreLike) {
    put("one.png", 1);
    const auto result = read_texture_folder(folder(), store_);
    ASSERT_FALSE(result.has_value());
    EXPECT_THAT(result.error().message, HasSubstr("wood_rough.png"));
    EXPECT_FALSE(read_texture_folder(folder() / "none", store_).has_value());
}

/// Every kind of file that a texture may be: samples, channels, formats.
TEST(ImageKinds, AreDecodedAsTheyAreStored) {
    for (const ImageFormat format : {ImageFormat::Png, ImageFormat::Tiff, ImageFormat::Exr})
        for (const SampleType type : {SampleType::U8, SampleType::U16, SampleType::F32})
            for (int channels = 1; channels <= 4; ++channels) {
                if (format == ImageFormat::Png && type == SampleType::F32) continue;
                Image image{.width = 3, .height = 2, .channels = channels, .type = type};
                image.data.resize(image.row_bytes() * 2);
                for (std::size_t i = 0; i < image.data.size() / sample_bytes(type); ++i) {
                    // Alpha stays 1, so that premultiplying changes nothing.
                    const bool alpha =
                        channels % 2 == 0 && i % static_cast<std::size_t>(channels) ==
                                                 static_cast<std::size_t>(channels) - 1;
                    const int value = alpha ? 255 : static_cast<int>(i * 8 + 3);
                    if (type == SampleType::U8) image.data[i] = static_cast<std::byte>(value);
                    if (type == SampleType::U16)
                        reinterpret_cast<std::uint16_t*>(image.data.data())[i] =
                            static_cast<std::uint16_t>(value * 257);
                    if (type == SampleType::F32)
                        reinterpret_cast<float*>(image.data.data())[i] =
                            static_cast<float>(value) / 255.0f;
                }
                const std::string name =
                    fmt::format("a.{}", kImageFormats[static_cast<std::size_t>(format)].id);
                const auto encoded = encode_image(image, format);
                ASSERT_TRUE(encoded.has_value()) << name;
                const auto decoded = decode_image(*encoded, name);
                ASSERT_TRUE(decoded.has_value()) << name << ": " << decoded.error().message;
                EXPECT_EQ((*decoded)->channels, channels) << name;
                if (format == ImageFormat::Exr) {
                    EXPECT_EQ((*decoded)->type, SampleType::F32);
                    const auto* const numbers =
                        reinterpret_cast<const float*>((*decoded)->data.data());
                    EXPECT_NEAR(numbers[0], 3.0f / 255.0f, 1e-4f) << name;
                } else {
                    EXPECT_EQ(**decoded, image) << name << " of " << channels << " channels";
                }
            }
}

TEST(ImageKinds, SayWhetherTheirColoursAreLinear) {
    TemporaryFolder folder;
    ImageStore store;
    Image floats{.width = 1, .height = 1, .channels = 3, .type = SampleType::F32};
    floats.data.resize(12);
    reinterpret_cast<float*>(floats.data.data())[0] = 7.0f;
    for (const char* name : {"a.exr", "a.tif"}) {
        ASSERT_TRUE(write_image_file(folder.path() / name, floats).has_value());
        const auto asset = store.add_file(folder.path() / name);
        ASSERT_TRUE(asset.has_value()) << asset.error().message;
        EXPECT_EQ((*asset)->color_space, ColorSpace::Linear) << name;
    }
    // Radiance HDR, one pixel of 1, 0.5, 0.25 (RGBE: mantissas over 256, exponent 129 - 128).
    std::string hdr = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n";
    hdr += "\x80\x40\x20\x81";
    ASSERT_TRUE(write_file_atomically(folder.path() / "a.hdr", hdr).has_value());
    const auto light = store.add_file(folder.path() / "a.hdr");
    ASSERT_TRUE(light.has_value()) << light.error().message;
    EXPECT_EQ((*light)->color_space, ColorSpace::Linear);
    const Bytes png = test::plain_png(1, 1, 9, 9, 9);
    EXPECT_EQ((*store.add(std::make_shared<const Bytes>(png), "a.png"))->color_space,
              ColorSpace::Srgb);
    // The same with a gAMA chunk of 1.0 after its header (CRC-32 of "gAMA" and 100000).
    Bytes linear = png;
    const std::string gama("\0\0\0\4gAMA\0\1\x86\xa0\x31\xe8\x96\x5f", 16);
    const auto bytes = bytes_of(gama);
    linear.insert(linear.begin() + 33, bytes.begin(), bytes.end());
    const auto asset = store.add(std::make_shared<const Bytes>(linear), "b.png");
    ASSERT_TRUE(asset.has_value()) << asset.error().message;
    EXPECT_EQ((*asset)->color_space, ColorSpace::Linear);
}

}  // namespace
}  // namespace patina::io
