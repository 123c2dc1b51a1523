// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>

#include "truth/reference/shading.h"

namespace dermis::reference {

Arriving arriving_light(const scene::Light& light, const glm::dvec3& position_m) {
  Arriving a;
  const glm::dvec3 colour(light.colour), direction(light.direction);
  if (light.type == LightType::directional) {
    a.irradiance = colour;
    a.to_light = -direction;
    return a;
  }

  const glm::dvec3 d = glm::dvec3(light.position_m) - position_m;
  const double d2 = std::max(glm::dot(d, d), 1e-8);
  a.distance_m = std::sqrt(d2);
  a.to_light = d / a.distance_m;
  a.irradiance = colour / d2;
  if (light.range_m > 0) a.irradiance *= std::clamp(1 - std::pow(a.distance_m / light.range_m, 4), 0.0, 1.0);

  if (light.type == LightType::spot) {
    const double outer = std::cos(light.outer_cone_rad), inner = std::cos(light.inner_cone_rad);
    const double c =
        std::clamp((glm::dot(direction, -a.to_light) - outer) / std::max(inner - outer, 1e-4), 0.0, 1.0);
    a.irradiance *= c * c;
  }
  return a;
}

Arriving arriving_light(const scene::Light& light, const glm::dvec3& position_m, Random& random) {
  Arriving a = arriving_light(light, position_m);
  if (!(light.radius > 0)) return a;
  const double tangent = light.radius / (light.type == LightType::directional ? 1 : a.distance_m);
  const double r = tangent * std::sqrt(random.next()), angle = 2 * std::numbers::pi * random.next();
  const glm::dvec3 across = glm::normalize(
      glm::cross(a.to_light, std::abs(a.to_light.x) < 0.8 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  const glm::dvec3 towards =
      a.to_light + r * (std::cos(angle) * across + std::sin(angle) * glm::cross(a.to_light, across));
  const double length = glm::length(towards);
  a.to_light = towards / length;
  a.distance_m *= length;
  a.irradiance *= length;  // the whole disc has the nominal irradiance on a surface that faces it
  return a;
}

rays::Ray shadow_ray(const rays::SurfacePoint& s, const Arriving& light) {
  const double gap = rays::stand_off_m(s.shadow_origin_m);
  const double side = glm::dot(s.normal, light.to_light) < 0 ? -1 : 1;
  return {.origin_m = s.shadow_origin_m + side * gap * s.normal,
          .direction = light.to_light,
          .t_min_m = gap,
          .t_max_m = light.distance_m - 2 * gap};
}

// Everything opaque casts a shadow, from either side of its triangles; cut-out parts cast that of what the
// alpha test leaves.
bool Shading::shadowed(const rays::SurfacePoint& s, const Arriving& light) const {
  const rays::Ray ray = shadow_ray(s, light);
  if (ray.t_max_m <= ray.t_min_m) return false;
  return rays_->solid_between(ray);
}

}  // namespace dermis::reference
