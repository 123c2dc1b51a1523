// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <fstream>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <map>

#include "api/prepare/scene_file.h"
#include "api/rig_pose.h"
#include "api/scene_state.h"
#include "base/core/error.h"
#include "base/core/file.h"
#include "base/core/known_names.h"
#include "base/settings/json.h"
#include "tissue/gaussians/json.h"
#include "tissue/gaussians/known.h"
#include "tissue/gaussians/scatter_profile.h"

namespace dermis::api {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t most_bytes = std::uint64_t{64} << 20;
constexpr std::size_t most_assets = 4096, most_instances = 16384, most_lights = 16384;
constexpr double most_off_unit = 1e-3;  // of a quaternion's length

char first_character(const fs::path& path) {
  std::ifstream file(path);
  char c = 0;
  return file >> c ? c : '\0';
}

/// Returns a path that the file names relative to itself.
fs::path path_of(const json::Value& json, const fs::path& folder) {
  const std::string& text = json.text();
  if (text.empty() || text.find('\0') != std::string::npos) json.fail("must be the name of a file");
  return folder / text;
}

// Adds the place to errors of Scene.
template <class Work>
auto at_place(const json::Value& json, const Work& work) {
  try {
    return work();
  } catch (const InputError& error) { json.fail("{}", error.what()); }
}

class Reader {
 public:
  Reader(const fs::path& path, const SceneOptions& options)
      : folder_(fs::absolute(path).parent_path()), options_(options) {}

  SceneFile read(const json::Value& root) {
    root.only_keys({scene_file_key, "assets", "instances", "lights", "environment"});
    if (root.at(scene_file_key).count(1) > scene_file_version)
      root.at(scene_file_key)
          .fail("is a version that is newer than this program, which reads {}", scene_file_version);

    for_each(root.find("assets"), most_assets, [this](const json::Value& v) { read_asset(v); });
    for_each(root.at("instances"), most_instances, [this](const json::Value& v) { read_instance(v); });
    for_each(root.find("lights"), most_lights, [this](const json::Value& v) { read_light(v); });
    if (const auto environment = root.find("environment")) read_environment(*environment);
    return std::move(made_);
  }

 private:
  template <class Read>
  static void for_each(const std::optional<json::Value>& array, std::size_t most, const Read& read) {
    if (!array) return;
    const std::size_t size = array->array_size(0, most);
    for (std::size_t i = 0; i < size; ++i) read(array->element(i).object());
  }

  void read_asset(const json::Value& json) {
    Asset::State::Source source;
    std::string name = "built-in";
    const auto built_in = json.find("built_in");
    const bool names_skin = built_in && built_in->is_text();
    if (names_skin || json.boolean_or("built_in", false)) {
      json.only_keys({"name", "built_in"});
      if (names_skin) source.skin = built_in->text();
      if (source.skin != "light" && source.skin != "medium" && source.skin != "dark")
        built_in->fail("must be true, light, medium or dark, got '{}'", source.skin);
      if (source.skin != "medium") name += ":" + source.skin;
    } else {
      source.options = options_;
      read_json(json, {"name", "file", "built_in"}, source.options);
      const auto time = json.find("time_s");
      source.holds_time = time && !time->is_null();
      if (!source.holds_time) source.options.time_s = options_.time_s;
      if (source.options.clip.empty()) source.options.clip = options_.clip;
      for (const auto& [key, map] : {std::pair{"melanin_map", &source.options.melanin_map},
                                     {"haemoglobin_map", &source.options.haemoglobin_map}})
        if (json.find(key) && !map->empty()) *map = (folder_ / *map).string();
      source.file = path_of(json.at("file"), folder_);
      name = json.at("file").text();
    }

    name = json.text_or("name", name);
    if (!asset_numbers_.emplace(name, made_.assets.size()).second)
      json.fail("an asset called '{}' stands before; give each a 'name' of its own", name);
    made_.assets.push_back(std::move(source));
  }

  void read_instance(const json::Value& json) {
    Instance instance{.asset = stand_in_};
    read_json(json, {"asset", "translation_m", "rotation", "scale", "profile", "clip", "time_s", "weights"},
              instance);
    if (const auto parts = transform_of(json)) instance.world_from_asset = *parts;
    if (const auto profile = json.find("profile")) instance.profile = profile_of(*profile);

    const json::Value asset = json.at("asset");
    const auto found = asset_numbers_.find(asset.text());
    if (found == asset_numbers_.end())
      asset.fail("no asset is called '{}'; {}", asset.text(), known_assets(asset.text()));

    const InstanceId id = at_place(json, [&] { return made_.scene.add(instance); });
    made_.asset_of_instance.push_back(found->second);
    made_.pose_of_instance.push_back(pose_of(json));
    ids_.push_back(id);
    if (!instance.name.empty()) ids_by_name_[instance.name].push_back(id);
  }

  static std::optional<RigPose> pose_of(const json::Value& json) {
    const bool has_clip = json.has("clip") || json.has("time_s");
    const std::optional<json::Value> weights = json.find("weights");
    if (!has_clip && !weights) return {};
    RigPose pose;
    if (has_clip) pose.clip = ClipTime{json.text_or("clip", ""), json.number_or("time_s", 0)};
    if (weights)
      for (const std::string& name : weights->object().keys())
        pose.weights.push_back({name, weights->at(name).number(-100, 100)});
    return pose;
  }

  std::string known_assets(const std::string& wanted) const {
    if (asset_numbers_.empty()) return "the file has no assets";
    return listed_names(wanted, asset_numbers_);
  }

