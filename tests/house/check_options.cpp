// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cctype>

#include "house/check.h"

namespace house {
namespace {

/// The parts of a line of C++ that are string literals. `raw_end` is what ends the raw literal that the line
/// begins in, or empty, and is left as the next line needs it.
std::vector<std::string> literals_of(std::string_view line, std::string& raw_end) {
  std::vector<std::string> found;
  std::size_t at = 0;
  while (at < line.size()) {
    if (!raw_end.empty()) {
      const std::size_t end = line.find(raw_end, at);
      found.emplace_back(line.substr(at, end == std::string_view::npos ? end : end - at));
      if (end == std::string_view::npos) return found;
      at = end + raw_end.size();
      raw_end.clear();
      continue;
    }

    const std::string_view rest = line.substr(at);
    if (rest.starts_with("//")) return found;
    if (rest.starts_with("'\"'") || rest.starts_with("'\\\"'")) {
      at += rest[1] == '"' ? 3 : 4;
    } else if (rest.starts_with("R\"") && rest.find('(') != std::string_view::npos) {
      const std::size_t open = rest.find('(');
      raw_end = ")" + std::string(rest.substr(2, open - 2)) + "\"";
      at += open + 1;
    } else if (rest[0] == '"') {
      std::size_t end = at + 1;
      while (end < line.size() && line[end] != '"') end += line[end] == '\\' ? 2 : 1;
      found.emplace_back(line.substr(at + 1, end - at - 1));
      at = end + 1;
    } else {
      ++at;
    }
  }
  return found;
}

/// "--size" in any text; nothing where none is.
std::string option_in(const std::string& text) {
  for (std::size_t at = text.find("--"); at != std::string::npos; at = text.find("--", at + 1)) {
    const bool begins =
        at == 0 || (text[at - 1] != '-' && std::isalnum(static_cast<unsigned char>(text[at - 1])) == 0);
    std::size_t end = at + 2;
    while (end < text.size() &&
           (std::islower(static_cast<unsigned char>(text[end])) != 0 || text[end] == '-'))
      ++end;
    if (begins && end > at + 2 && text[at + 2] != '-') return text.substr(at, end - at);
  }
  return {};
}

}  // namespace

Violations check_option_names(const std::vector<SourceFile>& tree) {
  Violations found;
  for (const SourceFile& file : tree) {
    const bool of_library = file.path.starts_with("src/") || file.path.starts_with("include/");
    if (!of_library || !is_code(file.path) || file.path.starts_with("src/tools/report/")) continue;
    std::string raw_end;
    for (std::size_t i = 0; i < file.lines.size(); ++i)
      for (const std::string& literal : literals_of(file.lines[i], raw_end))
        if (const std::string option = option_in(literal); !option.empty())
          found.push_back(fmt::format("{}:{}: the option '{}' in a text of the library: name the setting",
                                      file.path, i + 1, option));
  }
  return found;
}

}  // namespace house
