// SPDX-License-Identifier: MIT
#include "io/json_splice.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>

namespace patina::io {
namespace {

using Generator = std::mt19937_64;

std::size_t draw_below(Generator& random, std::size_t limit) {
    return random() % limit;
}

std::string random_space(Generator& random) {
    static const std::vector<std::string> kSpaces = {"", "", "", " ", "\n  ", "\t", "\r\n"};
    return kSpaces[draw_below(random, kSpaces.size())];
}

std::string random_leaf(Generator& random) {
    static const std::vector<std::string> kLeaves = {
        "0",           "-0.0",     "1.50",         "1e3",   "123456789012",
        "true",        "false",    "null",         "\"\"",  "\"a\\u0041\\/\"",
        "\"} ] , :\"", "\"\\\"\"", "\"\xC3\xA9\"", "0.1000"};
    return kLeaves[draw_below(random, kLeaves.size())];
}

/// A text with white space anywhere and numbers and escapes that no library would print so.
std::string random_text(Generator& random, int depth) {
    const std::size_t kind = depth == 0 ? 0 : draw_below(random, 3);
    if (kind == 0) return random_leaf(random);
    const bool object = kind == 1;
    std::string text = object ? "{" : "[";
    const std::size_t count = draw_below(random, 5);
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0) text += random_space(random) + ",";
        text += random_space(random);
        if (object)
            text += fmt::format("\"k{}\"{}:{}", i, random_space(random), random_space(random));
        text += random_text(random, depth - 1);
    }
    return text + random_space(random) + (object ? "}" : "]");
}

Json random_value(Generator& random) {
    return Json::parse(random_text(random, 2));
}

/// Changes something somewhere: a value replaced, a member or element added or removed.
void mutate(Generator& random, Json& value) {
    const std::size_t action = draw_below(random, 5);
    if (value.is_object() && action == 0) {
        value[fmt::format("new{}", draw_below(random, 3))] = random_value(random);
    } else if (value.is_array() && action == 0) {
        value.push_back(random_value(random));
    } else if (value.is_object() && !value.empty() && action == 1) {
        const auto member =
            std::next(value.begin(), static_cast<std::ptrdiff_t>(draw_below(random, value.size())));
        value.erase(std::string(member.key()));
    } else if (value.is_array() && !value.empty() && action == 1) {
        value.erase(value.size() - 1);
    } else if (value.is_structured() && !value.empty()) {
        const auto child =
            std::next(value.begin(), static_cast<std::ptrdiff_t>(draw_below(random, value.size())));
        mutate(random, *child);
    } else {
        value = random_value(random);
    }
}

nlohmann::json meaning(std::string_view text) {
    return nlohmann::json::parse(text);
}

/// Every value that means the same before and after has the same bytes.
void expect_equal_parts_untouched(const JsonSpans& before, int a, const JsonSpans& after, int b) {
    if (meaning(before.value_text(a)) == meaning(after.value_text(b))) {
        RC_ASSERT(before.value_text(a) == after.value_text(b));
        return;
    }
    if (before.node(a).kind != after.node(b).kind) return;
    const auto children_before = before.children(a), children_after = after.children(b);
    if (before.node(a).kind == JsonKind::Array) {
        for (std::size_t i = 0; i < std::min(children_before.size(), children_after.size()); ++i)
            expect_equal_parts_untouched(before, children_before[i], after, children_after[i]);
        return;
    }
    for (const int child : children_before)
        if (const auto same = after.member(b, before.key_of(child)))
            expect_equal_parts_untouched(before, child, after, *same);
}

RC_GTEST_PROP(JsonSpans, EveryValueIsFoundByItsPointerWithItsOwnText, (std::uint64_t seed)) {
    Generator random(seed);
    const std::string text = random_space(random) + random_text(random, 4) + random_space(random);
    const auto spans = JsonSpans::scan(text);
    RC_ASSERT(spans.has_value());
    const auto parsed = meaning(text);
    const auto flat = parsed.flatten();
    for (const auto& [pointer, value] : flat.items()) {
        const auto node = spans->find(pointer);
        RC_ASSERT(node.has_value());
        if (value.is_primitive() && !value.is_null())
            RC_ASSERT(meaning(spans->value_text(*node)) == value);
    }
    RC_ASSERT(meaning(spans->value_text(0)) == parsed);
}

