// SPDX-License-Identifier: MIT
#include "truth/reference/shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/core/error.h"
#include "base/core/hooks.h"
#include "base/core/parallel.h"
#include "rays/surface_point.h"
#include "tissue/optics/fresnel.h"
#include "truth/reference/tracer.h"
#include "truth/reference/walk.h"

namespace dermis::reference {
namespace {

using std::numbers::pi;

constexpr std::size_t walk_batches = 64;  // their scatter is the noise

/// Sums over the walks of a batch, per light: [0] all, [1 + bin] those that leave at an angle of that bin.
struct Batch {
  std::vector<std::array<glm::dvec3, 1 + exit_bins>> sums;
  std::array<double, 1 + exit_bins> walks{};
};

void check_walks(const Body& body, const ShapeWalks& walks) {
  if (!(body.size_mm >= 1e-3 && body.size_mm <= 1e4))
    throw input_error("", "size_mm must be 0.001 to 10000, got {}", body.size_mm);
  if (!(body.angle_deg >= 10 && body.angle_deg <= 170))
    throw input_error("", "angle_deg must be 10 to 170, got {}", body.angle_deg);
  if (walks.walks < walk_batches)
    throw input_error("", "walks must be at least {}, got {}", walk_batches, walks.walks);
}

/// Returns how far light spreads: less than a ten-thousandth of it goes farther.
double reach_of(const optics::RgbMedium& medium) {
  double reach = 0;
  for (const optics::Medium& m : medium)
    reach =
        std::max(reach, 10 * std::max(std::min(m.diffuse_mean_free_path().mm, 1e3), m.mean_free_path().mm));
  return reach;
}

/// Shared by all walks of a call.
struct Followed {
  const rays::RayScene& rays;
  const WalkMedium& medium;
  std::vector<glm::dvec3> to_light;
};

void follow_one(const Followed& f, Random& random, Batch& batch) {
  // The direction of exit outside, with the density of the cosine; inside by Snell's law.
  const double cosine = std::sqrt(random.next()), sine = std::sqrt(1 - cosine * cosine);
  const double phi = 2 * pi * random.next();
  const glm::dvec3 inwards(-sine * std::cos(phi), -sine * std::sin(phi), -cosine), normal(0, 0, 1);
  const glm::dvec3 start(0, 0, -rays::stand_off_m(glm::dvec3(0)));
  const WalkEnd end = walk(f.rays, f.medium, start, refracted(inwards, normal, 1 / f.medium.eta), random);

  const std::size_t bin = std::min(static_cast<std::size_t>(cosine * exit_bins), exit_bins - 1);
  batch.walks[0] += 1;
  batch.walks[1 + bin] += 1;
  if (end.how != WalkEnd::How::left) return;

  const glm::dvec3 there = rays::surface_point(f.rays.scene(), end.hit).normal;
  for (std::size_t i = 0; i < f.to_light.size(); ++i) {
    const glm::dvec3 light = end.weight * std::max(glm::dot(there, f.to_light[i]), 0.0);
    batch.sums[i][0] += light;
    batch.sums[i][1 + bin] += light;
  }
}

/// Mean over all walk_batches, and its standard error from their scatter.
void mean_over(const std::vector<Batch>& all, std::size_t light, std::size_t part, const glm::dvec3& total,
               optics::Rgb& mean, optics::Rgb& error) {
  glm::dvec3 sum(0), squares(0);
  for (const Batch& batch : all) {
    const glm::dvec3 value = batch.sums[light][part] / std::max(batch.walks[part], 1.0) / total;
    sum += value;
    squares += value * value;
  }
  constexpr double n = walk_batches;
  for (int c = 0; c < 3; ++c) {
    const auto k = static_cast<std::size_t>(c);
    mean[k] = sum[c] / n;
    error[k] = std::sqrt(std::max(squares[c] / n - mean[k] * mean[k], 0.0) / (n - 1));
  }
}

}  // namespace

std::span<const std::string_view> shape_names() {
  static constexpr std::array<std::string_view, 7> names{"sphere", "cylinder", "bowl", "groove",
                                                         "saddle", "slab",     "wedge"};
  return names;
}

std::vector<ShapeLight> follow(const Body& body, const optics::RgbMedium& medium, const ShapeWalks& walks) {
  check_walks(body, walks);
  optics::check(medium, "medium");
  const scene::AssetData scene = mesh_of(body, reach_of(medium));
  const WalkMedium walked(medium, scene.mm_per_unit);
  const glm::dvec3 total = diffuse_total(medium);
  const rays::RayScene rays(scene);

  Followed followed{rays, walked, {}};
  for (const double degrees : walks.lights_deg) {
    const double sine = std::sin(degrees * pi / 180), cosine = std::cos(degrees * pi / 180);
    followed.to_light.push_back(walks.across ? glm::dvec3(0, sine, cosine) : glm::dvec3(sine, 0, cosine));
  }

  std::vector<Batch> all(walk_batches);
  Steps steps("following light", walk_batches);
  parallel_for(walk_batches, [&](std::size_t b) {
    all[b].sums.resize(followed.to_light.size());
    const std::uint64_t count = walks.walks / walk_batches;
    for (std::uint64_t i = 0; i < count; ++i) {
      Random random = random_of(walks.seed, static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(i));
      follow_one(followed, random, all[b]);
    }
    steps.done();
  });

  std::vector<ShapeLight> lights(walks.lights_deg.size());
  for (std::size_t i = 0; i < lights.size(); ++i) {
    lights[i].light_deg = walks.lights_deg[i];
    mean_over(all, i, 0, total, lights[i].exitance, lights[i].exitance_error);
    for (std::size_t bin = 0; bin < exit_bins; ++bin)
      mean_over(all, i, 1 + bin, total, lights[i].radiance[bin], lights[i].radiance_error[bin]);
  }
  return lights;
}

}  // namespace dermis::reference
