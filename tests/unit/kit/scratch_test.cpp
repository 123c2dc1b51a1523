// SPDX-License-Identifier: MIT
// What a run needs is gone after it, also after one that was killed.
#include "kit/scratch.h"

#include <gtest/gtest.h>

#include <optional>

#include "dermis/error.h"
#include "support/files.h"

namespace dermis::kit {
namespace {

namespace fs = std::filesystem;

TEST(Scratch, IsGoneAfterwards) {
  const tests::TempFolder folder;
  const fs::path results = folder.path() / "deep" / "results";
  fs::path where;
  {
    const Scratch scratch(results);
    where = scratch.path();
    EXPECT_EQ(where.parent_path(), results);
    tests::write_text(where / "left.txt", "left");
  }
  EXPECT_FALSE(fs::exists(where));
  EXPECT_TRUE(fs::is_empty(results));
}

TEST(Scratch, OfAKilledRunIsRemovedAndThatOfARunningOneStays) {
  const tests::TempFolder folder;
  const fs::path killed = folder.path() / ".kit-killed", foreign = folder.path() / ".kit-without-lock";
  fs::create_directories(killed / "cache");
  tests::write_text(killed / "lock", "");
  fs::create_directories(foreign);

  std::optional<Scratch> running(folder.path());
  EXPECT_FALSE(fs::exists(killed));
  EXPECT_TRUE(fs::exists(foreign)) << "nothing says that it is ours";
  const Scratch second(folder.path());
  EXPECT_TRUE(fs::exists(running->path()));
  EXPECT_NE(running->path(), second.path());
}

TEST(Scratch, SaysWhereItCannotBe) {
  const tests::TempFolder folder;
  tests::write_text(folder.path() / "file", "");
  try {
    const Scratch scratch(folder.path() / "file" / "results");
    FAIL() << "a file is no folder";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("file/results: cannot be made"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace dermis::kit
