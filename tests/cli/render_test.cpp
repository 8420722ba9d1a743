// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <fstream>

#include "cli/picture.h"
#include "cli/program.h"

namespace patina::cli_tests {
namespace {

using testing::HasSubstr;

class Render : public ProgramTest {
  protected:
    /// Renders the sample, small and quickly unless it is asked for otherwise.
    Outcome render(std::vector<std::string> more, const std::string& output) const {
        const auto add_unless_given = [&](const char* option, const char* value) {
            if (std::find(more.begin(), more.end(), option) == more.end())
                more.insert(more.end(), {option, value});
        };
        add_unless_given("--size", "64x48");
        add_unless_given("--samples", "1");
        std::vector<std::string> arguments = {"render", input_, "-o", at(output)};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return patina(arguments);
    }

    std::string input_ = sample();
};

/// Width and height of a PNG, from its header.
std::pair<int, int> png_size(const std::string& png) {
    if (!png.starts_with("\x89PNG")) return {};
    const auto number = [&](std::size_t at) {
        int value = 0;
        for (std::size_t i = at; i < at + 4; ++i)
            value = value * 256 + static_cast<unsigned char>(png[i]);
        return value;
    };
    return {number(16), number(20)};
}

TEST_F(Render, WritesAPictureOfTheSizeThatWasAskedFor) {
    ASSERT_TRUE(succeeded(render({}, "picture.png")));
    EXPECT_EQ(png_size(file_text(at("picture.png"))), std::pair(64, 48));
}

TEST_F(Render, WritesLinearLightAsExr) {
    ASSERT_TRUE(succeeded(render({}, "picture.exr")));
    EXPECT_TRUE(file_text(at("picture.exr")).starts_with("\x76\x2f\x31\x01"));
}

TEST_F(Render, LinearLightHasABackgroundOnlyWhereOneIsAskedFor) {
    const auto drawn = [&](const std::vector<std::string>& words) {
        EXPECT_TRUE(succeeded(render(words, "a.exr"))) << testing::PrintToString(words);
        return file_text(at("a.exr"));
    };
    const std::string plain = drawn({});
    EXPECT_TRUE(plain == drawn({"--background", "none"}));
    for (const std::string background : {"studio", "environment", "#ff8000"})
        EXPECT_FALSE(plain == drawn({"--background", background})) << background;
}

TEST_F(Render, TheStripIsTenPicturesWideAndAllChannelsStandInASquare) {
    ASSERT_TRUE(succeeded(render({"--channel", "strip"}, "strip.png")));
    EXPECT_EQ(png_size(file_text(at("strip.png"))), std::pair(640, 48));
    const Outcome all = render({"--channel", "all", "--json"}, "all.png");
    ASSERT_TRUE(succeeded(all));
    EXPECT_EQ(png_size(file_text(at("all.png"))), std::pair(5 * 64, 5 * 48));
    const nlohmann::json cells = nlohmann::json::parse(all.out)["cells"];
    ASSERT_EQ(cells.size(), 25u);
    EXPECT_EQ(cells[6]["channel"], "position");
    EXPECT_EQ(cells[6]["x"], 64);
    EXPECT_EQ(cells[6]["y"], 48);
}

TEST_F(Render, SeveralChannelsAreThePicturesOfEachWithItsNameOverThem) {
    const std::vector<std::string> more = {"--split", "0.5", "--samples", "4", "--bits", "16"};
    const auto with = [&](std::vector<std::string> words) {
        words.insert(words.end(), more.begin(), more.end());
        return words;
    };
    const auto drawn = [&](const std::vector<std::string>& words) {
        EXPECT_TRUE(succeeded(render(with(words), "a.png"))) << testing::PrintToString(words);
        return png_picture(at("a.png")).rgba;
    };
    const std::vector<std::string> sheet = {"--channel", "final,normal", "--columns", "1"};
    std::vector<std::string> bare = sheet;
    bare.emplace_back("--no-labels");
    std::string one_by_one = drawn({"--channel", "final"});
    one_by_one += drawn({"--channel", "normal"});
    EXPECT_TRUE(drawn(bare) == one_by_one) << "the same samples, bits and light";
    EXPECT_FALSE(drawn(sheet) == one_by_one) << "names";
}

TEST_F(Render, WhatSeveralChannelsCannotBeIsWrongUsageInOneLine) {
    const auto refused = [&](std::vector<std::string> words, const std::string& output) {
        words.insert(words.end(), {"--channel", "strip"});
        const Outcome outcome = render(words, output);
        EXPECT_EQ(outcome.status, 2) << testing::PrintToString(words);
        EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1);
        return outcome.errors;
    };
    EXPECT_THAT(refused({"--turntable", "3"}, "a.png"), HasSubstr("--turntable takes one channel"));
    EXPECT_THAT(refused({}, "a.exr"), HasSubstr(".exr holds the raw numbers of one channel"));
    EXPECT_THAT(refused({"--shading", "difference"}, "a.png"), HasSubstr("can be --split"));
    EXPECT_EQ(render({"--columns", "2"}, "a.png").status, 2);
    EXPECT_EQ(render({"--channel", "final,gloss"}, "a.png").status, 2);
    const Outcome wide = render({"--channel", "strip", "--size", "2000x20"}, "a.png");
    EXPECT_TRUE(failed_with_one_line(wide));
    EXPECT_THAT(wide.errors, HasSubstr("20000x20"));
}

TEST_F(Render, EveryShadingAndChannelGivesAPictureOfItsOwn) {
    std::map<std::string, std::string> pictures;
    for (const std::string shading : {"pbr", "phong", "blinn-phong", "split", "difference"}) {
        ASSERT_TRUE(succeeded(render({"--shading", shading}, "a.png"))) << shading;
        pictures[file_text(at("a.png"))] += shading + " ";
    }
    for (const std::string channel : {"base-color", "normal", "position", "depth", "uv", "f0"}) {
        ASSERT_TRUE(succeeded(render({"--channel", channel}, "a.png"))) << channel;
        pictures[file_text(at("a.png"))] += channel + " ";
    }
    EXPECT_EQ(pictures.size(), 11u);
}

TEST_F(Render, TheCameraExposureAndBackgroundChangeThePicture) {
    ASSERT_TRUE(succeeded(render({}, "plain.png")));
    const std::string plain = file_text(at("plain.png"));
    for (const std::vector<std::string>& change : std::vector<std::vector<std::string>>{
             {"--camera-position", "0,1,4", "--camera-target", "0,0.5,0", "--fov-y", "40"},
             {"--view", "back"},
             {"--wires"},
             {"--camera-target", "0.5,0.5,0"},
             {"--camera-up", "1,1,0"},
             {"--exposure", "2"},
             {"--tone-map", "none"},
             {"--background", "#ff8000"},
             {"--background", "none"},
             {"--no-ground-shadow"},
             {"--environment", "sky"},
             {"--environment-rotation", "90"},
             {"--orthographic", "3"},
             {"--light", R"({"kind":"sphere","position":[1,2,2],"intensity":9,"radius":0.4})"},
             {"--light", R"({"kind":"rectangle","position":[0,1,3],"intensity":9})"},
             {"--preset", "brushed-brass@Ball"}}) {
        ASSERT_TRUE(succeeded(render(change, "changed.png"))) << change[0];
        EXPECT_TRUE(file_text(at("changed.png")) != plain) << testing::PrintToString(change);
    }
}

TEST_F(Render, ACameraOfTheFileIsThatCameraPlacedByHand) {
    input_ = triangle_with_cameras();
    const auto drawn = [&](std::vector<std::string> words) {
        words.insert(words.end(), {"--channel", "position"});
        EXPECT_TRUE(succeeded(render(words, "a.png"))) << testing::PrintToString(words);
        return png_picture(at("a.png")).rgba;
    };
    const std::string close = drawn({"--camera", "Close"});
    EXPECT_TRUE(close == drawn({"--camera", "0"}));
    EXPECT_TRUE(close ==
                drawn({"--camera-position", "0,0,3", "--camera-target", "0,0,0", "--fov-y", "45"}));
    EXPECT_FALSE(close == drawn({"--camera", "Close", "--fov-y", "20"}));
    EXPECT_FALSE(close == drawn({"--camera", "Side"}));
}

TEST_F(Render, ATurntableLeansAllTheWayAround) {
    input_ = triangle_with_cameras();
    ASSERT_TRUE(succeeded(render({"--turntable", "2", "--view", "front", "--camera-up", "1,0,0",
                                  "--channel", "geometric-normal"},
                                 "spin.png")));
    // The tip points to the left from in front and from behind; the base stands at the right.
    for (const std::string file : {"spin-000.png", "spin-001.png"}) {
        const Picture picture = png_picture(at(file));
        EXPECT_NE(picture.texel(48, 9), picture.texel(0, 0)) << file;
        EXPECT_EQ(picture.texel(16, 9), picture.texel(0, 0)) << file;
    }
}

TEST_F(Render, ACameraThatTheFileHasNotIsOneLineThatNamesThoseThatItHas) {
    input_ = triangle_with_cameras();
    const Outcome unknown = render({"--camera", "2"}, "a.png");
    EXPECT_TRUE(failed_with_one_line(unknown));
    EXPECT_THAT(unknown.errors, HasSubstr("0 'Close', 1 'Side'"));
    EXPECT_EQ(render({"--camera", "Side", "--view", "top"}, "a.png").status, 2);
    EXPECT_EQ(render({"--camera", "Side", "--camera-position", "1,1,1"}, "a.png").status, 2);
    input_ = sample();
    EXPECT_THAT(render({"--camera", "Side"}, "a.png").errors, HasSubstr("has no cameras"));
}

TEST_F(Render, ASplitIsTheShadingOfThatNameAndAMaterialPresetIsAPreset) {
    const auto picture = [&](const std::vector<std::string>& words) {
        EXPECT_TRUE(succeeded(render(words, "a.png"))) << testing::PrintToString(words);
        return file_text(at("a.png"));
    };
    EXPECT_TRUE(picture({"--split", "0.3"}) == picture({"--shading", "split", "--divider", "0.3"}));
    EXPECT_TRUE(picture({"--material-preset", "brushed-brass@Ball"}) ==
                picture({"--preset", "brushed-brass@Ball"}));
    EXPECT_EQ(render({"--split", "1.5"}, "a.png").status, 2);
}

TEST_F(Render, BothSidesOfASplitAreChosenApart) {
    const auto drawn = [&](const std::vector<std::string>& words) {
        EXPECT_TRUE(succeeded(render(words, "a.png"))) << testing::PrintToString(words);
        return png_picture(at("a.png")).rgba;
    };
    // A divider at an edge leaves one side alone.
    EXPECT_TRUE(drawn({"--split", "1", "--left", "blinn-phong"}) ==
                drawn({"--shading", "blinn-phong"}));
    EXPECT_TRUE(drawn({"--split", "0", "--against-terms", "lecture", "--terms", "gltf"}) ==
                drawn({"--terms", "lecture"}));
    EXPECT_TRUE(drawn({"--split", "1", "--against-terms", "gltf", "--terms", "lecture"}) ==
                drawn({"--terms", "lecture"}));
    EXPECT_TRUE(drawn({"--split", "0", "--against-terms", "gltf", "--geometry", "lecture"}) ==
                drawn({}))
        << "a set of its own stays as it is";
}

TEST_F(Render, WhatIsOfASideThatIsNotThereIsWrongUsageInOneLine) {
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"--against", "pbr"},
             {"--shading", "phong", "--against-path", "forward"},
             {"--against-terms", "lecture"},
             {"--left", "phong"},
             {"--divider", "0.3"},
             {"--split", "0.3", "--divider", "0.4"},
             {"--split", "0.3", "--shading", "phong"},
             {"--split", "0.3", "--against", "phong", "--against-terms", "lecture"}}) {
        const Outcome outcome = render(words, "a.png");
        EXPECT_EQ(outcome.status, 2) << testing::PrintToString(words);
        EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1);
    }
}

