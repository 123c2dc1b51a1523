// SPDX-License-Identifier: MIT
// Each kind of failure ends in one line and its own exit status.
#include "cli/failure.h"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>
#include <string>

#include "base/core/assert.h"
#include "base/core/error.h"
#include "dermis/hooks.h"

namespace dermis::cli {
namespace {

struct Ending {
  int status = 0;
  std::string said;
};

// Ends a program whose command throws.
template <class Work>
Ending ending_of(const Work& work) {
  const CLI::App app{"test"};
  testing::internal::CaptureStderr();
  Ending ending;
  try {
    work();
  } catch (...) { ending.status = report_failure(app); }
  ending.said = testing::internal::GetCapturedStderr();
  return ending;
}

TEST(Failure, AMistakeOfOursHasAStatusOfItsOwnAndBothValues) {
  const Ending ending = ending_of([] { DERMIS_ASSERT_EQ(1 + 1, 3); });
  EXPECT_EQ(ending.status, 70);
  EXPECT_NE(ending.said.find("dermis: internal error: 1 + 1 == 3: 2 vs 3 ("), std::string::npos)
      << ending.said;
}

TEST(Failure, BadInputIsOneLineWhateverItQuotes) {
  const Ending ending = ending_of([] { throw input_error("head\n.glb", "cannot be read"); });
  EXPECT_EQ(ending.status, 1);
  EXPECT_EQ(ending.said, "dermis: head .glb: cannot be read\n");
}

TEST(Failure, OthersAreFailuresToo) {
  EXPECT_EQ(ending_of([] { throw DeviceError("no driver"); }).status, 1);
  EXPECT_EQ(ending_of([] { throw Cancelled("stopped"); }).status, 1);
  EXPECT_EQ(ending_of([] { throw std::bad_alloc(); }).said, "dermis: too little memory\n");
  EXPECT_EQ(ending_of([] { throw CLI::ExtrasError({"--unknown"}); }).status, 2);
}

// The word that nothing takes is the reason, also where something else is missing because of it.
TEST(Failure, AnUnknownOptionIsNamedBeforeAMissingOne) {
  CLI::App app{"test"};
  double value = 0;
  CLI::App* command = app.add_subcommand("draw", "");
  command->add_option("--output", value)->required();
  command->add_option("--opacity", value)->group("");
  for (const auto& [line, says] : std::initializer_list<std::pair<const char*, const char*>>{
           {"draw --ouput 3", "dermis: draw: there is no option '--ouput'; did you mean '--output'?\n"},
           {"draw --opacit 3", "dermis: draw: there is no option '--opacit'; --help-all shows all\n"},
           {"drwa", "dermis: there is no command 'drwa'; there are: draw; did you mean 'draw'?\n"}}) {
    testing::internal::CaptureStderr();
    int status = 0;
    try {
      app.parse(line);
    } catch (...) { status = report_failure(app); }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), says);
    EXPECT_EQ(status, 2);
  }
}

}  // namespace
}  // namespace dermis::cli
