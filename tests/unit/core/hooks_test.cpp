// SPDX-License-Identifier: MIT
// Each call has its own log and progress, whichever thread works for it, and can be ended.
#include "base/core/hooks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "base/core/log.h"
#include "base/core/parallel.h"
#include "support/log_lines.h"
#include "support/thrown.h"

namespace dermis {
namespace {

TEST(Hooks, WorkersSpeakForTheCallThatTheyHelp) {
  tests::LogLines said;
  parallel_for(100, [](std::size_t i) { warn("{}", i); });
  EXPECT_EQ(said.warnings.size(), 100u);
}

TEST(Hooks, TwoThreadsHaveTheirOwn) {
  std::vector<std::string> of_first, of_second;
  const auto work = [](std::vector<std::string>& lines, const char* text) {
    const HookScope scope(Hooks{.log = [&](LogLevel, const std::string& line) { lines.push_back(line); }});
    for (int round = 0; round < 20; ++round) parallel_for(8, [&](std::size_t) { note("{}", text); });
  };
  {
    const std::jthread first(work, std::ref(of_first), "first");
    const std::jthread second(work, std::ref(of_second), "second");
  }
  EXPECT_EQ(of_first, std::vector<std::string>(160, "first"));
  EXPECT_EQ(of_second, std::vector<std::string>(160, "second"));
}

TEST(Hooks, AMemberThatIsEmptyIsThatOfTheEnclosingCall) {
  tests::LogLines outer;
  {
    const HookScope inner(Hooks{.progress = [](const WorkProgress&) { return true; }});
    note("to the outer log");
  }
  {
    tests::LogLines inner;
    note("to the inner log");
    EXPECT_EQ(inner.notes.size(), 1u);
  }
  EXPECT_EQ(outer.notes, std::vector<std::string>{"to the outer log"});
}

TEST(Hooks, ALogThatThrowsEndsNothing) {
  const HookScope scope(Hooks{.log = [](LogLevel, const std::string&) { throw std::runtime_error("full"); }});
  EXPECT_NO_THROW(note("lost"));
}

// With workers of its own, which must not wait for the hook that waits for them, and must not be heard by it.
TEST(Hooks, AHookMayCallTheLibrary) {
  std::vector<std::string> lines, of_the_hook;
  int told = 0;
  const auto call_again = [&] {
    const HookScope own(
        Hooks{.log = [&](LogLevel, const std::string& line) { of_the_hook.push_back(line); }});
    Steps steps("loading", 8);
    parallel_for(8, [&](std::size_t) {
      note("again");
      steps.done();
    });
  };
  Hooks hooks;
  hooks.log = [&](LogLevel, const std::string& line) {
    lines.push_back(line);
    call_again();
  };
  hooks.progress = [&](const WorkProgress&) {
    ++told;
    call_again();
    return true;
  };

  const HookScope scope(hooks);
  note("once");
  Steps("work", 1).done();
  EXPECT_EQ(lines, std::vector<std::string>{"once"});
  EXPECT_EQ(told, 1);
  EXPECT_EQ(of_the_hook, std::vector<std::string>(16, "again"));
}

class Progress : public testing::Test {
 protected:
  Hooks hooks_{.progress = [this](const WorkProgress& work) {
    names_.push_back(work.what);
    shares_.push_back(work.share);
    return true;
  }};
  std::vector<std::string> names_;
  std::vector<double> shares_;
};

TEST_F(Progress, RisesToOneOverParallelSteps) {
  const HookScope scope(hooks_);
  Steps steps("baking", 50);
  parallel_for(50, [&](std::size_t) { steps.done(); });
  ASSERT_EQ(shares_.size(), 50u);
  EXPECT_TRUE(std::is_sorted(shares_.begin(), shares_.end()));
  EXPECT_EQ(shares_.back(), 1);
}

TEST_F(Progress, StepsWithinAStepAreSharesOfIt) {
  const HookScope scope(hooks_);
  Steps heads("heads", 2);
  for (int head = 0; head < 2; ++head) {
    Steps rows("rows", 4);
    for (int row = 0; row < 4; ++row) rows.done();
    heads.done();
  }
  EXPECT_EQ(names_, std::vector<std::string>(10, "heads"));
  EXPECT_EQ(shares_, (std::vector<double>{.125, .25, .375, .5, .5, .625, .75, .875, 1, 1}));
}

TEST_F(Progress, StepsMayBeSharesOfSeveralOuterOnes) {
  const HookScope scope(hooks_);
  Steps passes("passes", 10);
  {
    Steps rows("rows", 4, 8);
    for (int row = 0; row < 4; ++row) rows.done();
  }
  passes.done(8);
  {
    Steps rows("rows", 2, 8);  // two are left
    rows.done(2);
  }
  passes.done(8);
  ASSERT_EQ(shares_.size(), 7u);
  const std::vector<double> expected{.2, .4, .6, .8, .8, 1, 1};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(shares_[i], expected[i], 1e-12);
}

TEST_F(Progress, NeverFallsWhereOuterStepsAreParallel) {
  const HookScope scope(hooks_);
  Steps heads("heads", 16);
  parallel_for(16, [&](std::size_t) {
    Steps rows("rows", 8);
    for (int row = 0; row < 8; ++row) rows.done();
    heads.done();
  });
  EXPECT_TRUE(std::is_sorted(shares_.begin(), shares_.end()));
  EXPECT_EQ(shares_.back(), 1);
}

TEST(Cancelling, ByAProgressThatSaysNo) {
  std::atomic<int> begun{0};
  const HookScope scope(Hooks{.progress = [](const WorkProgress& work) { return work.share < 0.5; }});
  const std::string said = tests::thrown<Cancelled>([&] {
    Steps steps("baking", 1000);
    parallel_for(1000, [&](std::size_t) {
      ++begun;
      steps.done();
    });
  });
  EXPECT_EQ(said, "stopped: baking");
  // The step that was refused, and what other threads had begun by then.
  EXPECT_LE(begun, 500 + static_cast<int>(std::thread::hardware_concurrency()));
  EXPECT_THROW(Steps("next", 1), Cancelled) << "the call is over";
}

TEST(Cancelling, ByAFlagWhereNothingIsCounted) {
  std::atomic<bool> stop{false};
  const HookScope scope(Hooks{.stop = &stop});
  EXPECT_THROW(parallel_for(1000, [&](std::size_t i) { stop = stop || i > 10; }), Cancelled);
}

TEST(Cancelling, AnExceptionOfTheHookReachesTheCaller) {
  const HookScope scope(
      Hooks{.progress = [](const WorkProgress&) -> bool { throw std::domain_error("of the host"); }});
  Steps steps("baking", 4);
  EXPECT_THROW(parallel_for(4, [&](std::size_t) { steps.done(); }), std::domain_error);
}

TEST(Cancelling, AnotherThreadGoesOn) {
  std::atomic<bool> stop{true};
  const HookScope scope(Hooks{.stop = &stop});
  std::atomic<int> done{0};
  std::jthread([&] { parallel_for(3, [&](std::size_t) { ++done; }); }).join();
  EXPECT_GT(done, 0);
}

}  // namespace
}  // namespace dermis
