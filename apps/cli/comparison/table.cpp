// SPDX-License-Identifier: MIT
#include "cli/comparison/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "base/core/error.h"
#include "base/core/known_names.h"
#include "cli/progress.h"
#include "cli/test_scenes/test_scenes.h"
#include "dermis/cancelled.h"

namespace dermis::cli::comparison {
namespace {

/// A case before it is compared.
struct Planned {
  std::string name, shows;
  std::string test_scene;  ///< empty: the scene of the table
  SceneComparisonSettings settings;
};

SceneComparisonSettings sized(const SceneComparisonSettings& common, const PictureSize& size) {
  SceneComparisonSettings s = common;
  s.render.output.width = size.width;
  s.render.output.height = size.height;
  return s;
}

// Cameras and lights are those of the test scene.
SceneComparisonSettings of_test_scene(const TableSettings& table) {
  const auto smallest = std::min_element(
      table.sizes.begin(), table.sizes.end(),
      [](const PictureSize& a, const PictureSize& b) { return a.width * a.height < b.width * b.height; });
  SceneComparisonSettings s = sized(table.comparison, *smallest);
  s.render.camera = {};
  s.render.lighting.rig_lights.reset();
  s.render.lighting.placed_lights.clear();
  s.render.lighting.environment.clear();
  s.render.lighting.light_radius_m.reset();
  s.one_gaussian = s.each_optimisation = s.curves = false;
  return s;
}

void plan_test_scene(const TableSettings& table, const std::string& name, std::vector<Planned>& to) {
  const std::vector<test_scenes::TestScene> all = test_scenes::all();
  const auto row =
      std::find_if(all.begin(), all.end(), [&](const auto& scene) { return scene.name == name; });
  const std::string full = std::string(test_scenes::prefix) + name;
  Planned one{
      .name = full, .shows = std::string(row->shows), .test_scene = full, .settings = of_test_scene(table)};

  if (name == "stereo") {
    for (const char* camera : {"left", "right"}) {
      Planned eye = one;
      eye.settings.render.camera.name = camera;
      eye.name += fmt::format(", {}", camera);
      to.push_back(std::move(eye));
    }
  } else if (name == "fringe") {
    // A larger picture would hide what the samples do.
    one.settings.supersample = 1;
    for (const int samples : {4, 1}) {
      Planned sampled = one;
      sampled.settings.render.quality.samples = samples;
      sampled.name += fmt::format(", --msaa {}", samples);
      to.push_back(std::move(sampled));
    }
  } else {
    to.push_back(std::move(one));
  }
}

std::vector<Planned> planned_cases(const TableSettings& table) {
  std::vector<Planned> cases;
  for (const PictureSize& size : table.sizes)
    for (const double distance : table.distances) {
      Planned one{.name = fmt::format("{}x{}, {:g} radii", size.width, size.height, distance),
                  .shows = {},
                  .test_scene = {},
                  .settings = sized(table.comparison, size)};
      one.settings.render.camera.distance = distance;
      cases.push_back(std::move(one));
    }
  for (const std::string& name : table.test_scenes) plan_test_scene(table, name, cases);
  return cases;
}

Case compared(const Scene& scene, const Planned& one) {
  std::optional<Scene> generated;
  if (!one.test_scene.empty())
    generated = test_scenes::make(one.test_scene, one.settings.render.output.height, one.settings.hooks);
  return {.name = one.name,
          .shows = one.shows,
          .is_test = generated.has_value(),
          .found = compare_scene_here(generated ? *generated : scene, one.settings)};
}

}  // namespace

std::vector<std::string> test_scenes_of(const std::vector<std::string>& names) {
  std::vector<std::string> all, wanted;
  for (const test_scenes::TestScene& scene : test_scenes::all()) all.emplace_back(scene.name);
  if (names == std::vector<std::string>{"all"}) return all;
  if (names == std::vector<std::string>{"none"}) return {};

  for (std::string name : names) {
    if (test_scenes::is_test_scene(name)) name.erase(0, test_scenes::prefix.size());
    if (std::find(all.begin(), all.end(), name) == all.end()) {
      all.insert(all.begin(), {"all", "none"});
      throw input_error("", "--test-scenes {}", unknown_name(name, all));
    }
    if (std::find(wanted.begin(), wanted.end(), name) == wanted.end()) wanted.push_back(std::move(name));
  }
  return wanted;
}

Table compare_table(const Scene& scene, const TableSettings& settings) {
  const std::vector<Planned> cases = planned_cases(settings);
  for (const Planned& one : cases) check_comparison(one.settings);

  Table table{.scene = scene.name(), .settings = {}, .cases = {}};
  try {
    for (std::size_t i = 0; i < cases.size(); ++i) {
      show_line(fmt::format("case {} of {}: {}", i + 1, cases.size(), cases[i].name));
      table.cases.push_back(compared(scene, cases[i]));
    }
  } catch (const Cancelled&) {
    if (table.cases.empty()) throw;
    table.complete = false;
  }
  return table;
}

}  // namespace dermis::cli::comparison
