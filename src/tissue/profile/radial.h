// SPDX-License-Identifier: MIT
// A diffusion profile of one channel: the light that leaves the skin at distance r from where a narrow beam
// entered, per unit of flux that entered (surface reflection excluded). Convention: R^(k) = 2 pi Int_0^inf
// R(r) J0(k r) r dr, so that R^(0) is the total.
#pragma once

#include <memory>
#include <mutex>
#include <span>
#include <string>

#include "tissue/profile/annuli.h"

namespace dermis::profile {

class RadialProfile {
 public:
  virtual ~RadialProfile() = default;
  RadialProfile() = default;
  RadialProfile(const RadialProfile&) = delete;
  RadialProfile& operator=(const RadialProfile&) = delete;

  /// Returns R(r) [1/mm^2], r > 0 in mm.
  virtual double at(double radius_mm) const = 0;
  /// Returns the standard error of R(r) [1/mm^2]; 0 of models that are not sampled.
  virtual double standard_error_at(double /*radius_mm*/) const { return 0; }
  /// Returns R^(k), dimensionless, k >= 0 in 1/mm. Models without a closed form use rings, 46 per decade
  /// (1e-3 of the total).
  virtual double hankel(double k_per_mm) const { return annuli().hankel(k_per_mm); }
  /// Returns the integral of R over the plane, 0..1 for skin.
  virtual double total() const { return hankel(0); }
  /// Return the energy within a radius, and the radius [mm] within which the fraction p (0..1) of the total
  /// leaves.
  virtual double within(double radius_mm) const { return annuli().within(radius_mm); }
  virtual double quantile(double p) const { return annuli().quantile(p); }

  /// Return the smallest and the largest length [mm] over which R changes its behaviour (about a mean free
  /// path, about a diffuse mean free path).
  virtual double inner_mm() const = 0;
  virtual double outer_mm() const = 0;
  /// True if R^ is known in closed form, so that fits should use it rather than R.
  virtual bool hankel_is_exact() const { return false; }
  /// True if R grows like 1/r towards 0: Int r R^2 dr diverges, and fits must start at a radius > 0.
  virtual bool has_pole() const { return false; }
  /// Returns rising radii [mm] between which R is smooth; past the last it is 0. Empty if R is smooth
  /// everywhere.
  virtual std::span<const double> break_points_mm() const { return {}; }
  /// Returns model and source, for display.
  virtual std::string name() const = 0;

 protected:
  /// Returns rings from 1e-4 inner_mm() to 60 outer_mm(), made from at() at the first call.
  const Annuli& annuli() const;

 private:
  mutable std::once_flag once_;
  mutable Annuli annuli_;
};

using ProfilePtr = std::shared_ptr<const RadialProfile>;

/// Returns R(r) [1/mm^2], r > 0 in mm, from a closed form R^ that vanishes past k = 45 / inner_mm. Relative
/// accuracy 1e-5 where R > 1e-8 R(0).
double inverse_hankel(const RadialProfile& profile, double radius_mm);

}  // namespace dermis::profile
