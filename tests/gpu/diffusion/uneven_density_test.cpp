// SPDX-License-Identifier: MIT
// A plane whose texels per mm change along u: where they are few, the maps of a cascade blur by more than its
// terms are wide, and a part of the light must not go there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gaussians/known.h"
#include "lab.h"
#include "scene/primitives.h"

namespace dermis {
namespace {

constexpr int map_side = 256, cells = 64;
constexpr double size_mm = 100;  // 2.4 texels per mm along v
constexpr double uneven = 0.85;  // along u 0.37 in the middle, up to 4.5

// Returns the texel at a place along u, 0..1, of the plane.
double texel_of(double s) {
  const double turns = 2 * std::numbers::pi;
  return map_side * (0.5 + 0.95 * (s + uneven * std::sin(turns * s) / turns - 0.5));
}

double place_of(double texel) {
  double low = 0, high = 1;
  for (int i = 0; i < 50; ++i) (texel_of(0.5 * (low + high)) < texel ? low : high) = 0.5 * (low + high);
  return low;
}

lab::Experiment experiment(double edge_texel) {
  lab::Experiment e;
  e.scene = scene::plane(size_mm / 1000, glm::dmat2(0.95), glm::dvec2(0.025), cells);
  for (scene::Primitive& p : e.scene.primitives)
    for (scene::Vertex& v : p.vertices)
      v.uv0.x = static_cast<float>(texel_of((v.uv0.x - 0.025) / 0.95) / map_side);
  e.map_size = map_side;
  e.cascade = true;
  e.level_density = 2;
  e.paint = {.band = 0, .edge_point = glm::vec2(edge_texel, 0), .edge_normal = {1, 0}, .axis = {}};
  for (const auto& term : gaussians::skin_six().terms) {
    e.variances_mm2.push_back(term.variance_mm2);
    e.weights.push_back(term.weight);
  }
  return e;
}

TEST(UnevenDensity, EvenLightStaysEven) {
  if (!lab::available()) GTEST_SKIP() << "no Vulkan device";
  const lab::Result r = lab::run(experiment(-map_side));
  EXPECT_GE(r.coarsest, 2u);
  double worst = 0;
  for (int y = 0; y < map_side; ++y)
    for (int x = 0; x < map_side; ++x)
      for (int c = 0; c < 3; ++c)
        if (r.painted.at(x, y)[3] != 0)
          worst = std::max(worst, std::abs(double{r.levels[0].at(x, y)[c]} - 1));
  EXPECT_LT(worst, 0.004);
}

// Largest error of red light around an edge, where texels are few, of the mean over each texel.
double edge_error(const lab::Experiment& e, double edge) {
  const lab::Result r = lab::run(e);
  const double edge_mm = place_of(edge) * size_mm;
  double worst = 0;
  for (int x = map_side / 4; x < 3 * map_side / 4; ++x) {
    double want = 0;
    for (int k = 0; k < 16; ++k) {
      const double mm = place_of(x + (k + 0.5) / 16) * size_mm - edge_mm;
      for (const auto& term : gaussians::skin_six().terms)
        want += term.weight[0] * 0.5 * std::erfc(-mm / std::sqrt(2 * term.variance_mm2)) / 16;
    }
    worst = std::max(worst, std::abs(r.levels[0].at(x, map_side / 2)[0] - want));
  }
  return worst;
}

TEST(UnevenDensity, AnEdgeKeepsItsWidthWhereTexelsAreFew) {
  if (!lab::available()) GTEST_SKIP() << "no Vulkan device";
  for (const double edge : {map_side / 2 - 4.0, map_side / 2.0, map_side / 2 + 2.0}) {
    lab::Experiment e = experiment(edge);
    const double held = edge_error(e, edge);
    e.holds_all = true;
    const double all = edge_error(e, edge);
    std::printf("edge at texel %.0f: %.4f, all on smaller maps %.4f\n", edge, held, all);
    // A texel is 2.7 mm there, as wide as the widest term.
    EXPECT_LT(held, 0.045) << edge;
    EXPECT_LT(held, 0.8 * all) << edge;
  }
}

}  // namespace
}  // namespace dermis
