// SPDX-License-Identifier: MIT
#include "house/measure.h"

#include <fmt/format.h>

#include <algorithm>

namespace house {

namespace {

std::vector<Length> longest_first(std::vector<Length> lengths) {
  std::stable_sort(lengths.begin(), lengths.end(),
                   [](const Length& a, const Length& b) { return a.lines > b.lines; });
  return lengths;
}

bool starts_with_any(std::string_view line, std::initializer_list<std::string_view> words) {
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view word) { return line.starts_with(word); });
}

/// A line in the first column that may begin a declaration.
bool begins_declaration(const std::string& line) {
  return !line.empty() && !starts_with_any(line, {" ", "}", "#", "//", "/*"});
}

bool is_no_function(const std::string& line) {
  // A table: what is assigned before any parameter is data.
  const std::size_t assigned = line.find(" = ");
  if (assigned != std::string::npos && assigned < line.find('(')) return true;
  return starts_with_any(line, {"namespace", "struct", "class", "enum", "union", "layout", "extern \"C\""});
}

void add_functions(const SourceFile& file, std::vector<Length>& lengths) {
  std::size_t begin = 0;
  bool inside = false;
  bool has_parameters = false;

  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    const std::string& line = file.lines[i];
    if (inside) {
      if (!line.starts_with('}')) continue;
      inside = false;
      const auto first = file.lines.begin() + static_cast<std::ptrdiff_t>(begin);
      const auto blank = std::count(first, file.lines.begin() + static_cast<std::ptrdiff_t>(i), "");
      lengths.push_back({fmt::format("{}:{} {}", file.path, begin + 1, file.lines[begin].substr(0, 90)),
                         static_cast<int>(i - begin + 1), static_cast<int>(blank)});
      continue;
    }

    if (begins_declaration(line)) {
      begin = i;
      has_parameters = false;
    }

    has_parameters = has_parameters || line.find('(') != std::string::npos;
    inside = line.ends_with('{') && has_parameters && !is_no_function(file.lines[begin]);
  }
}

}  // namespace

std::vector<Length> file_lengths(const std::vector<SourceFile>& tree) {
  std::vector<Length> lengths;
  for (const SourceFile& file : tree) {
    if (!is_code(file.path)) continue;
    const auto blank = std::count(file.lines.begin(), file.lines.end(), "");
    lengths.push_back({file.path, static_cast<int>(file.lines.size()), static_cast<int>(blank)});
  }
  return longest_first(std::move(lengths));
}

std::vector<Length> function_lengths(const std::vector<SourceFile>& tree) {
  std::vector<Length> lengths;
  for (const SourceFile& file : tree) {
    if (is_code(file.path)) add_functions(file, lengths);
  }
  return longest_first(std::move(lengths));
}

double share_without_blank_line(const std::vector<Length>& functions, int least_lines) {
  int all = 0, without = 0;
  for (const Length& function : functions) {
    if (function.lines < least_lines) continue;
    ++all;
    if (function.blank == 0) ++without;
  }
  return all == 0 ? 0 : double{1} * without / all;
}

int median(const std::vector<Length>& lengths) {
  return lengths.empty() ? 0 : lengths[lengths.size() / 2].lines;
}

Violations check_columns(const std::vector<SourceFile>& tree, int most) {
  // A character of UTF-8 is one column: its further bytes begin with the bits 10.
  const auto is_column = [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; };

  Violations violations;
  for (const SourceFile& file : tree) {
    if (!is_code(file.path) && !is_script(file.path)) continue;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      const auto columns = std::count_if(file.lines[i].begin(), file.lines[i].end(), is_column);
      if (columns > most) violations.push_back(fmt::format("{}:{}: {} columns", file.path, i + 1, columns));
    }
  }
  return violations;
}

std::string table(const std::string& title, const std::vector<Length>& lengths, std::size_t n) {
  std::string text = title + "\n";
  for (std::size_t i = 0; i < std::min(n, lengths.size()); ++i)
    text += fmt::format("{:6} {}\n", lengths[i].lines, lengths[i].where);
  return text;
}

}  // namespace house
