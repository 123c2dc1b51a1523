// SPDX-License-Identifier: MIT
// The energy that falls into each of a set of rings around the point where light enters: the common form of
// all profiles that are known only by numbers.
#pragma once

#include <vector>

namespace dermis::profile {

/// Energy in rings edges[i] .. edges[i+1], spread evenly over the area of each ring.
class Annuli {
 public:
  Annuli() = default;
  /// Takes strictly rising edges that begin at 0, and one energy per ring. Energies may be negative, as a
  /// channel of a colour space may be.
  Annuli(std::vector<double> edges_mm, std::vector<double> energies);

  /// Returns the sum of the energies; 0 for an empty set.
  double total() const { return cumulative_.empty() ? 0 : cumulative_.back(); }
  /// Returns the energy within radius_mm >= 0, in the units of the energies.
  double within(double radius_mm) const;
  /// Returns the radius [mm] that holds the fraction p (0..1) of the total; 0 for an empty set.
  double quantile(double p) const;
  /// Returns Int 2 pi r R(r) J0(k r) dr; exact for rings of even density.
  double hankel(double k_per_mm) const;

  /// The arguments of the constructor.
  const std::vector<double>& edges_mm() const { return edges_mm_; }
  const std::vector<double>& energies() const { return energies_; }
  /// Returns the mean of R over ring i [1/mm^2].
  double density_per_mm2(std::size_t i) const;

 private:
  std::vector<double> edges_mm_;
  std::vector<double> energies_;
  std::vector<double> cumulative_;  // energy within edges_mm_[i]
};

/// Returns edges [mm]: 0, then inner_mm .. outer_mm spaced evenly in log r, at least `per_decade` (> 0) per
/// decade; 0 < inner_mm < outer_mm.
std::vector<double> log_edges(double inner_mm, double outer_mm, int per_decade);

}  // namespace dermis::profile
