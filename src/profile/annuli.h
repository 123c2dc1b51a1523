// SPDX-License-Identifier: MIT
// Energy by distance: what falls into rings around the point where light enters. The common form of
// everything that is only known by numbers.
#pragma once

#include <vector>

namespace dermis::profile {

/// Energy in rings edges[i] .. edges[i+1], spread evenly over each ring.
class Annuli {
 public:
  Annuli() = default;
  /// edges_mm: strictly rising, from 0; energies: one fewer, any sign (a channel of a colour space may be
  /// negative somewhere).
  Annuli(std::vector<double> edges_mm, std::vector<double> energies);

  /// Sum of the energies; 0 for an empty set.
  double total() const { return cumulative_.empty() ? 0 : cumulative_.back(); }
  /// Energy within radius_mm >= 0, in the units of the energies.
  double within(double radius_mm) const;
  /// The radius [mm] that holds the part p (0..1) of the total; 0 for an empty set.
  double quantile(double p) const;
  /// Int 2 pi r R(r) J0(k r) dr, exact for rings of even density: E_i 2 [r J1(k r)] / (k (r1^2 - r0^2)), [ ]
  /// the difference over the ring.
  double hankel(double k_per_mm) const;

  /// As given: edges rising from 0 [mm], and the energy between each and the next.
  const std::vector<double>& edges_mm() const { return edges_mm_; }
  const std::vector<double>& energies() const { return energies_; }
  /// Mean of R over ring i [1/mm^2].
  double density_per_mm2(std::size_t i) const;

 private:
  std::vector<double> edges_mm_;
  std::vector<double> energies_;
  std::vector<double> cumulative_;  // energy within edges_mm_[i]
};

/// Edges [mm] 0, then inner_mm .. outer_mm spaced evenly in log r, at least `per_decade` (> 0) to a decade; 0
/// < inner_mm < outer_mm.
std::vector<double> log_edges(double inner_mm, double outer_mm, int per_decade);

}  // namespace dermis::profile