TEST_F(Render, EachTermChangesTheLightOfALamp) {
    const std::string lamp = R"({"kind":"point","position":[1,2,2],"intensity":30})";
    ASSERT_TRUE(succeeded(render({"--light", lamp}, "plain.png")));
    const std::string plain = file_text(at("plain.png"));
    for (const std::vector<std::string>& term :
         std::vector<std::vector<std::string>>{{"--distribution", "beckmann"},
                                               {"--geometry", "lecture"},
                                               {"--diffuse", "oren-nayar"}}) {
        std::vector<std::string> words = {"--light", lamp};
        words.insert(words.end(), term.begin(), term.end());
        ASSERT_TRUE(succeeded(render(words, "changed.png"))) << term[0];
        EXPECT_TRUE(file_text(at("changed.png")) != plain) << term[0];
    }
}

TEST_F(Render, EachOverrideOfPhongChangesItsPictureAndLeavesPbrAsItIs) {
    const std::string lamp = R"({"kind":"point","position":[1,2,2],"intensity":30})";
    const auto picture = [&](std::vector<std::string> words) {
        words.insert(words.end(), {"--light", lamp});
        EXPECT_TRUE(succeeded(render(words, "a.png"))) << testing::PrintToString(words);
        return file_text(at("a.png"));
    };
    const std::string plain = picture({"--shading", "phong"});
    for (const std::vector<std::string>& change :
         std::vector<std::vector<std::string>>{{"--phong-exponent", "3"},
                                               {"--phong-specular", "#ff0000"},
                                               {"--phong-strength", "0"},
                                               {"--phong-ambient", "#4060ff"}}) {
        std::vector<std::string> words = change;
        words.insert(words.end(), {"--shading", "phong"});
        EXPECT_TRUE(picture(words) != plain) << change[0];
        EXPECT_TRUE(picture(change) == picture({})) << change[0];
    }
}

