// SPDX-License-Identifier: MIT
// Files made to do harm: none may crash, hang, reach out of its folder or answer with more than one
// line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "io/load.h"
#include "io/sample_gltf.h"
#include "io/temporary_folder.h"
#include "quiet_load.h"

namespace patina::io {
namespace {

using test::expect_one_clean_line;
using test::Json;
using test::kSecret;
using testing::HasSubstr;

/// A model in a folder beside which a secret lies, reached in every way that files have tried.
class HostileUri : public testing::Test {
  protected:
    HostileUri() {
        std::filesystem::create_directories(model_folder() / "sub");
        EXPECT_TRUE(write_file_atomically(folder_.path() / "secret.bin", kSecret));
        EXPECT_TRUE(write_file_atomically(folder_.path() / "secret.png", kSecret));
        std::filesystem::create_symlink(folder_.path() / "secret.bin", model_folder() / "link.bin");
        std::filesystem::create_directory_symlink(folder_.path(), model_folder() / "linked");
        ::mkfifo((model_folder() / "fifo").c_str(), 0600);
    }

    std::filesystem::path model_folder() const { return folder_.path() / "model"; }

    Result<LoadedDocument> load_with(const char* array, const std::string& uri) {
        auto sample = test::sample_gltf();
        sample.json[array][0].erase("bufferView");
        sample.json[array][0]["uri"] = uri;
        if (std::string(array) == "images") {
            sample.json["buffers"][0]["uri"] = "model.bin";
            EXPECT_TRUE(write_file_atomically(model_folder() / "model.bin", sample.binary));
        }
        EXPECT_TRUE(write_file_atomically(model_folder() / "model.gltf", sample.json.dump()));
        return load_document(model_folder() / "model.gltf");
    }

