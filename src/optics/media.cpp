// SPDX-License-Identifier: MIT
#include "optics/media.h"

#include <charconv>
#include <cmath>
#include <map>
#include <sstream>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace dermis::optics {
namespace {

constexpr double largest_per_mm = 1e6;  // a mean free path of a nanometre: beyond any tissue, and numbers stay far from overflow
constexpr const char* keys = "sigma_a, sigma_s, g, eta";

double parse_number(std::string_view text, const std::string& where) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) throw input_error(where, "'{}' is not a number", text);
  return value;
}

Rgb parse_triple(const std::string& text, const std::string& where) {
  std::vector<double> values;
  std::size_t begin = 0;
  while (true) {
    const std::size_t comma = text.find(',', begin);
    values.push_back(parse_number(std::string_view(text).substr(begin, comma == std::string::npos ? comma : comma - begin), where));
    if (comma == std::string::npos || values.size() > 3) break;
    begin = comma + 1;
  }
  if (values.size() == 1) return {values[0], values[0], values[0]};
  if (values.size() != 3) throw input_error(where, "expected one number or three (R,G,B), got '{}'", text);
  return {values[0], values[1], values[2]};
}

void check_range(const std::string& where, const char* name, double value, double low, double high, const char* unit) {
  if (!(value >= low && value <= high)) throw input_error(where, "{} must be {} to {}{}, got {}", name, low, high, unit, value);
}

}  // namespace

double Medium::sigma_tr_per_mm() const { return std::sqrt(3 * sigma_a_per_mm * sigma_t_reduced_per_mm()); }

void check(const Medium& medium, const std::string& where) {
  check_range(where, "sigma_a", medium.sigma_a_per_mm, 0, largest_per_mm, " per mm");
  check_range(where, "sigma_s", medium.sigma_s_per_mm, 0, largest_per_mm, " per mm");
  if (!(medium.g > -1 && medium.g < 1)) throw input_error(where, "g must be above -1 and below 1, got {}", medium.g);
  check_range(where, "eta", medium.eta, 1, 3, "");
  if (!(medium.sigma_t_reduced_per_mm() > 0)) throw input_error(where, "sigma_a and sigma_s are both 0: light would pass without a trace");
}

void check(const RgbMedium& medium, const std::string& where) {
  constexpr const char* channel[] = {"red", "green", "blue"};
  for (int c = 0; c < 3; ++c) check(medium[c], where + ": " + channel[c]);
}

RgbMedium parse_coefficients(const std::string& text, const std::string& where) {
  std::map<std::string, Rgb> values;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos) throw input_error(where, "expected KEY=VALUE, got '{}'; keys: {}", word, keys);
    const std::string key = word.substr(0, equals);
    if (key != "sigma_a" && key != "sigma_s" && key != "g" && key != "eta")
      throw input_error(where, "unknown key '{}'; known: {}", key, keys);
    if (!values.emplace(key, parse_triple(word.substr(equals + 1), where + ": " + key)).second)
      throw input_error(where, "'{}' is given twice", key);
  }
  for (const char* key : {"sigma_a", "sigma_s"})
    if (!values.contains(key)) throw input_error(where, "'{}' is missing; write \"sigma_a=R,G,B sigma_s=R,G,B g=0 eta=1.4\", per mm", key);
  RgbMedium medium;
  for (int c = 0; c < 3; ++c) {
    medium[c].sigma_a_per_mm = values["sigma_a"][c];
    medium[c].sigma_s_per_mm = values["sigma_s"][c];
    if (values.contains("g")) medium[c].g = values["g"][c];
    if (values.contains("eta")) medium[c].eta = values["eta"][c];
  }
  check(medium, where);
  return medium;
}

}  // namespace dermis::optics
