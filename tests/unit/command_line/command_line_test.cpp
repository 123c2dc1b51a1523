// SPDX-License-Identifier: MIT
// Lists, numbers and the help: what is shown can be typed, and what cannot be understood says what can.
#include "cli/command_line.h"

#include <gtest/gtest.h>

#include "cli/help.h"

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

TEST_F(Options, HelpLeavesRareOptionsToHelpAll) {
  CLI::App program{"program"};
  set_up_help(program);
  CLI::App* command = program.add_subcommand("draw", "draws");
  command->add_option("--size", count, "pixels")->group("Picture");
  rare(command->add_option("--bloom", count, "spread light")->group("Picture"));
  command->add_option("--secret", count, "hidden")->group("");

  const std::string few = command->help("program"), all = command->help("program", CLI::AppFormatMode::All);
  EXPECT_NE(few.find("\nPicture:\n  --size UINT=7"), std::string::npos) << few;
  EXPECT_EQ(few.find("--bloom"), std::string::npos) << few;
  EXPECT_TRUE(few.ends_with("\nprogram draw --help-all shows all 4 options\n")) << few;
  EXPECT_NE(all.find("--bloom"), std::string::npos) << all;
  EXPECT_EQ(all.find("Picture", all.find("Picture") + 1), std::string::npos) << "one title: " << all;
  EXPECT_EQ((few + all).find("--secret"), std::string::npos);
  EXPECT_EQ(all.find("rare"), std::string::npos) << all;
  EXPECT_NE(program.help("program", CLI::AppFormatMode::All).find("--bloom"), std::string::npos);
}

// A long list of words stands in the description, unless that explains them.
TEST_F(Options, HelpShowsTheWordsOfAValue) {
  std::string word;
  const auto add = [&](const char* name, const char* type, const char* help) {
    app.add_option(name, word, help)->type_name(type);
  };
  add("--blur", "chain|cascade", "the order");
  add("--tone-map", "natural|neutral|agx|filmic|srgb", "from light to display");
  add("--behind", "black|studio|environment|#RRGGBB", "the background");
  add("--kind", "long-word-of-one-kind|long-word-of-another", "long-word-of-one-kind: it is explained");
  const std::string help = app.help();
  for (const char* text :
       {"--blur chain|cascade ", "--tone-map NAME ", "display: natural, neutral, agx, filmic, srgb\n",
        "--behind NAME|#RRGGBB ", "background: black, studio, environment\n", "kind: it is explained\n"})
    EXPECT_NE(help.find(text), std::string::npos) << text << " in " << help;
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
