// SPDX-License-Identifier: MIT
#include "render/environment_cache.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <fstream>

#include "core/files.h"

namespace patina::render {
namespace {

namespace fs = std::filesystem;

class EnvironmentCacheTest : public testing::Test {
  protected:
    EnvironmentCacheTest() {
        std::string pattern = (fs::temp_directory_path() / "patina-cache-XXXXXX").string();
        folder_ = ::mkdtemp(pattern.data());
        cache_.folder = folder_ / "patina" / "environments";
    }
    ~EnvironmentCacheTest() override { fs::remove_all(folder_); }

    static Image map(std::string_view id) { return *builtin_environment(id, 32); }
    void keep(const Image& of) const { ASSERT_TRUE(finished_environment(cache_, of)); }
    std::vector<fs::path> files() const {
        std::vector<fs::path> found;
        std::error_code error;
        for (const auto& entry : fs::directory_iterator(cache_.folder, error))
            found.push_back(entry.path());
        return found;
    }

    fs::path folder_;
    EnvironmentCache cache_;
};

void expect_equal(const FilteredEnvironment& a, const FilteredEnvironment& b) {
    EXPECT_EQ(a.source, b.source);
    EXPECT_EQ(a.quality, b.quality);
    EXPECT_EQ(a.map->texels, b.map->texels);
    EXPECT_EQ(a.map->width, b.map->width);
    EXPECT_EQ(a.specular.face_size, b.specular.face_size);
    EXPECT_EQ(a.specular.levels, b.specular.levels);
    EXPECT_EQ(a.diffuse.face_size, b.diffuse.face_size);
    EXPECT_EQ(a.diffuse.levels, b.diffuse.levels);
    ASSERT_EQ(a.suns.size(), b.suns.size());
    for (std::size_t i = 0; i < a.suns.size(); ++i) {
        EXPECT_EQ(a.suns[i].towards_map, b.suns[i].towards_map);
        EXPECT_EQ(a.suns[i].irradiance_linear, b.suns[i].irradiance_linear);
        EXPECT_EQ(a.suns[i].radius_radians, b.suns[i].radius_radians);
    }
    EXPECT_EQ(a.ambient_linear, b.ambient_linear);
    EXPECT_EQ(a.keys, b.keys);
}

/// A dark room with one lamp, which is taken out as a sun.
Image lamp() {
    Image image{.width = 128, .height = 64, .channels = 3, .type = SampleType::F32, .data = {}};
    std::vector<float> values(std::size_t{3} * 128 * 64, 0.1f);
    for (std::size_t c = 0; c < 3; ++c) values[3 * (20 * 128 + 40) + c] = 9000.0f;
    const auto bytes = std::as_bytes(std::span(values));
    image.data.assign(bytes.begin(), bytes.end());
    return image;
}

TEST_F(EnvironmentCacheTest, WhatIsKeptIsWhatFilteringGivesBitForBit) {
    for (const Image& each : {map("studio"), lamp()}) {
        EXPECT_FALSE(kept_environment(cache_, each));
        const auto filtered = filter_environment(each, FilterQuality::Finished);
        ASSERT_TRUE(filtered);
        keep(each);
        const auto kept = kept_environment(cache_, each);
        ASSERT_TRUE(kept);
        expect_equal(*kept, *filtered);
    }
    EXPECT_EQ(filter_environment(lamp(), FilterQuality::Finished)->suns.size(), 1u);
    EXPECT_EQ(files().size(), 2u);
}

TEST_F(EnvironmentCacheTest, TheFirstLightIsNotKept) {
    keep_environment(cache_, *filter_environment(map("studio"), FilterQuality::First));
    EXPECT_TRUE(files().empty());
}

TEST_F(EnvironmentCacheTest, ADamagedFileIsAsIfItWereNotThereAndIsWrittenAnew) {
    const Image studio = map("studio");
    keep(studio);
    ASSERT_EQ(files().size(), 1u);
    const fs::path file = files().front();
    const Bytes whole = *read_file(file);
    const auto expect_refused = [&](const Bytes& damaged, const std::string& how) {
        std::ofstream(file, std::ios::binary)
            .write(reinterpret_cast<const char*>(damaged.data()),
                   static_cast<std::streamsize>(damaged.size()));
        EXPECT_FALSE(kept_environment(cache_, studio)) << how;
    };
    for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{47}, std::size_t{48},
                                   std::size_t{60}, whole.size() / 2, whole.size() - 1})
        expect_refused(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)),
                       "cut to " + std::to_string(size));
    for (std::size_t at = 0; at < whole.size(); at += at < 80 ? 1 : whole.size() / 7) {
        Bytes damaged = whole;
        damaged[at] ^= std::byte{0x10};
        expect_refused(damaged, "damaged at " + std::to_string(at));
    }
    Bytes longer = whole;
    longer.push_back(std::byte{0});
    expect_refused(longer, "one byte too long");
    keep(studio);
    EXPECT_EQ(*read_file(file), whole);
}

TEST_F(EnvironmentCacheTest, BeyondTheBudgetWhatWasNotReadForLongestGoes) {
    const Image first = map("studio");
    const Image second = map("sky");
    const Image third = map("white");
    keep(first);
    const std::uint64_t one = fs::file_size(files().front());
    keep(second);
    const auto an_hour_ago = fs::file_time_type::clock::now() - std::chrono::hours(1);
    for (const fs::path& file : files()) fs::last_write_time(file, an_hour_ago);
    ASSERT_TRUE(kept_environment(cache_, first));  // read just now
    cache_.budget_bytes = 2 * one + 4096;
    keep(third);
    EXPECT_TRUE(kept_environment(cache_, first));
    EXPECT_FALSE(kept_environment(cache_, second));
    EXPECT_TRUE(kept_environment(cache_, third));
}

TEST_F(EnvironmentCacheTest, WithoutAFolderThatCanBeWrittenTheLightIsTheSame) {
    const Image studio = map("studio");
    const auto filtered = filter_environment(studio, FilterQuality::Finished);
    std::ofstream(folder_ / "file") << "in the way";
    for (const fs::path& folder : {fs::path(), folder_ / "file" / "below"}) {
        cache_.folder = folder;
        const auto light = finished_environment(cache_, studio);
        ASSERT_TRUE(light);
        expect_equal(*light, *filtered);
        EXPECT_FALSE(kept_environment(cache_, studio));
    }
}

}  // namespace
}  // namespace patina::render
