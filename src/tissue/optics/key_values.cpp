// SPDX-License-Identifier: MIT
#include "tissue/optics/key_values.h"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <string_view>
#include <vector>

#include "base/core/error.h"
#include "base/core/known_names.h"

namespace dermis::optics {
namespace {

double parse_number(std::string_view text, const std::string& where) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    throw input_error(where, "'{}' is not a number", text);
  return value + 0.0;  // -0 becomes 0: its inverse must not be -inf
}

Rgb parse_triple(const std::string& text, const std::string& where) {
  std::vector<double> values;
  std::size_t begin = 0;
  while (true) {
    const std::size_t comma = text.find(',', begin);
    values.push_back(parse_number(
        std::string_view(text).substr(begin, comma == std::string::npos ? comma : comma - begin), where));
    if (comma == std::string::npos || values.size() > 3) break;
    begin = comma + 1;
  }
  if (values.size() == 1) return {values[0], values[0], values[0]};
  if (values.size() != 3) throw input_error(where, "expected one number or three (R,G,B), got '{}'", text);
  return {values[0], values[1], values[2]};
}

}  // namespace

std::map<std::string, Rgb> parse_key_values(const std::string& text, std::initializer_list<const char*> known,
                                            const std::string& where) {
  std::map<std::string, Rgb> values;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos)
      throw input_error(where, "expected KEY=VALUE, got '{}'; {}", word, listed_names(word, known));
    const std::string key = word.substr(0, equals);
    if (std::find(known.begin(), known.end(), key) == known.end())
      throw input_error(where, "unknown key '{}'; {}", key, listed_names(key, known));
    if (!values.emplace(key, parse_triple(word.substr(equals + 1), where + ": " + key)).second)
      throw input_error(where, "'{}' is given twice", key);
  }
  return values;
}

}  // namespace dermis::optics
