// SPDX-License-Identifier: MIT
// Every setting has a row, and docs/settings.md is what the rows say.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "base/settings/check.h"
#include "base/settings/fields.h"
#include "base/settings/json.h"
#include "base/settings/names.h"
#include "base/settings/profile_fields.h"
#include "base/settings/scene_fields.h"
#include "dermis/error.h"
#include "support/written_table.h"

namespace dermis {
namespace {

/// What a value may be: a range with its unit, or names, in capitals what else.
template <class Value>
std::string range_of(const About& about, const Value& value) {
  if constexpr (is_optional<Value>) {
    return range_of(about, typename Value::value_type{});
  } else if constexpr (std::is_enum_v<Value>) {
    std::string names;
    for (const std::string_view name : names_of<Value>)
      names += fmt::format("{}{}", names.empty() ? "" : ", ", name);
    return names;
  } else if constexpr (std::is_same_v<Value, bool>) {
    return value || !value ? "true, false" : "";
  }
  if (!about.values.empty()) {
    std::string values;
    for (const char c : about.values) values += c == '|' ? std::string(", ") : std::string(1, c);
    return values;
  }
  const std::string range = range_text(about);
  return range.empty() ? std::string(about.unit) : range;
}

std::string default_of(const nlohmann::ordered_json& defaults, const std::string& path, const About& about) {
  nlohmann::json::json_pointer pointer;
  for (std::size_t from = 0; from <= path.size();) {
    const std::size_t to = std::min(path.find('.', from), path.size());
    pointer /= path.substr(from, to - from);
    from = to + 1;
  }

  const nlohmann::ordered_json& value =
      defaults.at(nlohmann::ordered_json::json_pointer(pointer.to_string()));
  const bool empty = value.is_null() || value == "" || (value.is_array() && value.empty());
  if (empty) return about.none.empty() ? "none" : std::string(about.none);
  return value.is_string() ? value.get<std::string>() : value.dump();
}

/// The settings of a structure; `parent` is its section in a file of settings.
template <class Settings>
std::string table(const std::string& parent = "") {
  const Settings settings;
  const nlohmann::ordered_json defaults = json_of(settings);
  static constexpr bool has_plan = std::is_same_v<Settings, RenderSettings>;
  static constexpr bool has_options = !std::is_same_v<Settings, Light>;
  std::string text = has_options ? "| setting | what it is | values | default | option |"
                                 : "| member | what it is | values | default |\n|---|---|---|---|\n";
  if (has_options)
    text += has_plan ? " new plan |\n|---|---|---|---|---|---|\n" : "\n|---|---|---|---|---|\n";

  for_each_setting(
      settings, [&](const std::string& path, const About& about, const auto& value, std::string_view) {
        const std::string option = about.option.empty() ? "" : fmt::format("`--{}`", about.option);
        text += fmt::format("| `{}` | {} | {} | {} |", path_of(parent, path), about.help,
                            range_of(about, value), default_of(defaults, path, about));
        if (has_options) text += fmt::format(" {} |", option);
        text += has_plan ? fmt::format(" {} |\n", about.rebuilds ? "yes" : "") : "\n";
      });
  return text;
}

void expect_in_docs(const std::string& name, const std::string& text) {
  tests::expect_table("docs/settings.md", name, "build/release/tests/unit/settings/test_settings", text);
}

TEST(Settings, TheDocsShowTheRows) {
  expect_in_docs("settings", table<RenderSettings>());
  expect_in_docs("scene", table<SceneOptions>("scene"));
  expect_in_docs("reference", table<ReferenceSettings>("reference"));
  expect_in_docs("profile", table<ProfileOptions>());
  expect_in_docs("spectral skin", table<SpectralSkin>());
  expect_in_docs("coefficients", table<Coefficients>());
  tests::expect_table("docs/scenes.md", "lights", "build/release/tests/unit/settings/test_settings",
                      table<Light>());
}

template <class Settings>
std::size_t expect_whole_rows() {
  const Settings settings;
  std::set<std::string> paths;
  for_each_setting(settings, [&](const std::string& path, const About& about, const auto&, std::string_view) {
    EXPECT_TRUE(paths.insert(path).second) << path;
    EXPECT_FALSE(about.help.empty()) << path;
    EXPECT_LE(about.least, about.most) << path;
    EXPECT_EQ(std::isfinite(about.least), std::isfinite(about.most)) << path << " is bounded on one side";
  });
  return paths.size();
}

TEST(Settings, HaveHelpAndAPathOfTheirOwn) {
  EXPECT_GT(expect_whole_rows<RenderSettings>(), 30u);
  EXPECT_GE(expect_whole_rows<SceneOptions>(), 3u);
  EXPECT_GE(expect_whole_rows<ReferenceSettings>(), 6u);
  EXPECT_EQ(expect_whole_rows<ProfileOptions>(), 5u);
  EXPECT_EQ(expect_whole_rows<SpectralSkin>(), 5u);
  EXPECT_EQ(expect_whole_rows<Coefficients>(), 4u);
}

/// Sets a number just outside its range, and expects an error that names it.
template <class Settings>
struct ExpectRefused {
  Settings& settings;

  template <class Value>
  void operator()(const std::string& path, const About& about, Value& value, std::string_view) const {
    if constexpr (std::is_same_v<Value, std::array<double, 3>>) {
      for (double& channel : value) (*this)(path, about, channel, {});
    } else if constexpr (is_optional<Value>) {
      value.emplace();
      (*this)(path, about, *value, {});
      value.reset();
    } else if constexpr (std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>) {
      const Value before = value;
      for (const double bad : {about.least - 1, about.most + 1}) {
        if (!std::isfinite(bad) || bad > static_cast<double>(std::numeric_limits<Value>::max())) continue;
        value = static_cast<Value>(bad);
        expect_error(path);
      }
      value = before;
    }
  }

  void expect_error(const std::string& path) const {
    try {
      check_ranges(settings);
      ADD_FAILURE() << path << " is taken whatever it is";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(path), std::string::npos) << error.what();
    }
  }
};

template <class Settings>
void expect_ranges_hold() {
  Settings settings;
  EXPECT_NO_THROW(check_ranges(settings));
  for_each_setting(settings, ExpectRefused<Settings>{settings});
}

TEST(Settings, OutOfRangeAreRefusedByName) {
  expect_ranges_hold<RenderSettings>();
  expect_ranges_hold<SceneOptions>();
  expect_ranges_hold<ReferenceSettings>();
  expect_ranges_hold<ProfileOptions>();
  expect_ranges_hold<SpectralSkin>();
  expect_ranges_hold<Coefficients>();
}

}  // namespace
}  // namespace dermis
