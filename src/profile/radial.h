// SPDX-License-Identifier: MIT
// A diffusion profile of one channel: what leaves the skin at distance r from where a narrow beam entered.
// Convention: R^(k) = 2 pi Int_0^inf R(r) J0(k r) r dr, so that R^(0) is the total; per unit of flux that
// entered (surface reflection excluded).
#pragma once

#include <memory>
#include <mutex>
#include <span>
#include <string>

#include "profile/annuli.h"

namespace dermis::profile {

class RadialProfile {
 public:
  virtual ~RadialProfile() = default;
  RadialProfile() = default;
  RadialProfile(const RadialProfile&) = delete;
  RadialProfile& operator=(const RadialProfile&) = delete;

  /// R(r) [1/mm^2], r > 0 in mm.
  virtual double at(double radius_mm) const = 0;
  /// R^(k), dimensionless, k >= 0 in 1/mm. Unless a model has a closed form, from 46 rings a decade (1e-3 of
  /// the total).
  virtual double hankel(double k_per_mm) const { return annuli().hankel(k_per_mm); }
  /// Int R over the plane, 0..1 for skin.
  virtual double total() const { return hankel(0); }
  /// Energy within a radius, and the radius [mm] within which the part p (0..1) of the total leaves.
  virtual double within(double radius_mm) const { return annuli().within(radius_mm); }
  virtual double quantile(double p) const { return annuli().quantile(p); }

  /// The smallest and the largest length [mm] over which R changes its behaviour (about a mean free path,
  /// about a diffuse one).
  virtual double inner_mm() const = 0;
  virtual double outer_mm() const = 0;
  /// R^ is known in closed form, and fits should use it rather than R.
  virtual bool hankel_is_exact() const { return false; }
  /// R grows like 1/r towards 0: Int r R^2 dr diverges, and fits must start at a radius > 0.
  virtual bool has_pole() const { return false; }
  /// Radii [mm], rising, between which R is smooth; past the last it is 0. Empty where R is smooth
  /// everywhere.
  virtual std::span<const double> break_points_mm() const { return {}; }
  /// Model and what it was made from, for people.
  virtual std::string name() const = 0;

 protected:
  /// Rings made once from at(), 1e-4 inner to 60 outer.
  const Annuli& annuli() const;

 private:
  mutable std::once_flag once_;
  mutable Annuli annuli_;
};

using ProfilePtr = std::shared_ptr<const RadialProfile>;

/// R(r) = Int_0^inf R^(k) J0(k r) k dk / (2 pi) [1/mm^2], r > 0 in mm, from a closed form R^ that dies out
/// past 45 / inner_mm. Relative accuracy 1e-5 where R > 1e-8 R(0).
double inverse_hankel(const RadialProfile& profile, double radius_mm);

}  // namespace dermis::profile
