// SPDX-License-Identifier: MIT
/// Poses of an instance: a clip of its asset at a time, two of them blended, morph weights and joints by
/// name.
///
///   scene.pose(head, "performance", 1.5);
///   scene.set_pose(head, dermis::RigPose{.clip = dermis::ClipTime{"performance", 1.5},
///                                        .weights = {{"jawOpen", 0.4}}});
///   scene.set_pose(head, {});  // as the asset was loaded
///
/// Moving parts are those of a glTF file: its nodes ("joints"), skins, morph targets and animations
/// ("clips"). Asset::clips(), joints() and morph_weights() name them. A pose moves vertices, on the device
/// and without loading anything again. Camera, lamps and the unit of distances stay those of the asset as it
/// was loaded, so that a picture does not breathe with a mouth. docs/scenes.md lists what else is at rest.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace dermis {

/// A clip at a time: before its first key and after its last, it stands still.
struct ClipTime {
  std::string clip{};  ///< as Asset::clips() names it, or its number there; empty: the first
  double seconds = 0;  ///< any finite number
};

/// The weight of a morph target, in place of what a clip has.
struct MorphWeight {
  std::string name{};  ///< as Asset::morph_weights() names it; of all meshes that have one of that name
  double weight = 0;   ///< -100 to 100; 0: none of it, 1: all of it
};

/// A node against its parent, in place of its transform in a clip. It scales, then turns, then moves. A
/// member without a value stays as in the clip, or else in the asset as it was loaded.
struct JointTransform {
  std::string name{};                                  ///< as Asset::joints() names it
  std::optional<std::array<double, 3>> translation{};  ///< in the file's unit of length, -1e6 to 1e6
  std::optional<std::array<double, 4>> rotation{};     ///< quaternion x y z w, of any length but 0
  std::optional<std::array<double, 3>> scale{};        ///< -1000 to 1000
};

struct RigPose {
  std::optional<ClipTime> clip{};    ///< none: the asset as it was loaded
  std::optional<ClipTime> second{};  ///< of what `clip` is blended with: rotations along the shorter arc
  double blend = 0;                  ///< 0 to 1, the share of `second`; has no meaning without it
  // Over both clips, in their order.
  std::vector<MorphWeight> weights{};
  std::vector<JointTransform> joints{};
};

}  // namespace dermis
