// SPDX-License-Identifier: MIT
// Places cameras and lights if the scene does not: framing, the paper's test of distance, the light rig.
// Based on: [JG08] Jimenez, Gutierrez: Faster rendering of human skin. CEIG 2008, sec. 6 (heads in a row,
// distance in bounding-sphere radii).
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "head/scene/asset_data.h"

namespace dermis::scene {

/// Returns a sphere around the centre of the points' bounding box, up to the farthest point, radius enlarged
/// by 1e-6 against rounding. It is not the smallest sphere (0.258 m on the scan against 0.293 m) but the
/// convention of renderers and engines. Distances of the paper's test are counted in its radii. No points: a
/// sphere of radius 0 at the origin.
BoundingSphere bounding_sphere(std::span<const glm::vec3> points_m);

/// Returns the bounding_sphere of all vertices of the primitives that `counts`, in all their placements.
BoundingSphere bounding_sphere(const AssetData& scene, const std::function<bool(const Primitive&)>& counts);

/// Returns the bounds of the skin, or of everything if nothing is skin. Counts only vertices of triangles.
Bounds skin_bounds(const AssetData& scene);

/// Returns the unit vector from a head towards azimuth (0 = its front, +Z; 90 = its left, +X) and elevation
/// (90 = +Y), degrees.
glm::dvec3 head_direction(double azimuth_deg, double elevation_deg);

/// Returns a camera that looks at the centre of the sphere, whose outline fills `fill` of the smaller side of
/// the picture. aspect = width / height > 0. Throws InputError if aspect or field of view is out of range, or
/// the sphere empty.
Camera framing_camera(const BoundingSphere& sphere, double aspect, double azimuth_deg = 0,
                      double elevation_deg = 0, double fov_y_deg = 20, double fill = 0.95);

/// Returns a camera that looks at the middle of the spheres, as near as their outlines all stay within `fill`
/// of the picture. Throws as framing_camera().
Camera group_camera(std::span<const BoundingSphere> spheres, double aspect, double azimuth_deg = 0,
                    double elevation_deg = 0, double fov_y_deg = 20, double fill = 0.95);

/// Returns the camera of the paper's test, `distance_radii` (> 0) sphere radii from the centre of the middle
/// head, in front of it but for azimuth and elevation. Throws InputError if distance_radii is not a positive
/// number, or the sphere empty.
Camera distance_camera(const BoundingSphere& middle_head, double distance_radii, double azimuth_deg = 0,
                       double elevation_deg = 0, double fov_y_deg = 20);

/// Returns a camera at `eye_m` with `target_m` in the middle of the picture and +Y up. Where it looks along
/// Y, the upper border is towards -Z (from above) or +Z (from below). Throws InputError if the points are
/// nearer than 0.1 mm, or the field of view is out of range.
Camera look_at_camera(const glm::dvec3& eye_m, const glm::dvec3& target_m, double fov_y_deg = 20);

/// Returns offsets of `heads` (>= 1) heads in a row along x, 1.6 radii apart; number floor(heads / 2) is at
/// the origin.
std::vector<glm::vec3> head_row_offsets(int heads, double radius_m);

/// Distance from the centre to each light of the rig, in radii of the sphere.
inline constexpr double rig_distance_radii = 4;

/// Returns the rig of `count` lights (at most 256): key, fill, rim and further ones. They are spots 4 radii
/// from the centre, aimed at it, with the irradiance at the centre given at rig_lamp(). `head_offsets_m`:
/// positions of further heads of this size; cones widen to hold all of them (at most 85 degrees). The sphere
/// lies within the inner cone, so a head is lit evenly; the outer cone is 2 degrees wider. Throws InputError
/// if count is out of range, or the sphere empty.
std::vector<Light> light_rig(const BoundingSphere& sphere, int count,
                             std::span<const glm::vec3> head_offsets_m = {});

/// A light of the rig: its direction as in head_direction(), and its irradiance at the centre of the sphere
/// on a surface that faces it.
struct Lamp {
  std::string name;
  double azimuth_deg = 0, elevation_deg = 0;
  glm::dvec3 irradiance{0};
};

/// Returns lights of one's own in the geometry of the rig. Throws InputError if the sphere is empty.
std::vector<Light> light_rig(const BoundingSphere& sphere, std::span<const Lamp> lamps,
                             std::span<const glm::vec3> head_offsets_m = {});

}  // namespace dermis::scene