RC_GTEST_PROP(JsonSplice, TheResultMeansWhatWasWantedAndTheRestKeepsItsBytes,
              (std::uint64_t seed)) {
    Generator random(seed ^ 0x9e3779b97f4a7c15u);
    const auto spans = JsonSpans::scan(random_text(random, 4)).value();
    Json wanted = Json::parse(spans.text());
    const std::size_t mutations = 1 + draw_below(random, 4);
    for (std::size_t i = 0; i < mutations; ++i) mutate(random, wanted);
    const auto text = spliced(spans, {{"", wanted}});
    RC_ASSERT(text.has_value());
    RC_LOG() << spans.text() << "\n-> " << *text << "\nwanted " << wanted << "\n";
    RC_ASSERT(meaning(*text) == meaning(wanted.dump()));
    const auto after = JsonSpans::scan(*text);
    RC_ASSERT(after.has_value());
    expect_equal_parts_untouched(spans, 0, *after, 0);
}

RC_GTEST_PROP(JsonSplice, WithNothingToChangeTheTextIsTheSame, (std::uint64_t seed)) {
    Generator random(seed);
    const auto spans = JsonSpans::scan(random_text(random, 4)).value();
    RC_ASSERT(spliced(spans, {}).value() == spans.text());
    RC_ASSERT(spliced(spans, {{"", Json::parse(spans.text())}}).value() == spans.text());
}

std::string changed(std::string_view text, const std::vector<JsonChange>& changes) {
    return spliced(JsonSpans::scan(std::string(text)).value(), changes).value();
}

TEST(JsonSplice, NewMembersOfAnIndentedTextStandOnLinesOfTheirOwn) {
    const std::string text =
        "{\n  \"a\": 1.0,\n  \"list\": [],\n  \"b\": {\n    \"c\": [0.10, 2]\n  }\n}\n";
    EXPECT_EQ(
        changed(text, {{"/b/d", Json{{"e", {1, 2}}, {"f", Json::object()}}},
                       {"/list/0", Json{{"g", "h"}}}}),
        "{\n  \"a\": 1.0,\n  \"list\": [\n    {\n      \"g\": \"h\"\n    }\n  ],\n  \"b\": {\n"
        "    \"c\": [0.10, 2],\n    \"d\": {\n      \"e\": [1, 2],\n      \"f\": {}\n    }\n  "
        "}\n}\n");
}

TEST(JsonSplice, NewMembersOfACompactTextAreCompact) {
    EXPECT_EQ(changed(R"({"a":[1],"b":{}})", {{"/a/1", 2}, {"/b/c", Json{{"d", {1, 2}}}}}),
              R"({"a":[1,2],"b":{"c":{"d":[1,2]}}})");
}

TEST(JsonSplice, ARemovedMemberTakesItsCommaWithIt) {
    EXPECT_EQ(changed(R"({"a": 1, "b": 2, "c": 3})", {{"/a", {}}}), R"({"b": 2, "c": 3})");
    EXPECT_EQ(changed(R"({"a": 1, "b": 2, "c": 3})", {{"/b", {}}}), R"({"a": 1, "c": 3})");
    EXPECT_EQ(changed(R"({"a": 1, "b": 2, "c": 3})", {{"/c", {}}}), R"({"a": 1, "b": 2})");
    EXPECT_EQ(changed(R"({ "a": 1 })", {{"/a", {}}}), "{}");
}

TEST(JsonSplice, OfAKeyThatOccursTwiceTheOneThatCountsIsChanged) {
    EXPECT_EQ(changed(R"({"a":1,"a":2})", {{"/a", 3}}), R"({"a":1,"a":3})");
}

TEST(JsonSplice, AChangeWhoseParentIsMissingIsAnError) {
    const auto spans = JsonSpans::scan(R"({"a":1})").value();
    EXPECT_FALSE(spliced(spans, {{"/b/c", 1}}));
    EXPECT_FALSE(spliced(spans, {{"/a/c", 1}}));
}

TEST(JsonSpans, RefusesBrokenAndBottomlessText) {
    for (const char* text : {"", "{", "[1", "[1,]", "{\"a\"}", "{\"a\":}", "\"", "[1]]", "{1:2}"})
        EXPECT_FALSE(JsonSpans::scan(text)) << text;
    EXPECT_TRUE(JsonSpans::scan(std::string(64, '[') + std::string(64, ']')));
    EXPECT_FALSE(JsonSpans::scan(std::string(65, '[') + std::string(65, ']')));
}

TEST(JsonNumber, PrintsAsShortlyAsTheFloat) {
    EXPECT_EQ(json_number(0.1f).dump(), "0.1");
    EXPECT_EQ(json_number(1.0f).dump(), "1");
    EXPECT_EQ(json_number(-0.25f).dump(), "-0.25");
}

}  // namespace
}  // namespace patina::io
