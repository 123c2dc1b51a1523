// SPDX-License-Identifier: MIT
#include "arguments.h"

#include <charconv>
#include <string_view>

namespace host {

std::optional<Arguments> read_arguments(std::span<char*> words) {
  Arguments read;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string_view word = words[i];
    const std::string_view value = i + 1 < words.size() ? words[i + 1] : "";
    if (word == "--validate") {
      read.validate = true;
    } else if (word == "--linear" && !value.empty()) {
      read.linear = words[++i];
    } else if (word == "--frames") {
      const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), read.frames);
      if (error != std::errc() || end != value.data() + value.size()) return {};
      if (read.frames < 1 || read.frames > 1'000'000) return {};
      ++i;
    } else if (read.picture.empty() && !word.empty() && word.front() != '-') {
      read.picture = word;
    } else {
      return {};
    }
  }
  if (read.picture.empty()) return {};
  return read;
}

}  // namespace host
