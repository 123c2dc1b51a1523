// SPDX-License-Identifier: MIT
// Bodies whose shape is simple, and the light that leaves them: what the laws of tissue/profile/shape_laws.h
// are fitted to and held against. Light is followed by walk(), as in a picture of the volume model.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "head/scene/asset_data.h"
#include "tissue/optics/media.h"

namespace dermis::reference {

/// The surface is that of skin around the point that is looked at:
enum class Shape : std::uint8_t {
  sphere,
  cylinder,
  bowl,    ///< the inside of a sphere
  groove,  ///< the inside of a cylinder
  saddle,  ///< curved as much to both sides, one of which is convex
  slab,
  wedge  ///< two planes
};

/// Returns the names, in the order of Shape.
std::span<const std::string_view> shape_names();

struct Body {
  Shape shape = Shape::sphere;
  /// > 0: the radius, of a slab its thickness, of a wedge the distance of the point from the edge
  double size_mm = 10;
  double angle_deg = 60;  ///< of a wedge, 10 to 170
};

/// Returns a closed mesh of skin, in which the point that is looked at is the origin, and its normal +z. The
/// axis of a cylinder or groove is y; a saddle is convex along x; the edge of a wedge lies along y at +x.
/// Where the shape has no end, the mesh ends `reach_mm` away.
scene::AssetData mesh_of(const Body& body, double reach_mm);

/// Options of the walks.
struct ShapeWalks {
  std::uint64_t walks = 100'000;  ///< >= 64
  std::uint64_t seed = 1;
  /// directions to the light: degrees from the normal at the point, in the plane of x and z, positive towards
  /// +x
  std::vector<double> lights_deg{0};
  bool across = false;  ///< in the plane of y and z instead
};

inline constexpr std::size_t exit_bins = 5;  ///< of the cosine of the angle of exit, evenly from 0 to 1

/// Light that leaves the point, for a parallel light that gives a surface that faces it an irradiance of 1.
/// In parts of what a half-space returns of that irradiance, so that a plane lit at an angle shows its
/// cosine.
struct ShapeLight {
  double light_deg = 0;
  optics::Rgb exitance{}, exitance_error{};                         ///< and one standard error
  std::array<optics::Rgb, exit_bins> radiance{}, radiance_error{};  ///< times pi
};

/// Follows light to the origin of the body from all lights at once, so that their noise is common. Every
/// point that faces a light is lit: bodies cast no shadows. Throws InputError for a medium whose channels
/// differ in g or eta, a size or an angle out of range, too few walks; Cancelled if a hook ends it.
std::vector<ShapeLight> follow(const Body& body, const optics::RgbMedium& medium, const ShapeWalks& walks);

}  // namespace dermis::reference
