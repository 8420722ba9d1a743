// SPDX-License-Identifier: MIT
#include "document/encoded_image.h"

#include <gtest/gtest.h>

namespace patina {
namespace {

std::shared_ptr<const Bytes> some_bytes(std::size_t count) {
    return std::make_shared<const Bytes>(count);
}

TEST(EncodedImage, IsMadeWhenItIsFirstAskedForAndNeverAgain) {
    int made = 0;
    const auto image = EncodedImage::when_asked([&made] {
        ++made;
        return some_bytes(7);
    });
    const EncodedImage copy = image;
    EXPECT_TRUE(copy);
    EXPECT_EQ(made, 0);
    const auto bytes = copy.bytes();
    ASSERT_TRUE(bytes);
    EXPECT_EQ(bytes->size(), 7u);
    EXPECT_EQ(image.bytes(), bytes) << "copies share the bytes";
    EXPECT_EQ(made, 1);
}

TEST(EncodedImage, LetsGoOfWhatItIsMadeOfAndCostsItsBytesFromThenOn) {
    const auto held = some_bytes(100);
    const auto image = EncodedImage::when_asked([held] { return some_bytes(held->size() / 10); });
    EXPECT_EQ(image.bytes_in_memory(), 0u);
    EXPECT_GT(held.use_count(), 1);
    (void)image.bytes();
    EXPECT_EQ(image.bytes_in_memory(), 10u);
    EXPECT_EQ(held.use_count(), 1);
}

TEST(EncodedImage, IsNullWhereThereIsNoneOrItCannotBeMade) {
    EXPECT_FALSE(EncodedImage());
    EXPECT_EQ(EncodedImage().bytes(), nullptr);
    EXPECT_FALSE(EncodedImage(nullptr));
    EXPECT_EQ(EncodedImage::when_asked([] { return nullptr; }).bytes(), nullptr);
}

}  // namespace
}  // namespace patina
