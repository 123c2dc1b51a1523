// SPDX-License-Identifier: MIT
#include "profile/slab.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "optics/fresnel.h"

namespace dermis::profile {
namespace {

using std::numbers::pi;

constexpr double thin = 1.1;  // mean free paths; see slab.h

struct OneSide {
  double reflect, transmit;
};

/// The two closed sums for light that enters at the side of extrapolation length z_b0.
OneSide closed_sums(double kappa, double l, double d, double z_b0, double z_bd) {
  const double period = 2 * (d + z_b0 + z_bd);
  if (kappa * period < 1e-7) return {1 - 2 * (l + z_b0) / period, 2 * (l + z_b0) / period};  // the limit kappa -> 0
  const auto e = [kappa](double z) { return std::exp(-z * kappa); };
  const double all = -std::expm1(-period * kappa);
  return {(e(l) - e(period - l) - e(period - l - 2 * z_b0) + e(l + 2 * z_b0)) / (2 * all),
          (e(d - l) - e(period + l - d) - e(d + l + 2 * z_b0) + e(d + 2 * z_bd - l)) / (2 * all)};
}

double flux(double z, double radius, double s) {
  const double distance = std::sqrt(radius * radius + z * z);
  return z * (1 + s * distance) * std::exp(-s * distance) / (distance * distance * distance);
}

}  // namespace

Multipole::Multipole(const optics::Layer& layer, double eta_above, double eta_below) {
  const optics::Medium medium = layer.medium();
  const double l = medium.mean_free_path().mm, diffusion = medium.diffusion_coefficient_mm();
  reduced_albedo_ = medium.reduced_albedo();
  sigma_tr_per_mm_ = medium.sigma_tr_per_mm();
  thickness_mm_ = std::max(layer.thickness_mm, 0.02 * l);
  source_mm_ = l;
  above_mm_ = 2 * optics::boundary_factor_classical(layer.eta / eta_above) * diffusion;
  below_mm_ = 2 * optics::boundary_factor_classical(layer.eta / eta_below) * diffusion;
  const double optical = layer.thickness_mm / l;
  if (optical < thin) {
    scale_ = std::expm1(-optical) / std::expm1(-thin);
    source_mm_ = thickness_mm_ * (0.5 + (1 / thin - 0.5) * std::min(optical / thin, 1.0));
  }
  straight_ = 1 - scale_;
}

double Multipole::outer_mm() const {
  const double reach = sigma_tr_per_mm_ > 0 ? 1 / sigma_tr_per_mm_ : 1e300;
  // Without absorption light leaves through the boundaries: the slowest mode decays over period / (2 pi).
  const double leak = std::isfinite(thickness_mm_) ? (thickness_mm_ + above_mm_ + below_mm_) / pi : 1000 * source_mm_;
  return std::max(source_mm_, std::min(reach, leak));
}

Spectra Multipole::spectra(double k_per_mm) const {
  const double kappa = std::hypot(sigma_tr_per_mm_, k_per_mm);
  if (!std::isfinite(thickness_mm_)) {  // the dipole
    return {.reflect_above = reduced_albedo_ / 2 * (std::exp(-source_mm_ * kappa) + std::exp(-(source_mm_ + 2 * above_mm_) * kappa))};
  }
  const OneSide above = closed_sums(kappa, source_mm_, thickness_mm_, above_mm_, below_mm_);
  const OneSide below = closed_sums(kappa, source_mm_, thickness_mm_, below_mm_, above_mm_);
  const double scale = reduced_albedo_ * scale_;
  return {scale * above.reflect, scale * above.transmit + straight_, scale * below.reflect, scale * below.transmit + straight_};
}

double Multipole::image_sum(double radius_mm, bool transmitted) const {
  const double period = 2 * (thickness_mm_ + above_mm_ + below_mm_);
  double sum = 0;
  const auto dipole = [&](int i) {
    const double real = period * i + source_mm_, image = period * i - source_mm_ - 2 * above_mm_;
    const double depth = transmitted ? thickness_mm_ : 0, sign = transmitted ? -1 : 1;
    return flux(sign * (real - depth), radius_mm, sigma_tr_per_mm_) - flux(sign * (image - depth), radius_mm, sigma_tr_per_mm_);
  };
  sum = dipole(0);
  if (!std::isfinite(thickness_mm_)) return transmitted ? 0 : reduced_albedo_ / (4 * pi) * sum;
  for (int i = 1; i < 2000; ++i) {
    const double pair = dipole(i) + dipole(-i);
    sum += pair;
    if (std::abs(pair) < 1e-9 * std::abs(sum) && period * i > 3 * radius_mm) break;
  }
  return scale_ * reduced_albedo_ / (4 * pi) * sum;
}

double Multipole::reflectance_at(double radius_mm) const { return image_sum(radius_mm, false); }
double Multipole::transmittance_at(double radius_mm) const { return image_sum(radius_mm, true); }

SlabProfile::SlabProfile(const optics::Layer& layer, Side side, double eta_above, double eta_below)
    : slab_(layer, eta_above, eta_below), side_(side) {}

double SlabProfile::at(double radius_mm) const {
  return side_ == Side::reflected ? slab_.reflectance_at(radius_mm) : slab_.transmittance_at(radius_mm);
}

double SlabProfile::hankel(double k_per_mm) const {
  const Spectra spectra = slab_.spectra(k_per_mm);
  return side_ == Side::reflected ? spectra.reflect_above : spectra.transmit_above - slab_.straight();
}

Spectra add(const Spectra& upper, const Spectra& lower) {
  const double bounces = 1 / (1 - lower.reflect_above * upper.reflect_below);
  return {upper.reflect_above + upper.transmit_above * lower.reflect_above * upper.transmit_below * bounces,
          upper.transmit_above * lower.transmit_above * bounces,
          lower.reflect_below + lower.transmit_below * upper.reflect_below * lower.transmit_above * bounces,
          lower.transmit_below * upper.transmit_below * bounces};
}

LayeredProfile::LayeredProfile(const optics::Layers& layers, Side side, const std::string& where) : side_(side) {
  optics::check(layers, where);
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const double eta_above = i == 0 ? 1 : layers[i - 1].eta, eta_below = i + 1 == layers.size() ? 1 : layers[i + 1].eta;
    slabs_.emplace_back(layers[i], eta_above, eta_below);
    straight_ *= slabs_.back().straight();
  }
  // Light from below a thin top layer still passes through it, so the finest structure is that of the finest layer,
  // and the longest reach that of the farthest-reaching one.
  inner_mm_ = slabs_[0].inner_mm(), outer_mm_ = slabs_[0].outer_mm();
  for (const Multipole& slab : slabs_) {
    inner_mm_ = std::min(inner_mm_, slab.inner_mm());
    outer_mm_ = std::max(outer_mm_, slab.outer_mm());
  }
}

Spectra LayeredProfile::spectra(double k_per_mm) const {
  Spectra stack = slabs_.back().spectra(k_per_mm);
  for (std::size_t i = slabs_.size() - 1; i-- > 0;) stack = add(slabs_[i].spectra(k_per_mm), stack);
  return stack;
}

double LayeredProfile::hankel(double k_per_mm) const {
  const Spectra stack = spectra(k_per_mm);
  return side_ == Side::reflected ? stack.reflect_above : stack.transmit_above - straight_;
}

std::string LayeredProfile::name() const {
  return slabs_.size() == 1 ? "multipole" : "multipole, " + std::to_string(slabs_.size()) + " layers";
}

}  // namespace dermis::profile
