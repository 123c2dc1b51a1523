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
      lengths.push_back({fmt::format("{}:{} {}", file.path, begin + 1, file.lines[begin].substr(0, 90)),
                         static_cast<int>(i - begin + 1)});
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
    if (is_code(file.path)) lengths.push_back({file.path, static_cast<int>(file.lines.size())});
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

std::string table(const std::string& title, const std::vector<Length>& lengths, std::size_t n) {
  std::string text = title + "\n";
  for (std::size_t i = 0; i < std::min(n, lengths.size()); ++i)
    text += fmt::format("{:6} {}\n", lengths[i].lines, lengths[i].where);
  return text;
}

}  // namespace house
