// SPDX-License-Identifier: MIT
// Text that is no JSON, or too much of it, is refused before anything is made of it.
#include "base/json/document.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace dermis::json {
namespace {

std::string error_of(std::string_view text, const Limits& limits = {}) {
  try {
    const Document document(text, "a.json", limits);
  } catch (const InputError& error) { return error.what(); }
  return "no error";
}

TEST(JsonDocument, WhatIsNoJsonIsSaidInOneLine) {
  for (const char* text :
       {"", "{", "nonsense", "[1,]", "\xff\xfe", "{\"name\": \"\x01\"}", "{} {}", "[1e999]", "{1: 2}"}) {
    const std::string error = error_of(text);
    EXPECT_EQ(error.find("a.json: is not valid JSON: "), 0u) << text << " -> " << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  }
  EXPECT_EQ(error_of("[1, {\"a\": null}]"), "no error");
}

TEST(JsonDocument, DepthAndValuesAreLimited) {
  EXPECT_EQ(error_of("[[[1]]]", {.depth = 3}), "no error");
  EXPECT_EQ(error_of("[[[1]]]", {.depth = 2}), "a.json: the JSON is nested deeper than 2 levels");
  EXPECT_EQ(error_of("[{\"a\": {}}]", {.depth = 2}), "a.json: the JSON is nested deeper than 2 levels");
  EXPECT_EQ(error_of(std::string(1'000'000, '[')), "a.json: the JSON is nested deeper than 16 levels");

  // Three numbers, the array and its end.
  EXPECT_EQ(error_of("[1, 2, 3]", {.values = 5}), "no error");
  EXPECT_EQ(error_of("[1, 2, 3]", {.values = 4}), "a.json: the JSON has more than 4 values");
}

// Among objects what is none is one without members, so that the others keep their numbers.
TEST(JsonDocument, NullAndEmptyMembersCanBeAbsent) {
  const char* text = R"({"a": null, "b": [], "c": [{"d": null}, [], null], "extras": {"e": []}, "f": null,
                         "extensions": {"g": []}})";
  const Document kept(text, "a.json");
  EXPECT_TRUE(kept.root().has("a"));
  EXPECT_EQ(kept.left_out().count, 0u);

  const Document document(text, "a.json", {.empty_is_absent = true});
  EXPECT_EQ(document.root().dump(), R"({"c":[{},{},{}],"extensions":{},"extras":{"e":[]}})");
  EXPECT_EQ(document.left_out().count, 6u) << "those of extensions do not count";
  EXPECT_EQ(document.left_out().first, (std::vector<std::string>{"a", "b", "c[0].d"}));
}

TEST(JsonDocument, AKeyGivenTwiceIsNamedWithItsPlace) {
  EXPECT_EQ(error_of(R"({"a": 1, "a": 2})"), "a.json: key 'a' is given twice");
  EXPECT_EQ(error_of(R"({"x": 1, "list": [0, [], {"y": {"a": 1, "b": [1, 2], "a": 2}}]})"),
            "a.json: list[2].y: key 'a' is given twice");
  EXPECT_EQ(error_of(R"({"list": [{"a": 1}, {"a": 1}], "a": 1})"), "no error");

  const Limits repeated{.repeated_keys = true};
  EXPECT_EQ(error_of(R"({"a": 1, "a": 2})", repeated), "no error");
  EXPECT_EQ(Document(R"({"a": 1, "a": 2})", "a.json", repeated).root().at("a").count(), 2u);
}

// A key stands in the message as it is read, and JSON may write a line feed into it.
TEST(JsonDocument, AnErrorIsOneLineWhateverTheKeysHold) {
  EXPECT_EQ(error_of(R"({"a\nb": {"c\u007fd": 1, "c\u007fd": 2}})"), "a.json: a?b: key 'c?d' is given twice");
  const std::string key(100'000, 'k');
  EXPECT_LE(error_of(fmt::format(R"({{"{0}": 1, "{0}": 2}})", key)).size(), 200u);
}

TEST(JsonDocument, ValuesOutliveAMove) {
  Document first(R"({"name": "x"})", "a.json");
  const Value root = first.root();
  const Document second = std::move(first);
  EXPECT_EQ(root.at("name").text(), "x");
  EXPECT_EQ(root.file(), "a.json");
}

TEST(JsonDocument, AFileThatIsNotThereIsNamed) {
  try {
    load("no-such-folder/a.json", 100);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("no-such-folder/a.json"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace dermis::json
