// SPDX-License-Identifier: MIT
// Made-up comments and texts that break one rule each.
#include "house/prose.h"

#include <gtest/gtest.h>

namespace {

house::SourceFile source(const std::string& path, std::vector<std::string> lines) {
  return {path, std::move(lines)};
}

std::vector<std::string> read(const std::vector<house::Sentence>& sentences) {
  std::vector<std::string> all;
  all.reserve(sentences.size());
  for (const house::Sentence& sentence : sentences) all.push_back(house::trimmed(sentence.text));
  return all;
}

TEST(Prose, ReadsComments) {
  const auto sentences = house::sentences_of_comments(
      source("src/a.h", {"// SPDX-License-Identifier: MIT", "/// One two.", "/// Three", "///   four = five;",
                         "/// - six", "///   seven", "int a;  ///< eight, e.g. nine", "        ///< ten",
                         "const char* b = \"http://eleven\";  // twelve", "//", "// thirteen"}));
  EXPECT_EQ(read(sentences), (std::vector<std::string>{"One two.", "Three", "six", "eight, e.g nine ten",
                                                       "twelve", "thirteen"}));
  EXPECT_EQ(sentences[3].line, 7u);
  EXPECT_EQ(sentences[3].words, 4);
}

TEST(Prose, ReadsTextsOfPrograms) {
  const auto sentences = house::sentences_of_texts(source(
      "src/a.cpp", {"#include \"a b.h\"", "error(\"one two. \"", "      \"three \\\"four\\\"\\nfive\");",
                    "'\"'; f(\"six\", \"seven {}\", R\"(eight nine)\");  // \"ten eleven\""}));
  EXPECT_EQ(read(sentences), (std::vector<std::string>{"one two.", "three \"four\"", "five", "seven {}"}));
  EXPECT_EQ(sentences[0].line, 2u);
}

TEST(Prose, KnowsAClauseForASubject) {
  for (const char* clause : {"What a frame costs.", "how many pixels", "(which of them) is it", "Who calls"})
    EXPECT_TRUE(house::has_clause_subject(clause)) << clause;
  for (const char* other :
       {"What is it?", "Whatsoever", "what() is one line", "Cost of a frame", "Returns what it costs", ""})
    EXPECT_FALSE(house::has_clause_subject(other)) << other;
}

TEST(Prose, FindsHardComments) {
  const std::vector<house::SourceFile> tree{
      source("src/a.cpp", {"// What it is. One two three", "int a;  // one two three four"}),
      source("include/a.h", {"/// one two three four five"}),
      source("tests/a.cpp", {"// What it is, and was"})};
  const house::HardComments hard = house::hard_comments(tree, 3);
  ASSERT_EQ(hard.clauses.size(), 1u);
  EXPECT_EQ(hard.clauses[0].path, "src/a.cpp");
  ASSERT_EQ(hard.longs.size(), 2u);
  EXPECT_EQ(hard.longs[0].path, "include/a.h");
  EXPECT_EQ(hard.longs[1].sentence.line, 2u);
}

TEST(Prose, FindsHardTexts) {
  const std::vector<house::SourceFile> tree{
      source("apps/a.cpp", {"f(\"one two three four\");", "f(\"what it does\");", "f(\"what\");"}),
      source("tests/a.cpp", {"f(\"one two three four\");"})};
  EXPECT_EQ(house::check_texts(tree, 3),
            (house::Violations{"apps/a.cpp:1: a sentence of 4 words: one two three four",
                               "apps/a.cpp:2: the subject is a clause: what it does"}));
}

}  // namespace
