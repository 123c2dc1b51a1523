// SPDX-License-Identifier: MIT
#include "truth/reference/walk.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/core/error.h"
#include "rays/surface_point.h"
#include "tissue/optics/fresnel.h"
#include "truth/reference/axes.h"

namespace dermis::reference {
namespace {

using std::numbers::pi;

constexpr int max_events = 4'000'000;  // total reflection can keep light in clear glass for ever
constexpr double roulette_below = 0.05;

/// Returns a direction sampled from Henyey-Greenstein about d.
glm::dvec3 scattered(const glm::dvec3& d, double g, Random& random) {
  const double u = random.next(), phi = 2 * pi * random.next();
  double cosine = 1 - 2 * u;
  if (g != 0) {
    const double part = (1 - g * g) / (1 - g + 2 * g * (1 - u));
    cosine = std::clamp((1 + g * g - part * part) / (2 * g), -1.0, 1.0);
  }
  return around(d, cosine, phi);
}

/// The state of a walk: throughput over the density of the channel that samples, and the densities of all
/// three channels over the same.
struct Carried {
  glm::dvec3 throughput{1}, density{1};

  glm::dvec3 weight() const { return throughput * (3 / (density.x + density.y + density.z)); }
  void move(const WalkMedium& m, double distance, double sigma_hero) {
    const glm::dvec3 transmitted = glm::exp((glm::dvec3(sigma_hero) - m.sigma_t) * distance);
    throughput *= transmitted;
    density *= transmitted;
  }
  void scatter(const WalkMedium& m, double sigma_hero) {
    throughput *= m.sigma_s / sigma_hero;
    density *= m.sigma_t / sigma_hero;
    // Avoids overflow after thousands of steps in a medium whose channels differ: only the ratio matters.
    const double most = std::max({density.x, density.y, density.z});
    if (most > 1e50) {
      throughput /= most;
      density /= most;
    }
  }
};

}  // namespace

WalkMedium::WalkMedium(const optics::RgbMedium& medium, double mm_per_unit)
    : g(medium[0].g), eta(medium[0].eta) {
  for (int c = 0; c < 3; ++c) {
    const optics::Medium& m = medium[static_cast<std::size_t>(c)];
    if (m.g != g || m.eta != eta) throw input_error("medium", "one g and one eta must serve all channels");
    sigma_a[c] = m.sigma_a_per_mm * mm_per_unit;
    sigma_s[c] = m.sigma_s_per_mm * mm_per_unit;
    sigma_t[c] = m.sigma_t_per_mm() * mm_per_unit;
  }
}

glm::dvec3 refracted(const glm::dvec3& d, const glm::dvec3& n, double n_ratio) {
  const double cosine = -glm::dot(d, n), k = 1 - n_ratio * n_ratio * (1 - cosine * cosine);
  if (k < 0) return glm::dvec3(0);
  return glm::normalize(n_ratio * d + (n_ratio * cosine - std::sqrt(k)) * n);
}

WalkEnd walk(const rays::RayScene& rays, const WalkMedium& medium, const glm::dvec3& start_m,
             const glm::dvec3& direction, Random& random) {
  WalkEnd end;
  // Samples all free paths by one channel; weight() divides by the mean density of all three.
  const int hero = std::min(2, static_cast<int>(3 * random.next()));
  const double sigma_hero = medium.sigma_t[hero];
  Carried carried;
  glm::dvec3 at = start_m, to = direction;

  for (int event = 0; event < max_events; ++event) {
    const double free_path = -std::log(random.next()) / sigma_hero;
    const std::optional<rays::Hit> hit =
        rays.nearest_skin({.origin_m = at, .direction = to, .t_min_m = 0, .t_max_m = free_path});
    if (!hit) {
      at += free_path * to;
      if (!rays.in_skin_box(at)) break;  // left through a hole
      carried.move(medium, free_path, sigma_hero);
      carried.scatter(medium, sigma_hero);
      to = scattered(to, medium.g, random);
      ++end.scatterings;

      const glm::dvec3 weight = carried.weight();
      const double most = std::max({weight.x, weight.y, weight.z});
      if (most < roulette_below) {
        if (!(random.next() * roulette_below < most)) return end;
        carried.throughput *= roulette_below / most;
      }
      continue;
    }

    const rays::SurfacePoint s = rays::surface_point(rays.scene(), *hit);
    const double cosine = glm::dot(s.face_normal, to);
    if (cosine <= 0) break;  // the front of a face: the walk is outside
    carried.move(medium, hit->t_m, sigma_hero);
    const double gap = rays::stand_off_m(s.position_m);

    if (random.next() >= optics::fresnel(std::min(cosine, 1.0), medium.eta)) {
      end.how = WalkEnd::How::left;
      end.weight = carried.weight();
      end.hit = *hit;
      end.direction = refracted(to, -s.face_normal, medium.eta);
      return end;
    }
    to = glm::normalize(to - 2 * cosine * s.face_normal);
    at = s.position_m - gap * s.face_normal;
  }

  end.how = WalkEnd::How::lost;
  return end;
}

}  // namespace dermis::reference
