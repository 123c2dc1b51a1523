// SPDX-License-Identifier: MIT
// Traces light through the medium under the skin, from the camera's side: a random walk between the triangles
// of a closed mesh.
// Based on:
// [WJZ95]  Wang, Jacques, Zheng: MCML. CMPB 47, 1995 (steps, boundary)
// [WNDS14] Wilkie, Nawaz, Droske, Weidlich, Hanika: Hero Wavelength Spectral Sampling. EGSR 2014 (one walk
//          for three channels)
#pragma once

#include <glm/glm.hpp>

#include "rays/ray_scene.h"
#include "tissue/optics/media.h"
#include "truth/reference/random.h"

namespace dermis::reference {

/// Three channels with common g and eta, coefficients per unit of the scene.
struct WalkMedium {
  glm::dvec3 sigma_a{0}, sigma_s{0}, sigma_t{0};
  double g = 0, eta = 1;

  /// Throws InputError if the channels differ in g or eta.
  WalkMedium(const optics::RgbMedium& medium, double mm_per_unit);
};

struct WalkEnd {
  enum class How {
    left,      ///< through a triangle, to the outside
    absorbed,  ///< ended by roulette
    lost,      ///< through a hole of the mesh; counts as absorbed
  } how = How::absorbed;
  glm::dvec3 weight{0};     ///< remaining weight per channel, for 1 that entered
  rays::Hit hit;            ///< where it left
  glm::dvec3 direction{0};  ///< outside, refracted
  int scatterings = 0;
};

/// Returns the refraction of the unit direction d at a face with unit normal n against d (d.n < 0), n_ratio =
/// index before / index after. Zero length under total reflection.
glm::dvec3 refracted(const glm::dvec3& d, const glm::dvec3& n, double n_ratio);

/// Walks from a point under the skin, in a direction inside it. Free paths are sampled for one channel and
/// weighted for all three by the balance heuristic. At a face the walk is reflected with Fresnel's
/// probability; roulette ends it below a weight of 0.05. A walk is lost if it meets the front of a face or
/// leaves the box around the skin, which a closed mesh does not allow.
WalkEnd walk(const rays::RayScene& rays, const WalkMedium& medium, const glm::dvec3& start_m,
             const glm::dvec3& direction, Random& random);

}  // namespace dermis::reference
