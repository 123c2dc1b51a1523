// SPDX-License-Identifier: MIT
// Kept files: damage is noticed, the folder stays within its limit, several processes may share it.
#include "base/core/cache.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>

#include "base/core/error.h"
#include "base/core/file.h"
#include "support/full_disk.h"
#include "support/log_lines.h"

namespace dermis::cache {
namespace {

namespace fs = std::filesystem;

std::vector<std::byte> bytes_of(std::size_t count, int seed) {
  std::vector<std::byte> bytes(count);
  for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<std::byte>((i * 31 + seed) & 255);
  return bytes;
}

constexpr std::uint64_t most = 1 << 24;
constexpr std::uint64_t seal = 26;  // bytes of the line with the checksum

class Cache : public testing::Test {
 protected:
  void SetUp() override {
    const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    folder_ = fs::path(testing::TempDir()) / fmt::format("dermis_cache_{}_{}", name, ::getpid());
    fs::remove_all(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path file(int number) const { return folder_ / fmt::format("occlusion-{}.bin", number); }
  void age(const fs::path& path, int hours) const {
    fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::hours(hours));
  }

  fs::path folder_;
  tests::LogLines said_;
};

TEST_F(Cache, GivesBackWhatItKeeps) {
  EXPECT_FALSE(read(file(1), most));
  for (const std::size_t size : {0, 1, 1000}) {
    write(file(1), bytes_of(size, 3));
    EXPECT_EQ(read(file(1), most), bytes_of(size, 3));
  }
  EXPECT_FALSE(read(file(1), 999)) << "more than the reader wants";
  EXPECT_FALSE(read({}, most));
  write({}, bytes_of(10, 0));
  EXPECT_TRUE(said_.notes.empty() && said_.warnings.empty());
}

TEST_F(Cache, EveryDamagedByteIsNoticed) {
  const std::vector<std::byte> content = bytes_of(40, 5);
  write(file(1), content);
  std::vector<char> whole(content.size() + seal);
  std::ifstream(file(1), std::ios::binary).read(whole.data(), static_cast<std::streamsize>(whole.size()));
  const auto expect_noticed = [&](const std::vector<char>& bytes) {
    std::ofstream(file(1), std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    said_.notes.clear();
    EXPECT_FALSE(read(file(1), most));
    ASSERT_EQ(said_.notes.size(), 1u);
    EXPECT_NE(said_.notes[0].find("occlusion-1.bin: damaged"), std::string::npos);
  };

  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::vector<char> bytes = whole;
    bytes[i] ^= 1;
    expect_noticed(bytes);
  }
  for (std::size_t size = 0; size < whole.size(); ++size)
    expect_noticed({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)});
  whole.push_back('\n');
  expect_noticed(whole);
}

TEST_F(Cache, WhatWasNotUsedForLongestGoesFirst) {
  constexpr std::uint64_t limit = 3 * (1000 + seal);
  for (int i = 0; i < 3; ++i) {
    write(file(i), bytes_of(1000, i), limit);
    age(file(i), 10 - i);
  }
  EXPECT_TRUE(read(file(0), most)) << "and is the youngest now";
  write(file(3), bytes_of(1000, 3), limit);
  EXPECT_TRUE(fs::exists(file(0)));
  EXPECT_FALSE(fs::exists(file(1)));
  EXPECT_TRUE(fs::exists(file(2)));
  EXPECT_TRUE(fs::exists(file(3)));

  write(file(3), bytes_of(1000, 4), limit);
  EXPECT_EQ(usage(folder_)[0].files, 3u) << "a file that is replaced needs no further room";
  write(file(4), bytes_of(3000, 4), limit);
  EXPECT_EQ(usage(folder_)[0].files, 1u);
  write(file(5), bytes_of(4000, 5), limit);
  EXPECT_FALSE(fs::exists(file(5))) << "larger than the limit";
  EXPECT_TRUE(fs::exists(file(4)));
}

TEST_F(Cache, CountsAndClearsItsOwnFilesAlone) {
  write(file(1), bytes_of(10, 0));
  write(folder_ / "monte-carlo-0.txt", bytes_of(20, 0));
  write(folder_ / "pipelines.bin", bytes_of(30, 0));
  write(folder_ / "built-in-0.bin", bytes_of(40, 0));
  for (const char* name : {"occlusion-2.bin.99.0.part", "letter.txt", "occlusions", "pipelines"})
    std::ofstream(folder_ / name) << "12345";
  fs::create_directories(folder_ / "occlusion-3.bin");

  const std::vector<Usage> before = usage(folder_), gone = clear(folder_);
  ASSERT_EQ(before.size(), 5u);
  for (const std::vector<Usage>& sums : {before, gone})
    for (std::size_t i = 0; i < 5; ++i) {
      EXPECT_EQ(sums[i].files, 1u) << sums[i].kind;
      EXPECT_EQ(sums[i].bytes, i < 4 ? 10 * (i + 1) + seal : 5) << sums[i].kind;
    }
  for (const Usage& left : usage(folder_)) EXPECT_EQ(left.files, 0u) << left.kind;
  for (const char* name : {"letter.txt", "occlusions", "pipelines", "occlusion-3.bin"})
    EXPECT_TRUE(fs::exists(folder_ / name)) << name;
  EXPECT_EQ(clear(folder_ / "nowhere")[0].files, 0u);
}

TEST_F(Cache, WhatAnEndedRunLeftGoesAfterAnHour) {
  fs::create_directories(folder_);
  const fs::path old = folder_ / "occlusion-7.bin.99.0.part", young = folder_ / "occlusion-8.bin.99.0.part";
  for (const fs::path& part : {old, young}) std::ofstream(part) << "half";
  age(old, 2);
  write(file(1), bytes_of(10, 0));
  EXPECT_FALSE(fs::exists(old));
  EXPECT_TRUE(fs::exists(young)) << "its writer may be at work";
}

TEST_F(Cache, AFolderThatCannotBeWrittenIsAWarning) {
  fs::create_directories(folder_);
  std::ofstream(folder_ / "deep") << "a file where the folder should be";
  write(folder_ / "deep" / "occlusion-1.bin", bytes_of(10, 0));
  EXPECT_FALSE(read(folder_ / "deep" / "occlusion-1.bin", most));
  ASSERT_EQ(said_.warnings.size(), 1u);
  EXPECT_NE(said_.warnings[0].find("not kept for the next run"), std::string::npos);
}

TEST_F(Cache, AFullDiskIsOneWarningAndLeavesNothing) {
  EXPECT_TRUE(write(file(1), bytes_of(1000, 1)));
  {
    const tests::FullDisk full;
    EXPECT_FALSE(write(file(1), bytes_of(2000, 2)));
    EXPECT_FALSE(write(folder_ / "monte-carlo-0.txt", bytes_of(2000, 2)));
    EXPECT_FALSE(write(folder_ / "pipelines.bin", bytes_of(100'000, 2)));
  }
  ASSERT_EQ(said_.warnings.size(), 1u) << "one for this call, whatever else cannot be written";
  EXPECT_NE(said_.warnings[0].find("not kept for the next run"), std::string::npos) << said_.warnings[0];

  EXPECT_EQ(read(file(1), most), bytes_of(1000, 1)) << "what was there stays whole";
  EXPECT_FALSE(fs::exists(folder_ / "monte-carlo-0.txt"));
  EXPECT_FALSE(fs::exists(folder_ / "pipelines.bin"));
  EXPECT_EQ(usage(folder_).back().files, 0u) << "something half-written is left";
  EXPECT_TRUE(write(file(1), bytes_of(2000, 2))) << "there is room again";
}

// A device tells of a full disk when its buffer is flushed.
TEST_F(Cache, WhatDoesNotFitOnADeviceIsAnError) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  EXPECT_THROW(write_file("/dev/full", bytes_of(10, 0)), InputError);
}

TEST_F(Cache, FolderAndLimitComeFromTheEnvironment) {
  const auto set = [](const char* name, const char* value) {
    value ? ::setenv(name, value, 1) : ::unsetenv(name);
  };
  const char* const names[] = {"XDG_CACHE_HOME", "HOME", "DERMIS_CACHE_LIMIT"};
  std::vector<std::optional<std::string>> former;
  for (const char* name : names) {
    const char* value = std::getenv(name);
    former.push_back(value ? std::optional<std::string>(value) : std::nullopt);
  }

  set(names[0], "/a"), set(names[1], "/b"), set(names[2], "5");
  EXPECT_EQ(default_folder(), "/a/dermis");
  EXPECT_EQ(limit_bytes(), 5'000'000u);
  set(names[0], nullptr), set(names[2], nullptr);
  EXPECT_EQ(default_folder(), "/b/.cache/dermis");
  EXPECT_EQ(limit_bytes(), 1'000'000'000u);
  set(names[1], nullptr), set(names[2], "much");
  EXPECT_EQ(default_folder(), "");
  EXPECT_EQ(limit_bytes(), 1'000'000'000u);
  EXPECT_EQ(said_.warnings.size(), 1u);

  for (std::size_t i = 0; i < 3; ++i) set(names[i], former[i] ? former[i]->c_str() : nullptr);
}

// One process writes two files in turns into a folder that holds but one, while this one reads both: each is
// whole or not there, and no damage is ever seen.
TEST_F(Cache, ReadersSeeWholeFilesWhileAnotherProcessWritesAndEvicts) {
  constexpr std::size_t size = 300'000;
  const std::vector<std::byte> contents[] = {bytes_of(size, 0), bytes_of(size / 2, 1)};
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    for (int i = 0; i < 200; ++i) write(file(i % 2), contents[i % 2], size + seal);
    ::_exit(0);
  }

  int whole = 0, status = 0;
  while (::waitpid(child, &status, WNOHANG) == 0)
    for (const int i : {0, 1})
      if (const auto found = read(file(i), most)) {
        EXPECT_EQ(*found, contents[i]);
        ++whole;
      }
  EXPECT_EQ(status, 0);
  EXPECT_TRUE(read(file(1), most));
  EXPECT_TRUE(said_.notes.empty()) << said_.notes.front();
  EXPECT_EQ(usage(folder_).back().files, 0u);
  RecordProperty("whole", whole);
}

}  // namespace
}  // namespace dermis::cache
