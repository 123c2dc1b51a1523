// SPDX-License-Identifier: MIT
// Made-up documents that break one rule each.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "house/documents.h"

namespace {

namespace fs = std::filesystem;

house::SourceFile file(const std::string& path, std::vector<std::string> lines) {
  return {path, std::move(lines)};
}

TEST(Documents, SentencesEndWhereAReaderStops) {
  const auto sentences = house::sentences_of(
      file("docs/a.md", {"# A heading", "", "One two `three four`, e.g. five. Six", "[seven](b.md) eight!",
                         "- nine 0.5", "  ten", "| eleven \\| twelve | thirteen. Fourteen |", "|---|---|",
                         "```", "a b c", "```", "    d e f"}));
  std::vector<int> words;
  for (const house::Sentence& sentence : sentences) words.push_back(sentence.words);
  EXPECT_EQ(words, (std::vector{2, 5, 3, 3, 2, 1, 1}));
  EXPECT_EQ(sentences[1].line, 3u);
}

TEST(Documents, FindsALongSentence) {
  const std::vector<house::SourceFile> tree{
      file("README.md", {"one two three four", "# How it is"}), file("docs/a.md", {"one two", "three. four"}),
      file("docs/b.md", {"<!-- rows: written by a test -->", "| one two three four |", "<!-- end -->"}),
      file("ARCHITECTURE.md", {"one two three four"})};
  EXPECT_EQ(house::check_sentences(tree, 3),
            (house::Violations{"README.md:1: a sentence of 4 words: one two three four",
                               "README.md:2: the subject is a clause: How it is"}));
  EXPECT_EQ(house::count_long_sentences_elsewhere(tree, 3), 1);
}

TEST(Documents, FindsACommit) {
  const std::vector<house::SourceFile> tree{
      file("docs/a.md", {"at commit 5133bd8, with #3a424d1 and 1234567", "(fd2bcd38)", "defaced"}),
      file("docs/results/a.json", {"5133bd8"})};
  EXPECT_EQ(house::check_commits(tree), (house::Violations{"docs/a.md:1: names the commit 5133bd8",
                                                           "docs/a.md:2: names the commit fd2bcd38"}));
}

TEST(Documents, FindsLinksThatLeadNowhere) {
  const fs::path root = fs::path(::testing::TempDir()) / "dermis_documents";
  fs::remove_all(root);
  fs::create_directories(root / "docs");
  for (const char* name : {"README.md", "docs/a.md", "docs/a.jpg"}) std::ofstream(root / name) << "\n";

  const std::vector<house::SourceFile> tree{
      file("README.md",
           {"[a](docs/a.md#way-i-it-draws-1) [b](docs/b.md)", "`[c](d.md)` [w](https://e.org/f)"}),
      file("docs/a.md", {"# Way (i): it `draws`", "# Way (i): it draws", "```", "[g](h.md)", "```",
                         "![p](a.jpg) [r](../README.md) [top](#way-i-it-draws) [no](#nothing)"})};
  EXPECT_EQ(house::check_links(tree, root),
            (house::Violations{"README.md:1: there is no such heading: docs/a.md#way-i-it-draws-1",
                               "README.md:1: the link leads nowhere: docs/b.md",
                               "docs/a.md:6: there is no such heading: #nothing"}));
}

TEST(Documents, CountsBytesOfNotesApart) {
  const std::vector<house::SourceFile> tree{file("README.md", {"12", "3"}), file("docs/a.md", {"1234"}),
                                            file("docs/notes/b.md", {"12345678"}),
                                            file("CHANGELOG.md", {"1"})};
  EXPECT_EQ(house::bytes_of_documents(tree).documents, 10u);
  EXPECT_EQ(house::bytes_of_documents(tree).notes, 9u);
}

}  // namespace
