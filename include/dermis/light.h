// SPDX-License-Identifier: MIT
/// Lights, as KHR_lights_punctual has them, in relative units: irradiance pi on white Lambert shows as 1.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace dermis {

enum class LightType : std::uint8_t {
  directional,  ///< from so far away that its rays are parallel
  spot,         ///< from a point, within a cone
  point         ///< from a point, to all sides
};

struct Light {
  std::string name{};  ///< for messages
  LightType type = LightType::directional;
  /// Linear Rec.709, >= 0. Irradiance on a surface that faces the light: colour (directional), colour / d^2
  /// at a distance of d metres (spot, point).
  std::array<double, 3> colour{1, 1, 1};
  std::array<double, 3> position_m{0, 0, 0};  ///< spot, point
  /// The direction in which light travels (directional, spot); of any length but 0.
  std::array<double, 3> direction{0, 0, -1};
  double range_m = 0;          ///< nothing arrives from further away (spot, point); 0: no limit
  double inner_cone_deg = 0;   ///< half angle within which a spot is even: 0 to below outer_cone_deg
  double outer_cone_deg = 45;  ///< half angle at which it ends: up to 90
  /// Of a disc that faces the lit point, for soft shadows: m; directional: tangent of the angular radius. 0:
  /// a point.
  double radius = 0;
  bool operator==(const Light&) const = default;
};

}  // namespace dermis
