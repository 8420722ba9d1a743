// SPDX-License-Identifier: MIT
#include "core/free_memory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace patina {
namespace {

TEST(FreeMemory, IsEnoughForAKilobyteAndNotForAnExbibyte) {
    EXPECT_TRUE(check_free_memory(1024, "a page").has_value());
    const Status too_much = check_free_memory(std::uint64_t{1} << 60, "maps of 7 texels a side");
    ASSERT_FALSE(too_much.has_value());
    EXPECT_THAT(too_much.error().message, testing::HasSubstr("maps of 7 texels a side take"));
}

}  // namespace
}  // namespace patina
