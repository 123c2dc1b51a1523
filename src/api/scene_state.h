// SPDX-License-Identifier: MIT
/// State of a Scene, and its readers in the rest of the library.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dermis/scene.h"
#include "render/setup/placed_scene.h"

namespace dermis {

struct Scene::State {
  struct Entry {
    InstanceId id{};
    Instance instance;
    setup::PlacedInstance placed;  ///< the same, checked and converted; without asset
    InstanceChanges changes;
  };
  /// Of a light of a file: the instance whose poses move it, and its number in the asset.
  struct Carrier {
    InstanceId instance{};
    std::size_t number = 0;
  };
  struct PlacedLight {
    LightId id{};
    SceneLight light;
    std::optional<Carrier> carrier{};  ///< none: it is of the caller
  };

  std::string name;  ///< empty: that of the asset
  std::vector<Entry> instances;
  std::vector<PlacedLight> lights;
  std::optional<SceneEnvironment> environment;
  std::uint64_t light_changes = 0, environment_changes = 0;
  std::uint32_t next_id = 1;

  static Scene make(State state) {
    Scene scene;
    *scene.state_ = std::move(state);
    return scene;
  }
};

namespace api {

/// Returns what the asset of a scene of one instance holds.
const scene::AssetData& only_asset(const Scene& scene);

/// Returns the scene as frames and the reference take it.
setup::PlacedScene placed_scene(const Scene& scene);

/// Returns a light of the scene as it stands: what a file has at one of its nodes moves with the pose of its
/// instance.
Light light_now(const Scene::State& scene, const Scene::State::PlacedLight& placed);

/// Returns a light of an asset or of a rig, in its coordinates.
Light light_of(const scene::Light& light);
/// Returns the light of a rig or of the world, in the world.
scene::Light placed_light(const Light& light, const scene::Similarity& world_from_rig);

}  // namespace api
}  // namespace dermis
