// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "gaussians/algebra.h"
#include "optics/presets.h"
#include "profile/slab.h"

namespace dermis {
namespace {

using gaussians::LayerSums;
using gaussians::Term;

TEST(Algebra, ConvolutionMultipliesTransforms) {
  const Term f[] = {{0.1, 0.3}, {2, 0.5}}, g[] = {{0, 0.2}, {0.7, 0.4}};
  const auto product = gaussians::convolve(f, g);
  ASSERT_EQ(product.size(), 4u);
  for (const double k : {0.0, 0.5, 2.0, 7.0})
    EXPECT_NEAR(gaussians::transform(product, k), gaussians::transform(f, k) * gaussians::transform(g, k), 1e-12);
  EXPECT_NEAR(gaussians::total(product), 0.8 * 0.6, 1e-12);
}

TEST(Algebra, MergingKeepsTotalVarianceAndShape) {
  std::vector<Term> many{{0, 0.1}};
  for (int i = 0; i < 400; ++i) many.push_back({1e-3 * std::exp(0.03 * i), 0.002});
  const auto few = gaussians::merge(many);
  EXPECT_LT(few.size(), 200u);
  double variance = 0, merged_variance = 0;
  for (const Term& t : many) variance += t.weight * t.variance_mm2;
  for (const Term& t : few) merged_variance += t.weight * t.variance_mm2;
  EXPECT_NEAR(gaussians::total(few), gaussians::total(many), 1e-12);
  EXPECT_NEAR(merged_variance / variance, 1, 1e-12);
  for (const double k : {0.01, 0.1, 1.0, 10.0, 100.0})
    EXPECT_NEAR(gaussians::transform(few, k), gaussians::transform(many, k), 1e-3 * gaussians::total(many));
}

/// Stacks layers both ways and compares over all frequencies.
double worst_deviation(const optics::Layers& layers, int terms = 6) {
  LayerSums stack = gaussians::fit_layer(layers.back(), layers.size() > 1 ? layers[layers.size() - 2].eta : 1, 1, terms);
  double lost = 0;
  for (std::size_t i = layers.size() - 1; i-- > 0;) {
    const auto stacked = gaussians::stack(gaussians::fit_layer(layers[i], i == 0 ? 1 : layers[i - 1].eta, layers[i + 1].eta, terms), stack);
    stack = stacked.layer;
    lost += stacked.lost;
  }
  EXPECT_LT(lost, 1e-3);
  const profile::LayeredProfile exact(layers, profile::SlabProfile::Side::reflected);
  double worst = 0;
  for (double k = 1e-3 / exact.outer_mm(); k < 40 / exact.inner_mm(); k *= 1.2) {
    const profile::Spectra spectra = exact.spectra(k);
    const profile::Spectra all = exact.spectra(0);
    worst = std::max({worst, std::abs(gaussians::transform(stack.reflect_above, k) - spectra.reflect_above) / all.reflect_above,
                      std::abs(gaussians::transform(stack.transmit_above, k) - spectra.transmit_above) / std::max(all.transmit_above, 0.05),
                      std::abs(gaussians::transform(stack.beam_reflect, k) - spectra.beam.reflect) / all.beam.reflect,
                      std::abs(gaussians::transform(stack.beam_transmit, k) - spectra.beam.transmit) / std::max(all.beam.transmit, 0.05)});
  }
  return worst;
}

TEST(Algebra, LayersAgreeWithLayersInHankelSpace) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const optics::RgbLayers skin = optics::donner_jensen_skin();
  for (int c = 0; c < 3; ++c) EXPECT_LT(worst_deviation(optics::channel(skin, c)), 0.01) << c;
  EXPECT_LT(worst_deviation({{0.5675, 9.2091, 1.4, 0.25}, {0.3166, 4.6046, 1.4, infinite}}), 0.01);
  EXPECT_LT(worst_deviation({{0.1, 1, 1.4, 2}, {0.01, 3, 1.33, 1}}), 0.01);           // ends in air, with an index step
  EXPECT_LT(worst_deviation({{0.02, 2, 1.4, 0.3}, {0.05, 1, 1.4, infinite}}), 0.01);  // a thin layer on the rest
  EXPECT_LT(worst_deviation({{0.02, 2, 1.4, 0.1}, {0.05, 1, 1.4, 0.2}}, 8), 0.01);    // only thin layers: their T has a narrow core
}

}  // namespace
}  // namespace dermis
