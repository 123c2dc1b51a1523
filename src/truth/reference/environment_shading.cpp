// SPDX-License-Identifier: MIT
// Light from a picture of the environment at a point: the visible part, and what occluders reflect over any
// number of bounces. Occluders reflect diffusely by their base colour, without scattering: under the light of
// a hemisphere nobody sees the difference.
// Based on: Veach, Guibas: Optimally Combining Sampling Techniques for Monte Carlo Rendering. SIGGRAPH 1995
//           (balance heuristic)
#include <algorithm>
#include <cmath>
#include <numbers>

#include "truth/reference/axes.h"
#include "truth/reference/shading.h"

namespace dermis::reference {
namespace {

using std::numbers::pi;

constexpr int most_bounces = 64;         // roulette ends nearly all paths long before
constexpr double most_survivors = 0.95;  // also in white caves

glm::dvec3 cosine_drawn(const glm::dvec3& n, Random& random) {
  const double r2 = random.next();
  return around(n, std::sqrt(1 - r2), 2 * pi * random.next());
}

}  // namespace

glm::dvec3 Shading::sent_on(const rays::SurfacePoint& s, Random& random, int bounces) const {
  const glm::dvec3 colour = glm::min(albedo(materials_[s.material], s), glm::dvec3(1));
  const double goes_on = std::min(most_survivors, std::max({colour.x, colour.y, colour.z}));
  if (bounces > most_bounces || random.next() >= goes_on) return glm::dvec3(0);
  const glm::dvec3 d =
      random.next() < 0.5 ? setup_.environment->draw(random) : cosine_drawn(s.normal, random);
  const double cosine = glm::dot(s.normal, d);
  if (cosine <= 0) return glm::dvec3(0);
  const double density = 0.5 * (setup_.environment->density(d) + cosine / pi);
  return arriving_from(s, d, random, bounces) * (colour * (cosine / (pi * density * goes_on)));
}

glm::dvec3 Shading::arriving_from(const rays::SurfacePoint& s, const glm::dvec3& direction, Random& random,
                                  int bounces) const {
  // The mapped normal sees directions below the surface.
  if (glm::dot(s.normal, direction) <= 0) return sent_on(s, random, bounces + 1);
  const rays::Ray ray = shadow_ray(s, {.to_light = direction});
  const std::optional<rays::Hit> hit = rays_->nearest_solid(ray);
  if (!hit) return setup_.environment->radiance(direction);
  rays::SurfacePoint other = rays::surface_point(rays_->scene(), *hit);
  if (glm::dot(other.face_normal, direction) > 0) {
    if (!materials_[other.material].source->double_sided) return glm::dvec3(0);  // the inside of a body
    other.normal *= -1;
    other.face_normal *= -1;
  }
  return sent_on(other, random, bounces + 1);
}

glm::dvec3 Shading::entering_from_environment(const rays::SurfacePoint& s, const glm::dvec3& n,
                                              const SkinSpecular& spec, Random& random) const {
  const EnvironmentSampler& sky = *setup_.environment;
  glm::dvec3 e(0);
  for (const glm::dvec3& d : {sky.draw(random), cosine_drawn(n, random)}) {
    const double cosine = glm::dot(n, d);
    if (cosine <= 0) continue;
    e += arriving_from(s, d, random, 0) *
         (cosine * (1 - table_.at(spec, cosine)) / (sky.density(d) + cosine / pi));
  }
  const ShadingMaterial& m = materials_[s.material];
  const double open = std::max(occlusion(m, s), 0.002);
  // Occluders of a painted map count as skin in the same light: the series of its bounces.
  return e / (1 - table_.mean(spec)) * (open / (1.0 - glm::min(albedo(m, s), glm::dvec3(1)) * (1 - open)));
}

glm::dvec3 Shading::reflected_environment(const rays::SurfacePoint& s, const glm::dvec3& n,
                                          const SkinSpecular& spec, const glm::dvec3& to_eye,
                                          Random& random) const {
  const EnvironmentSampler& sky = *setup_.environment;
  glm::dvec3 sum(0);
  for (const glm::dvec3& d : {sky.draw(random), lobe_drawn(spec, n, to_eye, random)}) {
    const double cosine = glm::dot(n, d);
    if (cosine <= 0) continue;
    const double density = sky.density(d) + lobe_density(spec, n, to_eye, d);
    if (density > 0)
      sum += arriving_from(s, d, random, 0) * (cosine * specular_brdf(spec, n, to_eye, d) / density);
  }
  return sum * occlusion(materials_[s.material], s);
}

}  // namespace dermis::reference
