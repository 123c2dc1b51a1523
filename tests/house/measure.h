// SPDX-License-Identifier: MIT
// Lengths of files and functions.
#pragma once

#include <string>
#include <vector>

#include "house/check.h"

namespace house {

struct Length {
  std::string where;  ///< path, or path:line and the first line of the function
  int lines = 0;
  int blank = 0;  ///< of those
};

/// All code files, longest first.
std::vector<Length> file_lengths(const std::vector<SourceFile>& tree);

/// Functions and test cases that start in the first column, longest first. As clang-format lays code out,
/// such a function opens on a line that ends in '{' and closes at the next '}' in the first column; members
/// written inside their class are not seen.
std::vector<Length> function_lengths(const std::vector<SourceFile>& tree);

/// Of the functions of so many lines or more, the share that has no blank line between its steps, 0..1.
double share_without_blank_line(const std::vector<Length>& functions, int least_lines);

/// The middle one of `lengths`, longest first; 0 of none.
int median(const std::vector<Length>& lengths);

/// Lines of code, scripts and CMake files that have more columns than that: "path:line: 123 columns".
Violations check_columns(const std::vector<SourceFile>& tree, int most);

/// The first n as a table.
std::string table(const std::string& title, const std::vector<Length>& lengths, std::size_t n);

}  // namespace house
