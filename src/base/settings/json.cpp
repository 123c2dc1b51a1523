// SPDX-License-Identifier: MIT
#include "base/settings/json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/core/known_names.h"
#include "base/core/log.h"
#include "base/json/document.h"
#include "base/settings/fields.h"
#include "base/settings/names.h"
#include "base/settings/profile_fields.h"
#include "base/settings/scene_fields.h"

namespace dermis {
namespace {

using nlohmann::ordered_json;

template <class Settings>
ordered_json object_of(const Settings& settings);

template <class Value>
ordered_json json_value(const Value& value) {
  if constexpr (has_fields<Value>)
    return object_of(value);
  else if constexpr (is_optional<Value>)
    return value ? json_value(*value) : ordered_json(nullptr);
  else if constexpr (std::is_enum_v<Value>)
    return name_of(value);
  else
    return value;
}

ordered_json json_value(const std::vector<PlacedLight>& lights) {
  ordered_json out = ordered_json::array();
  for (const PlacedLight& light : lights) out.push_back(object_of(light));
  return out;
}

// One text as programs before 0.3 read it, and as their records have it.
ordered_json json_value(const std::vector<std::string>& texts) {
  if (texts.empty()) return "";
  if (texts.size() == 1) return texts.front();
  return ordered_json(texts);
}

template <class Settings>
ordered_json object_of(const Settings& settings) {
  ordered_json out = ordered_json::object();
  std::apply(
      [&](const auto&... field) {
        ((out[std::string(field.name)] = json_value(settings.*field.member)), ...);
      },
      fields_of<Settings>);
  return out;
}

template <class Settings>
std::vector<std::string_view> keys_of() {
  return std::apply([](const auto&... field) { return std::vector<std::string_view>{field.name...}; },
                    fields_of<Settings>);
}

template <class Settings>
void read_object(const json::Value& json, Settings& into);

template <class Value>
void read(const json::Value& json, const About& about, Value& into) {
  if constexpr (has_fields<Value>)
    read_object(json, into);
  else if constexpr (std::is_enum_v<Value>) {
    const auto found = std::find(names_of<Value>.begin(), names_of<Value>.end(), json.text());
    if (found == names_of<Value>.end()) json.fail("{}", unknown_name(json.text(), names_of<Value>));
    into = static_cast<Value>(found - names_of<Value>.begin());
  } else if constexpr (std::is_same_v<Value, bool>)
    into = json.boolean();
  else if constexpr (std::is_same_v<Value, int>)
    into = static_cast<int>(
        json.count(static_cast<std::uint64_t>(about.least), static_cast<std::uint64_t>(about.most)));
  else if constexpr (std::is_same_v<Value, std::uint64_t>)
    into = std::isfinite(about.most)
               ? json.count(static_cast<std::uint64_t>(about.least), static_cast<std::uint64_t>(about.most))
               : json.whole();
  else if constexpr (std::is_same_v<Value, double>)
    into = json.number(about.least, about.most);
  else
    into = json.text();
}

template <std::size_t count>
void read(const json::Value& json, const About& about, std::array<double, count>& into) {
  json.array_size(count, count);
  for (std::size_t i = 0; i < count; ++i) read(json.element(i), about, into[i]);
}

template <class Value>
void read(const json::Value& json, const About& about, std::optional<Value>& into) {
  into.reset();
  if (!json.is_null()) read(json, about, into.emplace());
}

void read(const json::Value& json, const About& about, std::vector<PlacedLight>& into) {
  into.resize(json.array_size(0, static_cast<std::size_t>(about.most)));
  for (std::size_t i = 0; i < into.size(); ++i) read_object(json.element(i), into[i] = {});
}

void read(const json::Value& json, const About&, std::vector<std::string>& into) {
  into.clear();
  if (json.is_text()) {
    if (!json.text().empty()) into.push_back(json.text());
    return;
  }
  for (std::size_t i = 0; i < json.array_size(0); ++i) into.push_back(json.element(i).text());
}

// Returns the keys of `json` that nothing reads any more, each with a warning that says what to use.
template <class Settings>
Keys gone_keys(const json::Value& json) {
  Keys keys;
  for (const Gone& gone : gone_from<Settings>) {
    const auto value = json.find(std::string(gone.name));
    const bool whole = gone.value.empty();
    if (!value || !(whole || (value->is_text() && value->text() == gone.value))) continue;
    warn("{}: {}: {} left out: {}", value->file(), value->place(),
         whole ? "is" : fmt::format("'{}' is", gone.value), gone.instead);
    keys.push_back(gone.name);
  }
  return keys;
}

template <class Settings>
void read_object_with(const json::Value& json, const Keys& others, Settings& into) {
  json.object();
  const Keys own = keys_of<Settings>(), gone = gone_keys<Settings>(json);
  Keys known = others;
  known.insert(known.end(), own.begin(), own.end());
  known.insert(known.end(), gone.begin(), gone.end());
  json.only_keys(known);

  const auto one = [&](const auto& field) {
    const auto value = json.find(std::string(field.name));
    if (value && std::ranges::find(gone, field.name) == gone.end())
      read(*value, field.about, into.*field.member);
  };
  std::apply([&](const auto&... field) { (one(field), ...); }, fields_of<Settings>);
}

template <class Settings>
void read_object(const json::Value& json, Settings& into) {
  read_object_with(json, {}, into);
}

}  // namespace

ordered_json json_of(const RenderSettings& settings) { return object_of(settings); }
ordered_json json_of(const SceneOptions& options) { return object_of(options); }
ordered_json json_of(const ReferenceSettings& settings) { return object_of(settings); }

ordered_json json_of(const SettingsFile& settings) {
  ordered_json out = object_of(settings.render);
  out["scene"] = object_of(settings.scene);
  if (settings.reference) out["reference"] = object_of(*settings.reference);
  return out;
}

ordered_json json_of(const ProfileOptions& options) { return object_of(options); }
ordered_json json_of(const Coefficients& coefficients) { return object_of(coefficients); }
ordered_json json_of(const SpectralSkin& skin) { return object_of(skin); }
ordered_json json_of(const Instance& instance) { return object_of(instance); }
ordered_json json_of(const Light& light) { return object_of(light); }

void read_json(const json::Value& object, const Keys& others, RenderSettings& into) {
  read_object_with(object, others, into);
}
void read_json(const json::Value& object, const Keys& others, SceneOptions& into) {
  read_object_with(object, others, into);
}
void read_json(const json::Value& object, const Keys& others, ReferenceSettings& into) {
  read_object_with(object, others, into);
}
void read_json(const json::Value& object, const Keys& others, ProfileOptions& into) {
  read_object_with(object, others, into);
}
void read_json(const json::Value& object, const Keys& others, SpectralSkin& into) {
  read_object_with(object, others, into);
}
void read_json(const json::Value& object, const Keys& others, Instance& into) {
  read_object_with(object, others, into);
}
void read_json(const json::Value& object, const Keys& others, Light& into) {
  read_object_with(object, others, into);
}

std::string to_json(const SettingsFile& settings) {
  // Names of files need not be UTF-8.
  return json_of(settings).dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

namespace {

void read_file(const json::Value& root, SettingsFile& settings) {
  read_object_with(root, {"scene", "reference"}, settings.render);
  if (const auto scene = root.find("scene")) read_object(*scene, settings.scene);
  if (const auto reference = root.find("reference")) {
    if (!settings.reference) settings.reference.emplace();
    read_object(*reference, *settings.reference);
  }
}

}  // namespace

void load_settings(const std::filesystem::path& path, SettingsFile& settings) {
  read_file(json::load(path, 1 << 20).root(), settings);
}

void load_setting(std::string_view assignment, std::string_view where, SettingsFile& settings) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos)
    throw input_error(std::string(where), "expected NAME=VALUE, got '{}'", assignment);
  const auto quoted = [](std::string_view text) {
    return ordered_json(text).dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  };
  const std::string_view value = assignment.substr(equals + 1);
  std::string text = ordered_json::accept(value) ? std::string(value) : quoted(value);
  for (std::string_view path = assignment.substr(0, equals);;) {
    const std::size_t dot = path.rfind('.');
    text = "{" + quoted(path.substr(dot + 1)) + ":" + text + "}";  // without a dot: all of it
    if (dot == std::string_view::npos) break;
    path = path.substr(0, dot);
  }
  read_file(json::Document(text, std::string(where)).root(), settings);
}

}  // namespace dermis
