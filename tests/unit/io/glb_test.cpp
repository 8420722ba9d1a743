// SPDX-License-Identifier: MIT
#include "io/glb.h"

#include <gtest/gtest.h>

#include "sample_gltf.h"

namespace patina::io {
namespace {

using test::append_word;

TEST(Glb, IsTakenIntoItsChunks) {
    SourceAsset asset;
    asset.file = test::make_glb("{\"a\":1}", Bytes(5, std::byte{7}));
    const std::size_t known = asset.file.size();
    append_word(asset.file, 4);
    append_word(asset.file, 0x12345678);
    append_word(asset.file, 42);
    const auto length = static_cast<std::uint32_t>(asset.file.size());
    std::memcpy(asset.file.data() + 8, &length, 4);
    const auto split = split_container(asset);
    ASSERT_TRUE(split.has_value()) << split.error().message;
    EXPECT_EQ(asset.container, Container::Glb);
    EXPECT_EQ(asset.json_text, "{\"a\":1}");
    EXPECT_EQ(asset.binary_chunk.size(), 8u);
    EXPECT_EQ(asset.trailing_chunks,
              Bytes(asset.file.begin() + static_cast<std::ptrdiff_t>(known), asset.file.end()));
}

TEST(Glb, WithAWordChangedIsRefusedOrSplitInsideTheFile) {
    const Bytes valid = test::make_glb("{}  ", Bytes(8, std::byte{7}));
    for (std::size_t word = 0; word < valid.size() / 4; ++word) {
        for (const std::uint32_t value : {0u, 1u, 0x7FFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFF8u}) {
            SourceAsset asset;
            asset.file = valid;
            std::memcpy(asset.file.data() + 4 * word, &value, 4);
            if (!split_container(asset)) continue;
            EXPECT_LE(
                asset.json_text.size() + asset.binary_chunk.size() + asset.trailing_chunks.size(),
                asset.file.size());
        }
    }
}

TEST(Glb, OfAnotherVersionOrLengthOrOrderIsRefused) {
    const Bytes valid = test::make_glb("{}", Bytes(8, std::byte{7}));
    const auto with_word = [&](std::size_t offset, std::uint32_t value) {
        SourceAsset asset;
        asset.file = valid;
        std::memcpy(asset.file.data() + offset, &value, 4);
        return split_container(asset).has_value();
    };
    EXPECT_TRUE(with_word(4, 2));
    EXPECT_FALSE(with_word(4, 1));
    EXPECT_FALSE(with_word(8, static_cast<std::uint32_t>(valid.size() + 1)));
    EXPECT_FALSE(with_word(8, static_cast<std::uint32_t>(valid.size() - 1)));
    EXPECT_FALSE(with_word(12, 0xFFFFFFFF));
    EXPECT_FALSE(with_word(16, 0x004E4942));
}

}  // namespace
}  // namespace patina::io
