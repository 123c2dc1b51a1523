// SPDX-License-Identifier: MIT
// Completions and the manual page say what the program's options are, whatever characters their texts hold.
// tests/cli/completions.sh lets the shells read those of the program itself.
#include <gtest/gtest.h>

#include "cli/help.h"
#include "cli/manual/entries.h"

namespace dermis::cli::manual {
namespace {

struct Manual : testing::Test {
  CLI::App app{"a test"};
  std::string word;
  std::vector<std::string> words;
  bool flag = false;

  void SetUp() override {
    set_up_help(app);
    CLI::App* draw = app.add_subcommand("draw", "draws [it]: the user's way");
    draw->add_option("SCENE", words, "a file")->type_name("FILE|built-in:light");
    draw->add_option("-o,--output", word, ".png \\ it's -1")->type_name("FILE")->group("Picture");
    rare(draw->add_option("--kind", word, "a kind")->type_name("one|two|#N"));
    draw->add_option("--parts", words, "parts")
        ->type_name("nose|ear")
        ->delimiter(',')
        ->allow_extra_args(false);
    draw->add_flag("--quick", flag, "at once");
    draw->add_flag("--secret", flag, "hidden")->group("");
  }
};

TEST_F(Manual, EntriesAreThoseOfTheProgram) {
  const std::vector<CommandEntry> entries = entries_of(app);
  ASSERT_EQ(entries.size(), 2u);
  EXPECT_EQ(entries[0].name, "");
  ASSERT_EQ(entries[1].options.size(), 7u) << "help, help-all, SCENE and four options; none that is hidden";

  const auto find = [&](const std::string& name) {
    for (const OptionEntry& option : entries[1].options)
      if (option.names.back() == name) return option;
    ADD_FAILURE() << name;
    return OptionEntry{};
  };
  EXPECT_TRUE(find("SCENE").is_positional && find("SCENE").is_repeatable && find("SCENE").takes_file);
  EXPECT_EQ(find("SCENE").words, std::vector<std::string>{"built-in:light"});
  EXPECT_EQ(find("--output").names, (std::vector<std::string>{"-o", "--output"}));
  EXPECT_EQ(find("--output").title, "Picture");
  EXPECT_EQ(find("--kind").words, (std::vector<std::string>{"one", "two"}));
  EXPECT_EQ(find("--kind").title, "Options");
  EXPECT_TRUE(find("--parts").is_list && !find("--parts").is_repeatable);
  EXPECT_EQ(find("--quick").type, "");
}

TEST_F(Manual, TextsAreQuotedAsEachReaderTakesThem) {
  const std::string zsh = zsh_completion(app);
  EXPECT_NE(zsh.find(R"('draw:draws \[it\]\: the user'\''s way')"), std::string::npos) << zsh;
  EXPECT_NE(zsh.find(R"([.png \\ it'\''s -1])"), std::string::npos) << zsh;
  EXPECT_NE(zsh.find(R"( _dermis_words_or_files built-in\:light)"), std::string::npos) << zsh;

  const std::string man = man_page(app, "1.2.3");
  EXPECT_NE(man.find("\n\\&.png \\e it\\(aqs \\-1\n"), std::string::npos) << man;
  EXPECT_NE(man.find("\\fB\\-o\\fR, \\fB\\-\\-output\\fR \\fIFILE\\fR\n"), std::string::npos) << man;
  EXPECT_NE(man.find("dermis 1.2.3"), std::string::npos) << man;
  for (const std::string& text : {zsh, man, bash_completion(app)})
    EXPECT_EQ(text.find("secret"), std::string::npos) << text;
}

TEST_F(Manual, AreAskedForByHiddenOptions) {
  add_manual_options(app, "1.2.3");
  for (const auto& [line, begins] : std::initializer_list<std::pair<const char*, const char*>>{
           {"--completions bash", "# Completions"}, {"--completions zsh", "#compdef"}, {"--man", ".TH"}}) {
    testing::internal::CaptureStdout();
    EXPECT_THROW(app.parse(line), CLI::Success) << line;
    EXPECT_TRUE(testing::internal::GetCapturedStdout().starts_with(begins)) << line;
  }
  EXPECT_THROW(app.parse("--completions fish"), CLI::ValidationError);
  EXPECT_EQ(app.help("", CLI::AppFormatMode::All).find("--man"), std::string::npos);
}

}  // namespace
}  // namespace dermis::cli::manual
