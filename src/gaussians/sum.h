// SPDX-License-Identifier: MIT
// A diffusion profile as a sum of Gaussians, the form that the GPU can blur.
//   R(r) = sum_i w_i G(v_i, r),  G(v, r) = exp(-r^2 / (2 v)) / (2 pi v)   [1/mm^2]
// Based on:
// [DLE07] d'Eon, Luebke, Enderton: Efficient Rendering of Human Skin. EGSR 2007, sec. 4
// [JG08]  Jimenez, Gutierrez: Faster Rendering of Human Skin. CEIG 2008, eq. 2
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "dermis/profile.h"

namespace dermis::gaussians {

using Rgb = std::array<double, 3>;

/// One term. variance_mm2 > 0; each weight >= 0.
struct Gaussian {
  double variance_mm2 = 0;
  Rgb weight{};
  bool operator==(const Gaussian&) const = default;
};

/// Terms ordered narrow to wide. Weights sum to 1 per channel; total_reflectance holds what the skin
/// reflects.
struct SumOfGaussians {
  std::string name;
  std::string model;  ///< the model that made the profile ("dipole", "Monte-Carlo", ...); empty if published
                      ///< or unknown
  std::vector<Gaussian> terms;  ///< 1 to 8, variances strictly increasing
  /// 0..1, the integral of R over the plane before the weights were normalised
  Rgb total_reflectance{1, 1, 1};
  /// 100 sqrt(int r (R-S)^2 dr / int r R^2 dr) against the profile it was fitted to; 0 if published
  Rgb error_percent{};
  Rgb mean_free_path_mm{};          ///< 1 / sigma_t'; 0 if unknown
  Rgb diffuse_mean_free_path_mm{};  ///< 1 / sigma_tr; 0 if unknown
  /// its medium, see ScatterProfile::medium; none if published or unknown
  std::optional<Coefficients> medium;
  std::optional<ShapeLaws> shape;  ///< with a medium alone, in mm

  bool operator==(const SumOfGaussians&) const = default;
  double max_variance_mm2() const { return terms.empty() ? 0 : terms.back().variance_mm2; }
};

inline constexpr int max_terms = 8;
inline constexpr double weight_tolerance = 1e-3;  ///< of the sum of a channel's weights, which is 1

}  // namespace dermis::gaussians
