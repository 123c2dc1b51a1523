// SPDX-License-Identifier: MIT
// Runs the program as a user would: arguments in, exit status, standard output and standard error out. Every
// test has an empty folder.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/files.h"

namespace dermis::tests {

using Arguments = std::vector<std::string>;

struct Result {
  int status = -1;  ///< 128 + number if a signal ended it
  std::string out, err;
};

struct Surroundings {
  std::vector<std::string> variables;     ///< "NAME=value", on top of those of the test
  std::uint64_t address_space_bytes = 0;  ///< 0: no limit
  std::uint64_t file_bytes = 0;           ///< no file becomes longer, as on a full disk; 0: no limit
  double kill_after_s = 0;                ///< 0: only the limit of a test, 300 s
  double interrupt_after_s = 0;           ///< Ctrl-C after so long; 0: none
  std::string interrupt_after_text;       ///< Ctrl-C once standard output holds this; empty: none
};

class Program : public testing::Test {
 protected:
  Result run(const Arguments& arguments, const Surroundings& surroundings = {}) const;
  /// `render` to picture(), small unless the arguments say how large.
  Result render(const Arguments& arguments, const Surroundings& surroundings = {}) const;

  std::filesystem::path folder() const { return folder_.path(); }
  std::filesystem::path picture() const { return folder() / "picture.png"; }
  /// Writes a file into folder() and returns its name.
  std::string file(const std::string& name, const std::string& content) const;

  /// Exit status 1, one line that begins with "dermis: " and holds `says`, nothing on standard output, no
  /// picture, nothing left behind.
  void expect_refused(const Result& result, const std::string& says) const;
  /// Exit status 2 and a message that holds `says`.
  void expect_not_understood(const Result& result, const std::string& says) const;
  /// Exit status 0 and a picture. Returns whether it was so.
  bool expect_rendered(const Result& result) const;

 private:
  TempFolder folder_;
};

}  // namespace dermis::tests
