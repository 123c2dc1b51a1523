// SPDX-License-Identifier: MIT
// Programs that the kit starts: how they end is told apart, and none outlives its time.
#include "kit/child.h"

#include <gtest/gtest.h>

#include <thread>

namespace dermis::kit {
namespace {

const std::atomic<bool> never{false};

Ended shell(const std::string& script, double most_seconds = 60, const std::atomic<bool>& stop = never) {
  return run({.words = {"/bin/sh", "-c", script}, .folder = "/", .most_seconds = most_seconds}, stop);
}

TEST(Child, BothStreamsAndTheStatusComeBack) {
  const Ended ended = shell("echo out; echo first >&2; echo 'the reason' >&2; exit 3");
  EXPECT_EQ(ended.status, 3);
  EXPECT_FALSE(ended.ok());
  EXPECT_EQ(ended.out, "out\n");
  EXPECT_EQ(ended.err, "first\nthe reason\n");
  EXPECT_EQ(ended.why(), "the reason");
  EXPECT_GT(ended.peak_mb, 0.1);
}

TEST(Child, WithoutAWordTheStatusIsTheReason) {
  EXPECT_EQ(shell("exit 4").why(), "exit status 4");
  EXPECT_TRUE(shell("exit 0").ok());
  EXPECT_EQ(shell("exit 0").why(), "");
}

TEST(Child, ASignalIsNamed) {
  const Ended ended = shell("kill -SEGV $$");
  EXPECT_EQ(ended.signal, SIGSEGV);
  EXPECT_FALSE(ended.ok());
  EXPECT_NE(ended.why().find("signal 11"), std::string::npos) << ended.why();
}

TEST(Child, AProgramThatIsNotThereSaysSo) {
  const Ended ended = run({.words = {"bin/none"}, .folder = "/"}, never);
  EXPECT_EQ(ended.status, 127);
  EXPECT_NE(ended.why().find("bin/none: No such file"), std::string::npos) << ended.why();
}

TEST(Child, VariablesAndFolderAreThoseAsked) {
  const Ended ended = run({.words = {"/bin/sh", "-c", "echo $KIT_TEST; pwd"},
                           .folder = "/tmp",
                           .variables = {{"KIT_TEST", "as asked"}}},
                          never);
  EXPECT_EQ(ended.out, "as asked\n/tmp\n");
}

TEST(Child, WhatTakesTooLongIsEndedWithAllThatItStarted) {
  const Ended ended = shell("sleep 1000 & sleep 1000; exit 0", 0.2);
  EXPECT_TRUE(ended.timed_out);
  EXPECT_FALSE(ended.ok());
  EXPECT_LT(ended.seconds, grace_seconds);
  EXPECT_NE(ended.why().find("too long"), std::string::npos);
}

TEST(Child, AStopEndsItAndLetsItFinishInOrder) {
  std::atomic<bool> stop{false};
  std::thread later([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    stop = true;
  });
  const Ended ended = shell("trap 'echo in order; exit 0' TERM; while :; do sleep 0.05; done", 60, stop);
  later.join();
  EXPECT_TRUE(ended.stopped);
  EXPECT_FALSE(ended.ok());
  EXPECT_EQ(ended.out, "in order\n");
}

TEST(Child, MoreThanAMebibyteIsReadAndDropped) {
  const Ended ended = shell("i=0; while [ $i -lt 300 ]; do printf '%8192d' 1; i=$((i+1)); done");
  EXPECT_TRUE(ended.ok());
  EXPECT_EQ(ended.out.size(), std::size_t{1} << 20);
}

TEST(Child, WordsAreQuotedAsAShellTakesThem) {
  const std::vector<std::string> words{"printf", "%s|", "plain", "two words", "it's", "", "$HOME"};
  EXPECT_EQ(shell(quoted(words)).out, "plain|two words|it's||$HOME|");
}

}  // namespace
}  // namespace dermis::kit
