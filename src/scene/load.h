// SPDX-License-Identifier: MIT
// Scenes from files. Every limit is checked before memory is taken; whatever is wrong ends in one InputError
// that names file and place.
#pragma once

#include <filesystem>
#include <string>

#include "scene/scene.h"

namespace dermis::scene {

struct LoadOptions {
  double unit_scale = 1;      ///< multiplies every length of the file (positions, lights, cameras)
  std::string skin_material;  ///< --skin NAME: this material is skin; empty: extras.dermis, else the name
                              ///< contains "skin", else the only one
  std::size_t max_triangles = 20'000'000;
  int max_map_side = 16384;  ///< pixels
  /// For all maps of the scene, 1e6 bytes, 1 to 1e6: as decoded and on the device with their levels, 9.3
  /// bytes per texel, 14.7 of colour maps. Over it the largest maps are halved while they are read, with a
  /// note.
  double texture_budget_mb = 2000;
};

/// glTF 2.0, .gltf or .glb. Missing normals and tangents are made (scene/tangents.h). Warnings go to
/// core/log.h.
Scene load_gltf(const std::filesystem::path& path, const LoadOptions& options = {});

}  // namespace dermis::scene
