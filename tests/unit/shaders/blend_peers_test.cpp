// SPDX-License-Identifier: MIT
// The blend modes beside those of another program that has them: ImageMagick's -compose.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <vector>

#include "io/temporary_folder.h"
#include "shaders/published_modes.h"

namespace patina {
namespace {

constexpr int kRampSide = 256;

/// A 16-bit grey PGM whose value grows along x, or along y.
void write_ramp(const std::filesystem::path& path, bool along_x) {
    std::ofstream file(path, std::ios::binary);
    file << "P5\n" << kRampSide << ' ' << kRampSide << "\n65535\n";
    for (int y = 0; y < kRampSide; ++y)
        for (int x = 0; x < kRampSide; ++x) {
            const int value = (along_x ? x : y) * 257;
            file.put(static_cast<char>(value >> 8)).put(static_cast<char>(value & 255));
        }
}

std::vector<double> read_pgm(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::string magic;
    int width = 0, height = 0, most = 0;
    file >> magic >> width >> height >> most;
    file.get();
    std::vector<double> values;
    for (int i = 0; i < width * height; ++i) {
        const int high = most > 255 ? file.get() : 0;
        values.push_back(static_cast<double>(high * 256 + file.get()) / most);
    }
    return file ? values : std::vector<double>();
}

struct Peer {
    BlendMode mode;
    const char* compose;
};
/// Where both mean the same. Its vivid light and modes of hue follow other definitions.
const std::vector<Peer>& peers() {
    using enum BlendMode;
    static const std::vector<Peer> list = {
        {Darken, "Darken"},           {Multiply, "Multiply"},
        {ColorBurn, "ColorBurn"},     {LinearBurn, "LinearBurn"},
        {Lighten, "Lighten"},         {Screen, "Screen"},
        {ColorDodge, "ColorDodge"},   {Add, "Plus"},
        {Overlay, "Overlay"},         {SoftLightW3c, "SoftLight"},
        {HardLight, "HardLight"},     {SoftLightPegtop, "PegtopLight"},
        {LinearLight, "LinearLight"}, {PinLight, "PinLight"},
        {Difference, "Difference"},   {Exclusion, "Exclusion"},
        {Subtract, "MinusSrc"},       {InverseSubtract, "MinusDst"},
        {Divide, "DivideSrc"},        {InverseDivide, "DivideDst"},
    };
    return list;
}

TEST(BlendPeers, ImageMagickComposesTheSameWhereItHasTheMode) {
    if (std::system("command -v convert > /dev/null 2>&1") != 0)
        GTEST_SKIP() << "ImageMagick is not installed";
    const io::TemporaryFolder folder;
    write_ramp(folder.path() / "backdrop.pgm", true);
    write_ramp(folder.path() / "source.pgm", false);
    const std::filesystem::path result = folder.path() / "result.pgm";
    for (const Peer& peer : peers()) {
        const std::string command = "cd '" + folder.path().string() +
                                    "' && convert backdrop.pgm source.pgm -compose " +
                                    peer.compose + " -composite -depth 16 result.pgm";
        ASSERT_EQ(std::system(command.c_str()), 0) << peer.compose;
        const std::vector<double> composed = read_pgm(result);
        ASSERT_EQ(composed.size(), std::size_t{kRampSide} * kRampSide) << peer.compose;
        double worst = 0;
        // Division by 0 is a matter of taste: the borders are left out.
        for (int y = 1; y < kRampSide - 1; ++y)
            for (int x = 1; x < kRampSide - 1; ++x) {
                const double expected =
                    test_support::published_blend(peer.mode, x / 255.0, y / 255.0);
                worst = std::max(
                    worst,
                    std::abs(composed[static_cast<std::size_t>(y * kRampSide + x)] - expected));
            }
        EXPECT_LE(worst, 2.0 / 65535) << info(peer.mode).id << " and " << peer.compose;
    }
}

}  // namespace
}  // namespace patina
