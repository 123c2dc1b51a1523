// SPDX-License-Identifier: MIT
// kit_checks is many tests in one program, and the kit names them by filters.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <string>

#include "base/core/file.h"
#include "kit/child.h"
#include "kit/plan.h"

namespace dermis::kit {
namespace {

/// Returns the lines of --gtest_list_tests: suites, and below each its cases, indented.
std::vector<std::string> list(const std::string& program, const std::string& filter = "*") {
  const std::atomic<bool> never{false};
  const Ended ended =
      run({.words = {program, "--gtest_list_tests", "--gtest_filter=" + filter}, .folder = "/"}, never);
  EXPECT_TRUE(ended.ok()) << program << ": " << ended.why();
  std::vector<std::string> lines;
  for (std::size_t from = 0, end; from < ended.out.size(); from = end + 1) {
    end = std::min(ended.out.find('\n', from), ended.out.size());
    lines.push_back(ended.out.substr(from, end - from));
  }
  return lines;
}

bool is_case(const std::string& line) { return line.starts_with("  "); }

TEST(KitChecks, EveryInvariantHasCases) {
  for (const Extent extent : {Extent::smoke, Extent::quick, Extent::full})
    for (const Invariant& invariant : invariants(extent)) {
      // Each part of a filter: one that has lost its test would not be missed among others.
      const std::string& filter = invariant.filter;
      for (std::size_t from = 0, end; from < filter.size(); from = end + 1) {
        end = std::min(filter.find(':', from), filter.size());
        const std::string part = filter.substr(from, end - from);
        const std::vector<std::string> lines = list(KIT_CHECKS, part);
        EXPECT_TRUE(std::ranges::any_of(lines, is_case)) << invariant.name << ": nothing is called " << part;
      }
    }
}

// GoogleTest ends cases of two suites of one name as failures, and only when they run.
TEST(KitChecks, NoTwoProgramsHaveASuiteOfOneName) {
  std::map<std::string, std::string> program_of;
  std::ifstream programs(KIT_SUITES);
  std::size_t cases = 0;
  for (std::string program; std::getline(programs, program);)
    for (const std::string& line : list(program)) {
      if (is_case(line)) {
        ++cases;
        continue;
      }
      if (!line.ends_with(".")) continue;
      const auto [known, is_new] = program_of.emplace(line, program);
      EXPECT_TRUE(is_new || known->second == program)
          << line << " is in " << known->second << " and " << program;
    }
  EXPECT_GT(program_of.size(), 30u);
  const std::vector<std::string> all = list(KIT_CHECKS);
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count_if(all, is_case)), cases);
}

}  // namespace
}  // namespace dermis::kit
