// SPDX-License-Identifier: MIT
#include "io/json_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

namespace patina::io {
namespace {

using testing::HasSubstr;

std::string nested(int levels) {
    return std::string(static_cast<std::size_t>(levels), '[') +
           std::string(static_cast<std::size_t>(levels), ']');
}

std::string fault_of(const std::string& text, const JsonLimits& limits = {}) {
    const auto json = parse_json(text, limits);
    return json ? std::string() : json.error().message;
}

TEST(JsonCheck, GivesWhatTheTextSays) {
    const auto json = parse_json(R"({"a": [1, -2, 0.5, true, null, "x\n"], "b": {"c": {}}})");
    ASSERT_TRUE(json.has_value()) << json.error().message;
    EXPECT_EQ(json->dump(), R"({"a":[1,-2,0.5,true,null,"x\n"],"b":{"c":{}}})");
}

TEST(JsonCheck, RefusesAKeyThatOccursTwice) {
    EXPECT_THAT(fault_of(R"({"a": 1, "b": {"a": 2}, "a": 3})"), HasSubstr("\"a\" occurs twice"));
    EXPECT_EQ(fault_of(R"({"a": {"b": 1}, "c": {"b": 2}})"), "");
}

TEST(JsonCheck, RefusesWhatIsNestedTooDeepWithoutRecursion) {
    EXPECT_EQ(fault_of(nested(64)), "");
    EXPECT_THAT(fault_of(nested(65)), HasSubstr("64 levels"));
    EXPECT_THAT(fault_of(std::string(10'000'000, '[')), HasSubstr("64 levels"));
}

TEST(JsonCheck, RefusesBrokenUtf8AndBytesAfterTheValue) {
    for (const std::string text :
         {"{\"a\": \"\xff\"}", "{\"a\": \"\xc0\x80\"}", "{\"a\": \"\xed\xa0\x80\"}", "{} x", "{}{}",
          "{\"a\": \"\x01\"}", "{'a': 1}", "{\"a\": 1,}", "{\"a\": NaN}", "", " ", "[1, 2",
          "{\"a\"", "{\"a\": \"\\ud800\"}", "01", "+1", "/* c */ {}"})
        EXPECT_THAT(fault_of(text), HasSubstr("line ")) << text;
    EXPECT_THAT(fault_of("{\n  \"a\": oops\n}"), HasSubstr("line 2"));
}

TEST(JsonCheck, RefusesNumbersThatNoDoubleHolds) {
    EXPECT_THAT(fault_of("[1e999]"), HasSubstr("too large"));
    EXPECT_EQ(fault_of("[1e300, 1e-999]"), "");
}

TEST(JsonCheck, RefusesWhatWouldTakeTooMuchMemory) {
    std::string text = "[0";
    for (int i = 0; i < 100'000; ++i) text += ",0";
    text += "]";
    EXPECT_EQ(fault_of(text), "");
    EXPECT_THAT(fault_of(text, {.memory_bytes = 1 << 20}), HasSubstr("limit of 1 MiB"));
}

}  // namespace
}  // namespace patina::io
