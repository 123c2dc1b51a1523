// SPDX-License-Identifier: MIT
#include "tissue/optics/skin_table.h"

#include <algorithm>
#include <cmath>

#include "base/core/assert.h"
#include "base/core/parallel.h"
#include "base/settings/check.h"
#include "tissue/optics/radiative.h"

namespace dermis::optics {
namespace {

constexpr std::size_t stride = 2;  // of the tables of wavelengths

double fraction_of(double place, std::size_t nodes, double least, double most) {
  return least * std::pow(most / least, place / static_cast<double>(nodes - 1));
}

double place_in(double fraction, std::size_t nodes, double least, double most) {
  const double share = std::log(std::clamp(fraction, least, most) / least) / std::log(most / least);
  return std::clamp(share, 0.0, 1.0) * static_cast<double>(nodes - 1);
}

// The node below a place, and how far the place is from it.
struct Between {
  std::size_t low = 0;
  double part = 0;
};
Between between(double place, std::size_t nodes) {
  if (nodes == 1) return {};
  const std::size_t low = std::min(static_cast<std::size_t>(place), nodes - 2);
  return {low, place - static_cast<double>(low)};
}

}  // namespace

SkinTable::SkinTable(const SpectralSkin& fixed, const std::vector<double>& oxygenations)
    : fixed_(fixed), oxygenations_(oxygenations) {
  DERMIS_ASSERT_LE(1u, oxygenations.size());
  check_ranges(fixed, "skin");
  const auto nm = wavelengths_nm();
  const auto weights = rec709_weights();
  const std::size_t nodes = melanins * bloods * oxygenations.size();
  const std::size_t samples = (nm.size() + stride - 1) / stride;

  // Reflectance by wavelength, in parallel; then a sum in a fixed order.
  std::vector<std::vector<double>> spectra(samples);
  parallel_for(samples, [&](std::size_t k) {
    std::vector<Layer> above, below;
    SpectralSkin skin = fixed;
    for (std::size_t m = 0; m < melanins; ++m) {
      skin.melanin = fraction_of(static_cast<double>(m), melanins, least_melanin, most_melanin);
      above.push_back(skin_layers(skin, nm[k * stride])[0]);
    }
    for (const double oxygenation : oxygenations) {
      skin.oxygenation = oxygenation;
      for (std::size_t h = 0; h < bloods; ++h) {
        skin.haemoglobin = fraction_of(static_cast<double>(h), bloods, least_blood, most_blood);
        below.push_back(skin_layers(skin, nm[k * stride])[1]);
      }
    }
    spectra[k] = two_layers_coarse(above, below);
  });

  Rgb white{};
  for (std::size_t k = 0; k < samples; ++k)
    for (int c = 0; c < 3; ++c) white[c] += weights[k * stride][c];
  log_reflectance_.resize(nodes);
  labs_.resize(nodes);
  const std::size_t half_spaces = bloods * oxygenations.size();
  for (std::size_t m = 0; m < melanins; ++m)
    for (std::size_t below = 0; below < half_spaces; ++below) {
      Rgb sum{};
      for (std::size_t k = 0; k < samples; ++k)
        for (int c = 0; c < 3; ++c)
          sum[c] += weights[k * stride][c] / white[c] * spectra[k][m * half_spaces + below];
      const std::size_t at = node(m, below % bloods, below / bloods);
      // Some saturated reds lie outside Rec.709.
      for (int c = 0; c < 3; ++c)
        log_reflectance_[at][c] = static_cast<float>(std::log(std::max(sum[c], 1e-4)));
      labs_[at] = lab_from_linear(sum);
    }
}

SkinTable::Place SkinTable::place_of(const Pigments& p) const {
  const double first = oxygenations_.front(), last = oxygenations_.back();
  return {.melanin = place_in(p.melanin, melanins, least_melanin, most_melanin),
          .blood = place_in(p.haemoglobin, bloods, least_blood, most_blood),
          .oxygenation = oxygenations_.size() == 1
                             ? 0
                             : std::clamp((p.oxygenation - first) / (last - first), 0.0, 1.0) *
                                   static_cast<double>(oxygenations_.size() - 1)};
}

Pigments SkinTable::pigments_at(const Place& place, double oxygenation) const {
  return {.melanin = fraction_of(place.melanin, melanins, least_melanin, most_melanin),
          .haemoglobin = fraction_of(place.blood, bloods, least_blood, most_blood),
          .oxygenation = oxygenation};
}

std::array<float, 3> SkinTable::at(const Place& place) const {
  const Between m = between(place.melanin, melanins), h = between(place.blood, bloods),
                o = between(place.oxygenation, oxygenations_.size());
  std::array<double, 3> sum{};
  for (std::size_t corner = 0; corner < 8; ++corner) {
    const std::size_t dm = corner & 1, dh = corner >> 1 & 1, dk = corner >> 2;
    const double weight =
        (dm ? m.part : 1 - m.part) * (dh ? h.part : 1 - h.part) * (dk ? o.part : 1 - o.part);
    if (weight == 0) continue;
    const std::array<float, 3>& value = log_reflectance_[node(m.low + dm, h.low + dh, o.low + dk)];
    for (int c = 0; c < 3; ++c) sum[c] += weight * double{value[c]};
  }
  std::array<float, 3> albedo{};
  for (int c = 0; c < 3; ++c) albedo[c] = static_cast<float>(std::exp(sum[c]));
  return albedo;
}

std::array<float, 3> SkinTable::at(const Pigments& pigments) const { return at(place_of(pigments)); }

Lab SkinTable::lab_at(const Place& place) const {
  const std::array<float, 3> albedo = at(place);
  return lab_from_linear({albedo[0], albedo[1], albedo[2]});
}

SkinTable::Match SkinTable::nearest(const Rgb& albedo, double oxygenation) const {
  const Lab wanted = lab_from_linear(albedo);
  Place here = place_of({.oxygenation = oxygenation});
  const std::size_t layer = static_cast<std::size_t>(std::lround(here.oxygenation));

  double nearest = 1e300;
  for (std::size_t h = 0; h < bloods; ++h)
    for (std::size_t m = 0; m < melanins; ++m) {
      const double distance = delta_e76(labs_[node(m, h, layer)], wanted);
      if (distance >= nearest) continue;
      nearest = distance;
      here.melanin = static_cast<double>(m);
      here.blood = static_cast<double>(h);
    }

  // Damped Gauss-Newton in places of the table, with slopes by finite differences.
  constexpr double h = 0.25;
  const double most_m = melanins - 1, most_h = bloods - 1;
  Lab lab = lab_at(here);
  double distance = delta_e76(lab, wanted), damping = 1e-3;
  for (int step = 0; step < 20 && damping < 1e3 && distance > 1e-3; ++step) {
    std::array<std::array<double, 3>, 2> slope{};
    for (int i = 0; i < 2; ++i) {
      Place there = here;
      double& x = i == 0 ? there.melanin : there.blood;
      const double side = x + h > (i == 0 ? most_m : most_h) ? -h : h;
      x += side;
      const Lab moved = lab_at(there);
      slope[i] = {(moved.l - lab.l) / side, (moved.a - lab.a) / side, (moved.b - lab.b) / side};
    }
    const std::array<double, 3> off{wanted.l - lab.l, wanted.a - lab.a, wanted.b - lab.b};
    const auto dot = [](const auto& x, const auto& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; };
    const double a = dot(slope[0], slope[0]) * (1 + damping) + 1e-9, b = dot(slope[0], slope[1]),
                 d = dot(slope[1], slope[1]) * (1 + damping) + 1e-9, determinant = a * d - b * b;
    const double p = dot(slope[0], off), q = dot(slope[1], off);

    Place there = here;
    there.melanin = std::clamp(here.melanin + (d * p - b * q) / determinant, 0.0, most_m);
    there.blood = std::clamp(here.blood + (a * q - b * p) / determinant, 0.0, most_h);
    const Lab moved = lab_at(there);
    const double after = delta_e76(moved, wanted);
    if (after < distance) {
      const double gain = distance - after;
      here = there, lab = moved, distance = after;
      damping /= 4;
      if (gain < 1e-3) break;
    } else {
      damping *= 8;
    }
  }
  return {pigments_at(here, oxygenation), distance};
}

}  // namespace dermis::optics
