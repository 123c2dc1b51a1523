// SPDX-License-Identifier: MIT
#include "render/passes/asset/curvature_smoothing.h"

#include <gtest/gtest.h>

#include "head/scene/import/shapes.h"
#include "head/scene/surface/unwrap.h"

namespace dermis::passes {
namespace {

int smoothing_of(const scene::AssetData& made) {
  return curvature_smoothing(scene::skin_meshes(made).front(), made.mm_per_unit);
}

// Of a plane of quads with sides a and their diagonals, edges have a mean square of 4 a^2 / 3.
TEST(CurvatureSmoothing, ReachesAsFarOnAnyMesh) {
  for (const int cells : {50, 80, 100}) {
    const double side_mm = 100.0 / cells, quarter_mm2 = side_mm * side_mm / 3;
    EXPECT_NEAR(smoothing_of(scene::plane(0.1, glm::dmat2(1), {}, cells)) * quarter_mm2, 1.5 * 1.5,
                quarter_mm2 / 2 + 1e-6);
  }
}

TEST(CurvatureSmoothing, HasBounds) {
  EXPECT_EQ(smoothing_of(scene::plane(0.1, glm::dmat2(1), {}, 1)), 2);
  EXPECT_EQ(smoothing_of(scene::plane(0.01, glm::dmat2(1), {}, 100)), 64);
}

}  // namespace
}  // namespace dermis::passes
