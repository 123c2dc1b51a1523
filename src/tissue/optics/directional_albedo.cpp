// SPDX-License-Identifier: MIT
#include "tissue/optics/directional_albedo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/core/parallel.h"

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

double cosine_lambda(double cosine, double m) {
  const double t = m * std::sqrt(std::max(1 - cosine * cosine, 1e-8));
  const double a = cosine / t;
  return a < 1.6 ? t * (1 - 1.259 * a + 0.396 * a * a) / (3.535 + 2.181 * a) : 0;
}

namespace {

constexpr std::array maskings{Masking::smith, Masking::kelemen_szirmay_kalos};
using ByMasking = std::array<DirectionalAlbedo, maskings.size()>;

// Both forms take the same half vectors.
ByMasking albedos(double cosine, double m) {
  static const std::array<double, samples_phi> cosines_phi = make_cosines();
  const double c = std::clamp(cosine, 1e-3, 1.0);
  const double s = std::sqrt(1 - c * c), lambda_v = cosine_lambda(c, m);
  ByMasking sums;

  for (int i = 0; i < samples_theta; ++i) {
    // Half vector by inversion of Beckmann's distribution, tan^2 = -m^2 ln(1 - u), with pdf_h = D cos_h / pi,
    // because D is not divided by pi. Then pdf_l = pdf_h / (4 v.h), and a sample counts f cos_l / pdf_l:
    // pi F v.h G / (cos_v cos_h) by Smith and, as h.h is 4 (v.h)^2, pi F cos_l / (v.h cos_h) by [KSK01].
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
      const double smith = v_h * cos_l / (c * cos_l + cos_l * lambda_v + c * cosine_lambda(cos_l, m));
      for (const Masking masking : maskings) {
        const double unmasked = masking == Masking::smith ? smith : cos_l / v_h;
        const double weight = std::numbers::pi * unmasked / cos_h;
        DirectionalAlbedo& sum = sums[static_cast<std::size_t>(masking)];
        sum.of_f0 += weight * (1 - x);
        sum.rest += weight * x;
      }
    }
  }

  constexpr double count = samples_theta * samples_phi;
  for (DirectionalAlbedo& sum : sums) sum = {sum.of_f0 / count, sum.rest / count};
  return sums;
}

ByMasking mean_albedos(double m) {
  constexpr int steps = 64;
  ByMasking means;
  for (int i = 0; i < steps; ++i) {
    const double mu = (i + 0.5) / steps;
    const ByMasking there = albedos(mu, m);
    for (std::size_t form = 0; form < means.size(); ++form) {
      means[form].of_f0 += 2 * mu * there[form].of_f0 / steps;
      means[form].rest += 2 * mu * there[form].rest / steps;
    }
  }
  return means;
}

std::vector<float> make_table() {
  constexpr std::size_t width = directional_albedo_columns + 2, channels = directional_albedo_channels;
  std::vector<float> table(width * directional_albedo_rows * channels);
  parallel_for(directional_albedo_rows, [&](std::size_t row) {
    const double m = directional_albedo_min_m + (1 - directional_albedo_min_m) * static_cast<double>(row) /
                                                    (directional_albedo_rows - 1);
    float* entries = &table[row * width * channels];

    const auto put = [&](std::size_t column, const ByMasking& of) {
      for (std::size_t form = 0; form < of.size(); ++form) {
        entries[column * channels + 2 * form] = static_cast<float>(of[form].of_f0);
        entries[column * channels + 2 * form + 1] = static_cast<float>(of[form].rest);
      }
    };
    for (std::size_t i = 0; i < directional_albedo_columns; ++i)
      put(i, albedos(static_cast<double>(i) / (directional_albedo_columns - 1), m));
    const ByMasking mean = mean_albedos(m);
    put(directional_albedo_columns, mean);
    put(directional_albedo_columns + 1, mean);
  });
  return table;
}

}  // namespace

DirectionalAlbedo directional_albedo(double cosine, double m, Masking masking) {
  return albedos(cosine, m)[static_cast<std::size_t>(masking)];
}

const std::vector<float>& directional_albedo_table() {
  static const std::vector<float> table = make_table();
  return table;
}

}  // namespace dermis::optics
