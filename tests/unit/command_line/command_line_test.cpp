// SPDX-License-Identifier: MIT
// Lists, numbers and the help: what is shown can be typed, and what cannot be understood says what can.
#include "cli/command_line.h"

#include <gtest/gtest.h>

namespace dermis::cli {
namespace {

using Words = std::vector<std::string>;

TEST(Lists, TakeTheirValuesOneByOneOrWithCommas) {
  EXPECT_EQ(join_lists({"dermis", "bench", "--distances", "6", "15"}),
            (Words{"dermis", "bench", "--distances", "6,15"}));
  EXPECT_EQ(join_lists({"--distances=6", "15", "--heads", "1,2", "4", "--json", "-"}),
            (Words{"--distances=6,15", "--heads", "1,2,4", "--json", "-"}));
  EXPECT_EQ(join_lists({"--optimise", "cull", "depth", "-o", "a.png"}),
            (Words{"--optimise", "cull,depth", "-o", "a.png"}));
  EXPECT_EQ(join_lists({"--techniques", "lambert", "texture-space", "--size", "8x8"}),
            (Words{"--techniques", "lambert,texture-space", "--size", "8x8"}));
  EXPECT_EQ(join_lists({"--heads", "1", "-4"}), (Words{"--heads", "1,-4"})) << "refused later, as a number";
}

// A scene may follow, whatever it is called, and other options stay as they are.
TEST(Lists, TakeNothingElse) {
  for (const Words& unchanged :
       {Words{}, Words{"dermis"}, Words{"--distances"}, Words{"--distances", "6", "head.glb"},
        Words{"--distances", "6", "./15", "15"}, Words{"--distances", "6", "7 radii"},
        Words{"--size", "8x8", "15"}, Words{"--optimise", "cull", "head.glb", "depth"},
        Words{"--distances", "head.glb"}, Words{"--quick", "6", "15"}, Words{"6", "15"}})
    EXPECT_EQ(join_lists(unchanged), unchanged);
}

struct Options : testing::Test {
  CLI::App app{"test"};
  std::uint64_t count = 7;
  std::vector<double> radii{1, 2.5};
  std::vector<std::string> lights, files;

  void SetUp() override {
    app.formatter(std::make_shared<HelpFormatter>());
    add_count(app, "--photons", count, "photons", "1,000 to 1e9");
    app.add_option("--radii", radii, "")->delimiter(',')->allow_extra_args(false)->type_name("D,D,..");
    app.add_option("--light", lights, "")->allow_extra_args(false)->type_name("AZ,EL");
    app.add_option("--compare", files, "")->expected(2)->type_name("OLD NEW");
  }
};

TEST_F(Options, HelpShowsWhatCanBeTyped) {
  const std::string help = app.help();
  EXPECT_NE(help.find("--radii D,D,.."), std::string::npos) << help;
  EXPECT_NE(help.find("--light AZ,EL"), std::string::npos) << help;
  EXPECT_NE(help.find("--compare OLD NEW"), std::string::npos) << help;
  EXPECT_EQ(help.find("..."), std::string::npos) << help;
  EXPECT_EQ(help.find(" x 2"), std::string::npos) << help;
}

TEST_F(Options, ACountSaysItsRange) {
  app.parse("--photons 5000");
  EXPECT_EQ(count, 5000u);
  for (const char* given : {"-5", "1.5", "1e6", "many", "99999999999999999999"}) try {
      app.parse(std::string("--photons ") + given);
      ADD_FAILURE() << given;
    } catch (const CLI::ParseError& error) {
      EXPECT_EQ(std::string(error.what()),
                "--photons: expected a whole number, 1,000 to 1e9, got '" + std::string(given) + "'");
    }
}

}  // namespace
}  // namespace dermis::cli
