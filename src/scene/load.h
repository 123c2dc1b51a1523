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
};

/// glTF 2.0, .gltf or .glb. Missing normals and tangents are made (scene/tangents.h). Warnings go to
/// core/log.h.
Scene load_gltf(const std::filesystem::path& path, const LoadOptions& options = {});

}  // namespace dermis::scene
