// SPDX-License-Identifier: MIT
#include "dermis/asset.h"

#include <utility>

#include "api/asset_options.h"
#include "api/asset_state.h"
#include "api/rig_pose.h"
#include "api/scene_state.h"
#include "api/vectors.h"
#include "base/core/error.h"
#include "base/core/hooks.h"
#include "base/settings/check.h"
#include "head/scene/arrays/from_arrays.h"
#include "head/scene/import/complete.h"
#include "head/scene/surface/measured.h"
#include "render/setup/preparation.h"

namespace dermis {
namespace api {

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

bool changes_pigments(const SceneOptions& options) {
  return !options.melanin_map.empty() || !options.haemoglobin_map.empty() || options.melanin_factor != 1 ||
         options.haemoglobin_factor != 1;
}

std::shared_ptr<const scene::AssetData> finished(scene::AssetData&& asset, const SceneOptions& options) {
  const std::string name = asset.name;
  return scene::with_errors_of_import(name, [&] {
    if (changes_pigments(options)) setup::preparation("other pigments").repaint(asset, options);
    return scene::measured(std::move(asset));
  });
}

}  // namespace api

Asset Asset::from_arrays(const AssetArrays& arrays, const SceneOptions& options, const Hooks& hooks) {
  const HookScope scope(hooks);
  if (options.unit_scale != 1)
    throw input_error("", "unit_scale must be 1 for arrays, whose unit is the metre, got {}",
                      options.unit_scale);
  if (!options.clip.empty() || options.time_s)
    throw input_error("", "clip and time_s must be empty for arrays");
  const scene::LoadOptions load = api::load_options(options);
  return State::make(api::finished(scene::scene_from_arrays(arrays, load), options));
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
  const scene::Bounds& bounds = state_->data->bounds;
  return {.low_m = api::array_of(bounds.low_m),
          .high_m = api::array_of(bounds.high_m),
          .centre_m = api::array_of(bounds.sphere.centre_m),
          .radius_m = double{bounds.sphere.radius_m}};
}

std::vector<Light> Asset::lights() const {
  std::vector<Light> lights;
  for (const scene::Light& light : state_->data->lights) lights.push_back(api::light_of(light));
  return lights;
}

}  // namespace dermis
