// SPDX-License-Identifier: MIT
// Based on: [DLE07] d'Eon, Luebke, Enderton: Efficient Rendering of Human Skin. EGSR 2007, sec. 3.4 and GPU
// Gems 3, ch. 14
#include <algorithm>
#include <cmath>
#include <numbers>

#include "rays/alpha_test.h"
#include "truth/reference/shading.h"

namespace dermis::reference {
namespace {

using std::numbers::pi;

// Returns albedo^exponent; safe for the exponent 0 and for black texels.
glm::dvec3 power(const glm::dvec3& albedo, double exponent) {
  if (exponent <= 0) return glm::dvec3(1);
  return glm::pow(glm::max(albedo, glm::dvec3(1e-6)), glm::dvec3(exponent));
}

}  // namespace

Shading::Shading(const rays::RayScene& rays, const RenderSetup& setup)
    : rays_(&rays), setup_(setup), materials_(shading_materials(rays.scene(), setup.mix)) {}

glm::dvec3 Shading::mapped_normal(const ShadingMaterial& m, const rays::SurfacePoint& s,
                                  const glm::dvec3& normal) const {
  if (!m.normal.present() && !m.detail.present()) return normal;
  const auto slope = [&](const MapSlot& map) {
    return (glm::dvec3(map.read(s.uv)) * 2.0 - 1.0) * glm::dvec3(map.map.scale, map.map.scale, 1);
  };
  glm::dvec3 t = m.normal.present() ? slope(m.normal) : glm::dvec3(0, 0, 1);
  if (m.detail.present()) {
    // Slopes of heights add up.
    const glm::dvec3 d = slope(m.detail);
    const double up = std::max(d.z, 0.1);
    t = {t.x * up + d.x * t.z, t.y * up + d.y * t.z, t.z * up};
  }
  // MikkTSpace: the bitangent is computed per point, the tangent is used as interpolated.
  const glm::dvec3 tangent(s.tangent);
  const glm::dvec3 n = tangent * t.x + glm::cross(normal, tangent) * (s.tangent.w * t.y) + normal * t.z;
  const double length2 = glm::dot(n, n);
  return length2 > 1e-12 ? n / std::sqrt(length2) : normal;
}

// A mapped normal may face away from the camera at a silhouette; a visible point needs a positive cosine.
glm::dvec3 Shading::eye_normal(const ShadingMaterial& m, const rays::SurfacePoint& s,
                               const glm::dvec3& normal, const glm::dvec3& to_eye) const {
  const glm::dvec3 n = mapped_normal(m, s, normal);
  const double n_v = glm::dot(n, to_eye);
  return n_v < 0.05 ? glm::normalize(n + to_eye * (0.05 - n_v)) : n;
}

glm::dvec3 Shading::albedo(const ShadingMaterial& m, const rays::SurfacePoint& s) const {
  if (setup_.white_albedo) return glm::dvec3(1);
  glm::dvec3 colour = glm::dvec3(m.source->base_colour) * glm::dvec3(s.colour);
  if (m.base_colour.present()) colour *= glm::dvec3(m.base_colour.read(s.uv));
  return glm::max(colour, glm::dvec3(0));
}

SkinSpecular Shading::skin_specular(const ShadingMaterial& m, const rays::SurfacePoint& s) const {
  SkinSpecular spec;
  spec.rho_s = setup_.specular ? 0.18 : 0;  // [DLE07] GPU Gems 3, ch. 14.3
  if (m.specular.present()) spec.rho_s *= m.specular.map.scale * m.specular.channel(s.uv);
  double roughness = m.source->roughness;
  if (m.roughness.present()) roughness = m.roughness.map.scale * m.roughness.channel(s.uv);
  const double beckmann_m = std::clamp(roughness * roughness, 0.02, 1.0);
  const double r = (m.source->ior - 1.0) / (m.source->ior + 1.0);
  spec.f0 = r * r;
  const auto& lobes = m.source->skin_settings.lobes;
  for (std::size_t i = 0; i < 2; ++i) {
    spec.m[i] = std::clamp(beckmann_m * (i < lobes.size() ? lobes[i].roughness_factor : 1.0), 0.02, 1.0);
    spec.weight[i] = i < lobes.size() ? lobes[i].weight : lobes.empty() && i == 0 ? 1.0 : 0.0;
  }
  return spec;
}

double Shading::occlusion(const ShadingMaterial& m, const rays::SurfacePoint& s) const {
  return m.occlusion.present() ? 1 + m.occlusion.map.scale * (m.occlusion.read(s.uv).r - 1) : 1;
}

// Sum over the lights of E (1 - rho(L)) / (1 - rho_mean), plus the environment: what the surface reflects
// does not enter.
glm::dvec3 Shading::entering_irradiance(const rays::SurfacePoint& s, Random& random) const {
  const ShadingMaterial& m = materials_[s.material];
  const SkinSpecular spec = skin_specular(m, s);
  const glm::dvec3 n = mapped_normal(m, s, s.normal);
  glm::dvec3 e(0);
  for (const scene::Light& light : setup_.lights) {
    const Arriving a = arriving_light(light, s.position_m, random);
    const double cosine = glm::dot(n, a.to_light);
    if (cosine <= 0 || glm::dot(s.normal, a.to_light) <= 0 || a.irradiance == glm::dvec3(0) || shadowed(s, a))
      continue;
    e += a.irradiance * (cosine * (1 - table_.at(spec, cosine)));
  }
  e /= 1 - table_.mean(spec);
  return e + (setup_.environment ? entering_from_environment(s, n, spec, random)
                                 : glm::dvec3(setup_.ambient * pi * occlusion(m, s)));
}

glm::dvec3 Shading::light_in_skin(const rays::SurfacePoint& s, Random& random) const {
  if (rays::is_cut_away(rays_->scene(), s)) return glm::dvec3(0);
  const ShadingMaterial& m = materials_[s.material];
  const glm::dvec3 before = m.mix_before > 0 ? power(albedo(m, s), m.mix_before) : glm::dvec3(1);
  return entering_irradiance(s, random) * before / pi;
}

glm::dvec3 Shading::leaving_factor(const rays::SurfacePoint& s, const glm::dvec3& to_eye) const {
  const ShadingMaterial& m = materials_[s.material];
  const glm::dvec3 n = eye_normal(m, s, s.normal, to_eye);
  return power(albedo(m, s), 1 - m.mix_before) * (1 - table_.at(skin_specular(m, s), glm::dot(n, to_eye)));
}

glm::dvec3 Shading::skin_reflection(const rays::SurfacePoint& s, const glm::dvec3& to_eye,
                                    Random& random) const {
  const ShadingMaterial& m = materials_[s.material];
  const SkinSpecular spec = skin_specular(m, s);
  if (spec.rho_s <= 0) return glm::dvec3(0);
  const glm::dvec3 n = eye_normal(m, s, s.normal, to_eye);
  glm::dvec3 sum(0);
  for (const scene::Light& light : setup_.lights) {
    const Arriving a = arriving_light(light, s.position_m, random);
    const double cosine = glm::dot(n, a.to_light);
    if (cosine <= 0 || glm::dot(s.normal, a.to_light) <= 0 || a.irradiance == glm::dvec3(0) || shadowed(s, a))
      continue;
    sum += a.irradiance * (cosine * specular_brdf(spec, n, to_eye, a.to_light));
  }
  if (setup_.environment) return sum + reflected_environment(s, n, spec, to_eye, random);
  // A uniform environment is reflected by the directional albedo of the lobes.
  return sum + glm::dvec3(setup_.ambient * table_.at(spec, glm::dot(n, to_eye)) * occlusion(m, s));
}

}  // namespace dermis::reference
