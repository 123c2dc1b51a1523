// SPDX-License-Identifier: MIT
// The rows as callers of the library see them, and settings as JSON text.
#include "dermis/setting_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "dermis/error.h"
#include "support/thrown.h"

namespace dermis::tests {
namespace {

const SettingRow& row_of(const std::vector<SettingRow>& rows, std::string_view path) {
  const auto found = std::ranges::find(rows, path, &SettingRow::path);
  EXPECT_NE(found, rows.end()) << path;
  return *found;
}

TEST(SettingRows, SayWhatTheSettingsAre) {
  const std::vector<SettingRow> rows = rows_of(RenderSettings{});
  std::set<std::string> paths;
  for (const SettingRow& row : rows) {
    EXPECT_TRUE(paths.insert(row.path).second) << row.path;
    EXPECT_FALSE(row.help.empty()) << row.path;
    EXPECT_TRUE(nlohmann::json::accept(row.initial)) << row.path << ": " << row.initial;
  }

  const SettingRow& fov = row_of(rows, "camera.fov_deg");
  EXPECT_EQ(fov.option, "fov");
  EXPECT_EQ(fov.kind, SettingRow::Kind::number);
  EXPECT_TRUE(fov.optional);
  EXPECT_EQ(fov.least, 0.1);
  EXPECT_EQ(fov.most, 170);
  EXPECT_EQ(fov.unit, "degrees");
  EXPECT_EQ(fov.initial, "null");

  EXPECT_EQ(row_of(rows, "camera.eye_m").count, 3);
  EXPECT_EQ(row_of(rows, "camera.orbit_deg").count, 2);
  EXPECT_EQ(row_of(rows, "lighting.placed_lights").kind, SettingRow::Kind::lights);
  EXPECT_EQ(row_of(rows, "skin.translucency").on, "on");
  EXPECT_EQ(row_of(rows, "output.width").initial, std::to_string(OutputSettings{}.width));
  const SettingRow& tone_map = row_of(rows, "output.tone_map");
  EXPECT_EQ(tone_map.kind, SettingRow::Kind::choice);
  EXPECT_EQ(tone_map.choices.front(), "natural");
  EXPECT_TRUE(std::isinf(row_of(rows_of(ReferenceSettings{}), "seed").most));
  EXPECT_EQ(row_of(rows_of(SceneOptions{}), "skin_material").kind, SettingRow::Kind::texts);
  EXPECT_EQ(row_of(rows_of(SpectralSkin{}), "melanin").initial, "0.02");
}

TEST(SettingRows, TextIsReadBackToTheBit) {
  RenderSettings settings;
  settings.camera.fov_deg = 1.0 / 3;
  settings.camera.eye_m = {0.1, -0.2, 0.3};
  settings.camera.target_m = {0, 0, 0};
  settings.lighting.placed_lights = {{.azimuth_deg = 0.1, .elevation_deg = 20, .irradiance = 2}};
  settings.output.tone_map = ToneMap::agx;
  settings.technique = "lambert";
  const std::string text = settings_text(settings);

  RenderSettings read;
  read_settings(text, read);
  EXPECT_EQ(settings_text(read), text);
  EXPECT_EQ(*read.camera.fov_deg, 1.0 / 3);
  EXPECT_EQ(read.output.tone_map, ToneMap::agx);
}

TEST(SettingRows, WhatIsNotNamedStays) {
  RenderSettings settings;
  settings.output.width = 123;
  read_settings(R"({"output": {"height": 45}})", settings);
  EXPECT_EQ(settings.output.width, 123);
  EXPECT_EQ(settings.output.height, 45);
}

TEST(SettingRows, WhatIsWrongChangesNothing) {
  RenderSettings settings;
  const std::string before = settings_text(settings);
  const auto refused = [&](const char* json) {
    const std::string why = thrown<InputError>([&] { read_settings(json, settings); });
    EXPECT_EQ(settings_text(settings), before) << json;
    return why;
  };
  EXPECT_NE(refused(R"({"technique": "lambert", "camera": {"fov_deg": 300}})").find("0.1 to 170"),
            std::string::npos);
  EXPECT_NE(refused(R"({"camera": {"fov": 30}})").find("fov_deg"), std::string::npos);
  EXPECT_NE(refused(R"({"camera": {"fov_deg": "wide"}})").find("camera.fov_deg"), std::string::npos);
  EXPECT_NE(refused("{").find("settings"), std::string::npos);
  EXPECT_NE(refused(R"({"output": {"tone_map": "agxx"}})").find("did you mean 'agx'?"), std::string::npos);
}

TEST(SettingRows, TheNearestNameIsFound) {
  EXPECT_EQ(nearest_setting("map_sizes", {"map_size", "size"}), "map_size");
  EXPECT_EQ(nearest_setting("quantum", {"map_size", "size"}), "");
}

}  // namespace
}  // namespace dermis::tests
