// SPDX-License-Identifier: MIT
#include "head/scene/framing.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "base/core/error.h"
#include "head/scene/placement.h"

namespace dermis::scene {
namespace {

constexpr double radians_per_degree = glm::pi<double>() / 180;
constexpr double least_look_m = 1e-4;
constexpr float look_at_near_m = 1e-4f;  // reversed depth without a far plane keeps its precision

void require_sphere(const BoundingSphere& sphere) {
  if (!(sphere.radius_m > 0) || !std::isfinite(sphere.radius_m))
    throw input_error("camera", "the scene is empty: its bounding sphere has radius {} m", sphere.radius_m);
}

/// Returns a camera frame at `eye` that looks from this azimuth and elevation towards the target. Built from
/// the angles, so that straight above has a defined up.
glm::mat4 look(const glm::dvec3& eye, double azimuth_deg, double elevation_deg) {
  const double a = azimuth_deg * radians_per_degree;
  const glm::dvec3 back = head_direction(azimuth_deg, elevation_deg);
  const glm::dvec3 right(std::cos(a), 0, -std::sin(a));
  return glm::mat4(glm::dmat4(glm::dvec4(right, 0), glm::dvec4(glm::cross(back, right), 0),
                              glm::dvec4(back, 0), glm::dvec4(eye, 1)));
}

void require_fov(double fov_y_deg) {
  if (!(fov_y_deg > 0 && fov_y_deg < 180))
    throw input_error("fov_deg", "must be between 0 and 180 degrees, got {}", fov_y_deg);
}

void require_aspect(double aspect) {
  if (!(aspect > 0) || !std::isfinite(aspect))
    throw input_error("camera", "aspect must be > 0, got {}", aspect);
}

Camera camera_at(const BoundingSphere& sphere, double distance_m, double azimuth_deg, double elevation_deg,
                 double fov_y_deg) {
  Camera camera;
  const glm::dvec3 eye =
      glm::dvec3(sphere.centre_m) + distance_m * head_direction(azimuth_deg, elevation_deg);
  camera.world_from_camera = look(eye, azimuth_deg, elevation_deg);
  camera.fov_y_rad = static_cast<float>(fov_y_deg * radians_per_degree);
  camera.znear_m = 0.01f * sphere.radius_m;  // reversed depth without a far plane keeps its precision
  return camera;
}

Lamp rig_lamp(int index, int count) {
  if (index == 0) return {"key", 45, 35, 3.0 * glm::dvec3(1, 0.96, 0.90)};
  if (index == 1) return {"fill", -60, 10, 0.8 * glm::dvec3(0.85, 0.92, 1)};
  if (index == 2) return {"rim", 160, 25, glm::dvec3(2)};
  return {fmt::format("light {}", index + 1), 360.0 * (index - 2) / (count - 3) + 15, 20, glm::dvec3(1)};
}

/// Returns the half angle of the cone from `from` along `axis` (unit) that holds the ball; pi if `from` lies
/// inside.
double cone_around(const glm::dvec3& from, const glm::dvec3& axis, const glm::dvec3& centre, double radius) {
  const glm::dvec3 to = centre - from;
  const double distance = glm::length(to);
  if (distance <= radius) return glm::pi<double>();
  return std::acos(std::clamp(glm::dot(to, axis) / distance, -1.0, 1.0)) + std::asin(radius / distance);
}

/// Returns the bounds of points; for_each(visit) calls visit(position) for the same points each time.
template <class ForEach>
Bounds bounds_around(const ForEach& for_each) {
  bool any = false;
  glm::vec3 low(0), high(0);
  for_each([&](const glm::vec3& p) {
    low = any ? glm::min(low, p) : p;
    high = any ? glm::max(high, p) : p;
    any = true;
  });
  if (!any) return {};

  const glm::vec3 centre(0.5 * (glm::dvec3(low) + glm::dvec3(high)));
  double radius = 0;
  for_each([&](const glm::vec3& p) {
    radius = std::max(radius, glm::distance(glm::dvec3(p), glm::dvec3(centre)));
  });
  return {low, high, {centre, static_cast<float>(radius * (1 + 1e-6))}};
}

}  // namespace

BoundingSphere bounding_sphere(std::span<const glm::vec3> points_m) {
  return bounds_around([&](const auto& visit) { std::for_each(points_m.begin(), points_m.end(), visit); })
      .sphere;
}

BoundingSphere bounding_sphere(const AssetData& scene, const std::function<bool(const Primitive&)>& counts) {
  return bounds_around([&](const auto& visit) {
           for (const Primitive& p : scene.primitives)
             if (counts(p)) for_each_position(p, visit);
         })
      .sphere;
}

Bounds skin_bounds(const AssetData& scene) {
  const auto is_skin = [&](const Primitive& p) {
    return scene.materials.at(static_cast<std::size_t>(p.material)).skin;
  };
  const bool any_skin = std::any_of(scene.primitives.begin(), scene.primitives.end(), is_skin);
  return bounds_around([&](const auto& visit) {
    for (const Primitive& p : scene.primitives) {
      if (any_skin && !is_skin(p)) continue;
      for (std::size_t copy = 0; copy < copies_of(p); ++copy)
        for (const std::uint32_t index : p.indices) visit(world_position_m(p, copy, index));
    }
  });
}

glm::dvec3 head_direction(double azimuth_deg, double elevation_deg) {
  const double a = azimuth_deg * radians_per_degree, e = elevation_deg * radians_per_degree;
  return {std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e)};
}

