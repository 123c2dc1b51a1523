// SPDX-License-Identifier: MIT
#include "gpu/support/failure.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "image/codec.h"

namespace dermis::tests {
namespace {

namespace fs = std::filesystem;

std::string running_test() {
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  return test ? fmt::format("{}.{}", test->test_suite_name(), test->name()) : "no-test";
}

/// Of the same size; the alpha of the difference is 1, or nothing of it would be seen.
image::ImageF difference(const image::ImageF& wanted, const image::ImageF& found) {
  image::ImageF out = found;
  for (std::size_t i = 0; i < out.values.size(); ++i)
    out.values[i] = out.channels == 4 && i % 4 == 3 ? 1.0f : found.values[i] - wanted.values[i];
  return out;
}

}  // namespace

std::string write_failure(const image::ImageF& wanted, const image::ImageF& found, const std::string& name) {
  static int number = 0;
  const fs::path program = fs::read_symlink("/proc/self/exe");
  const fs::path folder = program.parent_path() / "failures";
  fs::create_directories(folder);

  std::string stem = fmt::format("{}-{}", running_test(), name.empty() ? std::to_string(++number) : name);
  std::replace(stem.begin(), stem.end(), '/', '_');
  const auto path = [&](const char* what) {
    return (folder / fmt::format("{}-{}.exr", stem, what)).string();
  };

  image::save_exr(path("wanted"), wanted);
  image::save_exr(path("found"), found);
  const bool same_size = wanted.values.size() == found.values.size() && wanted.width == found.width;
  if (same_size) image::save_exr(path("difference"), difference(wanted, found));

  return fmt::format("written: {}, and beside it found{}\nto repeat: {} '--gtest_filter={}'\n",
                     path("wanted"), same_size ? " and difference" : "", program.string(), running_test());
}

}  // namespace dermis::tests
