// SPDX-License-Identifier: MIT
#include "truth/reference/tracer.h"

#include <cmath>

#include "base/core/hooks.h"
#include "rays/alpha_test.h"
#include "tissue/profile/monte_carlo.h"
#include "truth/reference/camera_ray.h"

namespace dermis::reference {
namespace {

/// Ends a step and makes the next part.
template <class Make>
auto next(Steps& steps, const Make& make) {
  steps.done();
  return make();
}

}  // namespace

glm::dvec3 diffuse_total(const optics::RgbMedium& medium) {
  glm::dvec3 total(1);
  Steps channels("spread of light in skin", 3);
  for (int c = 0; c < 3; ++c, channels.done()) {
    const optics::Medium& m = medium[static_cast<std::size_t>(c)];
    if (m.sigma_a_per_mm == 0) continue;  // all light returns
    profile::ScatterScene scene = profile::scene_of(m);
    scene.light = profile::ScatterScene::Light::diffuse;
    total[c] = profile::monte_carlo(scene, {.photons = 400'000, .seed = 1, .cache = {}})->reflected_total;
  }
  return total;
}

Tracer::Tracer(const scene::AssetData& scene, const Job& job, Steps steps)
    : job_(job),
      rays_(scene),
      shading_(next(steps, [&] { return Shading(rays_, job.setup); })),
      medium_(job.medium, scene.mm_per_unit) {
  steps.done();
  if (job.model != ReferenceModel::volume)
    for (const ScatterProfile& profile : job.profiles) diffusion_.emplace_back(profile, scene.mm_per_unit);
  if (job.model == ReferenceModel::volume) medium_total_ = diffuse_total(job.medium);
  steps.done();
}

glm::dvec3 Tracer::from_the_medium(const rays::SurfacePoint& s, const glm::dvec3& to_eye,
                                   Random& random) const {
  // The camera ray enters by Snell's law; by reciprocity this is the path on which light leaves.
  const double facing = glm::dot(to_eye, s.face_normal);
  if (facing <= 0) return glm::dvec3(0);
  const glm::dvec3 inside = refracted(-to_eye, s.face_normal, 1 / medium_.eta);
  const double gap = rays::stand_off_m(s.position_m);
  const WalkEnd end = walk(rays_, medium_, s.position_m - gap * s.face_normal, inside, random);
  walks_.fetch_add(1, std::memory_order_relaxed);
  if (end.how == WalkEnd::How::lost) lost_.fetch_add(1, std::memory_order_relaxed);
  if (end.how != WalkEnd::How::left) return glm::dvec3(0);
  // Light enters as through a rough surface, spread over all directions: along the walk its radiance is E/pi.
  return end.weight / medium_total_ *
         shading_.light_in_skin(rays::surface_point(rays_.scene(), end.hit), random);
}

glm::dvec3 Tracer::skin_radiance(rays::SurfacePoint& s, double side, const glm::dvec3& to_eye, Random& random,
                                 std::vector<rays::Hit>& scratch) const {
  glm::dvec3 scattered(0);
  if (job_.model != ReferenceModel::volume)
    scattered = diffusion_[s.material].sample(rays_, s, random, scratch, [&](const rays::SurfacePoint& x) {
      return shading_.light_in_skin(x, random);
    });
  else
    scattered = from_the_medium(s, to_eye, random);
  s.normal *= side;
  return scattered * shading_.leaving_factor(s, to_eye) + shading_.skin_reflection(s, to_eye, random) +
         shading_.emitted(s);
}

Tracer::Sample Tracer::sample(int x, int y, Random& random, std::vector<rays::Hit>& scratch) const {
  const double px = x + random.next(), py = y + random.next();
  rays::Ray ray = camera_ray(job_.setup, px, py);
  const glm::dvec3 to_eye = -ray.direction;
  const scene::AssetData& scene = rays_.scene();

  Sample out;
  double through = 1;
  while (through > 1e-6) {
    const std::optional<rays::Hit> hit = rays_.nearest(ray);
    if (!hit) break;

    rays::SurfacePoint s = rays::surface_point(scene, *hit);
    const double side = glm::dot(s.face_normal, to_eye) >= 0 ? 1 : -1;
    const ShadingMaterial& material = shading_.material(s.material);
    if ((side > 0 || material.source->double_sided) && !rays::is_cut_away(scene, s)) {
      if (material.skin) {
        out.radiance += through * skin_radiance(s, side, to_eye, random, scratch);
        out.skin = through;
        break;
      }
      const Shading::Surface surface = shading_.surface(s, side, to_eye, random);
      out.radiance += through * surface.alpha * surface.radiance;
      through *= 1 - surface.alpha * (1 - surface.passes);
    }

    // Continues behind this surface, at the next larger float.
    ray.t_min_m = std::nextafter(static_cast<float>(hit->t_m), 1e30f);
  }

  out.radiance *= job_.setup.radiance_scale;
  return out;
}

}  // namespace dermis::reference