Camera framing_camera(const BoundingSphere& sphere, double aspect, double azimuth_deg, double elevation_deg,
                      double fov_y_deg, double fill) {
  require_sphere(sphere);
  require_fov(fov_y_deg);
  require_aspect(aspect);
  // A ball at distance d has the half angle asin(R/d), which is R / sqrt(d^2 - R^2) on the picture plane.
  const double half_side = fill * std::tan(0.5 * fov_y_deg * radians_per_degree) * std::min(1.0, aspect);
  const double distance_m = sphere.radius_m * std::sqrt(1 + 1 / (half_side * half_side));
  return camera_at(sphere, distance_m, azimuth_deg, elevation_deg, fov_y_deg);
}

Camera group_camera(std::span<const BoundingSphere> spheres, double aspect, double azimuth_deg,
                    double elevation_deg, double fov_y_deg, double fill) {
  require_fov(fov_y_deg);
  require_aspect(aspect);
  const glm::dmat3 axes(look(glm::dvec3(0), azimuth_deg, elevation_deg));
  const auto in_view = [&](const BoundingSphere& s) { return glm::transpose(axes) * glm::dvec3(s.centre_m); };

  glm::dvec3 low(HUGE_VAL), high(-HUGE_VAL);
  BoundingSphere middle;
  for (const BoundingSphere& sphere : spheres) {
    low = glm::min(low, in_view(sphere) - double{sphere.radius_m});
    high = glm::max(high, in_view(sphere) + double{sphere.radius_m});
    middle.radius_m = std::max(middle.radius_m, sphere.radius_m);
  }
  require_sphere(middle);
  const glm::dvec3 centre = 0.5 * (low + high);
  middle.centre_m = glm::vec3(axes * centre);

  // The eye stands so far back that each ball touches the planes of the filled part at most. From a plane of
  // half angle a through the eye, a ball at (x, z) is (distance - z) sin a - |x| cos a away.
  const double half_height = fill * std::tan(0.5 * fov_y_deg * radians_per_degree);
  const double half_angles[] = {std::atan(half_height * aspect), std::atan(half_height)};
  double distance_m = 0;
  for (const BoundingSphere& sphere : spheres) {
    const glm::dvec3 at = in_view(sphere) - centre;
    for (glm::length_t axis = 0; axis < 2; ++axis) {
      const double a = half_angles[axis];
      const double beside = double{sphere.radius_m} + std::abs(at[axis]) * std::cos(a);
      distance_m = std::max(distance_m, at.z + beside / std::sin(a));
    }
  }
  return camera_at(middle, distance_m, azimuth_deg, elevation_deg, fov_y_deg);
}

