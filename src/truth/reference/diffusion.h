// SPDX-License-Identifier: MIT
// Light that a profile brings to a point of the skin: the integral of R(|x - o|) times the light at x over
// all skin.
// Based on: [KKCF13] King, Kulla, Conty, Fajardo: BSSRDF Importance Sampling. SIGGRAPH 2013 talks
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "rays/ray_scene.h"
#include "rays/surface_point.h"
#include "tissue/gaussians/sum.h"
#include "truth/reference/random.h"

namespace dermis::reference {

/// A sum of Gaussians, prepared for sampling. |x - o| is the straight distance between both points, through
/// the body or across a fold. So the far side of an ear counts, and on a sphere of radius a the weights sum
/// to 1 - sum_i w_i exp(-2 a^2 / v_i). A term without width is light that leaves where it entered.
class Diffusion {
 public:
  /// Takes mm_per_unit of the scene.
  Diffusion(const ScatterProfile& profile, double mm_per_unit);

  /// Returns R(r) per channel, 1/mm^2, without the term that has no width.
  glm::dvec3 profile(double radius_mm) const;

  /// Returns one sample of the integral of R(|x - o|) light(x) dA. Rays probe the skin along the normal at
  /// `o` and along one of two tangents. Each triangle that they hit within five sigma counts, divided by the
  /// sum of the densities with which all three axes and all terms would have found it [KKCF13]. Unbiased
  /// except for the 4e-6 of a term's light beyond five sigma. `scratch` only saves memory.
  glm::dvec3 sample(const rays::RayScene& rays, const rays::SurfacePoint& o, Random& random,
                    std::vector<rays::Hit>& scratch,
                    const std::function<glm::dvec3(const rays::SurfacePoint&)>& light) const;

 private:
  struct Term {
    double variance_mm2, reach_mm;
    double chance;   // probability of being sampled
    double density;  // chance / (2 pi v) / (part within reach)
    glm::dvec3 weight;
  };
  rays::Ray probe(const rays::SurfacePoint& o, const std::array<glm::dvec3, 3>& axes, std::size_t axis,
                  double pick, double angle) const;
  double density(const glm::dvec3& offset_mm, const std::array<glm::dvec3, 3>& axes,
                 const glm::dvec3& face_normal) const;

  std::vector<Term> terms_;
  glm::dvec3 unscattered_{0};  // weight of the term without width
  double mm_per_unit_;
};

}  // namespace dermis::reference
