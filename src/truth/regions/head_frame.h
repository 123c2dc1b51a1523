// SPDX-License-Identifier: MIT
// Finds the nose and the ears of a head from its shape alone.
// Based on: [SSC08] Shapira, Shamir, Cohen-Or: Consistent Mesh Partitioning and Skeletonisation using the
// Shape Diameter Function. The Visual Computer 24, 2008 (thickness)
#pragma once

#include <optional>

#include "rays/ray_scene.h"
#include "rays/surface_point.h"

namespace dermis::regions {

/// A head that stands upright (+Y) and looks along +Z, as in glTF and for the cameras of this library. The
/// unit of length is half the breadth of the head from ear to ear, about 90 mm on an adult: larger and
/// smaller heads have the same shape.
class HeadFrame {
 public:
  /// Finds a head. The tip of the nose is the foremost point of skin in the upper 260 mm (a head is 230 mm
  /// high; a chest begins below). It counts if the skin beside it and above it, at the cheeks and at the root
  /// of the nose, lies clearly deeper. That distinguishes a face from a ball or a plane. Returns nothing
  /// otherwise.
  static std::optional<HeadFrame> find(const rays::RayScene& rays);

  /// Returns how far the point is inside the nose, a cone along its ridge: half breadths, negative outside.
  double inside_nose(const glm::dvec3& position_m) const;
  bool on_nose(const glm::dvec3& position_m) const { return inside_nose(position_m) >= 0; }
  /// Returns the distance of the point from where no ear can be, half breadths. An ear is at the side, as
  /// high as the face, well behind the tip of the nose. Negative: there. Thin parts beside the head are ears.
  double inside_sides(const glm::dvec3& position_m) const;
  bool beside_the_head(const glm::dvec3& position_m) const { return inside_sides(position_m) > 0; }

  /// Skin beside the head is thin below this, 22 mm on an adult: an ear's root may be filled.
  double ear_thickness_m() const { return 0.25 * half_breadth_m_; }
  /// Skin no farther from thin skin is part of the ear: its bowl is not wider than twice 8 mm.
  double ear_closing_m() const { return 0.09 * half_breadth_m_; }

  double half_breadth_m() const { return half_breadth_m_; }
  glm::dvec3 nose_tip_m() const { return tip_m_; }

 private:
  glm::dvec3 in_half_breadths(const glm::dvec3& position_m) const {
    return (position_m - tip_m_) / half_breadth_m_;
  }
  glm::dvec3 tip_m_{0};
  double half_breadth_m_ = 0;
};

/// Returns the thickness of the body under a point of skin [m]: the median length of 24 rays inwards to where
/// they leave, in a cone of 60 degrees. [SSC08] takes a mean without outliers. Infinity if most rays meet
/// nothing.
double thickness_m(const rays::RayScene& rays, const rays::SurfacePoint& s);

/// Returns the distance [m] to other skin outside of a point of skin: a quarter of 24 rays outwards, in the
/// same cone, meet skin sooner. Infinity in the open.
double gap_m(const rays::RayScene& rays, const rays::SurfacePoint& s);

}  // namespace dermis::regions