Camera distance_camera(const BoundingSphere& middle_head, double distance_radii, double azimuth_deg,
                       double elevation_deg, double fov_y_deg) {
  require_sphere(middle_head);
  require_fov(fov_y_deg);
  if (!(distance_radii > 0) || !std::isfinite(distance_radii))
    throw input_error("distance", "must be > 0 bounding-sphere radii, got {}", distance_radii);
  return camera_at(middle_head, distance_radii * middle_head.radius_m, azimuth_deg, elevation_deg, fov_y_deg);
}

Camera look_at_camera(const glm::dvec3& eye_m, const glm::dvec3& target_m, double fov_y_deg) {
  require_fov(fov_y_deg);
  const glm::dvec3 away = eye_m - target_m;
  const double distance_m = glm::length(away);
  if (!(distance_m >= least_look_m) || !std::isfinite(distance_m))
    throw input_error(
        "", "camera.eye_m and camera.target_m must be finite and 0.1 mm apart: there is nowhere to look");

  // The azimuth of a camera straight above or below is that of the front.
  const double azimuth = std::hypot(away.x, away.z) > 1e-9 * distance_m ? std::atan2(away.x, away.z) : 0;
  const double elevation = std::asin(std::clamp(away.y / distance_m, -1.0, 1.0));
  Camera camera;
  camera.world_from_camera = look(eye_m, azimuth / radians_per_degree, elevation / radians_per_degree);
  camera.fov_y_rad = static_cast<float>(fov_y_deg * radians_per_degree);
  camera.znear_m = look_at_near_m;
  return camera;
}

std::vector<glm::vec3> head_row_offsets(int heads, double radius_m) {
  if (heads < 1) throw input_error("heads", "must be at least 1, got {}", heads);
  std::vector<glm::vec3> offsets;
  for (int i = 0; i < heads; ++i)
    offsets.emplace_back(static_cast<float>(1.6 * radius_m * (i - heads / 2)), 0.f, 0.f);
  return offsets;
}

std::vector<Light> light_rig(const BoundingSphere& sphere, int count,
                             std::span<const glm::vec3> head_offsets_m) {
  if (count < 0 || count > 256) throw input_error("rig_lights", "must be 0 to 256, got {}", count);
  std::vector<Lamp> lamps;
  for (int i = 0; i < count; ++i) lamps.push_back(rig_lamp(i, count));
  return light_rig(sphere, lamps, head_offsets_m);
}

std::vector<Light> light_rig(const BoundingSphere& sphere, std::span<const Lamp> lamps,
                             std::span<const glm::vec3> head_offsets_m) {
  require_sphere(sphere);
  const double radius = sphere.radius_m, distance = rig_distance_radii * radius;
  const glm::dvec3 centre(sphere.centre_m);

  std::vector<Light> lights;
  for (const Lamp& lamp : lamps) {
    const glm::dvec3 towards = head_direction(lamp.azimuth_deg, lamp.elevation_deg);
    const glm::dvec3 position = centre + distance * towards;
    double cone = cone_around(position, -towards, centre, radius);
    for (const glm::vec3& offset : head_offsets_m)
      cone = std::max(cone, cone_around(position, -towards, centre + glm::dvec3(offset), radius));

    Light light;
    light.name = lamp.name;
    light.type = LightType::spot;
    light.colour = glm::vec3(lamp.irradiance * distance * distance);
    light.position_m = glm::vec3(position);
    light.direction = glm::vec3(-towards);
    // Keeps the outer cone, 2 degrees wider, below a right angle.
    light.inner_cone_rad = static_cast<float>(std::min(cone, 83 * radians_per_degree));
    light.outer_cone_rad =
        static_cast<float>(std::min(cone, 83 * radians_per_degree) + 2 * radians_per_degree);
    lights.push_back(light);
  }
  return lights;
}

}  // namespace dermis::scene