TEST_F(Render, APhongExponentBeyondItsRangeAndAColourThatIsNoneAreWrongUsage) {
    EXPECT_EQ(render({"--phong-exponent", "0.5"}, "a.png").status, 2);
    const Outcome outcome = render({"--phong-specular", "red"}, "a.png");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.errors, HasSubstr("'red' is no colour"));
}

TEST_F(Render, BothPathsGiveThePictureAtTheirOwnCost) {
    const Outcome deferred = render({"--json"}, "deferred.png");
    const Outcome forward = render({"--path", "forward", "--json"}, "forward.png");
    ASSERT_TRUE(succeeded(deferred));
    ASSERT_TRUE(succeeded(forward));
    EXPECT_GT(nlohmann::json::parse(deferred.out)["left"]["gbuffer_bytes"], 0);
    EXPECT_EQ(nlohmann::json::parse(forward.out)["left"]["gbuffer_bytes"], 0);
    // A difference of the paths is black: nothing but the lowest colour of the heat map.
    ASSERT_TRUE(succeeded(render({"--shading", "difference", "--against", "pbr"}, "none.png")));
    ASSERT_TRUE(succeeded(render(
        {"--shading", "difference", "--against", "pbr", "--against-path", "forward", "--json"},
        "paths.png")));
    EXPECT_LE(file_text(at("paths.png")).size(), file_text(at("none.png")).size() + 300);
}

