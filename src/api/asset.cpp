// SPDX-License-Identifier: MIT
#include "dermis/asset.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "api/asset_state.h"
#include "api/rig_pose.h"
#include "api/scene_file.h"
#include "builtin_head/builtin_head.h"
#include "core/cache.h"
#include "core/error.h"
#include "core/hooks.h"
#include "core/known_names.h"
#include "pigments/maps.h"
#include "scene/framing.h"
#include "scene/from_arrays.h"
#include "scene/load.h"
#include "settings/check.h"

namespace dermis {
namespace {

constexpr double degrees_per_radian = 180 / std::numbers::pi;

LightType type_of(scene::LightType type) {
  switch (type) {
    case scene::LightType::directional: return LightType::directional;
    case scene::LightType::spot: return LightType::spot;
    case scene::LightType::point: break;
  }
  return LightType::point;
}

scene::LoadOptions load_options(const SceneOptions& options) {
  check_ranges(options);
  scene::LoadOptions load;
  load.unit_scale = options.unit_scale;
  load.skin_material = options.skin_material;
  load.clip = options.clip;
  load.time_s = options.time_s;
  load.texture_budget_mb = options.texture_budget_mb;
  return load;
}

pigments::Wanted wanted_pigments(const SceneOptions& options) {
  return {.melanin_map = options.melanin_map,
          .haemoglobin_map = options.haemoglobin_map,
          .melanin = options.melanin_factor,
          .haemoglobin = options.haemoglobin_factor};
}

std::shared_ptr<const scene::Scene> with_pigments(scene::Scene&& scene, const SceneOptions& options) {
  if (wanted_pigments(options).changes()) pigments::repaint(scene, wanted_pigments(options));
  return std::make_shared<const scene::Scene>(std::move(scene));
}

// "built-in:NAME" is no file.
constexpr std::string_view built_in_prefix = "built-in:";

builtin_head::Tone tone_of(const std::string& name, std::string_view skin) {
  using builtin_head::Tone;
  if (skin == "light") return Tone::light;
  if (skin == "medium") return Tone::medium;
  if (skin == "dark") return Tone::dark;
  throw input_error(name, "the built-in head has no skin '{}'; {}", skin,
                    listed_names(skin, {"light", "medium", "dark"}));
}

std::array<double, 3> values_of(const glm::vec3& v) { return {v.x, v.y, v.z}; }

}  // namespace

Asset Asset::load(const std::filesystem::path& path, const SceneOptions& options, const Hooks& hooks) {
  const HookScope scope(hooks);
  const scene::LoadOptions load = load_options(options);
  if (const std::string name = path.string(); name.starts_with(built_in_prefix)) {
    const std::string skin = name.substr(built_in_prefix.size());
    scene::Scene made = builtin_head::make({.tone = tone_of(name, skin), .cache = cache::default_folder()});
    if (skin != "medium") made.name = name;
    const bool changed = wanted_pigments(options).changes();
    return State::make(
        with_pigments(std::move(made), options),
        changed ? std::nullopt : std::optional(State::Source{.file = {}, .options = {}, .skin = skin}));
  }
  if (api::open_scene_file(path))
    throw input_error(path.string(), "is a scene file, and an asset is glTF; give a scene file alone");

  return State::make(with_pigments(scene::load_gltf(path, load), options),
                     State::Source{.file = std::filesystem::absolute(path), .options = options});
}

Asset Asset::from_arrays(const AssetArrays& arrays, const SceneOptions& options, const Hooks& hooks) {
  const HookScope scope(hooks);
  if (options.unit_scale != 1)
    throw input_error("", "unit_scale must be 1 for arrays, whose unit is the metre, got {}",
                      options.unit_scale);
  if (!options.clip.empty() || options.time_s)
    throw input_error("", "clip and time_s must be empty for arrays");
  const scene::LoadOptions load = load_options(options);
  return State::make(with_pigments(scene::scene_from_arrays(arrays, load), options));
}

Asset Asset::built_in(const Hooks& hooks) {
  const HookScope scope(hooks);
  scene::Scene made = builtin_head::make({.cache = cache::default_folder()});
  return State::make(std::make_shared<const scene::Scene>(std::move(made)), State::Source{});
}

const std::string& Asset::name() const { return state_->data->name; }

std::vector<std::string> Asset::materials() const {
  std::vector<std::string> names;
  for (const scene::Material& material : state_->data->materials) names.push_back(material.name);
  return names;
}

std::vector<std::string> Asset::cameras() const {
  std::vector<std::string> names;
  for (const scene::Camera& camera : state_->data->cameras) names.push_back(camera.name);
  return names;
}

std::vector<std::string> Asset::clips() const { return state_->data->clips; }

double Asset::clip_end_s(const std::string& clip) const {
  return api::find_clip(*state_->data, clip).end_s();
}
std::vector<std::string> Asset::joints() const { return api::joint_names(*state_->data); }
std::vector<std::string> Asset::morph_weights() const { return api::morph_names(*state_->data); }

AssetBounds Asset::bounds() const {
  const scene::Bounds bounds = scene::skin_bounds(*state_->data);
  return {.low_m = values_of(bounds.low_m),
          .high_m = values_of(bounds.high_m),
          .centre_m = values_of(bounds.sphere.centre_m),
          .radius_m = double{bounds.sphere.radius_m}};
}

std::vector<Light> Asset::lights() const {
  std::vector<Light> lights;
  for (const scene::Light& light : state_->data->lights)
    lights.push_back({.name = light.name,
                      .type = type_of(light.type),
                      .colour = values_of(light.colour),
                      .position_m = values_of(light.position_m),
                      .direction = values_of(light.direction),
                      .range_m = light.range_m,
                      .inner_cone_deg = light.inner_cone_rad * degrees_per_radian,
                      .outer_cone_deg = std::min(light.outer_cone_rad * degrees_per_radian, 90.0),
                      .radius = light.radius});
  return lights;
}

}  // namespace dermis
