// SPDX-License-Identifier: MIT
// Each value is what its reader expects, or the error says where it stands, what it must be and what it is.
#include "base/json/value.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "base/json/document.h"

namespace dermis::json {
namespace {

std::string error_of(const char* text, const std::function<void(const Value&)>& read) {
  const Document document(text, "a.json");
  try {
    read(document.root());
  } catch (const InputError& error) { return error.what(); }
  return "no error";
}

TEST(JsonValue, ReadsWhatIsThere) {
  const Document document(
      R"({"n": -1.5, "c": 3.0, "t": "text", "b": true, "list": [1, 2], "objects": [{"i": 1}, {"i": 0}]})",
      "a.json");
  const Value root = document.root();
  EXPECT_EQ(root.at("n").number(), -1.5);
  EXPECT_EQ(root.at("c").count(), 3u);
  EXPECT_EQ(root.at("t").text(), "text");
  EXPECT_TRUE(root.at("b").boolean());
  EXPECT_EQ(root.numbers("list", 2), (std::vector<double>{1, 2}));
  EXPECT_EQ(root.indices("list", 3, "light"), (std::vector<int>{1, 2}));
  EXPECT_EQ(root.size_of("list"), 2u);

  int sum = 0;
  root.for_each("objects", [&](const Value& object) { sum += 1 + object.index("i", 2, "light"); });
  EXPECT_EQ(sum, 3);
  EXPECT_EQ(root.keys(), (std::vector<std::string>{"b", "c", "list", "n", "objects", "t"}));
  EXPECT_EQ(root.at("objects").dump(), R"([{"i":1},{"i":0}])");
}

TEST(JsonValue, WholeNumbersOf64BitsAreExact) {
  const Document document(R"({"most": 18446744073709551615, "odd": 9007199254740993})", "a.json");
  EXPECT_EQ(document.root().at("most").whole(), std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(document.root().at("odd").whole(), 9007199254740993u);
  for (const char* text : {"-1", "1.0", "18446744073709551616", "null"})
    EXPECT_NE(error_of(text, [](const Value& value) { value.whole(); }).find("must be an integer of 0 to"),
              std::string::npos)
        << text;
}

TEST(JsonValue, WhatIsLeftOutHasItsDefault) {
  const Document document("{}", "a.json");
  const Value root = document.root();
  EXPECT_FALSE(root.has("x") || root.find("x"));
  EXPECT_EQ(root.number_or("x", 2.5), 2.5);
  EXPECT_EQ(root.count_or("x", 7, 1, 2), 7u);
  EXPECT_TRUE(root.boolean_or("x", true));
  EXPECT_EQ(root.text_or("x", "y"), "y");
  EXPECT_EQ(root.index_or_none("x", 3, "light"), -1);
  EXPECT_TRUE(root.numbers("x", 3).empty());
  EXPECT_EQ(root.size_of("x"), 0u);
}

TEST(JsonValue, AnotherTypeIsAnError) {
  const auto error = [](const char* json, auto read) {
    return error_of(json, [&](const Value& root) { read(root.at("a")); });
  };

  EXPECT_EQ(error(R"({"a": "1"})", [](const Value& v) { v.number(); }),
            "a.json: a: must be a number, is string");
  EXPECT_EQ(error(R"({"a": 1.5})", [](const Value& v) { v.count(); }),
            "a.json: a: must be an integer, is number");
  EXPECT_EQ(error(R"({"a": 1})", [](const Value& v) { v.text(); }), "a.json: a: must be a string, is number");
  EXPECT_EQ(error(R"({"a": 1})", [](const Value& v) { v.boolean(); }),
            "a.json: a: must be true or false, is number");
  EXPECT_EQ(error(R"({"a": {}})", [](const Value& v) { v.array_size(); }),
            "a.json: a: must be an array, is object");
  EXPECT_EQ(error(R"({"a": []})", [](const Value& v) { v.at("b"); }),
            "a.json: a: must be an object, is array");
  EXPECT_EQ(error(R"({"a": null})", [](const Value& v) { v.keys(); }),
            "a.json: a: must be an object, is null");
  EXPECT_EQ(error_of("[]", [](const Value& root) { root.object(); }),
            "a.json: the JSON must be an object, is array");
}

TEST(JsonValue, ARangeIsHeld) {
  const auto error = [](const char* json, auto read) {
    return error_of(json, [&](const Value& root) { read(root.element(0)); });
  };

  EXPECT_EQ(error("[2]", [](const Value& v) { v.number(0, 1); }), "a.json: [0]: must be 0 to 1, is 2");
  EXPECT_EQ(error("[-2]", [](const Value& v) { v.number(0); }), "a.json: [0]: must be at least 0, is -2");
  EXPECT_EQ(error("[1e300]", [](const Value& v) { v.number(); }),
            "a.json: [0]: the number 1e+300 is out of range");
  EXPECT_EQ(error("[1e300]", [](const Value& v) { v.number(0, std::numeric_limits<double>::max()); }),
            "no error");
  EXPECT_EQ(error("[-1]", [](const Value& v) { v.count(); }),
            "a.json: [0]: must be 0 to 281474976710656, is -1");
  EXPECT_EQ(error("[9]", [](const Value& v) { v.count(1, 8); }), "a.json: [0]: must be 1 to 8, is 9");

  EXPECT_EQ(error("[[]]", [](const Value& v) { v.array_size(); }), "a.json: [0]: is an empty array");
  EXPECT_EQ(error("[[]]", [](const Value& v) { v.array_size(0); }), "no error");
  EXPECT_EQ(error("[[1]]", [](const Value& v) { v.array_size(2); }),
            "a.json: [0]: must have at least 2 elements, has 1");
  EXPECT_EQ(error("[[1, 2]]", [](const Value& v) { v.array_size(0, 1); }),
            "a.json: [0]: must have 0 to 1 elements, has 2");
}

TEST(JsonValue, MembersAreNamed) {
  const auto error = [](const char* json, auto read) {
    return error_of(json, [&](const Value& root) { read(root.at("s")); });
  };

  EXPECT_EQ(error(R"({"s": {}})", [](const Value& v) { v.at("size"); }), "a.json: s: 'size' is missing");
  EXPECT_EQ(error(R"({"s": {"siz": 1, "b": 2}})",
                  [](const Value& v) {
                    v.only_keys({"size", "b"});
                  }),
            "a.json: s: unknown key 'siz'; there are: size, b; did you mean 'size'?");
  EXPECT_EQ(error(R"({"s": {"size": [1, 2]}})", [](const Value& v) { v.numbers("size", 3); }),
            "a.json: s.size: must have 3 numbers, has 2");
  EXPECT_EQ(error(R"({"s": {"size": [1, true]}})", [](const Value& v) { v.numbers("size", 0); }),
            "a.json: s.size[1]: must be a number, is boolean");
  EXPECT_EQ(error(R"({"s": {"light": 3}})", [](const Value& v) { v.index("light", 3, "light"); }),
            "a.json: s.light: there is no light 3 (3 in all)");
  EXPECT_EQ(error(R"({"s": {"lights": [1, 0, 3]}})", [](const Value& v) { v.indices("lights", 3, "light"); }),
            "a.json: s.lights[2]: there is no light 3 (3 in all)");
  EXPECT_EQ(error(R"({"s": {"a": [{}, 1]}})", [](const Value& v) { v.for_each("a", [](const Value&) {}); }),
            "a.json: s.a[1]: must be an object, is number");
  EXPECT_EQ(error(R"({"s": {}})", [](const Value& v) { v.called("layer 2").at("eta"); }),
            "a.json: layer 2: 'eta' is missing");
}

TEST(JsonValue, AnErrorIsOneLineWhateverTheTextHolds) {
  EXPECT_EQ(error_of(R"({"a\nb": {"c": 1}})", [](const Value& root) { root.at("a\nb").at("c").text(); }),
            "a.json: a?b.c: must be a string, is number");
  EXPECT_EQ(error_of(R"({"a\nb": 1})", [](const Value& root) { root.only_keys({"c"}); }),
            "a.json: unknown key 'a?b'; there are: c");
  EXPECT_EQ(error_of(R"(["a\nb"])",
                     [](const Value& root) { root.element(0).fail("no {}", root.element(0).text()); }),
            "a.json: [0]: no a?b");
}

}  // namespace
}  // namespace dermis::json
