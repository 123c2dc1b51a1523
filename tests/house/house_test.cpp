// SPDX-License-Identifier: MIT
// The rules of the house, held against this source tree. check_test.cpp shows that each rule notices what
// breaks it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>

#include "house/check.h"
#include "house/documents.h"
#include "house/measure.h"
#include "house/prose.h"
#include "support/written_table.h"

namespace {

constexpr int longest_file = 500;     // lines
constexpr int longest_shader = 300;   // lines; a shader is one step
constexpr int longest_function = 80;  // lines
constexpr int most_columns = 110;     // as .clang-format has it
constexpr int has_steps = 20;         // lines from which a function should show its steps as paragraphs
constexpr int longest_sentence = 25;  // words, of documents, helps and messages
constexpr int long_sentence = 30;     // words, of comments and of other Markdown
// Of comments: sentences whose subject is a clause, and sentences over 30 words. Both may fall.
constexpr std::size_t most_clauses = 0, most_long_comments = 45;
// Of README.md and docs/, without docs/notes; of docs/notes.
constexpr std::size_t most_document_bytes = 170'000, most_note_bytes = 30'000;
// Sentences of more words in ARCHITECTURE.md, CHANGELOG.md and below src/. It may fall.
constexpr int long_sentences_elsewhere = 49;

const std::vector<house::SourceFile>& tree() {
  static const auto files = house::read_tree(DERMIS_SOURCE_DIR);
  return files;
}

const std::vector<house::Dependencies>& dependencies() {
  static const auto all = [] {
    std::ifstream in(DERMIS_HOUSE_FILE);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    return house::read_dependencies(text, house::rooms_of(tree()));
  }();
  return all;
}

void expect_none(const house::Violations& violations) {
  for (const std::string& violation : violations) ADD_FAILURE() << violation;
}

TEST(House, IncludesGoAlongTheDependencies) {
  ASSERT_FALSE(dependencies().empty()) << DERMIS_HOUSE_FILE << " is written when CMake configures";
  const house::Rules rules = house::close_over(dependencies());
  expect_none(house::check_includes(tree(), rules));
  expect_none(house::check_rules(rules));
}

TEST(House, ArchitectureShowsTheDependencies) {
  dermis::tests::expect_table("ARCHITECTURE.md", "dependencies", "build/release/tests/house/test_house",
                              house::dependency_table(dependencies()));
}

TEST(House, GpuAndFrameKnowNothingOfSkin) { expect_none(house::check_words(tree())); }

TEST(House, NamespacesAreRooms) { expect_none(house::check_namespaces(tree())); }

TEST(House, EveryFileNamesItsLicence) { expect_none(house::check_licence(tree())); }

TEST(House, NoPathOfAMachine) { expect_none(house::check_machine_paths(tree())); }

TEST(House, DocumentsNameWhatIsThere) { expect_none(house::check_document_paths(tree())); }

TEST(House, SentencesOfDocumentsAreShort) {
  expect_none(house::check_sentences(tree(), longest_sentence));
  EXPECT_LE(house::count_long_sentences_elsewhere(tree(), long_sentence), long_sentences_elsewhere);
}

TEST(House, TextsOfProgramsArePlain) { expect_none(house::check_texts(tree(), longest_sentence)); }

TEST(House, CommentsArePlain) {
  const house::HardComments hard = house::hard_comments(tree(), long_sentence);
  std::printf("comments: %zu sentences begin with a clause, %zu have over %d words\n", hard.clauses.size(),
              hard.longs.size(), long_sentence);
  const auto print = [](const std::vector<house::Found>& found) {
    for (std::size_t i = 0; i < std::min<std::size_t>(found.size(), 20); ++i)
      std::printf("  %s:%zu: %s\n", found[i].path.c_str(), found[i].sentence.line,
                  found[i].sentence.text.c_str());
  };
  print(hard.clauses);
  print(hard.longs);
  EXPECT_LE(hard.clauses.size(), most_clauses);
  EXPECT_LE(hard.longs.size(), most_long_comments);
}

TEST(House, DocumentsNameNoCommit) { expect_none(house::check_commits(tree())); }

TEST(House, LinksOfDocumentsLeadSomewhere) { expect_none(house::check_links(tree(), DERMIS_SOURCE_DIR)); }

TEST(House, DocumentsAreShort) {
  const house::DocumentBytes bytes = house::bytes_of_documents(tree());
  std::printf("documents: %zu bytes, notes: %zu\n", bytes.documents, bytes.notes);
  EXPECT_GT(bytes.documents, 0u);
  EXPECT_LE(bytes.documents, most_document_bytes);
  EXPECT_LE(bytes.notes, most_note_bytes);
}

TEST(House, TheLibraryNamesNoOption) { expect_none(house::check_option_names(tree())); }

TEST(House, TheViewerRendersNothingAndRepeatsNoSetting) { expect_none(house::check_viewer(tree())); }

TEST(House, LinesAreNarrow) { expect_none(house::check_columns(tree(), most_columns)); }

TEST(House, FilesAndFunctionsAreShort) {
  const auto files = house::file_lengths(tree());
  const auto functions = house::function_lengths(tree());
  std::fputs(house::table("longest files (lines)", files, 10).c_str(), stdout);
  std::fputs(house::table("longest functions (lines)", functions, 10).c_str(), stdout);
  std::printf(
      "median: file %d lines, function %d; of functions of %d lines or more %.0f %% have no blank line\n",
      house::median(files), house::median(functions), has_steps,
      100 * house::share_without_blank_line(functions, has_steps));
  ASSERT_FALSE(files.empty());
  ASSERT_FALSE(functions.empty());
  for (const house::Length& file : files) {
    const int limit = house::is_shader(file.where) ? longest_shader : longest_file;
    EXPECT_LE(file.lines, limit) << file.where;
  }
  for (const house::Length& function : functions)
    EXPECT_LE(function.lines, longest_function) << function.where;
}

}  // namespace
