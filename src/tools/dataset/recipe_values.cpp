// SPDX-License-Identifier: MIT
// The values of a recipe as settings, options and poses.
#include <algorithm>
#include <cmath>

#include "base/core/error.h"
#include "base/settings/json.h"
#include "tools/dataset/recipe.h"

namespace dermis::dataset {
namespace {

namespace fs = std::filesystem;

constexpr json::Limits value_limits{.depth = 24, .values = 200'000};
constexpr std::size_t most_trees = 20'000;

// Calls read(value) with the tree as a value whose place is `place`.
template <class Read>
auto with_value(const Json& tree, const char* place, const Read& read) {
  const json::Document document(tree.dump(), "recipe", value_limits);
  return read(document.root().called(place));
}

std::array<double, 3> three(const json::Value& object, const char* key, std::array<double, 3> otherwise,
                            double least, double most) {
  const std::vector<double> numbers = object.numbers(key, 3);
  if (numbers.empty()) return otherwise;
  for (std::size_t i = 0; i < 3; ++i) otherwise[i] = object.at(key).element(i).number(least, most);
  return otherwise;
}

/// Turns about x, then y, then z: a quaternion x y z w.
std::array<double, 4> rotation_of(const std::array<double, 3>& turn_deg) {
  std::array<double, 3> c{}, s{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double half = turn_deg[i] * 3.14159265358979323846 / 360;
    c[i] = std::cos(half);
    s[i] = std::sin(half);
  }
  return {s[0] * c[1] * c[2] - c[0] * s[1] * s[2], c[0] * s[1] * c[2] + s[0] * c[1] * s[2],
          c[0] * c[1] * s[2] - s[0] * s[1] * c[2], c[0] * c[1] * c[2] + s[0] * s[1] * s[2]};
}

void add_weights(const json::Value& weights, RigPose& pose) {
  weights.object();
  for (const std::string& name : weights.keys())
    pose.weights.push_back({name, weights.at(name).number(-100, 100)});
}

void add_pose(const json::Value& value, RigPose& pose) {
  value.object();
  value.only_keys({"clip", "time_s", "weights", "joints"});
  if (value.has("clip") || value.has("time_s"))
    pose.clip = ClipTime{value.text_or("clip", ""), value.number_or("time_s", 0, -1e6, 1e6)};
  if (const auto weights = value.find("weights")) add_weights(*weights, pose);
  const auto joints = value.find("joints");
  if (!joints) return;
  joints->object();
  for (const std::string& name : joints->keys()) {
    const json::Value joint = joints->at(name).object();
    joint.only_keys({"turn_deg"});
    JointTransform transform;
    transform.name = name;
    transform.rotation = rotation_of(three(joint, "turn_deg", {0, 0, 0}, -3600, 3600));
    pose.joints.push_back(transform);
  }
}

void check_settings_of_a_sample(const RenderSettings& s) {
  if (!s.output.exposure_ev)
    throw input_error("recipe",
                      "settings.output.exposure_ev must be a number or a distribution: an automatic one "
                      "depends on the picture");
  if (s.output.show != OutputSettings{}.show)
    throw input_error("recipe", "settings.output.show must be 'picture', got '{}'", s.output.show);
  if (s.camera.heads != 1)
    throw input_error("recipe", "settings.camera.heads must be 1, got {}", s.camera.heads);
}

}  // namespace

RenderSettings settings_of(const Recipe::State& recipe, const Json& tree) {
  RenderSettings settings;
  with_value(tree, "settings", [&](const json::Value& value) {
    if (const auto output = value.find("output"))
      for (const char* key : {"width", "height", "frames"})
        if (output->has(key))
          output->at(key).fail("cannot be set: \"size\" of the recipe is that of all samples");
    read_json(value, {}, settings);
  });
  settings.output.width = recipe.width;
  settings.output.height = recipe.height;
  std::string& environment = settings.lighting.environment;
  if (!environment.empty() && environment != "studio") environment = recipe.file(environment);
  std::string& profile = settings.skin.profile;
  std::error_code ignored;  // else it is the name of a preset
  if (!profile.empty() && fs::is_regular_file(recipe.file(profile), ignored)) profile = recipe.file(profile);
  return settings;
}

SceneOptions options_of(const Recipe::State& recipe, const Json& tree) {
  SceneOptions options;
  with_value(tree, "options", [&](const json::Value& value) { read_json(value, {}, options); });
  for (std::string* map : {&options.melanin_map, &options.haemoglobin_map})
    if (!map->empty()) *map = recipe.file(*map);
  return options;
}

HeadPlace head_of(const Json& tree) {
  HeadPlace head;
  with_value(tree, "head", [&](const json::Value& value) {
    value.object();
    value.only_keys({"turn_deg", "tint", "mix"});
    head.turn_deg = three(value, "turn_deg", head.turn_deg, -3600, 3600);
    head.tint = three(value, "tint", head.tint, 0, 100);
    if (value.has("mix")) head.mix = value.at("mix").number(0, 1);
  });
  return head;
}

std::optional<RigPose> pose_of(const Json& morphs, const Json& tree) {
  RigPose pose;
  with_value(morphs, "morphs", [&](const json::Value& value) { add_weights(value, pose); });
  with_value(tree, "pose", [&](const json::Value& value) { add_pose(value, pose); });
  const bool moves = pose.clip || !pose.weights.empty() || !pose.joints.empty();
  return moves ? std::optional(pose) : std::nullopt;
}

void check_values(const Recipe::State& recipe) {
  for (const Json& tree : extremes(recipe.settings, "settings", most_trees))
    check_settings_of_a_sample(settings_of(recipe, tree));
  for (const Json& tree : extremes(recipe.head, "head", most_trees)) head_of(tree);
  for (const Json& tree : extremes(recipe.pose, "pose", most_trees)) pose_of(Json::object(), tree);
  for (std::size_t i = 0; i < recipe.entries.size(); ++i) {
    const Entry& entry = recipe.entries[i];
    const std::string place = fmt::format("identities[{}]", i);
    try {
      for (const Json& tree : extremes(entry.options, "options", most_trees)) options_of(recipe, tree);
      for (const Json& tree : extremes(entry.morphs, "morphs", most_trees)) pose_of(tree, Json::object());
      if (!entry.pose.is_null())
        for (const Json& tree : extremes(entry.pose, "pose", most_trees)) pose_of(Json::object(), tree);
    } catch (const InputError& error) { throw input_error(place, "{}", error.what()); }
  }
}

}  // namespace dermis::dataset
