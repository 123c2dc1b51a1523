// SPDX-License-Identifier: MIT
// The triangles of a scene for rays: Embree behind a small door. Metres; results do not depend on the number
// of threads.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "scene/scene.h"

namespace dermis::rays {

/// A ray from `origin_m`, points at origin + t * direction (unit) with t in (t_min, t_max).
struct Ray {
  glm::dvec3 origin_m{0}, direction{0, 0, 1};
  double t_min_m = 0, t_max_m = 1e30;
};

struct Hit {
  std::uint32_t primitive = 0;  ///< of Scene::primitives
  std::uint32_t triangle = 0;
  double u = 0, v = 0;  ///< weights of the second and third corner
  double t_m = 0;
  std::uint32_t copy = 0;  ///< which placement of the primitive, if it has some
};

/// How far a new ray stands off the surface that it starts from: what rounding to float can move a point of
/// this size, and a little more.
inline double stand_off_m(const glm::dvec3& p) {
  return 1e-6 * (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) + 1e-3);
}

class RayScene {
 public:
  /// Keeps a reference to the scene. DeviceError: Embree could not start.
  explicit RayScene(const scene::Scene& scene);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  const scene::Scene& scene() const { return *scene_; }

  std::optional<Hit> nearest(const Ray& ray) const;       ///< of all triangles
  std::optional<Hit> nearest_skin(const Ray& ray) const;  ///< of skin
  /// Of what casts shadows: opaque materials, and what the alpha test leaves of cut-out ones. Blended parts
  /// (lashes, brows) would cast the shadow of their whole card, so they cast none.
  std::optional<Hit> nearest_solid(const Ray& ray) const;
  bool solid_between(const Ray& ray) const;  ///< does any of that lie on the ray?
  /// Is the point in the bounding box of the skin?
  bool in_skin_box(const glm::dvec3& p) const {
    return glm::all(glm::greaterThanEqual(p, low_m_)) && glm::all(glm::lessThanEqual(p, high_m_));
  }
  /// All triangles of skin on the ray, near to far, into `hits`, which is emptied first.
  void all_skin(const Ray& ray, std::vector<Hit>& hits) const;

 private:
  struct Scenes;
  std::optional<Hit> nearest_cut_out(Ray ray) const;
  const scene::Scene* scene_;
  std::unique_ptr<Scenes> scenes_;
  bool has_cut_outs_ = false;
  glm::dvec3 low_m_{1e300}, high_m_{-1e300};
};

/// Returns whether the primitive is skin, with or without texture coordinates.
bool is_skin(const scene::Scene& scene, const scene::Primitive& primitive);

}  // namespace dermis::rays
