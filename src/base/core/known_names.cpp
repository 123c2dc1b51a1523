// SPDX-License-Identifier: MIT
#include "base/core/known_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "base/core/one_line.h"

namespace dermis {
namespace {

constexpr std::size_t longest_word = 64;    // a longer one is no typing error of a name
constexpr std::size_t least_begin = 3;      // letters of a name that say which is meant
constexpr std::size_t longest_list = 1000;  // bytes: enough to see the names, not a page

// Without what people do not think of as a part of the name.
std::string plain(std::string_view name) {
  name.remove_prefix(std::min(name.find_first_not_of('-'), name.size()));
  std::string text(name);
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (c == '_') c = '-';
  }
  return text;
}

// Letters put in, left out, exchanged, or two neighbours swapped: the restricted Damerau-Levenshtein
// distance.
std::size_t typing_errors(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), now(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;

  for (std::size_t i = 1; i <= a.size(); ++i) {
    now[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t exchanged = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      now[j] = std::min({last[j] + 1, now[j - 1] + 1, exchanged});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) now[j] = std::min(now[j], before[j - 2] + 1);
    }
    before.swap(last);
    last.swap(now);
  }
  return last[b.size()];
}

// A name of a file may hold anything; those with spaces, and empty ones, need marks around them.
std::string shown(std::string_view name) {
  const bool is_word = !name.empty() && name.find_first_of(" ,;'\"") == std::string_view::npos;
  return is_word ? one_line(name, 80) : fmt::format("'{}'", one_line(name, 80));
}

}  // namespace

std::string_view nearest_name(std::string_view word, const KnownNames& names) {
  const std::string given = plain(word.substr(0, longest_word + 1));
  if (given.empty() || given.size() > longest_word) return {};
  const bool is_number = given.find_first_not_of("0123456789.,:x") == std::string::npos;
  if (is_number) return {};

  std::size_t fewest = std::min<std::size_t>((given.size() + 1) / 3, 3);
  std::string_view nearest, begins;
  for (const std::string_view name : names.all()) {
    if (name.size() > longest_word) continue;
    const std::string known = plain(name);

    const std::size_t errors = typing_errors(given, known);
    const bool is_other_name = errors < std::max(given.size(), known.size());
    if (is_other_name && (errors < fewest || (errors == fewest && nearest.empty()))) {
      fewest = errors;
      nearest = name;
    }
    const bool is_begin = given.size() >= least_begin && known.starts_with(given);
    if (is_begin && (begins.empty() || name.size() < begins.size())) begins = name;
  }
  return nearest.empty() ? begins : nearest;
}

std::string did_you_mean(std::string_view word, const KnownNames& names) {
  const std::string_view nearest = nearest_name(word, names);
  return nearest.empty() ? "" : fmt::format("; did you mean '{}'?", one_line(nearest, 80));
}

std::string listed_names(std::string_view word, const KnownNames& names) {
  if (names.all().empty()) return "there are none";
  std::string list;
  std::size_t listed = 0;
  for (const std::string_view name : names.all()) {
    if (list.size() > longest_list) break;
    list += (listed++ == 0 ? "" : ", ") + shown(name);
  }
  if (listed < names.all().size()) list += fmt::format(" and {} more", names.all().size() - listed);
  return "there are: " + list + did_you_mean(word, names);
}

std::string unknown_name(std::string_view word, const KnownNames& names) {
  return fmt::format("'{}' is not known; {}", one_line(word, 200), listed_names(word, names));
}

}  // namespace dermis
