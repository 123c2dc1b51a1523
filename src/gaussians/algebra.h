// SPDX-License-Identifier: MIT
// Combines layers as sums of Gaussians: convolving two sums adds variances, so fitted layers need no new fit.
// Based on:
// [DLE07] d'Eon, Luebke, Enderton: Efficient Rendering of Human Skin. EGSR 2007, sec. 4 and 5
// [DJ05]  Donner, Jensen: Light Diffusion in Multi-Layered Translucent Materials. SIGGRAPH 2005, sec. 4
#pragma once

#include <span>
#include <vector>

#include "gaussians/fit.h"
#include "optics/layers.h"

namespace dermis::gaussians {

/// Returns f * g over the plane: all pairs (w1, v1) * (w2, v2) = (w1 w2, v1 + v2), narrow to wide. [DLE07]
/// sec. 4. Variance 0 is a delta: light that leaves where it entered. More than 512 pairs are merged, see
/// merge().
std::vector<Term> convolve(std::span<const Term> f, std::span<const Term> g);

/// Returns the sum of the weights, which is the total over the plane.
double total(std::span<const Term> terms);

/// Returns S^(k) = Sum w e^{-v k^2/2}, k in 1/mm, dimensionless.
double transform(std::span<const Term> terms, double k_per_mm);

/// E(x), the light at distance x [mm] into the dark (negative: in the light) from a straight edge, 0..1 for
/// normalised weights. [DLE07] fig. 2 idea, the integral of the sum over a half-plane.
double edge_response(std::span<const Term> terms, double x_mm);

/// How far two normalised sums are apart, in per cent: 100 sqrt( Int r (S - S')^2 dr / Int r S^2 dr ), in
/// closed form: Int r G(v) G(v') dr = 1 / (4 pi^2 (v + v')).
double difference_percent(std::span<const Term> sum, std::span<const Term> other);

/// Returns fewer terms, on a grid of 32 variances per decade: splits each weight between the two neighbours
/// on the grid so that Sum w and Sum w v stay. Changes R^ by less than 1e-3 of the total.
std::vector<Term> merge(std::span<const Term> terms);

/// Reflectance and transmittance of a layer as sums, the seven of profile::Spectra: for diffuse light from
/// above and from below, and for a beam from above. A half-space transmits nothing.
struct LayerSums {
  std::vector<Term> reflect_above, transmit_above, reflect_below, transmit_below;
  std::vector<Term> beam_reflect, beam_transmit, beam_straight;
};

/// Fits the multipole of one layer (profile::Multipole) between media of index eta_above and eta_below: each
/// of the seven spectra with `terms` (1 to 8) terms of any sign.
LayerSums fit_layer(const optics::Layer& layer, double eta_above, double eta_below, int terms);

/// Two layers as one, and the light lost by truncation, as a fraction of the light that entered (upper
/// bound).
struct Stacked {
  LayerSums layer;
  double lost = 0;
};

/// Returns two layers as one. [DJ05] eq. 15 to 17 as a series of Gaussians: R12 = R1 + T1 R2 T1' Sum_m (R1'
/// R2)^m and likewise for the others (profile::add), with convolutions as products. The series ends where the
/// remaining bounces hold less than `energy` (0 < energy < 1) of the light.
Stacked stack(const LayerSums& upper, const LayerSums& lower, double energy = 1e-4);

}  // namespace dermis::gaussians
