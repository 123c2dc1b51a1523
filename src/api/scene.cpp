// SPDX-License-Identifier: MIT
#include "dermis/scene.h"

#include "builtin_head/builtin_head.h"
#include "core/hooks.h"
#include "scene/load.h"
#include "scene/scene.h"
#include "settings/check.h"

namespace dermis {

Scene Scene::load(const std::filesystem::path& path, const SceneOptions& options, const Hooks& hooks) {
  const HookScope scope(hooks);
  check_ranges(options);
  scene::LoadOptions load;
  load.unit_scale = options.unit_scale;
  load.skin_material = options.skin_material;
  load.texture_budget_mb = options.texture_budget_mb;
  return Scene(std::make_shared<const scene::Scene>(scene::load_gltf(path, load)));
}

Scene Scene::built_in(const Hooks& hooks) {
  const HookScope scope(hooks);
  return Scene(std::make_shared<const scene::Scene>(builtin_head::make()));
}

const std::string& Scene::name() const { return data_->name; }

}  // namespace dermis
