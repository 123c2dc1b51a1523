// SPDX-License-Identifier: MIT
#include "base/core/warnings.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "support/log_lines.h"

namespace dermis {
namespace {

void warn_of_hole(int i) {
  const std::string name = "sock " + std::to_string(i);
  warn_of("a hole", name, "'" + name + "' has a hole");
}

TEST(Warnings, OneThingIsSaidAsItIs) {
  tests::LogLines said;
  warn_of_hole(7);
  {
    const WarningGroup group;
    warn_of_hole(8);
  }
  EXPECT_EQ(said.all, (std::vector<std::string>{"'sock 7' has a hole", "'sock 8' has a hole"}));
}

TEST(Warnings, ManyOfAKindAreOneLineWithTheFirstThree) {
  tests::LogLines said;
  {
    const WarningGroup outer;
    for (int i = 0; i < 500; ++i) {
      const WarningGroup inner;
      warn_of_hole(i);
    }
    warn_of("a stain", "shirt", "'shirt' has a stain");
    EXPECT_TRUE(said.all.empty());
  }
  EXPECT_EQ(said.all,
            (std::vector<std::string>{"a hole: 500 of them: 'sock 0', 'sock 1', 'sock 2' and 497 more",
                                      "'shirt' has a stain"}));
}

TEST(Warnings, EachNameIsSaidOnce) {
  tests::LogLines said;
  {
    const WarningGroup group;
    for (int i = 0; i < 5; ++i) warn_of_hole(i / 3);
  }
  {
    const WarningGroup group;
    for (int i = 0; i < 10; ++i) warn_of_hole(i / 2);
  }
  EXPECT_EQ(said.all,
            (std::vector<std::string>{"a hole: 5 of them: 'sock 0', 'sock 1'",
                                      "a hole: 10 of them: 'sock 0', 'sock 1', 'sock 2' and 4 more"}));
}

TEST(Warnings, AnErrorIsNotPrecededByThem) {
  tests::LogLines said;
  try {
    const WarningGroup group;
    warn_of_hole(1);
    throw std::runtime_error("torn");
  } catch (const std::runtime_error&) {}
  EXPECT_TRUE(said.all.empty());
  warn_of_hole(2);
  EXPECT_EQ(said.all.size(), 1u);
}

}  // namespace
}  // namespace dermis
