// SPDX-License-Identifier: MIT
/// The settings as data: the rows of which range checks, the command line, JSON and the docs are made.
/// Programs make options, panels or keywords of them. Also settings as JSON text.
///
///   for (const dermis::SettingRow& row : dermis::rows_of(dermis::RenderSettings{}))
///     add(row.option, row.help);
///   dermis::RenderSettings settings;
///   dermis::read_settings(R"({"camera": {"fov_deg": 30}})", settings);
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "dermis/profile.h"
#include "dermis/reference.h"
#include "dermis/scene.h"
#include "dermis/settings.h"

namespace dermis {

struct SettingRow {
  std::string path;    ///< of its value in JSON: "camera.fov_deg"
  std::string option;  ///< on the command line, without dashes; empty: --set alone
  std::string help;    ///< one line
  enum class Kind : std::uint8_t { text, texts, number, whole, boolean, choice, lights } kind{};
  int count = 1;          ///< of numbers: 1, or as many as the array has
  bool optional = false;  ///< null in JSON: it has no value, and `none` holds
  std::string none;
  std::string unit;            ///< of numbers; empty: none
  double least = 0, most = 0;  ///< of numbers; infinite: no bound
  std::string values;          ///< of texts: words, and in capitals what else it may be, '|' between them
  std::vector<std::string> choices;  ///< of a choice
  std::string on, off;               ///< of booleans: their words on the command line; empty: a flag or none
  std::string initial;               ///< the value of the structure given, as JSON
};

std::vector<SettingRow> rows_of(const RenderSettings& settings);
std::vector<SettingRow> rows_of(const SceneOptions& options);
std::vector<SettingRow> rows_of(const ReferenceSettings& settings);
std::vector<SettingRow> rows_of(const ProfileOptions& options);
std::vector<SettingRow> rows_of(const SpectralSkin& skin);

/// Returns an object with all rows: what is read back is equal to the bit.
std::string settings_text(const RenderSettings& settings);
std::string settings_text(const SceneOptions& options);
std::string settings_text(const ReferenceSettings& settings);

/// Read an object; what it does not name stays as it is. Throw InputError, in one line with the place: not
/// JSON, a key that is not known (lists those that are, and the nearest), another type, a value out of range.
/// `settings` are then as before.
void read_settings(std::string_view json, RenderSettings& settings);
void read_settings(std::string_view json, SceneOptions& options);
void read_settings(std::string_view json, ReferenceSettings& settings);
void read_settings(std::string_view json, ProfileOptions& options);
void read_settings(std::string_view json, SpectralSkin& skin);

/// Returns the one of `names` that a word most likely stands for; empty if none is near.
std::string nearest_setting(std::string_view word, const std::vector<std::string>& names);

}  // namespace dermis