TEST_F(Render, ADifferenceHasItsRangeAndItsScale) {
    const auto picture = [&](std::vector<std::string> words) {
        words.insert(words.end(), {"--shading", "difference", "--size", "240x180"});
        EXPECT_TRUE(succeeded(render(words, "a.png"))) << testing::PrintToString(words);
        return png_picture(at("a.png"));
    };
    const Picture scaled = picture({"--difference-range", "0.1"});
    const Picture bare = picture({"--difference-range", "0.1", "--no-labels"});
    EXPECT_FALSE(bare.rgba == picture({"--no-labels"}).rgba) << "hotter";
    EXPECT_EQ(scaled.texel(235, 5), bare.texel(235, 5));
    EXPECT_NE(scaled.texel(10, 160), bare.texel(10, 160)) << "the plate of the scale";
    const Outcome report = render({"--shading", "difference", "--json"}, "a.png");
    EXPECT_EQ(nlohmann::json::parse(report.out)["difference_range"], 1.0);
}

TEST_F(Render, ADifferenceOfWhatBothSidesShareIsWrongUsage) {
    const Outcome outcome = render({"--shading", "difference", "--channel", "roughness"}, "a.png");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.errors, HasSubstr("nothing anywhere"));
    EXPECT_TRUE(
        succeeded(render({"--shading", "difference", "--channel", "specular-ambient"}, "a.png")));
    EXPECT_EQ(render({"--difference-range", "2"}, "a.png").status, 2);
}

TEST_F(Render, WiresLieOverThePictureAndLeaveTheRestOfIt) {
    input_ = triangle_with_cameras();
    const auto drawn = [&](std::vector<std::string> words) {
        words.insert(words.end(), {"--view", "front", "--background", "#102030"});
        EXPECT_TRUE(succeeded(render(words, "a.png"))) << testing::PrintToString(words);
        return png_picture(at("a.png"));
    };
    const Picture plain = drawn({});
    const Picture wired = drawn({"--wires"});
    EXPECT_EQ(wired.texel(32, 30), plain.texel(32, 30)) << "inside of the triangle";
    EXPECT_EQ(wired.texel(4, 4), plain.texel(4, 4)) << "beside it";
    int changed = 0;
    for (int x = 0; x < 64; ++x) changed += wired.texel(x, 30) == plain.texel(x, 30) ? 0 : 1;
    EXPECT_GE(changed, 2) << "both edges that the row crosses";
    EXPECT_LE(changed, 6);
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{"--wires"}, {"--bits", "16"}})
        EXPECT_EQ(render(words, "a.exr").status, 2);
}