    TemporaryFolder folder_;
};

TEST_F(HostileUri, NeverReachesOutOfTheModelsFolder) {
    const std::string absolute = (folder_.path() / "secret.bin").string();
    for (const std::string& uri : {absolute,
                                   "file://" + absolute,
                                   std::string("../secret.bin"),
                                   std::string("..%2fsecret.bin"),
                                   std::string("%2e%2e/secret.bin"),
                                   std::string("sub/../../secret.bin"),
                                   std::string("sub%2f..%2f..%2fsecret.bin"),
                                   std::string("..\\secret.bin"),
                                   std::string("link.bin"),
                                   std::string("linked/secret.bin"),
                                   std::string("fifo"),
                                   std::string("sub"),
                                   std::string("."),
                                   std::string("/dev/zero"),
                                   std::string("/dev/stdin"),
                                   std::string("http://localhost/secret.bin"),
                                   std::string("~/secret.bin"),
                                   std::string("$HOME/secret.bin"),
                                   std::string("`id`"),
                                   std::string("secret.bin\n../x"),
                                   std::string("secret.bin%00.png"),
                                   std::string("\x1b[31mred")}) {
        for (const char* array : {"buffers", "images"}) {
            const auto loaded = load_with(array, uri);
            if (loaded) {
                // Only as an image that is simply not there.
                ASSERT_EQ(loaded->warnings.size(), 1u) << uri;
                EXPECT_THAT(loaded->warnings[0], HasSubstr("missing"));
                expect_one_clean_line(loaded->warnings[0]);
                EXPECT_EQ(loaded->document->images.begin()->second->encoded.bytes(), nullptr);
            } else {
                EXPECT_THAT(loaded.error().message, HasSubstr(array));
                expect_one_clean_line(loaded.error().message);
            }
        }
    }
}

TEST_F(HostileUri, MayLeadToAFileInAFolderBelow) {
    auto sample = test::sample_gltf();
    ASSERT_TRUE(write_file_atomically(model_folder() / "sub" / "my data.bin", sample.binary));
    const auto loaded = load_with("buffers", "sub/my%20data.bin");
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    EXPECT_EQ(loaded->document->source->external_files.count("sub/my%20data.bin"), 1u);
}

TEST_F(HostileUri, OfAFileLargerThanTheLimitIsRefusedBeforeItIsRead) {
    ASSERT_TRUE(write_file_atomically(model_folder() / "huge.bin", "x"));
    std::filesystem::resize_file(model_folder() / "huge.bin", std::uintmax_t{1} << 40);
    const auto loaded = load_with("buffers", "huge.bin");
    ASSERT_FALSE(loaded.has_value());
    EXPECT_THAT(loaded.error().message, HasSubstr("limit"));
}

/// A PNG whose header promises a size that its data does not have.
Bytes png_promising(std::uint32_t width, std::uint32_t height) {
    Bytes png = test::plain_png(4, 4, 0, 0, 0);
    for (int byte = 0; byte < 4; ++byte) {
        png[static_cast<std::size_t>(16 + byte)] = static_cast<std::byte>(width >> (24 - 8 * byte));
        png[static_cast<std::size_t>(20 + byte)] =
            static_cast<std::byte>(height >> (24 - 8 * byte));
    }
    // The header's CRC, or the decoder would stop before the size counts.
    std::uint32_t crc = 0xFFFFFFFF;
    for (std::size_t i = 12; i < 29; ++i) {
        crc ^= std::to_integer<std::uint32_t>(png[i]);
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (0xEDB88320u & (0u - (crc & 1u)));
    }
    crc = ~crc;
    for (std::size_t byte = 0; byte < 4; ++byte)
        png[29 + byte] = static_cast<std::byte>(crc >> (24 - 8 * byte));
    return png;
}

Result<LoadedDocument> load_with_images(const std::vector<Bytes>& pngs,
                                        const LoadLimits& limits = {}) {
    auto sample = test::sample_gltf();
    Json images = Json::array();
    Json textures = Json::array();
    Json materials = Json::array();
    for (const Bytes& png : pngs) {
        const std::size_t start = sample.binary.size();
        sample.binary.insert(sample.binary.end(), png.begin(), png.end());
        sample.json["bufferViews"].push_back(test::view(start, png.size()));
        images.push_back({{"bufferView", sample.json["bufferViews"].size() - 1}});
        textures.push_back({{"source", images.size() - 1}});
        materials.push_back({{"normalTexture", {{"index", textures.size() - 1}}}});
    }
    sample.json["buffers"][0]["byteLength"] = sample.binary.size();
    sample.json["images"] = images;
    sample.json["textures"] = textures;
    sample.json["materials"] = materials;
    return load_document_from_memory(sample.glb(), "model.glb", limits);
}

TEST(ImageBomb, WithASideBeyondTheLimitIsRefusedFromTheHeader) {
    for (const auto& [width, height] :
         {std::pair{16385u, 4u}, {4u, 100'000u}, {65'535u, 65'535u}}) {
        const auto loaded = load_with_images({png_promising(width, height)});
        ASSERT_FALSE(loaded.has_value());
        EXPECT_THAT(loaded.error().message, HasSubstr("/images/0"));
        expect_one_clean_line(loaded.error().message);
    }
}

TEST(ImageBomb, OfManyImagesThatTogetherAreTooLargeIsRefusedFromTheHeaders) {
    std::vector<Bytes> pngs;
    for (std::uint32_t i = 0; i < 64; ++i) pngs.push_back(png_promising(8192, 8191 - i));
    const auto loaded = load_with_images(pngs);
    ASSERT_FALSE(loaded.has_value());
    EXPECT_THAT(loaded.error().message, HasSubstr("all images together"));
}

TEST(ImageBomb, ThatPromisesMoreThanItHoldsIsAPlaceholder) {
    const auto loaded = load_with_images({png_promising(64, 64), png_promising(0, 4)});
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    EXPECT_EQ(loaded->warnings.size(), 2u);
    for (const std::string& warning : loaded->warnings) expect_one_clean_line(warning);
}

TEST(HostileJson, NestedInExtrasIsRefused) {
    for (const int levels : {1'000, 100'000}) {
        std::string text = test::sample_gltf().json.dump();
        text.pop_back();
        text += ",\"extras\":";
        for (int i = 0; i < levels; ++i) text += "{\"a\":";
        text += '1';
        text.append(static_cast<std::size_t>(levels) + 1, '}');
        const auto loaded = load_document_from_memory(test::bytes_from(text), "model.gltf");
        ASSERT_FALSE(loaded.has_value());
        EXPECT_THAT(loaded.error().message, HasSubstr("64 levels"));
        expect_one_clean_line(loaded.error().message);
    }
}

TEST(HostileFile, ThatIsNoModelIsRefusedInOneLine) {
    for (const std::string text : {"", "x", "glTF", "{}", "[]", "null", "{\"asset\":{}}",
                                   "\xEF\xBB\xBF", "\x1b]0;owned\x07", "PK\x03\x04"}) {
        const auto loaded = load_document_from_memory(test::bytes_from(text), "a\x1b[2Jb.glb");
        ASSERT_FALSE(loaded.has_value());
        expect_one_clean_line(loaded.error().message);
    }
    EXPECT_FALSE(load_document("/").has_value());
    EXPECT_FALSE(load_document("/dev/zero").has_value());
    EXPECT_FALSE(load_document("/no/such/file.glb").has_value());
}

}  // namespace
}  // namespace patina::io
