// SPDX-License-Identifier: MIT
#include "truth/reference/diffusion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "truth/reference/axes.h"

namespace dermis::reference {
namespace {

using std::numbers::pi;

constexpr double reach_in_sigma = 5;
/// Probes of each kind per sample, spread evenly over terms and radii. Most of the noise comes from which
/// term was sampled, and the camera ray and reflections serve all probes.
constexpr int strata = 4;
// The normal finds nearly everything and is always probed. One of the two tangents, which find steep parts,
// is probed.
constexpr std::array axis_chance{1.0, 0.5, 0.5};

/// With these probabilities the sum of the channels' variances is smallest, if the terms hardly overlap.
double importance(const Gaussian& g) { return std::hypot(g.weight[0], g.weight[1], g.weight[2]); }

}  // namespace

Diffusion::Diffusion(const ScatterProfile& profile, double mm_per_unit) : mm_per_unit_(mm_per_unit) {
  double all = 0;
  for (const Gaussian& g : profile.terms)
    if (g.variance_mm2 > 0) all += importance(g);

  for (const Gaussian& g : profile.terms) {
    if (importance(g) == 0) continue;
    if (g.variance_mm2 == 0) {
      unscattered_ += glm::dvec3(g.weight[0], g.weight[1], g.weight[2]);
      continue;
    }

    Term term{};
    term.variance_mm2 = g.variance_mm2;
    term.reach_mm = reach_in_sigma * std::sqrt(g.variance_mm2);
    term.weight = {g.weight[0], g.weight[1], g.weight[2]};
    term.chance = importance(g) / all;
    term.density =
        term.chance / (2 * pi * g.variance_mm2) / -std::expm1(-0.5 * reach_in_sigma * reach_in_sigma);
    terms_.push_back(term);
  }
}

glm::dvec3 Diffusion::profile(double radius_mm) const {
  glm::dvec3 sum(0);
  for (const Term& t : terms_)
    sum += t.weight * (std::exp(-radius_mm * radius_mm / (2 * t.variance_mm2)) / (2 * pi * t.variance_mm2));
  return sum;
}

// Returns the density per mm^2 of skin: an axis sees the point at its projected radius, on a face seen at an
// angle.
double Diffusion::density(const glm::dvec3& offset_mm, const std::array<glm::dvec3, 3>& axes,
                          const glm::dvec3& face_normal) const {
  const double distance2 = glm::dot(offset_mm, offset_mm);
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double along = glm::dot(offset_mm, axes[k]);
    const double projected2 = std::max(0.0, distance2 - along * along);
    double disk = 0;
    for (const Term& t : terms_)
      if (distance2 <= t.reach_mm * t.reach_mm)
        disk += t.density * std::exp(-projected2 / (2 * t.variance_mm2));
    sum += axis_chance[k] * disk * std::abs(glm::dot(face_normal, axes[k]));
  }
  return sum;
}

// Returns a ray: its radius is that of a Gaussian in the plane perpendicular to the axis, cut off at the
// reach. The ray is a chord of the ball of this reach.
rays::Ray Diffusion::probe(const rays::SurfacePoint& o, const std::array<glm::dvec3, 3>& axes,
                           std::size_t axis, double pick, double angle) const {
  std::size_t index = 0;
  while (index + 1 < terms_.size() && pick >= terms_[index].chance) pick -= terms_[index++].chance;
  const Term& term = terms_[index];
  // The rest of the number is uniform again.
  const double pick_radius = std::clamp(pick / term.chance, 0.0, 1.0);
  const double within = -std::expm1(-0.5 * reach_in_sigma * reach_in_sigma);
  const double radius_mm = std::sqrt(-2 * term.variance_mm2 * std::log1p(-pick_radius * within));
  const double half_m =
      std::sqrt(std::max(0.0, term.reach_mm * term.reach_mm - radius_mm * radius_mm)) / mm_per_unit_;
  const glm::dvec3 across = std::cos(angle) * axes[(axis + 1) % 3] + std::sin(angle) * axes[(axis + 2) % 3];
  const glm::dvec3 centre = o.position_m + (radius_mm / mm_per_unit_) * across;
  return {
      .origin_m = centre - half_m * axes[axis], .direction = axes[axis], .t_min_m = 0, .t_max_m = 2 * half_m};
}

glm::dvec3 Diffusion::sample(const rays::RayScene& rays, const rays::SurfacePoint& o, Random& random,
                             std::vector<rays::Hit>& scratch,
                             const std::function<glm::dvec3(const rays::SurfacePoint&)>& light) const {
  const glm::dvec3 here = unscattered_ == glm::dvec3(0) ? unscattered_ : unscattered_ * light(o);
  if (terms_.empty()) return here;

  const std::array<glm::dvec3, 3> axes = axes_of(o.face_normal);
  glm::dvec3 sum(0);
  for (int probed = 0; probed < 2 * strata; ++probed) {
    const std::size_t axis = probed % 2 == 0 ? 0 : random.next() < 0.5 ? 1 : 2;
    const double pick = (probed / 2 + random.next()) / strata, angle = 2 * pi * random.next();
    rays.all_skin(probe(o, axes, axis, pick, angle), scratch);
    for (const rays::Hit& hit : scratch) {
      const rays::SurfacePoint x = rays::surface_point(rays.scene(), hit);
      const glm::dvec3 offset_mm = (x.position_m - o.position_m) * mm_per_unit_;
      const double found = density(offset_mm, axes, x.face_normal);
      if (found > 0) sum += profile(glm::length(offset_mm)) * light(x) / found;
    }
  }
  return here + sum / static_cast<double>(strata);
}

}  // namespace dermis::reference
