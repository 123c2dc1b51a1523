// SPDX-License-Identifier: MIT
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "api/prepare/scene_file.h"
#include "api/scene_state.h"
#include "base/core/error.h"
#include "base/core/file.h"
#include "base/settings/json.h"
#include "tissue/gaussians/json.h"
#include "tissue/gaussians/scatter_profile.h"

namespace dermis::api {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// Returns the folder of a file without links, so that ".." is what it seems.
fs::path folder_of(const fs::path& path) { return fs::weakly_canonical(fs::absolute(path).parent_path()); }

/// Returns the file as one in `folder` names it: relative, unless both have no folder in common.
fs::path named_from(const fs::path& folder, const fs::path& file) {
  // The last link stays: what a glTF file names lies beside its link.
  const fs::path full = folder_of(file) / file.filename();
  const auto below_root = [](const fs::path& path) {
    return path.relative_path().empty() ? fs::path() : *path.relative_path().begin();
  };
  return below_root(full) == below_root(folder) ? full.lexically_relative(folder) : full;
}

class Writer {
 public:
  Writer(const Scene& scene, const fs::path& path)
      : state_(scene.state()), path_(path), folder_(folder_of(path)) {}

  std::string text() {
    std::vector<ordered_json> instances, lights;
    for (std::size_t i = 0; i < state_.instances.size(); ++i) {
      numbers_.emplace(state_.instances[i].id, i);
      ++times_named_[state_.instances[i].instance.name];
      instances.push_back(json_of_instance(i));
    }
    for (const Scene::State::PlacedLight& placed : state_.lights)
      lights.push_back(json_of_light({light_now(state_, placed), placed.light.rig}));

    std::string text = fmt::format("{{\n  \"{}\": {}", scene_file_key, scene_file_version);
    text += list("assets", assets_) + list("instances", instances) + list("lights", lights);
    if (state_.environment) text += ",\n  \"environment\": " + line_of(environment_name(*state_.environment));
    return text + "\n}\n";
  }

 private:
  /// One line for each entry.
  std::string list(const char* key, const std::vector<ordered_json>& entries) const {
    std::string text;
    for (const ordered_json& entry : entries) text += (text.empty() ? "\n    " : ",\n    ") + line_of(entry);
    return fmt::format(",\n  \"{}\": [{}{}]", key, text, text.empty() ? "" : "\n  ");
  }

  std::string line_of(const ordered_json& json) const {
    try {
      return json.dump();
    } catch (const ordered_json::type_error&) {
      throw input_error(path_.string(), "a name in this scene is not UTF-8, which JSON cannot hold: {}",
                        json.dump(-1, ' ', false, ordered_json::error_handler_t::replace).substr(0, 200));
    }
  }

  ordered_json json_of_instance(std::size_t number) {
    const Scene::State::Entry& entry = state_.instances[number];
    const Instance& instance = entry.instance;
    ordered_json json{{"asset", asset_name(number)}};
    json.update(json_of(instance));
    if (instance.pose) json.update(json_of_pose(*instance.pose, number));
    if (instance.profile)
      json["profile"] =
          ordered_json::parse(gaussians::to_json(gaussians::checked_profile(*instance.profile)));
    return json;
  }

  ordered_json json_of_pose(const RigPose& pose, std::size_t number) const {
    if (pose.second || !pose.joints.empty()) {
      const std::string& name = state_.instances[number].instance.name;
      throw input_error(
          path_.string(),
          "instance {}{}: it has a pose of two clips or of single joints, which a scene file cannot "
          "hold",
          number, name.empty() ? "" : " ('" + name + "')");
    }
    ordered_json json = ordered_json::object();
    if (pose.clip) json = {{"clip", pose.clip->clip}, {"time_s", pose.clip->seconds}};
    for (const MorphWeight& weight : pose.weights) json["weights"][weight.name] = weight.weight;
    return json;
  }

  /// Returns the name of the asset of this instance in the file; lists the asset at its first.
  std::string asset_name(std::size_t number) {
    const Instance& instance = state_.instances[number].instance;
    const std::optional<Asset::State::Source>& source = Asset::State::source_of(instance.asset);
    if (!source)
      throw input_error(path_.string(),
                        "instance {}{}: its asset '{}' was made in memory and is of no file, so a scene file "
                        "cannot name it",
                        number, instance.name.empty() ? "" : " ('" + instance.name + "')",
                        instance.asset.name());

    const ordered_json options = json_of(source->options);
    const std::string option_text = options.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
    const auto [known, is_new] = names_.try_emplace(std::pair(source->file, source->skin + option_text));
    if (is_new) {
      known->second = free_name(instance.asset.name());
      ordered_json& json = assets_.emplace_back(ordered_json{{"name", known->second}});
      if (source->file.empty()) {
        json["built_in"] = true;
        if (source->skin != "medium") json["built_in"] = source->skin;
      } else {
        if (same_file(source->file, path_))
          throw input_error(path_.string(),
                            "is the file of an asset of this scene; it needs a name of its own");
        json["file"] = named_from(folder_, source->file).string();
        json.update(options);
        for (const auto& [key, map] : {std::pair{"melanin_map", &source->options.melanin_map},
                                       {"haemoglobin_map", &source->options.haemoglobin_map}})
          if (!map->empty()) json[key] = named_from(folder_, fs::absolute(*map)).string();
      }
    }
    return known->second;
  }

  std::string free_name(const std::string& wanted) {
    std::string name = wanted;
    for (int i = 2; !taken_.insert(name).second; ++i) name = fmt::format("{} ({})", wanted, i);
    return name;
  }

  ordered_json json_of_light(const SceneLight& light) const {
    ordered_json json = json_of(light.light);
    if (!light.rig) return json;
    const std::size_t number = numbers_.at(*light.rig);
    const std::string& name = state_.instances[number].instance.name;
    const bool is_clear = !name.empty() && times_named_.at(name) == 1;
    json["rig"] = is_clear ? ordered_json(name) : ordered_json(number);
    return json;
  }

  std::string environment_name(const SceneEnvironment& environment) const {
    if (environment.file.empty())
      throw input_error(path_.string(),
                        "the environment of this scene was made in memory and is of no file, so a scene file "
                        "cannot name it");
    if (environment.file == "studio") return environment.file;
    const fs::path name = named_from(folder_, environment.file);
    return name == "studio" ? "./studio" : name.string();
  }

  const Scene::State& state_;
  const fs::path& path_;
  fs::path folder_;
  std::vector<ordered_json> assets_;
  std::map<std::pair<fs::path, std::string>, std::string> names_;  ///< of assets, by file and options
  std::set<std::string> taken_;
  std::map<InstanceId, std::size_t> numbers_;
  std::map<std::string, std::size_t> times_named_;
};

}  // namespace

std::string scene_file_text(const Scene& scene, const fs::path& path) {
  std::string text = Writer(scene, path).text();
  // Nothing is written that could not be read: what a scene may hold and a file may not is said here.
  read_scene_file(json::Document(text, path.string(), scene_file_limits).root(), path, {});
  return text;
}

}  // namespace dermis::api
