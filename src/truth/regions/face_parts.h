// SPDX-License-Identifier: MIT
// Lips, neck and side of the face at the vertices of skin, and parts that are no skin, once for each asset.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "head/scene/asset_data.h"
#include "head/scene/surface/unwrap.h"

namespace dermis::regions {

/// Of a vertex of skin, metres; each number is 0 at a border.
struct FacePlace {
  float lips = -1;           ///< distance inside the outline of the lips, and not behind them
  float above_parting = -1;  ///< of the lips
  float behind_lips = -1;    ///< distance inside their outline, and behind them
  float below_jaw = -1;      ///< distance below the jaw line
  float left = 0;            ///< of the middle of the face, +X
};

/// Finds them from the 68 points of iBUG, of which `points_m` are the places in the asset at rest.
class FacePlaces {
 public:
  explicit FacePlaces(std::span<const glm::dvec3> points_m);
  FacePlace at(const glm::dvec3& p_m) const;

 private:
  double jaw_height_m(const glm::dvec3& p_m) const;
  double front_m(const glm::dvec2& p) const;

  std::vector<glm::dvec2> outline_;  ///< of the lips, x and y
  std::vector<glm::dvec3> lips_;     ///< points on them
  std::vector<glm::dvec2> parting_;  ///< by x: its height
  std::vector<glm::dvec2> jaw_;      ///< by angle around the axis of the head: its height
  double middle_x_m_ = 0, axis_z_m_ = 0;
};

enum class NamedPart : std::uint8_t { none, eye, brow, mouth, hair, lashes };

/// Returns the part that words of a name say: "Eyes_left" is an eye. The earliest rule that fits counts, so
/// that an "eyelash" is none.
NamedPart named_part(std::string_view name);

}  // namespace dermis::regions
