// SPDX-License-Identifier: MIT
#include "quiet_load.h"

#include <gtest/gtest.h>

#include <chrono>

#include "io/load.h"

namespace patina::io::test {

void expect_one_clean_line(const std::string& message) {
    for (const char c : message) EXPECT_GE(static_cast<unsigned char>(c), 0x20) << message;
    EXPECT_LT(message.size(), 1000u);
    EXPECT_EQ(message.find(kSecret), std::string::npos);
}

bool load_quietly(Bytes file) {
    LoadLimits limits;
    limits.decoded_image_bytes = std::uint64_t{64} << 20;
    limits.geometry_bytes = std::uint64_t{64} << 20;
    const auto start = std::chrono::steady_clock::now();
    const auto loaded = load_document_from_memory(std::move(file), "model.glb", limits);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
    if (!loaded)
        expect_one_clean_line(loaded.error().message);
    else
        for (const std::string& warning : loaded->warnings) expect_one_clean_line(warning);
    return loaded.has_value();
}

}  // namespace patina::io::test
