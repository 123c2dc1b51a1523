// SPDX-License-Identifier: MIT
// The two specular lobes of skin.
// Based on:
// [DLE07] GPU Gems 3, ch. 14.3
// [WMLT07] Walter et al.: Microfacet Models for Refraction through Rough Surfaces. EGSR 2007
// [Hei14] Heitz: Understanding the Masking-Shadowing Function. JCGT 3(2), 2014
// The lobe is pi times a normalised Beckmann lobe; rho_s = 0.18 goes with that.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "truth/reference/random.h"

namespace dermis::reference {

/// The lobes at one point of skin.
struct SkinSpecular {
  double rho_s = 0;  ///< 0: no reflection
  double f0 = 0;
  std::array<double, 2> m{1, 1}, weight{1, 0};
};

/// Returns f, so that radiance = f * irradiance. All directions are unit vectors.
double specular_brdf(const SkinSpecular& s, const glm::dvec3& n, const glm::dvec3& v, const glm::dvec3& l);

/// Samples a direction l: a lobe's half vector by Beckmann's distribution, mirrored. It may lie below the
/// surface.
glm::dvec3 lobe_drawn(const SkinSpecular& s, const glm::dvec3& n, const glm::dvec3& v, Random& random);
/// Returns the density of lobe_drawn() per steradian.
double lobe_density(const SkinSpecular& s, const glm::dvec3& n, const glm::dvec3& v, const glm::dvec3& l);

/// The directional albedo of the lobes, tabulated (tissue/optics/directional_albedo.h, masking by Smith).
class ReflectanceTable {
 public:
  ReflectanceTable();
  /// For light from (or to) this direction. At most 0.9: painted maps must not reflect all of it.
  double at(const SkinSpecular& s, double cosine) const;
  /// For diffuse light.
  double mean(const SkinSpecular& s) const;

 private:
  double lookup(const SkinSpecular& s, double column) const;
  std::vector<float> table_;
};

}  // namespace dermis::reference
