// SPDX-License-Identifier: MIT
// Settings as JSON: an object per section, null where a setting has no value.
// Values that are written are read back to the last bit.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/json/value.h"
#include "dermis/profile.h"
#include "dermis/reference.h"
#include "dermis/scene.h"
#include "dermis/settings.h"

namespace dermis {

/// A file of settings: RenderSettings, SceneOptions under "scene", and ReferenceSettings under "reference"
/// for commands that compute ground truth.
struct SettingsFile {
  RenderSettings render;
  SceneOptions scene;
  std::optional<ReferenceSettings> reference;
};

nlohmann::ordered_json json_of(const RenderSettings& settings);
nlohmann::ordered_json json_of(const SceneOptions& options);
nlohmann::ordered_json json_of(const ReferenceSettings& settings);
nlohmann::ordered_json json_of(const SettingsFile& settings);
nlohmann::ordered_json json_of(const ProfileOptions& options);
nlohmann::ordered_json json_of(const Coefficients& coefficients);
nlohmann::ordered_json json_of(const SpectralSkin& skin);
nlohmann::ordered_json json_of(const Instance& instance);  ///< without asset and profile
nlohmann::ordered_json json_of(const Light& light);
std::string to_json(const SettingsFile& settings);

// Read an object; what it does not name stays as it is. InputError: a key that is neither of a row nor among
// `others` (lists those that are known), another type, an option out of its range.
using Keys = std::vector<std::string_view>;
void read_json(const json::Value& object, const Keys& others, RenderSettings& into);
void read_json(const json::Value& object, const Keys& others, SceneOptions& into);
void read_json(const json::Value& object, const Keys& others, ReferenceSettings& into);
void read_json(const json::Value& object, const Keys& others, ProfileOptions& into);
void read_json(const json::Value& object, const Keys& others, SpectralSkin& into);
void read_json(const json::Value& object, const Keys& others, Instance& into);
void read_json(const json::Value& object, const Keys& others, Light& into);

/// Reads a file of at most 1 MiB into `settings`; what it does not name stays as it is. InputError names file
/// and setting: a key that is not known (lists those that are), another type, a value out of range.
void load_settings(const std::filesystem::path& path, SettingsFile& settings);

/// Reads one setting, `quality.mask=alpha` or `camera.eye_m=[0,0,1]`: JSON, or else a text. InputError as
/// above, with `where` in place of the file; also without a '='.
void load_setting(std::string_view assignment, std::string_view where, SettingsFile& settings);

}  // namespace dermis
