// SPDX-License-Identifier: MIT
#include "base/settings/check.h"

#include <fmt/ranges.h>

#include <cmath>

#include "base/core/error.h"
#include "base/settings/comparison_fields.h"
#include "base/settings/fields.h"
#include "base/settings/names.h"
#include "base/settings/profile_fields.h"

namespace dermis {
namespace {

struct Checker {
  template <class Value>
  void operator()(const std::string& path, const About& about, const Value& value, std::string_view) const {
    check(path, about, value);
  }

 private:
  template <class Value>
  static void check(const std::string& path, const About& about, const Value& value) {
    if constexpr (std::is_enum_v<Value>) {
      // A number that was made an enumeration need not be one of its values.
      if (static_cast<std::size_t>(value) >= names_of<Value>.size())
        throw input_error("", "{} must be one of: {}", path, fmt::join(names_of<Value>, ", "));
    } else if constexpr (std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>) {
      check_number(path, about, static_cast<double>(value));
    }
  }

  template <class Value>
  static void check(const std::string& path, const About& about, const std::optional<Value>& value) {
    if (value) check(path, about, *value);
  }

  template <std::size_t size>
  static void check(const std::string& path, const About& about, const std::array<double, size>& values) {
    for (const double value : values) check(path, about, value);
  }

  static void check(const std::string&, const About&, const std::vector<std::string>&) {}

  static void check(const std::string& path, const About& about, const std::vector<PlacedLight>& lights) {
    if (static_cast<double>(lights.size()) > about.most)
      throw input_error("", "{} must be at most {}, got {}", path, about.most, lights.size());
    for (std::size_t i = 0; i < lights.size(); ++i)
      for_each_setting(lights[i], Checker{}, fmt::format("{}[{}]", path, i));
  }
};

}  // namespace

void check_ranges(const RenderSettings& settings) { for_each_setting(settings, Checker{}); }
void check_ranges(const SceneOptions& options) { for_each_setting(options, Checker{}); }
void check_ranges(const ReferenceSettings& settings) { for_each_setting(settings, Checker{}); }
void check_ranges(const SceneComparisonSettings& settings) { for_each_setting(settings, Checker{}); }

void check_ranges(const ProfileOptions& options) { for_each_setting(options, Checker{}); }
void check_ranges(const Coefficients& coefficients) { for_each_setting(coefficients, Checker{}); }
void check_ranges(const SpectralSkin& skin, const std::string& where) {
  for_each_setting(skin, [&](const std::string& path, const About& about, double value, std::string_view) {
    check_number(path, about, value, where);
  });
}

void check_number(const std::string& name, const About& about, double number, const std::string& where) {
  const bool in_range = about.open ? number > about.least && number < about.most
                                   : number >= about.least && number <= about.most;
  if (in_range) return;
  // Counts with all their digits.
  const bool whole = number == std::trunc(number) && std::abs(number) < 1e18;
  const std::string got = whole ? fmt::format("{:.0f}", number) : fmt::format("{:.10g}", number);
  throw input_error(where, "{} must be {}, got {}", name, range_text(about), got);
}

std::string range_text(const About& about) {
  if (!std::isfinite(about.least) || !std::isfinite(about.most)) return "";
  if (about.open) return fmt::format("above {:.10g} and below {:.10g}", about.least, about.most);
  return fmt::format("{:.10g} to {:.10g}{}{}", about.least, about.most, about.unit.empty() ? "" : " ",
                     about.unit);
}

}  // namespace dermis
