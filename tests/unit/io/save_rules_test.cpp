// SPDX-License-Identifier: MIT

/// The bake rules of a save, each on a small scene.

#include <gtest/gtest.h>

#include <algorithm>

#include "document/record.h"
#include "document/scene_edits.h"
#include "io/glb_write.h"
#include "io/image_file.h"
#include "io/json_splice.h"
#include "io/png_writer.h"
#include "io/sample_gltf.h"
#include "io/save_fixture.h"

namespace patina::io {
namespace {

ImageAssetPtr shaded_image(ImageStore& store, std::uint8_t shade) {
    Image image{.width = 8, .height = 8, .channels = 3, .type = SampleType::U8, .data = {}};
    image.data.resize(image.row_bytes() * 8);
    for (std::size_t i = 0; i < image.data.size(); ++i)
        image.data[i] = static_cast<std::byte>(shade + i % 50);
    return store
        .add(std::make_shared<const Bytes>(encode_png(image).value()),
             fmt::format("shade {}.png", shade))
        .value();
}

ImageSource color_image(const ImageAsset& image) {
    ImageSource source;
    source.image = image.hash;
    source.color_space = ColorSpace::Srgb;
    return source;
}

/// The lowest layer's base colour from that source.
Document with_base_color(const Document& document, const Source& source, std::size_t index = 0) {
    Material material = material_at(document, index);
    Layer layer = *material.stack.front();
    at(layer.channels, Channel::BaseColor) = {.enabled = true, .source = source};
    material.stack.front() = std::make_shared<const Layer>(layer);
    material.resolution = kMinResolution;
    return with_material(document, index, std::move(material));
}

TEST_F(Save, AnUntouchedImageIsShownAsItIsWithFactorTransformAndWrap) {
    const auto document = quad(true);
    const auto image = shaded_image(*document.images, 10);
    ImageSource source = color_image(*image);
    source.multiply = {0.5f, 0.25f, 1.0f};
    source.transform.scale = {2.0f, 1.0f};
    source.wrap_u = Wrap::Clamp;
    Document edited = with(*document.document, add_image(image));
    edited = with_base_color(edited, source);
    const auto path = folder_ / "a.glb";
    EXPECT_EQ(saved(edited, *document.images, path).maps_baked, 0);
    const Json json = Json::parse(json_of(path));
    const Json& slots = json["materials"][0]["pbrMetallicRoughness"];
    EXPECT_EQ(slots["baseColorFactor"], Json({0.5, 0.25, 1, 1}));
    const Json& info = slots["baseColorTexture"];
    EXPECT_EQ(info["extensions"]["KHR_texture_transform"]["scale"], Json({2, 1}));
    EXPECT_EQ(json["extensionsUsed"], Json({"KHR_texture_transform"}));
    EXPECT_EQ(json["samplers"][0]["wrapS"], 33071);
    const Bytes binary = parts_of(read_file(path).value()).binary;
    const auto encoded = image->encoded.bytes();
    ASSERT_TRUE(encoded);
    EXPECT_NE(std::search(binary.begin(), binary.end(), encoded->begin(), encoded->end()),
              binary.end())
        << "the bytes of the image went in as they were";
    EXPECT_TRUE(serialise(*loaded(path).document) == serialise(edited));
}

TEST_F(Save, LayersOverAMapOfAUvSetThatIsNotReadComeBack) {
    auto sample = test::sample_gltf();
    sample.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = 2;
    const auto document = test::load_from(sample.json, sample.binary);
    ASSERT_TRUE(document.has_value()) << document.error().message;
    const Document edited = with_noise_layer(*document->document, 0);
    const auto path = folder_ / "a.glb";
    saved(edited, *document->images, path);
    EXPECT_TRUE(serialise(*loaded(path).document) == serialise(edited));
}

TEST_F(Save, ABakedSlotLosesItsFactorsAndTransformAndKeepsItsWrapModes) {
    const auto document = quad(true);
    const auto image = shaded_image(*document.images, 10);
    ImageSource source = color_image(*image);
    source.multiply = {0.5f, 0.25f, 1.0f};
    source.transform.offset = {0.5f, 0.0f};
    source.wrap_v = Wrap::Mirror;
    const auto path = folder_ / "a.glb";
    saved(with_base_color(with(*document.document, add_image(image)), source), *document.images,
          path);
    const auto shown = loaded(path);
    saved(with_noise_layer(*shown.document, 0), *shown.images, path);
    const Json json = Json::parse(json_of(path));
    const Json& slots = json["materials"][0]["pbrMetallicRoughness"];
    EXPECT_FALSE(slots["baseColorTexture"].contains("extensions"));
    for (const double factor : slots.value("baseColorFactor", Json({1, 1, 1, 1})))
        EXPECT_EQ(factor, 1);
    const auto texture = slots["baseColorTexture"]["index"].get<std::size_t>();
    const auto sampler = json["textures"][texture]["sampler"].get<std::size_t>();
    EXPECT_EQ(json["samplers"][sampler]["wrapT"], 33648);
}

TEST_F(Save, AnImageOfALayerStaysInTheFileThoughNoSlotShowsIt) {
    const auto document = quad(true);
    const auto image = shaded_image(*document.images, 10);
    Document edited =
        with_base_color(with(*document.document, add_image(image)), color_image(*image));
    edited = with_noise_layer(edited, 0);
    const auto path = folder_ / "a.gltf";
    saved(edited, *document.images, path);
    const auto reopened = loaded(path);
    EXPECT_TRUE(serialise(*reopened.document) == serialise(edited));
    // Once no layer reads it, it goes, its file too.
    const std::size_t files = files_in(folder_);
    saved(with_base_color(*reopened.document, noise(3)), *reopened.images, path);
    EXPECT_EQ(files_in(folder_), files - 1);
}

TEST_F(Save, AnImageThatTwoMaterialsReadOutlivesTheEditOfOne) {
    const auto document = quad(true, {{.name = "A"}, {.name = "B"}});
    const auto image = shaded_image(*document.images, 10);
    Document edited = with(*document.document, add_image(image));
    for (std::size_t i = 0; i < 2; ++i) edited = with_base_color(edited, color_image(*image), i);
    const auto path = folder_ / "a.glb";
    saved(edited, *document.images, path);
    const auto both = loaded(path);
    saved(with_base_color(*both.document, ConstantSource{glm::vec3(0.5f)}, 0), *both.images, path);
    const auto one = loaded(path);
    EXPECT_EQ(to_json(material_record(*one.document, material_at(*one.document, 1))),
              to_json(material_record(edited, material_at(edited, 1))));
    const Json json = Json::parse(json_of(path));
    EXPECT_EQ(json["images"].size(), 1u);
    saved(with_base_color(*one.document, ConstantSource{glm::vec3(0.5f)}, 1), *one.images, path);
    EXPECT_FALSE(Json::parse(json_of(path)).contains("images"));
}

TEST_F(Save, ATextureOfAnotherMaterialIsNeverChanged) {
    const auto models = asset_models();
    const auto truck = std::find_if(models.begin(), models.end(), [](const fs::path& path) {
        return path.stem() == "CesiumMilkTruck";
    });
    if (truck == models.end()) GTEST_SKIP() << "no CesiumMilkTruck in ../shared/assets";
    // Its first and its last material show one texture.
    const auto document = loaded(*truck);
    const auto path = folder_ / "a.glb";
    saved(with_noise_layer(*document.document, 0), *document.images, path);
    const Json before = Json::parse(json_of(*truck)), after = Json::parse(json_of(path));
    EXPECT_EQ(after["textures"][0], before["textures"][0]);
    EXPECT_EQ(after["images"][0], before["images"][0]);
    EXPECT_NE(after["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"], 0);
    EXPECT_EQ(after["materials"].back(), before["materials"].back());
}

TEST_F(Save, FloatDataBeyondOneLiesBesideTheFileAndComesBack) {
    const auto document = quad(true);
    Image hdr{.width = 4, .height = 4, .channels = 3, .type = SampleType::F32, .data = {}};
    hdr.data.resize(hdr.row_bytes() * 4);
    auto* const values = reinterpret_cast<float*>(hdr.data.data());
    for (int i = 0; i < 48; ++i) values[i] = 0.25f * static_cast<float>(i);
    const auto file = folder_ / "in" / "glow.exr";
    fs::create_directories(file.parent_path());
    ASSERT_TRUE(write_image_file(file, hdr));
    const auto image = document.images->add_file(file).value();
    Document edited = with(*document.document, add_image(image));
    edited = with_base_color(edited, color_image(*image));
    const auto folder = folder_ / "out";
    fs::create_directories(folder);
    saved(edited, *document.images, folder / "a.glb");
    EXPECT_EQ(files_in(folder), 2u);
    const auto reopened = loaded(folder / "a.glb");
    EXPECT_TRUE(reopened.warnings.empty());
    EXPECT_TRUE(serialise(*reopened.document) == serialise(edited));
}

TEST_F(Save, TheEnvironmentComesBackAndEveryMaterialKeepsItsBytes) {
    const auto document = quad(true);
    const auto path = folder_ / "a.glb";
    saved(*document.document, *document.images, path);
    const auto before = JsonSpans::scan(json_of(path)).value();
    const Document edited = with(*document.document, set_environment_intensity(2.0f));
    saved(edited, *document.images, path);
    const auto after = JsonSpans::scan(json_of(path)).value();
    EXPECT_EQ(before.value_text(*before.find("/materials")),
              after.value_text(*after.find("/materials")));
    EXPECT_TRUE(serialise(*loaded(path).document) == serialise(edited));
}

TEST_F(Save, AnUndoneEditOfASavedGltfFindsTheMapsAgainThatASaveHadReplaced) {
    const auto document = quad(true);
    const auto path = folder_ / "a.gltf";
    saved(with_noise_layer(*document.document, 0, 1), *document.images, path);
    const auto before = read_file(path).value();
    const std::size_t files = files_in(folder_);
    const auto reopened = loaded(path);
    saved(with_base_color(with_noise_layer(*reopened.document, 0, 5), noise(9)), *reopened.images,
          path);
    EXPECT_EQ(files_in(folder_), files) << "the replaced maps are gone";
    saved(*reopened.document, *reopened.images, path);
    EXPECT_TRUE(read_file(path).value() == before);
    EXPECT_EQ(files_in(folder_), files);
    EXPECT_TRUE(serialise(*loaded(path).document) == serialise(*reopened.document));
}

TEST_F(Save, ThePreviousVersionIsKeptWhenAskedFor) {
    const auto document = quad(true);
    const auto path = folder_ / "a.glb";
    saved(*document.document, *document.images, path, {.keep_previous = true});
    EXPECT_EQ(files_in(folder_), 1u);
    const auto before = read_file(path).value();
    for (std::uint32_t seed = 1; seed < 3; ++seed) {
        const auto previous = read_file(path).value();
        saved(with_noise_layer(*document.document, 0, seed), *document.images, path,
              {.keep_previous = true});
        EXPECT_TRUE(read_file(folder_ / "a.glb~").value() == previous);
    }
    EXPECT_EQ(files_in(folder_), 2u);
}

TEST(GlbPieces, MoreThanFourGibibytesAreRefused) {
    // One MiB that is named 4 096 times.
    const Bytes mebibyte(std::size_t{1} << 20);
    const std::vector<std::span<const std::byte>> binary(4096, mebibyte);
    const auto glb = GlbPieces::make({.json_text = "{}", .binary = binary, .trailing_chunks = {}});
    ASSERT_FALSE(glb);
    EXPECT_NE(glb.error().message.find("4 GiB"), std::string::npos);
}

}  // namespace
}  // namespace patina::io
