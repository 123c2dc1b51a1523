// SPDX-License-Identifier: MIT
// Curvature of shapes whose curvature is known.
#include "head/scene/surface/curvature.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace dermis::scene {
namespace {

using std::numbers::pi;

struct Sheet {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
};

/// A sheet of points over 0..1 x 0..1, in mm. With `seam`, its vertices in the middle are there twice.
Sheet sheet_of(int side, bool seam, const std::function<void(double, double, glm::dvec3&, glm::dvec3&)>& at) {
  Sheet sheet;
  std::vector<std::vector<std::uint32_t>> number(2);
  for (int half = 0; half < (seam ? 2 : 1); ++half)
    for (int j = 0; j <= side; ++j)
      for (int i = 0; i <= side; ++i) {
        glm::dvec3 p(0), n(0, 0, 1);
        at(double(i) / side, double(j) / side, p, n);
        Vertex v;
        v.position_m = glm::vec3(p / 1000.0);
        v.normal = glm::vec3(n);
        number[static_cast<std::size_t>(half)].push_back(static_cast<std::uint32_t>(sheet.vertices.size()));
        sheet.vertices.push_back(v);
      }

  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      const auto& of = number[seam && i >= side / 2 ? 1 : 0];
      const auto a = static_cast<std::size_t>(j * (side + 1) + i), b = a + static_cast<std::size_t>(side) + 1;
      sheet.indices.insert(sheet.indices.end(), {of[a], of[a + 1], of[b + 1], of[a], of[b + 1], of[b]});
    }
  return sheet;
}

/// In the middle of the sheet.
Curvature middle(const Sheet& sheet, int side, CurvatureScales scales = {1.5, 1.5}) {
  const CurvatureStencil stencil = curvature_stencil(sheet.vertices, sheet.indices, 1000, scales);
  const std::vector<Curvature> all = curvatures(sheet.vertices, stencil, 1000);
  return all[static_cast<std::size_t>((side / 2) * (side + 1) + side / 2)];
}

void on_sphere(double radius, double u, double v, glm::dvec3& p, glm::dvec3& n) {
  const double a = (u - 0.5) * 1.6, b = (v - 0.5) * 1.6;
  n = glm::normalize(glm::dvec3(std::tan(a), std::tan(b), 1));
  p = radius * n;
}

TEST(Curvature, OfSpheresAndBowls) {
  for (const int side : {12, 60})
    for (const double radius : {4.0, 10.0, 40.0}) {
      const Curvature out = middle(
          sheet_of(side, false, [&](double u, double v, auto& p, auto& n) { on_sphere(radius, u, v, p, n); }),
          side);
      EXPECT_NEAR(out.mean_per_mm * radius, 1, 0.01) << side << ", " << radius;
      EXPECT_NEAR(out.difference_per_mm * radius, 0, 0.01) << side << ", " << radius;

      const Curvature in = middle(sheet_of(side, false,
                                           [&](double u, double v, auto& p, auto& n) {
                                             on_sphere(radius, u, v, p, n);
                                             n = -n;
                                           }),
                                  side);
      EXPECT_NEAR(in.mean_per_mm * radius, -1, 0.01) << side << ", " << radius;
    }
}

TEST(Curvature, OfACylinderAndASaddle) {
  constexpr double radius = 6;
  const Curvature cylinder = middle(sheet_of(40, false,
                                             [](double u, double v, auto& p, auto& n) {
                                               n = {std::sin(2 * (u - 0.5)), 0, std::cos(2 * (u - 0.5))};
                                               p = radius * n + glm::dvec3(0, 20 * (v - 0.5), 0);
                                             }),
                                    40);
  EXPECT_NEAR(cylinder.mean_per_mm, 0.5 / radius, 0.002);
  EXPECT_NEAR(cylinder.difference_per_mm, 0.5 / radius, 0.002);

  // z = (y^2 - x^2) / 2R, turned by 30 degrees in its unwrap: eigenvalues do not depend on the axes.
  // Smoothing over 1.5 mm makes it flatter, by about (scale / R)^2 = 6 %.
  const Curvature saddle = middle(sheet_of(60, false,
                                           [](double u, double v, auto& p, auto& n) {
                                             const double a = 12 * (u - 0.5), b = 12 * (v - 0.5);
                                             const double x = a * std::cos(pi / 6) - b * std::sin(pi / 6),
                                                          y = a * std::sin(pi / 6) + b * std::cos(pi / 6);
                                             p = {x, y, (y * y - x * x) / (2 * radius)};
                                             n = glm::normalize(glm::dvec3(x / radius, -y / radius, 1));
                                           }),
                                  60);
  EXPECT_NEAR(saddle.mean_per_mm, 0, 0.002);
  EXPECT_NEAR(saddle.difference_per_mm * radius, 1, 0.09);
}

