// SPDX-License-Identifier: MIT
// Loads scenes. Every limit is checked before memory is taken; any fault ends in one InputError that names
// file and place.
#pragma once

#include <filesystem>
#include <string>

#include "scene/scene.h"

namespace dermis::scene {

struct LoadOptions {
  double unit_scale = 1;      ///< multiplies every length in the file (positions, lights, cameras)
  std::string skin_material;  ///< this material is skin; empty: extras.dermis, else the name
                              ///< contains "skin", else the only one
  std::size_t max_triangles = 20'000'000;
  int max_map_side = 16384;  ///< pixels
  /// For all maps of the scene, in 1e6 bytes, 1 to 1e6: decoded maps and mip levels on the device, 9.3 bytes
  /// per texel, 14.7 for colour maps. If it is exceeded, the largest maps are downsampled by 2 while they are
  /// read, with a note.
  double texture_budget_mb = 2000;
};

/// Loads glTF 2.0, .gltf or .glb. Makes missing normals and tangents (scene/tangents.h). Warnings go to
/// core/log.h.
Scene load_gltf(const std::filesystem::path& path, const LoadOptions& options = {});

}  // namespace dermis::scene
