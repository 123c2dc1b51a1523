// SPDX-License-Identifier: MIT
#include "tissue/profile/photon.h"

#include <algorithm>
#include <numbers>

#include "tissue/optics/fresnel.h"

namespace dermis::profile {
namespace {

using std::numbers::pi;

struct Vector {
  double x, y, z;  // z into the skin
};

constexpr int max_scatterings = 200'000;
constexpr double roulette_below = 1e-3, roulette_survivors = 0.1;

/// Returns a new direction, sampled from Henyey-Greenstein, [WJZ95] sec. 3.
Vector scatter(const Vector& d, double g, PhotonRandom& random) {
  const double u = random.next(), phi = 2 * pi * random.next();
  double cosine = 1 - 2 * u;
  if (g != 0) {
    const double part = (1 - g * g) / (1 - g + 2 * g * (1 - u));
    cosine = std::clamp((1 + g * g - part * part) / (2 * g), -1.0, 1.0);
  }

  const double sine = std::sqrt(1 - cosine * cosine), cp = std::cos(phi), sp = std::sin(phi);
  if (g == 0) return {sine * cp, sine * sp, cosine};  // isotropic: independent of the old direction
  const double flat = std::sqrt(std::max(0.0, 1 - d.z * d.z));
  if (flat < 1e-6) return {sine * cp, sine * sp, d.z > 0 ? cosine : -cosine};
  return {sine * (d.x * d.z * cp - d.y * sp) / flat + d.x * cosine,
          sine * (d.y * d.z * cp + d.x * sp) / flat + d.y * cosine, -sine * cp * flat + d.z * cosine};
}

struct Photon {
  Vector at{0, 0, 0}, to{0, 0, 1};
  double weight = 1;
  std::size_t layer = 0;
  int scatterings = 0;
  bool turned = false;  // by a boundary
  double reflected = 0, transmitted = 0;
};

/// Enters from air. Light that the surface reflects does not count, so draws repeat until one enters.
void enter(Photon& photon, double eta, ScatterScene::Light light, PhotonRandom& random) {
  if (light == ScatterScene::Light::perpendicular) return;
  double cosine = 1;
  do cosine = std::sqrt(random.next());  // cosine-weighted: diffuse light
  while (random.next() < optics::fresnel(cosine, 1 / eta));
  const double sine = std::sqrt(1 - cosine * cosine) / eta;
  photon.to = {sine, 0, std::sqrt(1 - sine * sine)};
}

/// Handles the top or bottom of the current layer: light leaves the skin and is counted, enters the next
/// layer or is reflected.
void cross(const std::vector<PhotonLayer>& layers, Photon& photon, PhotonRandom& random, PhotonTally& tally) {
  const bool up = photon.to.z < 0;
  const bool outside = up ? photon.layer == 0 : photon.layer + 1 == layers.size();
  const double eta_next = outside ? 1 : layers[up ? photon.layer - 1 : photon.layer + 1].eta;
  const double n = layers[photon.layer].eta / eta_next;
  const double reflect = n == 1 ? 0 : optics::fresnel(std::abs(photon.to.z), n);

  if (outside) {
    const double leaving = photon.weight * (1 - reflect);
    const double radius2 = photon.at.x * photon.at.x + photon.at.y * photon.at.y;
    if (!up && photon.scatterings == 0) {
      tally.ballistic += leaving;
    } else if (up && photon.scatterings == 1 && !photon.turned && tally.leave_single_out) {
      // known exactly: single_rings()
    } else {
      (up ? photon.reflected : photon.transmitted) += leaving;
      tally.add(up ? tally.reflected : tally.transmitted, radius2, leaving);
    }
    photon.weight *= reflect;
    photon.to.z = -photon.to.z;
    photon.turned = true;
    return;
  }

  if (reflect > 0 && random.next() < reflect) {
    photon.to.z = -photon.to.z;
    photon.turned = true;
    return;
  }

  // Refracts by Snell's law: the part along the boundary is scaled by n.
  const double sine_scale = n, z2 = 1 - n * n * (1 - photon.to.z * photon.to.z);
  photon.to = {photon.to.x * sine_scale, photon.to.y * sine_scale,
               (up ? -1 : 1) * std::sqrt(std::max(0.0, z2))};
  photon.layer += up ? -1 : 1;
}

}  // namespace

PhotonTally::PhotonTally(const std::vector<double>& edges_mm, std::size_t layers)
    : log_inner(2 * std::log(edges_mm[1])),
      rings_per_log(static_cast<double>(edges_mm.size() - 2) / (2 * std::log(edges_mm.back() / edges_mm[1]))),
      reflected(edges_mm.size() - 1, 0.0),
      transmitted(edges_mm.size() - 1, 0.0),
      absorbed(layers, 0.0) {}

void PhotonTally::add(std::vector<double>& rings, double radius2_mm2, double weight) const {
  if (weight <= 0) return;
  const double ring = radius2_mm2 > 0 ? 1 + (std::log(radius2_mm2) - log_inner) * rings_per_log : 0;
  rings[static_cast<std::size_t>(std::clamp(ring, 0.0, static_cast<double>(rings.size() - 1)))] += weight;
}

void trace_photon(const std::vector<PhotonLayer>& layers, ScatterScene::Light light, PhotonRandom random,
                  PhotonTally& tally) {
  Photon photon;
  enter(photon, layers[0].eta, light, random);
  double depth_left = -std::log(random.next());  // optical depth to the next scattering
  while (photon.weight > 0) {
    const PhotonLayer& layer = layers[photon.layer];
    // Moves to the next scattering or to the wall of the layer, whichever is nearer.
    const double wall = photon.to.z > 0   ? (layer.bottom_mm - photon.at.z) / photon.to.z
                        : photon.to.z < 0 ? (layer.top_mm - photon.at.z) / photon.to.z
                                          : HUGE_VAL;
    const double step = depth_left / layer.sigma_t_per_mm;
    const double moved = std::min(step, std::max(wall, 0.0));
    photon.at = {photon.at.x + moved * photon.to.x, photon.at.y + moved * photon.to.y,
                 photon.at.z + moved * photon.to.z};

    if (step >= wall) {
      // Exactly on the wall: rounding must not leave it outside.
      photon.at.z = photon.to.z > 0 ? layer.bottom_mm : layer.top_mm;
      depth_left -= moved * layer.sigma_t_per_mm;
      cross(layers, photon, random, tally);
      continue;
    }

    tally.absorbed[photon.layer] += photon.weight * (1 - layer.albedo);
    photon.weight *= layer.albedo;
    if (++photon.scatterings >= max_scatterings) {
      tally.absorbed[photon.layer] += photon.weight;
      tally.cut += photon.weight;
      break;
    }

    if (photon.weight < roulette_below)
      photon.weight = random.next() < roulette_survivors ? photon.weight / roulette_survivors : 0;
    photon.to = scatter(photon.to, layer.g, random);
    depth_left = -std::log(random.next());
  }

  tally.reflected_sum += photon.reflected;
  tally.reflected_sum2 += photon.reflected * photon.reflected;
  tally.transmitted_sum += photon.transmitted;
  tally.transmitted_sum2 += photon.transmitted * photon.transmitted;
}

}  // namespace dermis::profile
