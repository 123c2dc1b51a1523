// SPDX-License-Identifier: MIT
// A picture of the environment as a light: radiance from a direction, and directions sampled by brightness.
// Based on: [PJH16] Pharr, Jakob, Humphreys: Physically Based Rendering. 3rd edition 2016, sec. 14.2.4
// (infinite area lights)
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "environment/environment.h"
#include "truth/reference/random.h"

namespace dermis::reference {

class EnvironmentSampler {
 public:
  /// Multiplies radiance by intensity >= 0. Turns the picture about +Y by rotation_deg, from the head's front
  /// (+Z) towards its left (+X).
  EnvironmentSampler(environment::Environment picture, double intensity, double rotation_deg);

  /// Returns the radiance from a unit direction, bilinear between pixels.
  glm::dvec3 radiance(const glm::dvec3& direction) const;
  /// Samples a direction by the brightness of cells (at most 1024 x 512), uniform over the solid angle of
  /// each; any direction if all is black.
  glm::dvec3 draw(Random& random) const;
  /// Returns the density of draw() per steradian; 0 if all is black.
  double density(const glm::dvec3& direction) const;

  const environment::Environment& picture() const { return picture_; }
  double intensity() const { return intensity_; }
  double rotation_rad() const { return rotation_rad_; }

 private:
  glm::dvec3 to_picture(const glm::dvec3& direction) const;
  double solid_angle(int row) const;

  environment::Environment picture_;
  double intensity_, rotation_rad_;
  int columns_ = 0, rows_ = 0;
  std::vector<double> cumulative_;  // share of the light in all cells up to this one, row by row
};

}  // namespace dermis::reference
