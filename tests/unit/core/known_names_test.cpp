// SPDX-License-Identifier: MIT
// A slip finds the name that was meant, and nonsense none.
#include "base/core/known_names.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <string>

namespace dermis {
namespace {

const KnownNames options{"--output",   "--size",       "--environment",  "--environment-intensity",
                         "--light",    "--lights",     "--light-radius", "--tone-map",
                         "--map-size", "--map-budget", "--mask",         "--maps",
                         "--fov",      "--optimise",   "--haemoglobin",  "--background"};

TEST(NearestName, IsTheOneWithFewestTypingErrors) {
  for (const auto& [word, name] : std::map<std::string, std::string>{{"--ouput", "--output"},
                                                                     {"--outptu", "--output"},
                                                                     {"--sise", "--size"},
                                                                     {"--envrionment", "--environment"},
                                                                     {"--lihgt", "--light"},
                                                                     {"--lihgts", "--lights"},
                                                                     {"--light-radus", "--light-radius"},
                                                                     {"--optimize", "--optimise"},
                                                                     {"--hemoglobin", "--haemoglobin"},
                                                                     {"--mapsize", "--map-size"},
                                                                     {"--backgroud", "--background"},
                                                                     {"--fvo", "--fov"}})
    EXPECT_EQ(nearest_name(word, options), name) << word;
}

TEST(NearestName, CapitalsDashesAndUnderscoresAreNoErrors) {
  for (const char* word : {"tone_map", "--Tone-Map", "-tone-map", "TONE_MAP"})
    EXPECT_EQ(nearest_name(word, options), "--tone-map") << word;
}

TEST(NearestName, ABeginIsEnough) {
  EXPECT_EQ(nearest_name("--env", options), "--environment");
  EXPECT_EQ(nearest_name("back", options), "--background");
  EXPECT_EQ(nearest_name("ba", options), "") << "two letters say too little";
}

TEST(NearestName, NonsenseHasNone) {
  for (const char* word :
       {"", "-", "--", "x", "--q", "--brush", "--asdfgh", "--xyzzy", "--colours", "--watercolour", "99",
        "1.5", "640x480", "--paint-with-oil-on-canvas", "\xff\xfe\x01"})
    EXPECT_EQ(nearest_name(word, options), "") << word;
  EXPECT_EQ(nearest_name(std::string(100000, 'a'), options), "");
  EXPECT_EQ(nearest_name("depth", KnownNames{}), "");
  // Half of a short word is no slip.
  EXPECT_EQ(nearest_name("no", {"on", "off"}), "on");
  EXPECT_EQ(nearest_name("a", {"b", "c"}), "");
  EXPECT_EQ(nearest_name("ab", {"cd", "ef"}), "");
}

TEST(KnownNames, AreListedWithTheOneThatWasMeant) {
  constexpr std::array<std::string_view, 3> names{"alpha", "depth", "tiles"};
  EXPECT_EQ(unknown_name("dept", names),
            "'dept' is not known; there are: alpha, depth, tiles; did you mean 'depth'?");
  EXPECT_EQ(unknown_name("tape", names), "'tape' is not known; there are: alpha, depth, tiles");
  EXPECT_EQ(listed_names("tape", std::vector<std::string>{}), "there are none");

  const std::map<std::string, int> numbers{{"", 1}, {"two words", 2}, {"a\nb", 3}};
  EXPECT_EQ(listed_names("x", numbers), "there are: '', a?b, 'two words'");
}

// A file may hold thousands of names, and long ones.
TEST(KnownNames, StayALineThatCanBeRead) {
  std::vector<std::string> names;
  for (int i = 0; i < 5000; ++i) names.push_back("material-" + std::to_string(i) + std::string(500, 'x'));
  const std::string text = listed_names("material", names);
  EXPECT_LT(text.size(), 1500u);
  EXPECT_NE(text.find(" more"), std::string::npos) << text;
}

}  // namespace
}  // namespace dermis
