// SPDX-License-Identifier: MIT
#include "optics/directional_albedo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/parallel.h"

namespace dermis::optics {
namespace {

constexpr int samples_theta = 48, samples_phi = 32;

// Of the azimuths over half a turn; the other half is symmetric.
std::array<double, samples_phi> make_cosines() {
  std::array<double, samples_phi> cosines;
  for (int j = 0; j < samples_phi; ++j)
    cosines[static_cast<std::size_t>(j)] = std::cos(std::numbers::pi * (j + 0.5) / samples_phi);
  return cosines;
}

}  // namespace

DirectionalAlbedo directional_albedo(double cosine, double m) {
  static const std::array<double, samples_phi> cosines_phi = make_cosines();
  const double c = std::clamp(cosine, 1e-3, 1.0);
  const double s = std::sqrt(1 - c * c);
  DirectionalAlbedo sum;

  for (int i = 0; i < samples_theta; ++i) {
    // Half vector by inversion of Beckmann's distribution, tan^2 = -m^2 ln(1 - u), with pdf_h = D cos_h / pi:
    // D of [KSK01] is not divided by pi. Then pdf_l = pdf_h / (4 v.h) and f = D F / (4 (v.h)^2), so that a
    // sample counts f cos_l / pdf_l = pi F cos_l / (v.h cos_h).
    const double u = (i + 0.5) / samples_theta;
    const double tan2 = -m * m * std::log(1 - u);
    const double cos_h = 1 / std::sqrt(1 + tan2), sin_h = std::sqrt(std::max(0.0, 1 - cos_h * cos_h));

    for (const double cos_phi : cosines_phi) {
      const double v_h = s * sin_h * cos_phi + c * cos_h;
      if (v_h <= 0) continue;
      const double cos_l = 2 * v_h * cos_h - c;
      if (cos_l <= 0) continue;

      // Splits Schlick's F = f0 (1 - x) + x into the part that f0 scales and the rest.
      const double y = 1 - v_h, x = y * y * y * y * y;
      const double weight = std::numbers::pi * cos_l / (v_h * cos_h);
      sum.of_f0 += weight * (1 - x);
      sum.rest += weight * x;
    }
  }

  constexpr double count = samples_theta * samples_phi;
  return {sum.of_f0 / count, sum.rest / count};
}

DirectionalAlbedo mean_directional_albedo(double m) {
  constexpr int steps = 64;
  DirectionalAlbedo mean;
  for (int i = 0; i < steps; ++i) {
    const double mu = (i + 0.5) / steps;
    const DirectionalAlbedo a = directional_albedo(mu, m);
    mean.of_f0 += 2 * mu * a.of_f0 / steps;
    mean.rest += 2 * mu * a.rest / steps;
  }
  return mean;
}

namespace {

std::vector<float> make_table() {
  constexpr int width = directional_albedo_columns + 2;
  std::vector<float> table(static_cast<std::size_t>(width) * directional_albedo_rows * 2);
  parallel_for(directional_albedo_rows, [&](std::size_t row) {
    const double m = directional_albedo_min_m + (1 - directional_albedo_min_m) * static_cast<double>(row) /
                                                    (directional_albedo_rows - 1);
    for (int column = 0; column < width; ++column) {
      const DirectionalAlbedo a =
          column < directional_albedo_columns
              ? directional_albedo(static_cast<double>(column) / (directional_albedo_columns - 1), m)
              : mean_directional_albedo(m);
      table[(row * width + static_cast<std::size_t>(column)) * 2] = static_cast<float>(a.of_f0);
      table[(row * width + static_cast<std::size_t>(column)) * 2 + 1] = static_cast<float>(a.rest);
    }
  });
  return table;
}

}  // namespace

const std::vector<float>& directional_albedo_table() {
  static const std::vector<float> table = make_table();
  return table;
}

}  // namespace dermis::optics
