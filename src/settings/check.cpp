// SPDX-License-Identifier: MIT
#include "settings/check.h"

#include <cmath>

#include "core/error.h"
#include "settings/fields.h"
#include "settings/names.h"

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
      const auto number = static_cast<double>(value);
      if (!(number >= about.least && number <= about.most))
        throw input_error("", "{} must be {}, got {:.10g}", path, range_text(about), number);
    }
  }

  template <class Value>
  static void check(const std::string& path, const About& about, const std::optional<Value>& value) {
    if (value) check(path, about, *value);
  }

  static void check(const std::string& path, const About& about, const std::array<double, 2>& values) {
    for (const double value : values) check(path, about, value);
  }

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

std::string range_text(const About& about) {
  if (!std::isfinite(about.least) || !std::isfinite(about.most)) return "";
  return fmt::format("{:.10g} to {:.10g}{}{}", about.least, about.most, about.unit.empty() ? "" : " ",
                     about.unit);
}

}  // namespace dermis
