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
    EXPECT_NEAR(gaussians::transform(product, k), gaussians::transform(f, k) * gaussians::transform(g, k),
                1e-12);
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

/// Stacks layers both ways and compares all seven spectra over all frequencies: within 1 % of the light that
/// entered, and what one sees from above also within 1 % of its own total (of 0.05 where less than that
/// passes).
void expect_agreement(const optics::Layers& layers, int terms = 6) {
  LayerSums stack =
      gaussians::fit_layer(layers.back(), layers.size() > 1 ? layers[layers.size() - 2].eta : 1, 1, terms);

  // Put the other layers on top of the lowest, one by one.
  double lost = 0;
  for (std::size_t i = layers.size() - 1; i-- > 0;) {
    const auto stacked = gaussians::stack(
        gaussians::fit_layer(layers[i], i == 0 ? 1 : layers[i - 1].eta, layers[i + 1].eta, terms), stack);
    stack = stacked.layer;
    lost += stacked.lost;
  }
  EXPECT_LT(lost, 1e-3);

  const profile::LayeredProfile exact(layers, profile::SlabProfile::Side::reflected);
  const profile::Spectra all = exact.spectra(0);
  for (double k = 1e-3 / exact.outer_mm(); k < 40 / exact.inner_mm(); k *= 1.2) {
    const profile::Spectra at = exact.spectra(k);
    const auto near = [&](const std::vector<Term>& terms_of, double truth, double part, const char* what) {
      EXPECT_NEAR(gaussians::transform(terms_of, k), truth, 0.01 * part)
          << what << ", k " << k << ", layers " << layers.size();
    };

    near(stack.reflect_above, at.reflect_above, all.reflect_above, "R+");
    near(stack.beam_reflect, at.beam.reflect, all.beam.reflect, "R+ of a beam");
    near(stack.transmit_above, at.transmit_above, std::max(all.transmit_above, 0.05), "T+");
    near(stack.reflect_below, at.reflect_below, 1, "R-");
    near(stack.transmit_below, at.transmit_below, 1, "T-");
    near(stack.beam_transmit, at.beam.transmit, std::max(all.beam.transmit, 0.05), "T+ of a beam");
    near(stack.beam_straight, at.beam.straight, 1, "T+ that is a beam still");
  }
}

TEST(Algebra, LayersAgreeWithLayersInHankelSpace) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const optics::RgbLayers skin = optics::donner_jensen_skin();
  for (int c = 0; c < 3; ++c) expect_agreement(optics::channel(skin, c));
  expect_agreement({{0.5675, 9.2091, 1.4, 0.25}, {0.3166, 4.6046, 1.4, infinite}});
  expect_agreement({{0.1, 1, 1.4, 2}, {0.01, 3, 1.33, 1}});           // ends in air, with an index step
  expect_agreement({{0.02, 2, 1.4, 0.3}, {0.05, 1, 1.4, infinite}});  // a thin layer on the rest
  // only thin layers: their T has a narrow core
  expect_agreement({{0.02, 2, 1.4, 0.1}, {0.05, 1, 1.4, 0.2}}, 8);
}

}  // namespace
}  // namespace dermis
