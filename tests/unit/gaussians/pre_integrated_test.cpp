// SPDX-License-Identifier: MIT
// Pre-integrated scattering against tables and closed forms.
#include "tissue/gaussians/pre_integrated.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tissue/gaussians/known.h"

namespace dermis::gaussians {
namespace {

// Computed for this test by other code, four digits: white light, the published six Gaussians. -1: not there.
struct OnASphere {
  double radius_mm, cosine;
  Rgb sphere, arc, ring;
};
constexpr OnASphere on_spheres[] = {
    {5, 1, {.9456, -1, -1}, {.9735, -1, -1}, {.9954, -1, -1}},
    {5, .5, {.4787, .4987, .4995}, {.4916, .4993, .4998}, {.4984, .4997, .4999}},
    {5, 0, {.0679, .0165, .0106}, {.0686, .0165, .0106}, {.0196, .0104, .0082}},
    {5, -.25, {.0199, .0002, 0}, {.0186, .0001, 0}, {.0028, 0, 0}},
    {5, -.5, {.0063, 0, 0}, {.0048, 0, 0}, {.0007, 0, 0}},
    {10, .25, {.2494, .2498, .2499}, {.2510, .2499, .2500}, {.2500, .2500, .2500}},
    {10, 0, {.0353, .0082, .0053}, {.0353, .0082, .0053}, {.0098, .0052, .0041}},
    {10, -.25, {.0029, 0, 0}, {.0027, 0, 0}, {.0003, 0, 0}},
    {20, 0, {.0178, .0041, .0027}, {.0178, .0041, .0027}, {.0049, .0026, .0021}},
    {50, 0, {.0071, .0017, .0011}, {.0071, .0017, .0011}, {.0020, .0010, .0008}}};

void expect_light(const Rgb& found, const Rgb& wanted, double relative) {
  for (std::size_t c = 0; c < 3; ++c)
    if (wanted[c] >= 0) { EXPECT_NEAR(found[c], wanted[c], relative * wanted[c] + 6e-5) << "channel " << c; }
}

TEST(PreIntegrated, IsTheTableOfSpheres) {
  const ScatterProfile skin = skin_six();
  for (const OnASphere& row : on_spheres) {
    SCOPED_TRACE(testing::Message() << "radius " << row.radius_mm << ", cosine " << row.cosine);
    expect_light(lit_arc(skin, row.cosine, 1 / row.radius_mm), row.arc, 0.01);
    expect_light(lit_ring(skin, row.cosine, 1 / row.radius_mm), row.ring, 0.01);
  }
}

// Beside the terminator the arc is what a sphere shows, from a radius of 10 mm everywhere; the ring is not.
TEST(PreIntegrated, TheArcIsNearTheSphere) {
  const ScatterProfile skin = skin_six();
  for (const OnASphere& row : on_spheres) {
    const double most = row.radius_mm >= 10 ? 0.002 : 0.03;
    EXPECT_NEAR(lit_arc(skin, row.cosine, 1 / row.radius_mm)[0], row.sphere[0], most);
  }
  EXPECT_LT(lit_ring(skin, 0, 0.1)[0], lit_arc(skin, 0, 0.1)[0] / 3);
}

// A Gaussian on an arc, integrated by brute force; also where it reaches around the whole circle.
TEST(PreIntegrated, IntegratesAnyGaussian) {
  for (const double variance_mm2 : {0.01, 1.0, 30.0})
    for (const double curvature : {0.02, 0.3, 1.0})
      for (const double cosine : {-1.0, -0.7, -0.05, 0.0, 0.4, 1.0}) {
        const double sigma = std::sqrt(variance_mm2), r = 1 / curvature,
                     bound = std::min(std::numbers::pi * r, 4 * sigma), theta = std::acos(cosine);
        double sum = 0, whole = 0;
        constexpr int steps = 200000;
        for (int i = 0; i < steps; ++i) {
          const double s = bound * ((2.0 * i + 1) / steps - 1), g = std::exp(-s * s / (2 * variance_mm2));
          sum += g * std::max(std::cos(theta + s / r), 0.0);
          whole += g;
        }
        const ScatterProfile one{.name = "one", .model = {}, .terms = {{variance_mm2, {1, 1, 1}}}};
        // A Gaussian that is cut at eight sigma is whole within 1e-14; here it is cut at four.
        EXPECT_NEAR(lit_arc(one, cosine, curvature)[0], sum / whole, 1e-6)
            << variance_mm2 << " " << curvature << " " << cosine;
      }
}

TEST(PreIntegrated, APlaneShowsTheCosine) {
  for (const double cosine : {-1.0, -0.2, 0.0, 0.3, 1.0})
    for (const bool ring : {false, true}) {
      const Rgb light = ring ? lit_ring(skin_six(), cosine, 0) : lit_arc(skin_six(), cosine, 0);
      for (const double value : light) EXPECT_EQ(value, std::max(cosine, 0.0));
    }
}

TEST(PreIntegrated, TheEdgeOfAShadowIsTheProfiles) {
  struct Case {
    double x_mm;
    Rgb light;
  };
  for (const auto& [x_mm, light] : {Case{.1, {.6374, .7569, .8166}},
                                    {.25, {.7220, .8966, .9528}},
                                    {.5, {.7929, .9684, .9943}},
                                    {1, {.8749, .9963, .9994}},
                                    {2, {.9535, .9997, 1}},
                                    {4, {.9937, 1, 1}}})
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(lit_edge(skin_six(), x_mm)[c], light[c], 6e-5);
      EXPECT_NEAR(lit_edge(skin_six(), -x_mm)[c], 1 - light[c], 6e-5);
    }
}

TEST(PreIntegrated, AnEdgeIsFoundInADisc) {
  EXPECT_NEAR(edge_in_disc(0.5), 0, 1e-12);
  for (const double x : {-1.0, -0.9, -0.3, 0.2, 0.99}) {
    const double share = 0.5 + (x * std::sqrt(1 - x * x) + std::asin(x)) / std::numbers::pi;
    EXPECT_NEAR(edge_in_disc(share), x, 1e-6);
  }
}

TEST(PreIntegrated, TablesHoldTheFunctions) {
  const ScatterProfile skin = skin_six();
  const LightTable lit = lit_table(skin, 256, 64), ring = lit_table(skin, 256, 64, true),
                   edge = edge_table(skin, 256), shadow = shadow_table(skin, 33, 4);
  const int column = 140, row = 20;
  const double cosine = -1 + 2.0 * column / 255, curvature = std::pow(row / 63.0, 2);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_EQ(lit.at(column, row)[c], lit_arc(skin, cosine, curvature)[c] - cosine);
    EXPECT_EQ(ring.at(column, row)[c], lit_ring(skin, cosine, curvature)[c] - cosine);
    EXPECT_EQ(lit.at(column, 0)[c], 0);
    EXPECT_EQ(edge.at(0, 0)[c], 0);
    EXPECT_EQ(edge.at(255, 0)[c], 1);
    const double border_mm = shadow_filter_mm(skin) / 2, least = lit_edge(skin, -border_mm)[c];
    EXPECT_LT(least, 0.002) << "the tables leave this much out";
    EXPECT_NEAR(edge.at(200, 0)[c],
                (lit_edge(skin, std::pow(-1 + 400.0 / 255, 2) * border_mm)[c] - least) / (1 - 2 * least),
                1e-12);
    // A filter that is half lit has the edge in its middle, however slanted.
    for (int j = 0; j < 4; ++j) EXPECT_NEAR(shadow.at(16, j)[c], 0.5, 1e-9);
  }
}

// A head of twice the size is bent half as much, and its profile is half as wide in its own mm.
TEST(PreIntegrated, KnowsNoUnit) {
  ScatterProfile half = skin_six();
  for (Gaussian& term : half.terms) term.variance_mm2 /= 4;
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(lit_arc(half, 0.1, 0.2)[c], lit_arc(skin_six(), 0.1, 0.1)[c], 1e-12);
}

}  // namespace
}  // namespace dermis::gaussians
