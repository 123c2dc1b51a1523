// SPDX-License-Identifier: MIT
// A row says whether a change of its setting may make the plan of a frame anew. Set to other values, in
// several frames, those that say no leave the plan as it is, and each that says yes changes it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

#include "alone.h"
#include "base/settings/fields.h"
#include "base/settings/names.h"
#include "dermis/error.h"
#include "environment/environment.h"
#include "environment/sources.h"
#include "head/scene/surface/measured.h"
#include "render/setup/environment_light.h"
#include "render/setup/frame_setup.h"
#include "support/built_in.h"
#include "support/files.h"

namespace dermis::setup {
namespace {

/// A scene and settings, which are then changed one at a time.
struct Frame {
  std::string name;
  std::shared_ptr<const scene::AssetData> asset;
  RenderSettings settings;
};

/// Settings whose change needs more than the built-in head by itself to make another plan.
struct Exception {
  std::string_view path, frame, reason;
};
constexpr Exception exceptions[] = {
    {"quality.map_budget_mb", "heads in the studio", "a head by itself takes one square"},
    {"quality.kernel", "in screen space", "light maps have no kernels in the picture"},
    {"quality.taps", "in screen space", "nor taps"},
    {"skin.shape_aware", "a profile of a medium", "published ones know none"},
    {"skin.mix", "skin alone", "light must enter all that it falls on, and eyes and teeth are no skin"},
};

std::shared_ptr<const scene::AssetData> head() {
  scene::AssetData scene = tests::built_in_head();
  scene.cameras.push_back({.name = "side"});
  return scene::measured(std::move(scene));
}

std::shared_ptr<const scene::AssetData> skin_alone() {
  scene::AssetData scene = tests::built_in_head();
  scene.primitives.resize(1);
  scene.rig = nullptr;
  return scene::measured(std::move(scene));
}

/// A file: a profile that knows its medium.
const std::string& medium_file() {
  static const tests::TempFolder folder;
  static const std::string path = [] {
    const std::filesystem::path file = folder.path() / "medium.json";
    tests::write_text(file,
                      R"({"variances_mm2": [0.1, 1], "weights": [[0.5, 0.5, 0.5], [0.5, 0.5, 0.5]], "medium":
            {"sigma_a_per_mm": [0.01, 0.07, 0.1], "sigma_s_per_mm": [1, 1.5, 2], "g": 0, "eta": 1.3}})");
    return file.string();
  }();
  return path;
}

std::vector<Frame> frames() {
  const std::shared_ptr<const scene::AssetData> asset = head();
  return {{"the built-in head", asset, {}},
          {"in screen space", asset, {.technique = "separable"}},
          {"heads in the studio",
           asset,
           {.camera = {.heads = 3},
            .lighting = {.environment = "studio"},
            .quality = {.map_size = 256, .map_budget_mb = 12}}},
          {"a camera that looks at a point",
           asset,
           {.camera = {.eye_m = std::array{0.1, 0.0, 0.8}, .target_m = std::array{0.0, 0.05, 0.0}}}},
          {"skin alone", skin_alone(), {}},
          {"a profile of a medium", asset, {.skin = {.profile = medium_file()}}}};
}

FrameSetup set_up_frame(const Frame& frame) {
  check_settings(frame.settings);
  static const environment::Split studio =
      environment::split_sources(environment::from_name_or_file("studio"));
  std::optional<std::vector<scene::Light>> environment_lights;
  if (!frame.settings.lighting.environment.empty())
    environment_lights = setup::environment_lights(studio.sources, frame.settings);
  return set_up_alone(frame.asset, frame.settings, environment_lights);
}

// Values to try; those that are out of range are left out by who tries them.
template <class Value>
std::vector<Value> values_for(const std::string& path, const About& about) {
  if constexpr (std::is_same_v<Value, bool>) {
    return {false, true};
  } else if constexpr (std::is_enum_v<Value>) {
    std::vector<Value> all;
    for (std::size_t i = 0; i < names_of<Value>.size(); ++i) all.push_back(static_cast<Value>(i));
    return all;
  } else if constexpr (std::is_same_v<Value, std::string>) {
    static const std::map<std::string, std::vector<std::string>> texts{
        {"technique",
         {"texture-space", "lambert", "screen-gaussians", "separable", "burley-disc", "pre-integrated",
          "published"}},
        {"camera.name", {"", "side"}},
        {"lighting.environment", {"", "studio"}},
        {"skin.profile", {"skin", medium_file()}},
        {"output.background", {"black", "studio", "environment", "#336699"}},
        {"output.show", {"picture", "irradiance", "visibility", "shadow:0"}}};
    return texts.at(path);
  } else if constexpr (std::is_same_v<Value, std::array<double, 2>>) {
    return {{0, 0}, {30, 10}, {-170, 80}};
  } else if constexpr (std::is_same_v<Value, std::array<double, 3>>) {
    return {{0, 0, 1}, {0.2, -0.1, 0.4}, {-3, 4, -5}};
  } else if constexpr (std::is_same_v<Value, std::vector<PlacedLight>>) {
    return {{PlacedLight{}}, std::vector<PlacedLight>(3)};
  } else {
    return {static_cast<Value>(about.least),
            static_cast<Value>(about.most),
            Value(0),
            static_cast<Value>(0.1),
            Value(1),
            Value(2),
            Value(4),
            Value(21),
            Value(1000)};
  }
}

template <class Value>
std::vector<Value> others(const std::string& path, const About& about, const Value& now) {
  std::vector<Value> found;
  if constexpr (is_optional<Value>) {
    found.emplace_back();
    for (const auto& value : values_for<typename Value::value_type>(path, about)) found.emplace_back(value);
  } else {
    found = values_for<Value>(path, about);
  }
  if constexpr (!std::is_same_v<Value, std::vector<PlacedLight>>) std::erase(found, now);
  return found;
}

struct Tried {
  int values = 0, new_plans = 0;
};

// Whatever moves the camera makes a new plan where a head comes close or goes far away: that is no row's.
void leave_out_close_ups(techniques::FrameSettings& plan, const techniques::FrameSettings& before) {
  if (!plan.mixes() || !before.mixes() || plan.skin.size() != before.skin.size()) return;
  const auto same = [](const techniques::PlannedMesh& a, const techniques::PlannedMesh& b) {
    return a.most_side == b.most_side && a.first_mapped == b.first_mapped &&
           a.reads_entered == b.reads_entered;
  };
  if (std::ranges::equal(plan.skin, before.skin, same)) return;
  plan.most_side = before.most_side;
  plan.square_side = before.square_side;
  plan.heads_per_batch = before.heads_per_batch;
  plan.meshes_per_batch = before.meshes_per_batch;
  plan.keep_shadows = before.keep_shadows;
  for (std::size_t i = 0; i < plan.skin.size(); ++i) {
    plan.skin[i].most_side = before.skin[i].most_side;
    plan.skin[i].first_mapped = before.skin[i].first_mapped;
    plan.skin[i].reads_entered = before.skin[i].reads_entered;
  }
}

/// Sets one setting after the other to each of its other values, and back.
std::map<std::string, Tried> try_all(Frame frame) {
  const FrameSetup before = set_up_frame(frame);
  std::map<std::string, Tried> tried;

  const auto one = [&](const std::string& path, const About& about, auto& value, std::string_view) {
    auto now = value;
    for (const auto& other : others(path, about, now)) {
      value = other;
      try {
        FrameSetup after = set_up_frame(frame);
        leave_out_close_ups(after.plan, before.plan);
        ++tried[path].values;
        if (after.plan != before.plan || after.technique != before.technique) ++tried[path].new_plans;
      } catch (const InputError&) {
        // Out of range, or not together with another setting of this frame.
      }
    }
    value = now;
  };
  for_each_setting(frame.settings, one);
  return tried;
}

TEST(Rebuilds, RowsSayWhatChangesThePlan) {
  std::map<std::string, std::map<std::string, Tried>> tried;  // by frame, by setting
  for (const Frame& frame : frames()) tried[frame.name] = try_all(frame);

  const RenderSettings settings;
  for_each_setting(settings, [&](const std::string& path, const About& about, const auto&, std::string_view) {
    if (!about.rebuilds) {
      int values = 0;
      for (auto& [frame, found] : tried) {
        values += found[path].values;
        EXPECT_EQ(found[path].new_plans, 0)
            << path << " changes the plan: its row lacks .rebuilds, " << frame;
      }
      EXPECT_GT(values, 0) << path << ": no other value was taken in any frame";
      return;
    }

    const auto* exception = std::find_if(std::begin(exceptions), std::end(exceptions),
                                         [&](const Exception& e) { return e.path == path; });
    const bool is_exception = exception != std::end(exceptions);
    const std::string frame = is_exception ? std::string(exception->frame) : "the built-in head";
    EXPECT_GT(tried.at(frame)[path].new_plans, 0)
        << path << " leaves the plan as it is: its row says .rebuilds, " << frame;
    if (is_exception) {
      EXPECT_EQ(tried.at("the built-in head")[path].new_plans, 0)
          << path << " is no exception: " << exception->reason;
    }
  });
}

}  // namespace
}  // namespace dermis::setup
