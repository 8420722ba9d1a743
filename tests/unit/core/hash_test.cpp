// SPDX-License-Identifier: MIT
#include "core/hash.h"

#include <gtest/gtest.h>

namespace patina {
namespace {

TEST(Hash, HexadecimalTextRoundTripsAndOtherTextIsRefused) {
    const Hash128 hash = hash_text("patina");
    EXPECT_EQ(hash_from_hex(to_hex(hash)), hash);
    EXPECT_FALSE(hash_from_hex("xyz"));
    EXPECT_FALSE(hash_from_hex(std::string(32, 'G')));
}

TEST(Hash, TheSplitOfTextBetweenCallsMatters) {
    EXPECT_NE(Hasher().add("ab").add("c").finish(), Hasher().add("a").add("bc").finish());
    EXPECT_EQ(Hasher().add(0.0f).finish(), Hasher().add(-0.0f).finish());
}

}  // namespace
}  // namespace patina
