// SPDX-License-Identifier: MIT
// Shades eyes, teeth, brows, lashes: glTF 2.0 metallic-roughness (specification, appendix B) with GGX and
// height-correlated Smith. A uniform environment is reflected by the split-sum fit of Karis, "Physically
// Based Shading on Mobile", 2014.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "truth/reference/axes.h"
#include "truth/reference/shading.h"

namespace dermis::reference {
namespace {

using std::numbers::pi;

struct Look {
  glm::dvec3 albedo, f0;
  double f90, alpha, roughness;
};

double largest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

Look look_at(const ShadingMaterial& m, const rays::SurfacePoint& s, const glm::dvec3& base) {
  const scene::Material& source = *m.source;
  double metallic = source.metallic, roughness = source.roughness;
  if (m.roughness.present()) {
    const glm::dvec4 t = m.roughness.read(s.uv);
    roughness *= t.g;
    metallic *= t.b;
  }

  double specular = source.specular;
  if (m.specular.present()) specular *= m.specular.read(s.uv).a;
  glm::dvec3 tint(source.specular_colour);
  if (m.specular_colour.present()) tint *= glm::dvec3(m.specular_colour.read(s.uv));

  // Reflectance of a dielectric at normal incidence; tint and strength as in KHR_materials_specular.
  const double r = (source.ior - 1.0) / (source.ior + 1.0);
  const glm::dvec3 dielectric = glm::min(r * r * tint, glm::dvec3(1)) * specular;

  Look look{};
  look.f0 = glm::mix(dielectric, base, metallic);
  look.f90 = glm::mix(specular, 1.0, metallic);
  look.albedo = base * (1 - metallic);
  look.roughness = std::clamp(roughness, 0.045, 1.0);
  look.alpha = look.roughness * look.roughness;
  return look;
}

glm::dvec3 brdf_times_cosine(const Look& look, bool specular, const glm::dvec3& n, const glm::dvec3& v,
                             const glm::dvec3& l) {
  const glm::dvec3 h = glm::normalize(v + l);
  const double n_l = std::max(glm::dot(n, l), 0.0), n_v = std::max(glm::dot(n, v), 1e-3),
               n_h = std::max(glm::dot(n, h), 0.0), v_h = std::max(glm::dot(v, h), 0.0);
  const double a2 = look.alpha * look.alpha, d = n_h * n_h * (a2 - 1) + 1;
  const double distribution = a2 / (pi * d * d);
  const double visibility =
      0.5 /
      std::max(n_l * std::sqrt(n_v * n_v * (1 - a2) + a2) + n_v * std::sqrt(n_l * n_l * (1 - a2) + a2), 1e-5);
  const glm::dvec3 fresnel = look.f0 + (look.f90 - look.f0) * std::pow(1 - v_h, 5);
  glm::dvec3 sum = look.albedo * ((1 - largest(fresnel)) / pi);
  if (specular) sum += fresnel * (distribution * visibility);
  return sum * n_l;
}

/// Samples a direction: a half vector by GGX, mirrored about v. Below, its density per steradian.
glm::dvec3 highlight_drawn(const Look& look, const glm::dvec3& n, const glm::dvec3& v, Random& random) {
  const double u = random.next();
  const glm::dvec3 h =
      around(n, 1 / std::sqrt(1 + look.alpha * look.alpha * u / (1 - u)), 2 * pi * random.next());
  return glm::normalize(2 * glm::dot(v, h) * h - v);
}
double highlight_density(const Look& look, const glm::dvec3& n, const glm::dvec3& v, const glm::dvec3& l) {
  const glm::dvec3 h = glm::normalize(v + l);
  const double n_h = glm::dot(n, h), v_h = glm::dot(v, h), a2 = look.alpha * look.alpha,
               d = n_h * n_h * (a2 - 1) + 1;
  return n_h > 0 && v_h > 0 ? a2 * n_h / (4 * pi * d * d * v_h) : 0;
}

/// Returns the reflection of a picture of the environment; `arriving` gives the radiance from a direction.
glm::dvec3 mirrored_picture(const Look& look, bool specular, const EnvironmentSampler& sky,
                            const glm::dvec3& n, const glm::dvec3& v, Random& random,
                            const std::function<glm::dvec3(const glm::dvec3&)>& arriving) {
  const double r2 = random.next();
  glm::dvec3 sum(0);
  for (const glm::dvec3& d : {sky.draw(random), around(n, std::sqrt(1 - r2), 2 * pi * random.next()),
                              highlight_drawn(look, n, v, random)}) {
    const double cosine = glm::dot(n, d);
    if (cosine <= 0) continue;
    sum += arriving(d) * brdf_times_cosine(look, specular, n, v, d) /
           (sky.density(d) + cosine / pi + highlight_density(look, n, v, d));
  }
  return sum;
}

glm::dvec3 mirrored_uniform(const Look& look, double n_v) {
  const glm::dvec4 c0(-1, -0.0275, -0.572, 0.022), c1(1, 0.0425, 1.04, -0.04);
  const glm::dvec4 r = look.roughness * c0 + c1;
  const double a = std::min(r.x * r.x, std::exp2(-9.28 * n_v)) * r.x + r.y;
  return glm::max(look.f0 * (-1.04 * a + r.z) + look.f90 * (1.04 * a + r.w), glm::dvec3(0));
}

}  // namespace

Shading::Surface Shading::surface(const rays::SurfacePoint& s, double normal_side, const glm::dvec3& to_eye,
                                  Random& random) const {
  const ShadingMaterial& m = materials_[s.material];
  const scene::Material& source = *m.source;
  glm::dvec4 base = glm::dvec4(source.base_colour) * s.colour;
  if (m.base_colour.present()) base *= m.base_colour.read(s.uv);
  if (setup_.white_albedo) base = glm::dvec4(1, 1, 1, base.a);
  if (source.alpha_mode == AssetAlpha::mask && base.a < source.alpha_cutoff)
    return {.radiance = glm::dvec3(0), .alpha = 0};

  Surface out;
  if (source.alpha_mode == AssetAlpha::blend) out.alpha = std::clamp(base.a, 0.0, 1.0);
  const glm::dvec3 albedo(base);
  if (source.unlit) {
    out.radiance = albedo;
    return out;
  }

  rays::SurfacePoint seen = s;
  seen.normal *= normal_side;
  Look look = look_at(m, s, albedo);
  look.albedo *= 1 - double{source.transmission};
  const glm::dvec3 n = mapped_normal(m, s, seen.normal);
  for (const scene::Light& light : setup_.lights) {
    const Arriving a = arriving_light(light, s.position_m, random);
    if (glm::dot(n, a.to_light) <= 0 || a.irradiance == glm::dvec3(0) || shadowed(seen, a)) continue;
    out.radiance += a.irradiance * brdf_times_cosine(look, setup_.specular, n, to_eye, a.to_light);
  }

  const glm::dvec3 mirrored =
      setup_.specular ? mirrored_uniform(look, std::max(glm::dot(n, to_eye), 0.0)) : glm::dvec3(0);
  out.passes = source.transmission * glm::dot(albedo, glm::dvec3(1.0 / 3)) * (1 - largest(mirrored));
  if (setup_.environment) {
    const auto arriving = [&](const glm::dvec3& d) { return arriving_from(seen, d, random, 0); };
    out.radiance += occlusion(m, s) *
                    mirrored_picture(look, setup_.specular, *setup_.environment, n, to_eye, random, arriving);
  } else {
    out.radiance += setup_.ambient * occlusion(m, s) * (look.albedo * (1 - largest(mirrored)) + mirrored);
  }

  out.radiance += emitted(s);
  return out;
}

glm::dvec3 Shading::emitted(const rays::SurfacePoint& s) const {
  const ShadingMaterial& m = materials_[s.material];
  glm::dvec3 out(m.source->emissive);
  if (m.emissive.present()) out *= glm::dvec3(m.emissive.read(s.uv));
  return out;
}

}  // namespace dermis::reference
