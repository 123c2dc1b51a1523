// SPDX-License-Identifier: MIT
/// A scene as a frame or the reference takes it: assets, each with its pose, and lights in the world.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dermis/settings.h"
#include "head/scene/asset_data.h"
#include "head/scene/rig/rig.h"
#include "head/scene/similarity.h"
#include "tissue/gaussians/sum.h"

namespace dermis::setup {

/// An asset in a pose of its joints and morph targets, in its own coordinates.
struct PosedAsset {
  scene::PosedRig rig;
  scene::Bounds skin, all;           ///< hold its vertices, not tightly
  std::vector<glm::vec3> corners_m;  ///< their convex hull does so more tightly
};

struct PlacedInstance {
  std::shared_ptr<const scene::AssetData> asset;
  scene::Similarity world_from_asset;
  std::shared_ptr<const PosedAsset> posed;  ///< null: as the asset was loaded
  std::uint64_t posed_change = 0;           ///< InstanceChanges::rig
  bool visible = true;
  // Instead of those of the materials.
  std::optional<ScatterProfile> profile;
  std::optional<float> mix;
  glm::vec3 tint{1};  ///< multiplies the colour of the skin
};

struct PlacedScene {
  std::string name;  ///< for messages
  std::vector<PlacedInstance> instances;
  std::vector<scene::Light> lights;  ///< in the world
};

/// Throws InputError: an asset with nothing to see.
void check_seen(const PlacedScene& scene);

/// Spheres around the skin of the heads, by which cameras and rigs are placed.
struct HeadSpheres {
  scene::BoundingSphere middle;  ///< about the middle of the heads, as large as the largest of them
  std::vector<scene::BoundingSphere> framed;  ///< all visible instances; of a row, the middle head
  /// The rig stands around this: the middle as long as all heads lie within its lamps, else all heads.
  scene::BoundingSphere lit;
  std::vector<glm::vec3> offsets_m;  ///< from there to heads that the rig must reach too
};
HeadSpheres head_spheres(const PlacedScene& scene, const RenderSettings& settings);

/// Returns the cameras of all instances, in the world.
std::vector<scene::Camera> placed_cameras(const PlacedScene& scene);

/// Returns one asset that shows the same: copies of all visible instances in the world, with materials of
/// their own, and their skin, but not measured otherwise. Of a single one that is as its asset is, returns
/// that. For what knows no instances, such as the reference. Takes memory for each copy.
std::shared_ptr<const scene::AssetData> flattened(const PlacedScene& scene);

}  // namespace dermis::setup
