// SPDX-License-Identifier: MIT
/// Scenes: heads with their maps, lights and cameras. A Scene is a cheap handle; copies share what they hold
/// and never change it.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "dermis/hooks.h"

namespace dermis {

namespace scene {
struct Scene;
}

struct SceneOptions {
  double unit_scale = 1;      ///< multiplies every length of the file; glTF says metres
  std::string skin_material;  ///< this material is skin; empty: extras.dermis, else the name contains "skin",
                              ///< else the only one
  /// For all maps of the scene, 1e6 bytes, 1 to 1e6: as decoded and on the device with their levels, 9.3
  /// bytes per texel, 14.7 of colour maps. Over it the largest maps are halved while they are read, with a
  /// note.
  double texture_budget_mb = 2000;
};

class Scene {
 public:
  /// Loads glTF 2.0, .gltf or .glb. Warns of doubtful things. Takes seconds with large maps. Throws
  /// - InputError: one line with file and place;
  /// - Cancelled: a hook has ended the work.
  static Scene load(const std::filesystem::path& path, const SceneOptions& options = {},
                    const Hooks& hooks = {});
  /// Makes the head that is built into the library; no file needed. Takes seconds. Throws Cancelled as load()
  /// does.
  static Scene built_in(const Hooks& hooks = {});
  /// A scene made by other means.
  explicit Scene(std::shared_ptr<const scene::Scene> data) : data_(std::move(data)) {}

  const std::string& name() const;
  const scene::Scene& data() const { return *data_; }
  const std::shared_ptr<const scene::Scene>& shared() const { return data_; }

 private:
  std::shared_ptr<const scene::Scene> data_;
};

}  // namespace dermis
