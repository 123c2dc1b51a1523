// SPDX-License-Identifier: MIT
#include "dermis/setting_rows.h"

#include <nlohmann/json.hpp>

#include "base/core/known_names.h"
#include "base/json/document.h"
#include "base/settings/check.h"
#include "base/settings/fields.h"
#include "base/settings/json.h"
#include "base/settings/names.h"
#include "base/settings/profile_fields.h"

namespace dermis {
namespace {

using Kind = SettingRow::Kind;

void describe(SettingRow& row, const std::string&) { row.kind = Kind::text; }
void describe(SettingRow& row, const std::vector<std::string>&) { row.kind = Kind::texts; }
void describe(SettingRow& row, const std::vector<PlacedLight>&) { row.kind = Kind::lights; }
void describe(SettingRow& row, bool) { row.kind = Kind::boolean; }
void describe(SettingRow& row, int) { row.kind = Kind::whole; }
void describe(SettingRow& row, std::uint64_t) { row.kind = Kind::whole; }
void describe(SettingRow& row, double) { row.kind = Kind::number; }

template <class Value>
requires std::is_enum_v<Value>
void describe(SettingRow& row, Value) {
  row.kind = Kind::choice;
  row.choices.assign(names_of<Value>.begin(), names_of<Value>.end());
}

template <std::size_t numbers>
void describe(SettingRow& row, const std::array<double, numbers>&) {
  row.kind = Kind::number;
  row.count = static_cast<int>(numbers);
}

template <class Value>
void describe(SettingRow& row, const std::optional<Value>&) {
  describe(row, Value{});
  row.optional = true;
}

// Names of files need not be UTF-8.
std::string dumped(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

template <class Settings>
std::vector<SettingRow> rows(const Settings& settings) {
  const nlohmann::ordered_json values = json_of(settings);
  std::vector<SettingRow> rows;
  for_each_setting(settings,
                   [&](const std::string& path, const About& about, const auto& value, std::string_view) {
                     SettingRow row{.path = path,
                                    .option = std::string(about.option),
                                    .help = std::string(about.help),
                                    .none = std::string(about.none),
                                    .unit = std::string(about.unit),
                                    .least = about.least,
                                    .most = about.most,
                                    .values = std::string(about.values),
                                    .on = std::string(about.on),
                                    .off = std::string(about.off)};
                     describe(row, value);
                     std::string pointer = "/" + path;
                     for (char& c : pointer)
                       if (c == '.') c = '/';
                     row.initial = dumped(values.at(nlohmann::ordered_json::json_pointer(pointer)));
                     rows.push_back(std::move(row));
                   });
  return rows;
}

template <class Settings>
void read_text(std::string_view json, Settings& settings) {
  const json::Document document(json, "settings");
  Settings read = settings;
  read_json(document.root(), {}, read);
  check_ranges(read);
  settings = std::move(read);
}

}  // namespace

std::vector<SettingRow> rows_of(const RenderSettings& settings) { return rows(settings); }
std::vector<SettingRow> rows_of(const SceneOptions& options) { return rows(options); }
std::vector<SettingRow> rows_of(const ReferenceSettings& settings) { return rows(settings); }
std::vector<SettingRow> rows_of(const ProfileOptions& options) { return rows(options); }
std::vector<SettingRow> rows_of(const SpectralSkin& skin) { return rows(skin); }

std::string settings_text(const RenderSettings& settings) { return dumped(json_of(settings)); }
std::string settings_text(const SceneOptions& options) { return dumped(json_of(options)); }
std::string settings_text(const ReferenceSettings& settings) { return dumped(json_of(settings)); }

void read_settings(std::string_view json, RenderSettings& settings) { read_text(json, settings); }
void read_settings(std::string_view json, SceneOptions& options) { read_text(json, options); }
void read_settings(std::string_view json, ReferenceSettings& settings) { read_text(json, settings); }
void read_settings(std::string_view json, ProfileOptions& options) { read_text(json, options); }
void read_settings(std::string_view json, SpectralSkin& skin) { read_text(json, skin); }

std::string nearest_setting(std::string_view word, const std::vector<std::string>& names) {
  return std::string(nearest_name(word, KnownNames(names)));
}

}  // namespace dermis
