// SPDX-License-Identifier: MIT
// What the kit runs covers every setting, also those that are added later.
#include "kit/plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "base/settings/fields.h"
#include "base/settings/json.h"
#include "render/setup/frame_setup.h"
#include "support/files.h"

namespace dermis::kit {
namespace {

using Json = nlohmann::ordered_json;

TEST(Plan, EverySettingIsSwitchedOrFixed) {
  std::set<std::string> switched;
  for (const Switch& change : switches(Extent::full)) switched.insert(change.path);
  EXPECT_TRUE(switched.contains("")) << "nothing is changed in one of them";
  const RenderSettings settings;
  for_each_setting(settings, [&](const std::string& path, const About&, const auto&, std::string_view) {
    EXPECT_NE(switched.contains(path), is_fixed(path)) << path;
  });
}

TEST(Plan, ChoicesHaveEveryOtherValue) {
  std::set<std::string> values;
  for (const Switch& change : switches(Extent::quick)) values.insert(change.path + " " + change.text);
  for (const char* value :
       {R"(quality.mask "alpha")", R"(quality.mask "depth")", "quality.cull false", "skin.translucency false",
        R"(output.tone_map "linear")", "lighting.rig_lights 5"})
    EXPECT_TRUE(values.contains(value)) << value;
  EXPECT_FALSE(values.contains(R"(lighting.specular true)")) << "the default is drawn once, under ''";
}

// What is written is what `dermis render --settings` takes: another key, a value out of range, or one that
// does not go with the others would throw.
TEST(Plan, SettingsAreReadBack) {
  const tests::TempFolder folder;
  for (const Switch& change : switches(Extent::full)) {
    SCOPED_TRACE(change.path + " " + change.text);
    tests::write_text(folder.path() / "settings.json", settings_with("texture-space", change).dump());
    SettingsFile read;
    ASSERT_NO_THROW(load_settings(folder.path() / "settings.json", read));
    EXPECT_EQ(read.render.technique, "texture-space");
    EXPECT_NO_THROW(setup::check_settings(read.render));
    if (change.path.empty()) continue;
    std::string place = "/" + change.path;
    std::ranges::replace(place, '.', '/');
    const Json value = json_of(read.render)[Json::json_pointer(place)];
    if (change.path == "lighting.placed_lights")  // what is left out of one has its default
      EXPECT_EQ(value.size(), 1u);
    else
      EXPECT_EQ(value, change.value());
  }
}

TEST(Plan, ExtentsLieWithinEachOther) {
  EXPECT_GT(switches(Extent::full).size(), 40u);
  EXPECT_LT(switches(Extent::smoke).size(), 5u);
  EXPECT_EQ(invariants(Extent::smoke).size(), 1u);
  EXPECT_GT(invariants(Extent::full).size(), invariants(Extent::quick).size());
  EXPECT_GT(invariants(Extent::quick).size(), 5u);
}

}  // namespace
}  // namespace dermis::kit
