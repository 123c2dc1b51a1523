// SPDX-License-Identifier: MIT
// Files on disk: whole or not there.
#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <functional>

#include "base/core/error.h"
#include "base/core/file.h"
#include "pictures.h"

namespace dermis::image::test {
namespace {

namespace fs = std::filesystem;

class Files : public ::testing::Test {
 protected:
  Files() : folder_(fs::temp_directory_path() / fmt::format("dermis_image_{}", ::getpid())) {
    fs::create_directory(folder_);
  }
  ~Files() override { fs::remove_all(folder_); }

  std::size_t count() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  static std::string error_of(const std::function<void()>& action) {
    try {
      action();
    } catch (const InputError& error) { return error.what(); }
    return "no error";
  }

  fs::path folder_;
  Image8 map_{.width = 3, .height = 2, .rgba = noise(24, 1)};
  ImageF sky_{.width = 2, .height = 1, .channels = 3, .values = {1, 2, 3, 4, 5, 6}};
};

TEST_F(Files, SavedAndLoaded) {
  save_png(folder_ / "map.png", map_, true);
  save_exr(folder_ / "sky.exr", sky_);
  save_exr(folder_ / "sky half.exr", sky_, true);
  EXPECT_EQ(load_image8(folder_ / "map.png").rgba, map_.rgba);
  EXPECT_EQ(load_image_f(folder_ / "sky.exr").values, sky_.values);
  EXPECT_EQ(load_image_f(folder_ / "sky half.exr").values, sky_.values);
  EXPECT_EQ(count(), 3u) << "no temporary file may stay";
}

TEST_F(Files, TwoRunsWriteTheSameBytes) {
  for (const char* name : {"a", "b"}) {
    save_png(folder_ / fmt::format("{}.png", name), map_);
    save_exr(folder_ / fmt::format("{}.exr", name), sky_);
  }
  EXPECT_EQ(read_file(folder_ / "a.png"), read_file(folder_ / "b.png"));
  EXPECT_EQ(read_file(folder_ / "a.exr"), read_file(folder_ / "b.exr"));
}

TEST_F(Files, AMissingFolderLeavesNothing) {
  const fs::path gone = folder_ / "gone";
  for (const std::string& error : {error_of([&] { save_png(gone / "map.png", map_); }),
                                   error_of([&] { save_exr(gone / "sky.exr", sky_); })}) {
    EXPECT_NE(error.find("does not exist"), std::string::npos) << error;
  }
  EXPECT_EQ(count(), 0u);
}

TEST_F(Files, AFolderInTheWayIsAnErrorAndStays) {
  fs::create_directory(folder_ / "map.png");
  EXPECT_NE(error_of([&] { save_png(folder_ / "map.png", map_); }).find("is a directory"), std::string::npos);
  EXPECT_EQ(count(), 1u);
}

TEST_F(Files, OverwritingReplacesTheWholeFile) {
  save_png(folder_ / "map.png", {.width = 64, .height = 64, .rgba = noise(64 * 64 * 4, 2)});
  save_png(folder_ / "map.png", map_, true);
  EXPECT_EQ(load_image8(folder_ / "map.png").rgba, map_.rgba);
}

TEST_F(Files, APipeIsWrittenToAndStays) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  write_file(pipe, std::string_view("light"));
  char read[8] = {};
  EXPECT_EQ(::read(reader, read, sizeof read), 5);
  ::close(reader);
  EXPECT_EQ(std::string(read), "light");
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_EQ(count(), 1u);
}

TEST_F(Files, AFullDeviceIsAnErrorAndStays) {
  if (!fs::is_character_file("/dev/full")) GTEST_SKIP() << "no /dev/full";
  EXPECT_NE(error_of([] {
              write_file("/dev/full", std::string_view("light"));
            }).find("/dev/full: cannot be written"),
            std::string::npos);
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(Files, ErrorsNameTheFile) {
  const std::string path = (folder_ / "none.png").string();
  EXPECT_EQ(error_of([&] { load_image8(path); }), path + ": no such file");
  EXPECT_EQ(error_of([&] { load_image_f(folder_); }).find(folder_.string()), 0u);
  write_file(folder_ / "empty.png", std::string_view());
  EXPECT_NE(error_of([&] { load_image8(folder_ / "empty.png"); }).find("is empty"), std::string::npos);
}

}  // namespace
}  // namespace dermis::image::test
