// SPDX-License-Identifier: MIT
// Where the camera and the lamps stand when the scene does not say: framing, the paper's test, the light rig.
// Based on: [JG08] Jimenez, Gutierrez: Faster rendering of human skin. CEIG 2008, sec. 6 (heads in a row,
// distance in bounding-sphere radii).
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace dermis::scene {

/// Around the centre of the points' bounding box, up to the farthest point. Not the smallest sphere (0.258 m
/// on the scan against 0.293 m): this is the convention that renderers and engines share, and distances of
/// the paper's test are counted in its radii, so it must stay. The radius is grown by 1e-6 so that rounding
/// leaves no point outside. No points: a sphere of radius 0 at the origin.
BoundingSphere bounding_sphere(std::span<const glm::vec3> points_m);

/// bounding_sphere of all vertices of the primitives that `counts`, however often they stand in the world.
BoundingSphere bounding_sphere(const Scene& scene, const std::function<bool(const Primitive&)>& counts);

/// bounding_sphere of the skin; of everything if nothing is skin. Only vertices that a triangle uses count.
BoundingSphere skin_sphere(const Scene& scene);

/// Unit vector from a head towards azimuth (0 = its front, +Z; 90 = its left, +X) and elevation (90 = +Y),
/// degrees.
glm::dvec3 head_direction(double azimuth_deg, double elevation_deg);

/// Looks at the centre of the sphere, whose outline fills `fill` of the smaller side of the picture. aspect =
/// width / height > 0. InputError: aspect or field of view out of range, or an empty sphere.
Camera framing_camera(const BoundingSphere& sphere, double aspect, double azimuth_deg = 0,
                      double elevation_deg = 0, double fov_y_deg = 20, double fill = 0.95);

/// The paper's test: the eye stands `distance_radii` (> 0) sphere radii in front of the centre of the middle
/// head and looks at it. InputError: distance_radii is not a positive number, or an empty sphere.
Camera distance_camera(const BoundingSphere& middle_head, double distance_radii, double fov_y_deg = 20);

/// Offsets of `heads` (>= 1) heads in a row along x, 1.6 radii apart; number floor(heads / 2) stands at the
/// origin.
std::vector<glm::vec3> head_row_offsets(int heads, double radius_m);

/// From the centre to each light of the rig, in radii of the sphere.
inline constexpr double rig_distance_radii = 4;

/// The rig: key, fill, rim and the k-th further lights (at most 256), spots 4 radii from the centre, aimed at
/// it, each with the irradiance at the centre given at rig_lamp(). `head_offsets_m`: where further heads of
/// this size stand; cones are widened to hold them all (at most 85 degrees). The sphere lies within the inner
/// cone, so a head is lit evenly; the outer cone is 2 degrees wider. InputError: count out of range, or an
/// empty sphere.
std::vector<Light> light_rig(const BoundingSphere& sphere, int count,
                             std::span<const glm::vec3> head_offsets_m = {});

/// Where a lamp of the rig stands, by head_direction(), and what it brings to the centre of the sphere on a
/// surface that faces it.
struct Lamp {
  std::string name;
  double azimuth_deg = 0, elevation_deg = 0;
  glm::dvec3 irradiance{0};
};

/// Lamps of one's own in the geometry of the rig. InputError: an empty sphere.
std::vector<Light> light_rig(const BoundingSphere& sphere, std::span<const Lamp> lamps,
                             std::span<const glm::vec3> head_offsets_m = {});

}  // namespace dermis::scene