  /// Returns the transform that stands as its parts, if it does.
  static std::optional<std::array<double, 16>> transform_of(const json::Value& json) {
    const auto translation = json.find("translation_m"), rotation = json.find("rotation"),
               scale = json.find("scale");
    if (!translation && !rotation && !scale) return {};
    if (json.has("world_from_asset"))
      json.fail("has world_from_asset beside translation_m, rotation or scale; one of them");

    std::vector<double> t = json.numbers("translation_m", 3), q = json.numbers("rotation", 4);
    if (t.empty()) t = {0, 0, 0};
    if (q.empty()) q = {0, 0, 0, 1};
    const double length = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
    if (!(std::abs(length - 1) <= most_off_unit))
      rotation->fail("must be a quaternion x, y, z, w of length 1, its length is {:.6g}", length);

    const glm::dquat unit(q[3] / length, q[0] / length, q[1] / length, q[2] / length);
    const glm::dmat3 axes = glm::mat3_cast(unit) * json.number_or("scale", 1);
    return std::array<double, 16>{axes[0].x, axes[0].y, axes[0].z, 0, axes[1].x, axes[1].y, axes[1].z, 0,
                                  axes[2].x, axes[2].y, axes[2].z, 0, t[0],      t[1],      t[2],      1};
  }

  std::optional<ScatterProfile> profile_of(const json::Value& json) {
    if (json.is_null()) return {};
    if (json.is_object()) return gaussians::read_json(json);
    if (!json.is_text()) json.fail("must be a name, a file or an object");

    const std::string& name = json.text();
    const auto known = profiles_.find(name);
    if (known != profiles_.end()) return known->second;
    const std::vector<std::string_view> names = gaussians::known_names();
    const bool is_name = std::find(names.begin(), names.end(), name) != names.end();
    const std::string source = is_name ? name : path_of(json, folder_).string();
    const auto read = [&] { return gaussians::from_name_or_file(source); };
    return profiles_.emplace(name, at_place(json, read)).first->second;
  }

  void read_light(const json::Value& json) {
    SceneLight light;
    read_json(json, {"rig"}, light.light);
    if (const auto rig = json.find("rig")) light.rig = rig_of(*rig);
    at_place(json, [&] { return made_.scene.add_light(light); });
  }

  /// Returns the instance that is named, or given by its number.
  InstanceId rig_of(const json::Value& json) const {
    if (!json.is_text()) {
      if (ids_.empty()) json.fail("there are no instances");
      return ids_[json.count(0, ids_.size() - 1)];
    }
    const auto found = ids_by_name_.find(json.text());
    if (found == ids_by_name_.end())
      json.fail("no instance is called '{}'; {}", json.text(), listed_names(json.text(), ids_by_name_));
    if (found->second.size() > 1)
      json.fail("{} instances are called '{}'; give the number of one, from 0", found->second.size(),
                json.text());
    return found->second.front();
  }

  void read_environment(const json::Value& json) {
    if (json.is_null()) return;
    const bool is_file = json.text() != "studio";
    made_.scene.set_environment(
        SceneEnvironment{.file = is_file ? path_of(json, folder_).string() : json.text()});
  }

  fs::path folder_;
  const SceneOptions& options_;
  Asset stand_in_ = Asset::State::make(std::make_shared<const scene::AssetData>());
  SceneFile made_;
  std::map<std::string, std::size_t> asset_numbers_;
  std::map<std::string, std::vector<InstanceId>> ids_by_name_;
  std::vector<InstanceId> ids_;
  std::map<std::string, ScatterProfile> profiles_;  ///< by name or file, as the scene file has them
};

}  // namespace

std::optional<json::Document> open_scene_file(const fs::path& path) {
  // A pipe is not opened: the reader of glTF refuses it.
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return {};
  const std::uintmax_t size = fs::file_size(path, error);
  if (error || size > most_bytes || first_character(path) != '{') return {};

  const std::vector<std::byte> bytes = read_file(path, most_bytes);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (text.find(fmt::format("\"{}\"", scene_file_key)) == std::string_view::npos) return {};

  // A glTF file may hold the word, but not at its top.
  json::Document document(text, path.string(), scene_file_limits);
  if (!document.root().is_object() || !document.root().has(scene_file_key)) return {};
  return document;
}

SceneFile read_scene_file(const json::Value& root, const fs::path& path, const SceneOptions& options) {
  return Reader(path, options).read(root.object());
}

Scene load_scene_file(const json::Value& root, const fs::path& path, const SceneOptions& options) {
  const SceneFile file = read_scene_file(root, path, options);
  std::map<std::size_t, Asset> loaded;
  Scene::State state = file.scene.state();
  state.name = path.filename().string();

  for (std::size_t i = 0; i < state.instances.size(); ++i) {
    const std::size_t number = file.asset_of_instance[i];
    auto found = loaded.find(number);
    if (found == loaded.end()) {
      const Asset::State::Source& source = file.assets[number];
      Asset asset = source.file.empty() ? Asset::load("built-in:" + source.skin)
                                        : Asset::load(source.file, source.options);
      if (source.holds_time) asset = Asset::State::make(Asset::State::of(asset), source);
      found = loaded.emplace(number, std::move(asset)).first;
    }
    Scene::State::Entry& entry = state.instances[i];
    entry.instance.asset = found->second;
    entry.instance.pose = file.pose_of_instance[i];
    entry.placed.posed = posed_asset(*Asset::State::of(found->second), entry.instance.pose);
  }
  return Scene::State::make(std::move(state));
}

}  // namespace dermis::api
