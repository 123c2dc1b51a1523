// SPDX-License-Identifier: MIT
#include "tissue/profile/slab.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tissue/optics/fresnel.h"
#include "tissue/profile/point_source.h"
#include "tissue/profile/thin_slab.h"

namespace dermis::profile {

using std::numbers::pi;

TwoFlux multipole_sums(double kappa, double l, double d, double z_b0, double z_bd) {
  // Geometric sums over the images, P = 2 (d + z_b0 + z_bd):
  //   R^ = 1/2 [ e^{-l kappa} - e^{-(P-l) kappa} - e^{-(P-l-2 z_b0) kappa} + e^{-(l+2 z_b0) kappa} ]
  //        / (1 - e^{-P kappa})
  //   T^ = 1/2 [ e^{-(d-l) kappa} - e^{-(P+l-d) kappa} - e^{-(d+l+2 z_b0) kappa} + e^{-(d+2 z_bd-l) kappa} ]
  //        / (1 - e^{-P kappa})
  const double period = 2 * (d + z_b0 + z_bd);
  // The limit kappa -> 0.
  if (kappa * period < 1e-7) return {1 - 2 * (l + z_b0) / period, 2 * (l + z_b0) / period};

  const auto e = [kappa](double z) { return std::exp(-z * kappa); };
  const double all = -std::expm1(-period * kappa);
  return {(e(l) - e(period - l) - e(period - l - 2 * z_b0) + e(l + 2 * z_b0)) / (2 * all),
          (e(d - l) - e(period + l - d) - e(d + l + 2 * z_b0) + e(d + 2 * z_bd - l)) / (2 * all)};
}

Multipole::Multipole(const optics::Layer& layer, double eta_above, double eta_below) {
  const optics::Medium medium = layer.medium();
  const double l = medium.mean_free_path().mm, diffusion = medium.diffusion_coefficient_mm();
  reduced_albedo_ = medium.reduced_albedo();
  sigma_tr_per_mm_ = medium.sigma_tr_per_mm();
  thickness_mm_ = layer.thickness_mm;
  source_mm_ = l;

  // Extrapolation lengths z_b = 2 A D of the two boundaries.
  above_mm_ = 2 * optics::boundary_factor_classical(layer.eta / eta_above) * diffusion;
  below_mm_ = 2 * optics::boundary_factor_classical(layer.eta / eta_below) * diffusion;
  thin_ = thickness_mm_ < thin_limit(above_mm_ / l, below_mm_ / l) * l;
}

double Multipole::inner_mm() const { return thin_ ? std::min(source_mm_, thickness_mm_ / 2) : source_mm_; }

double Multipole::outer_mm() const {
  // Without absorption the tail is a power law without a length: a thousand mean free paths hold 99.9 % of
  // the light.
  const double reach = std::min(sigma_tr_per_mm_ > 0 ? 1 / sigma_tr_per_mm_ : HUGE_VAL, 1000 * source_mm_);
  // Without absorption light leaves through the boundaries: the slowest mode decays over period / (2 pi).
  const double leak = (thickness_mm_ + above_mm_ + below_mm_) / pi;
  return std::max(source_mm_, std::min(reach, leak));
}

Spectra Multipole::closed_sums(double k_per_mm, double thickness_mm) const {
  const double kappa = std::hypot(sigma_tr_per_mm_, k_per_mm);
  const TwoFlux above = multipole_sums(kappa, source_mm_, thickness_mm, above_mm_, below_mm_);
  const TwoFlux below = multipole_sums(kappa, source_mm_, thickness_mm, below_mm_, above_mm_);
  const double a = reduced_albedo_;
  return {a * above.reflect,
          a * above.transmit,
          a * below.reflect,
          a * below.transmit,
          {a * above.reflect, a * above.transmit, 0}};
}

Spectra Multipole::spectra(double k_per_mm) const {
  if (!std::isfinite(thickness_mm_)) {  // the dipole
    const double kappa = std::hypot(sigma_tr_per_mm_, k_per_mm);
    const double reflect = reduced_albedo_ / 2 *
                           (std::exp(-source_mm_ * kappa) + std::exp(-(source_mm_ + 2 * above_mm_) * kappa));
    return {.reflect_above = reflect, .beam = {.reflect = reflect}};
  }
  if (!thin_) return closed_sums(k_per_mm, thickness_mm_);

  // Lengths in mean free paths from here on.
  const double l = source_mm_, limit = thin_limit(above_mm_ / l, below_mm_ / l);
  const ThinSlab thin({reduced_albedo_, sigma_tr_per_mm_ * l}, above_mm_ / l, below_mm_ / l);
  return thin.spectra(k_per_mm * l, thickness_mm_ / l, closed_sums(k_per_mm, limit * l));
}

double Multipole::image_sum(double radius_mm, bool transmitted) const {
  const double period = 2 * (thickness_mm_ + above_mm_ + below_mm_);
  double sum = 0;

  // Dipole i: a real source at depth P i + l, its image at P i - l - 2 z_b0. [DJ05] sec. 3
  const auto dipole = [&](int i) {
    const double real = period * i + source_mm_, image = period * i - source_mm_ - 2 * above_mm_;
    const double depth = transmitted ? thickness_mm_ : 0, sign = transmitted ? -1 : 1;
    return source_flux(sign * (real - depth), radius_mm, sigma_tr_per_mm_) -
           source_flux(sign * (image - depth), radius_mm, sigma_tr_per_mm_);
  };
  sum = dipole(0);
  if (!std::isfinite(thickness_mm_)) return transmitted ? 0 : reduced_albedo_ / (4 * pi) * sum;

  // Add pairs outwards until they no longer count.
  for (int i = 1; i < 2000; ++i) {
    const double pair = dipole(i) + dipole(-i);
    sum += pair;
    if (std::abs(pair) < 1e-9 * std::abs(sum) && period * i > 3 * radius_mm) break;
  }
  return reduced_albedo_ / (4 * pi) * sum;
}

double Multipole::reflectance_at(double radius_mm) const { return image_sum(radius_mm, false); }
double Multipole::transmittance_at(double radius_mm) const { return image_sum(radius_mm, true); }

SlabProfile::SlabProfile(const optics::Layer& layer, Side side, double eta_above, double eta_below)
    : slab_(layer, eta_above, eta_below), side_(side) {}

double SlabProfile::at(double radius_mm) const {
  if (slab_.thin()) return inverse_hankel(*this, radius_mm);
  return side_ == Side::reflected ? slab_.reflectance_at(radius_mm) : slab_.transmittance_at(radius_mm);
}

double SlabProfile::hankel(double k_per_mm) const {
  const Spectra spectra = slab_.spectra(k_per_mm);
  return side_ == Side::reflected ? spectra.beam.reflect : spectra.beam.transmit;
}

Spectra add(const Spectra& upper, const Spectra& lower) {
  // Bounces between the two layers form a geometric series, [DJ05] eq. 15 to 17:
  //   R12+ = R1+ + T1+ R2+ T1- / (1 - R2+ R1-),  T12+ = T1+ T2+ / (1 - R2+ R1-), and the same from below.
  // Of a beam, s1 reaches the lower layer unscattered and t1 - s1 as diffuse light. The light that comes up
  // there is y = (s1 r2 + R2+ (t1 - s1)) / (1 - R2+ R1-), so that
  //   r12 = r1 + T1- y,  t12 = s1 t2 + T2+ (t1 - s1 + R1- y),  s12 = s1 s2.
  const double bounces = 1 / (1 - lower.reflect_above * upper.reflect_below);
  const double turned = upper.beam.transmit - upper.beam.straight;
  const double up = (upper.beam.straight * lower.beam.reflect + lower.reflect_above * turned) * bounces;
  return {
      upper.reflect_above + upper.transmit_above * lower.reflect_above * upper.transmit_below * bounces,
      upper.transmit_above * lower.transmit_above * bounces,
      lower.reflect_below + lower.transmit_below * upper.reflect_below * lower.transmit_above * bounces,
      lower.transmit_below * upper.transmit_below * bounces,
      {upper.beam.reflect + upper.transmit_below * up,
       upper.beam.straight * lower.beam.transmit + lower.transmit_above * (turned + upper.reflect_below * up),
       upper.beam.straight * lower.beam.straight}};
}

LayeredProfile::LayeredProfile(const optics::Layers& layers, Side side, const std::string& where)
    : side_(side) {
  optics::check(layers, where);
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const double eta_above = i == 0 ? 1 : layers[i - 1].eta,
                 eta_below = i + 1 == layers.size() ? 1 : layers[i + 1].eta;
    slabs_.emplace_back(layers[i], eta_above, eta_below);
  }
  // Light from below a thin top layer still passes through it. So the finest detail is that of the finest
  // layer, and the reach is that of the layer that reaches farthest.

  inner_mm_ = slabs_[0].inner_mm();
  outer_mm_ = slabs_[0].outer_mm();
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
  return side_ == Side::reflected ? stack.beam.reflect : stack.beam.transmit;
}

std::string LayeredProfile::name() const {
  return slabs_.size() == 1 ? "multipole" : "multipole, " + std::to_string(slabs_.size()) + " layers";
}

}  // namespace dermis::profile
