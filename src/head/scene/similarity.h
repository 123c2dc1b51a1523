// SPDX-License-Identifier: MIT
/// The way from an asset to the world.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>

#include "head/scene/asset_data.h"

namespace dermis::scene {

/// From the coordinates of an asset to the world: a rotation, one scale, then a shift.
struct Similarity {
  glm::mat3 rotation{1};
  float scale = 1;
  glm::vec3 origin_m{0};

  glm::vec3 direction(const glm::vec3& d) const { return rotation * d; }
  glm::vec3 position(const glm::vec3& p_m) const { return rotation * p_m * scale + origin_m; }
  /// From the world to the asset.
  glm::vec3 position_in_asset(const glm::vec3& p_m) const;
  BoundingSphere sphere(const BoundingSphere& s) const;
  glm::mat4x3 matrix() const;
  bool is_identity() const { return *this == Similarity{}; }
  bool operator==(const Similarity&) const = default;
};

/// Returns that of a column-major 4x4 matrix; none unless it is rigid to 1e-4, with one scale of 1e-3 to
/// 1e3. Scales are rounded to 1e-5, so that the roundings of a host's floats make no difference.
std::optional<Similarity> similarity_of(const std::array<double, 16>& world_from_asset);

}  // namespace dermis::scene