TEST_F(Render, ATurntableIsAFileForEachPictureAndTheFirstIsThePictureAlone) {
    ASSERT_TRUE(succeeded(render({}, "alone.png")));
    ASSERT_TRUE(succeeded(render({"--turntable", "3"}, "spin.png")));
    EXPECT_EQ(file_text(at("spin-000.png")), file_text(at("alone.png")));
    EXPECT_EQ(png_size(file_text(at("spin-001.png"))), std::pair(64, 48));
    EXPECT_NE(file_text(at("spin-001.png")), file_text(at("spin-002.png")));
    EXPECT_EQ(file_text(at("spin.png")), "");
}

TEST_F(Render, APngHasAsManyBitsAsWereAskedFor) {
    constexpr std::size_t kBitDepth = 24;  // of IHDR
    ASSERT_TRUE(succeeded(render({}, "8.png")));
    ASSERT_TRUE(succeeded(render({"--bits", "16"}, "16.png")));
    EXPECT_EQ(file_text(at("8.png"))[kBitDepth], 8);
    EXPECT_EQ(file_text(at("16.png"))[kBitDepth], 16);
}

TEST_F(Render, ALampThatIsNoneIsOneLine) {
    const Outcome outcome = render({"--light", R"({"kind":"candle"})"}, "picture.png");
    EXPECT_EQ(outcome.status, 2) << "wrong usage";
    EXPECT_THAT(outcome.errors, HasSubstr("/kind is none of"));
    const Outcome degrees = render({"--light", R"({"kind":"spot","outer-cone":40})"}, "a.png");
    EXPECT_EQ(degrees.status, 2);
    EXPECT_THAT(degrees.errors, HasSubstr("Outer cone must be 0 to 1.5707964 radians, got 40"));
}

TEST_F(Render, GivesTheSamePictureTwiceAndAtAnyNumberOfThreads) {
    ASSERT_TRUE(succeeded(render({"--threads", "1"}, "1.png")));
    ASSERT_TRUE(succeeded(render({"--threads", "3"}, "3.png")));
    EXPECT_EQ(file_text(at("1.png")), file_text(at("3.png")));
}

TEST_F(Render, ReportsItsCostsAsJson) {
    const Outcome outcome = render({"--json"}, "picture.png");
    ASSERT_TRUE(succeeded(outcome));
    const nlohmann::json report = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(report["width"], 64);
    EXPECT_GT(report["triangles"], 10000);
    EXPECT_GT(report["left"]["gbuffer_bytes"], 64 * 48 * 4);
}

TEST_F(Render, TheSunOfTheSkyIsMovedAndNoOther) {
    ASSERT_TRUE(succeeded(render({"--environment", "sky"}, "noon.png")));
    ASSERT_TRUE(succeeded(render({"--environment", "sky", "--sun-elevation", "6"}, "evening.png")));
    EXPECT_TRUE(file_text(at("noon.png")) != file_text(at("evening.png")));
    const Outcome outcome = render({"--sun-elevation", "6"}, "picture.png");
    EXPECT_TRUE(failed_with_one_line(outcome));
    EXPECT_THAT(outcome.errors, HasSubstr("--environment sky"));
    EXPECT_EQ(render({"--environment", "sky", "--sun-elevation", "91"}, "a.png").status, 2);
}

TEST_F(Render, AnEnvironmentOfAnotherShapeIsTakenWithOneLineOfWarning) {
    ASSERT_TRUE(succeeded(render({"--size", "128x64"}, "twice-as-wide.png")));
    ASSERT_TRUE(succeeded(render({}, "photo.png")));
    const Outcome fits = render({"--environment", at("twice-as-wide.png")}, "picture.png");
    ASSERT_TRUE(succeeded(fits));
    EXPECT_THAT(fits.errors, testing::Not(HasSubstr("twice as wide as high")));
    const Outcome photo = render({"--environment", at("photo.png")}, "picture.png");
    ASSERT_TRUE(succeeded(photo));
    EXPECT_THAT(photo.errors, HasSubstr("photo.png is 64x48, not twice as wide as high"));
}

TEST_F(Render, AnEnvironmentThatIsNoImageIsOneLine) {
    std::ofstream(at("fake.hdr")) << "no picture";
    const Outcome outcome = render({"--environment", at("fake.hdr")}, "picture.png");
    EXPECT_TRUE(failed_with_one_line(outcome));
    EXPECT_THAT(outcome.errors, HasSubstr("fake.hdr"));
}

}  // namespace
}  // namespace patina::cli_tests
