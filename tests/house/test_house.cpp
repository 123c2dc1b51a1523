// SPDX-License-Identifier: MIT
// The rules of the house, held against this source tree. test_check.cpp shows that each rule notices what breaks it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <iterator>

#include "house/check.h"
#include "house/measure.h"

namespace {

constexpr int longest_file = 500;     // lines
constexpr int longest_shader = 200;   // lines; a shader is one step
constexpr int longest_function = 80;  // lines

const std::vector<house::SourceFile>& tree() {
  static const auto files = house::read_tree(DERMIS_SOURCE_DIR);
  return files;
}

house::Rules rules() {
  std::ifstream in(DERMIS_HOUSE_FILE);
  EXPECT_TRUE(in) << DERMIS_HOUSE_FILE << " is written when CMake configures";
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  return house::read_rules(text, house::rooms_of(tree()));
}

void expect_none(const house::Violations& violations) {
  for (const std::string& violation : violations) ADD_FAILURE() << violation;
}

TEST(House, IncludesGoAlongTheDependencies) {
  const house::Rules allowed = rules();
  ASSERT_TRUE(allowed.contains("core"));
  for (const std::string& room : house::rooms_of(tree())) {
    // A room that so far only holds headers has no target yet; its includes are judged as soon as it has one.
    if (!allowed.contains(room)) std::printf("note: src/%s is no dermis_module\n", room.c_str());
  }
  expect_none(house::check_includes(tree(), allowed));
  expect_none(house::check_rules(allowed));
}

TEST(House, GpuAndFrameKnowNothingOfSkin) { expect_none(house::check_words(tree())); }

TEST(House, EveryFileNamesItsLicence) { expect_none(house::check_licence(tree())); }

TEST(House, NoPathOfAMachine) { expect_none(house::check_machine_paths(tree())); }

TEST(House, FilesAndFunctionsAreShort) {
  const auto files = house::file_lengths(tree());
  const auto functions = house::function_lengths(tree());
  std::fputs(house::table("longest files (lines)", files, 10).c_str(), stdout);
  std::fputs(house::table("longest functions (lines)", functions, 10).c_str(), stdout);
  ASSERT_FALSE(files.empty());
  ASSERT_FALSE(functions.empty());
  for (const house::Length& file : files) {
    const int limit = house::is_shader(file.where) ? longest_shader : longest_file;
    EXPECT_LE(file.lines, limit) << file.where;
  }
  for (const house::Length& function : functions) EXPECT_LE(function.lines, longest_function) << function.where;
}

}  // namespace