TEST(Curvature, SeesWavesThatAreLongerThanItsScaleAlone) {
  // z = h cos(k x) has the curvature h k^2 on its crest, of which a Gaussian leaves exp(-(k s)^2 / 2); two
  // scales leave the mean of theirs.
  constexpr double height = 0.05;
  struct Case {
    double length_mm;
    CurvatureScales scales;
    int side;
    double size_mm;
  };
  for (const Case& c :
       {Case{30, {1.5, 1.5}, 120, 20}, Case{6, {1.5, 1.5}, 120, 20}, Case{3, {1.5, 1.5}, 120, 20},
        Case{12, {1, 4}, 80, 30}, Case{8, {1, 4}, 80, 30}, Case{16, {2.5, 8}, 80, 60}}) {
    const double k = 2 * pi / c.length_mm;
    const Curvature crest =
        middle(sheet_of(c.side, false,
                        [&](double u, double v, auto& p, auto& n) {
                          const double x = c.size_mm * (u - 0.5);
                          p = {x, c.size_mm * (v - 0.5), height * std::cos(k * x)};
                          n = glm::normalize(glm::dvec3(height * k * std::sin(k * x), 0, 1));
                        }),
               c.side, c.scales);
    const double whole = height * k * k;
    const auto left = [&](double scale_mm) { return std::exp(-0.5 * k * k * scale_mm * scale_mm); };
    const double both = 0.5 * (left(c.scales.narrow_mm) + left(c.scales.wide_mm));
    EXPECT_NEAR(2 * crest.mean_per_mm / whole, both, 0.12) << c.length_mm;
  }
}

TEST(Curvature, DoesNotSeeSeams) {
  const auto at = [](double u, double v, auto& p, auto& n) { on_sphere(8, u, v, p, n); };
  const Curvature whole = middle(sheet_of(40, false, at), 40), cut = middle(sheet_of(40, true, at), 40);
  EXPECT_FLOAT_EQ(whole.mean_per_mm, cut.mean_per_mm);
  EXPECT_FLOAT_EQ(whole.difference_per_mm, cut.difference_per_mm);
}

TEST(Curvature, MovesWithTheSkin) {
  // A flat sheet that is bent to a cylinder keeps its neighbourhoods.
  Sheet sheet = sheet_of(40, false, [](double u, double v, auto& p, auto&) { p = {20 * u, 20 * v, 0}; });
  const CurvatureStencil stencil = curvature_stencil(sheet.vertices, sheet.indices, 1000, {1.5, 1.5});
  EXPECT_NEAR(curvatures(sheet.vertices, stencil, 1000)[20 * 41 + 20].mean_per_mm, 0, 1e-4);
  for (Vertex& v : sheet.vertices) {
    const double angle = v.position_m.x * 1000 / 7 - 10.0 / 7;
    v.normal = {static_cast<float>(std::sin(angle)), 0, static_cast<float>(std::cos(angle))};
    v.position_m = {v.normal.x * 0.007f, v.position_m.y, v.normal.z * 0.007f};
  }
  EXPECT_NEAR(curvatures(sheet.vertices, stencil, 1000)[20 * 41 + 20].mean_per_mm, 0.5 / 7, 0.002);
}

TEST(Curvature, OfWhatHasNoneIsZero) {
  Sheet line;  // three points on a line, and one that no triangle has
  for (int i = 0; i < 4; ++i) {
    Vertex v;
    v.position_m = {0.001f * static_cast<float>(i), 0, 0};
    line.vertices.push_back(v);
  }
  line.indices = {0, 1, 2};
  const CurvatureStencil stencil = curvature_stencil(line.vertices, line.indices, 1000, {1.5, 1.5});
  for (const Curvature& c : curvatures(line.vertices, stencil, 1000)) {
    EXPECT_EQ(c.mean_per_mm, 0);
    EXPECT_EQ(c.difference_per_mm, 0);
  }
}

}  // namespace
}  // namespace dermis::scene
