// SPDX-License-Identifier: MIT
// Finds which triangles of a scene a ray hits; wraps Embree. Metres; results do not depend on the number of
// threads.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "head/scene/asset_data.h"

namespace dermis::rays {

/// A ray: points origin + t * direction (unit) with t in (t_min, t_max).
struct Ray {
  glm::dvec3 origin_m{0}, direction{0, 0, 1};
  double t_min_m = 0, t_max_m = 1e30;
};

struct Hit {
  std::uint32_t primitive = 0;  ///< index into AssetData::primitives
  std::uint32_t triangle = 0;
  double u = 0, v = 0;  ///< weights of the second and third corner
  double t_m = 0;
  std::uint32_t copy = 0;  ///< index of the placement, if the primitive has some
};

/// Returns the distance from the surface at which a new ray starts: slightly more than rounding to float can
/// move a point of this size.
inline double stand_off_m(const glm::dvec3& p) {
  return 1e-6 * (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) + 1e-3);
}

class RayScene {
 public:
  /// Keeps a reference to the scene. Counts steps (base/core/hooks.h): takes seconds for millions of
  /// triangles. Throws DeviceError if Embree cannot start, and Cancelled if its caller ends it.
  explicit RayScene(const scene::AssetData& scene);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  const scene::AssetData& scene() const { return *scene_; }

  std::optional<Hit> nearest(const Ray& ray) const;       ///< among all triangles
  std::optional<Hit> nearest_skin(const Ray& ray) const;  ///< among triangles of skin
  /// Among all that casts shadows: opaque materials, and what the alpha test leaves of cut-out ones. Blended
  /// parts (lashes, brows) cast no shadow, which would be that of their whole card.
  std::optional<Hit> nearest_solid(const Ray& ray) const;
  bool solid_between(const Ray& ray) const;  ///< whether such a surface lies on the ray
  /// Returns whether the point lies in the bounding box of the skin.
  bool in_skin_box(const glm::dvec3& p) const {
    return glm::all(glm::greaterThanEqual(p, low_m_)) && glm::all(glm::lessThanEqual(p, high_m_));
  }
  /// Writes all triangles of skin on the ray, near to far, to `hits`.
  void all_skin(const Ray& ray, std::vector<Hit>& hits) const;

 private:
  struct Scenes;
  std::optional<Hit> nearest_cut_out(Ray ray) const;
  const scene::AssetData* scene_;
  std::unique_ptr<Scenes> scenes_;
  bool has_cut_outs_ = false;
  glm::dvec3 low_m_{1e300}, high_m_{-1e300};
};

/// Returns whether the primitive is skin, with or without texture coordinates.
bool is_skin(const scene::AssetData& scene, const scene::Primitive& primitive);

}  // namespace dermis::rays
