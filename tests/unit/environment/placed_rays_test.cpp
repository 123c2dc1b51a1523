// SPDX-License-Identifier: MIT
// Rays meet a mesh that stands in several places as they meet as many meshes.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "head/scene/import/shapes.h"
#include "rays/ray_scene.h"
#include "rays/surface_point.h"
#include "support/written_out.h"

namespace dermis::rays {
namespace {

scene::AssetData balls(AssetAlpha alpha) {
  scene::AssetData made = scene::sphere(0.5, 3);
  made.materials[0].skin = false;
  made.materials[0].alpha_mode = alpha;
  for (int i = 0; i < 6; ++i) {
    const bool mirrored = i % 2 == 1;
    glm::dmat4 m = glm::translate(glm::dmat4(1), glm::dvec3(0.3 * i - 0.75, 0.1 * (i % 3), 0.05 * i));
    m = glm::rotate(m, 0.4 * i, glm::dvec3(0.6, 0, 0.8));
    m = glm::scale(m, glm::dvec3(mirrored ? -0.3 : 0.3, 0.2, 0.25));
    made.primitives[0].placements.push_back({glm::dmat4x3(m), i, mirrored});
  }
  return made;
}

TEST(PlacedRays, HitTheSamePointsAsMeshesOfTheirOwn) {
  for (const AssetAlpha alpha : {AssetAlpha::opaque, AssetAlpha::mask}) {
    const scene::AssetData shared = balls(alpha);
    scene::AssetData distinct = shared;
    distinct.primitives = scene::written_out(shared);
    const RayScene a(shared), b(distinct);

    std::size_t hits = 0;
    for (int i = 0; i < 1600; ++i) {
      const Ray ray{.origin_m = {-1.1 + 0.055 * (i % 40) + 0.003, -0.4 + 0.02 * (i / 40) + 0.001, 2},
                    .direction = {0, 0, -1}};

      const auto x = a.nearest(ray), y = b.nearest(ray);
      ASSERT_EQ(x.has_value(), y.has_value()) << i;
      // The alpha test of these balls cuts nothing away: their alpha is 1.
      EXPECT_EQ(a.solid_between(ray), x.has_value());
      if (!x) continue;
      ++hits;
      EXPECT_NEAR(x->t_m, y->t_m, 1e-5);
      if (x->copy != y->primitive || x->triangle != y->triangle) continue;  // on an edge

      const SurfacePoint p = surface_point(shared, *x), q = surface_point(distinct, *y);
      EXPECT_NEAR(glm::distance(p.position_m, q.position_m), 0, 1e-5) << i;
      EXPECT_NEAR(glm::distance(p.normal, q.normal), 0, 1e-3) << i;
      EXPECT_NEAR(glm::distance(p.face_normal, q.face_normal), 0, 1e-5) << i;
      EXPECT_GT(glm::dot(p.face_normal, p.normal), 0.5) << i;
    }

    EXPECT_GT(hits, 200u);
  }
}

}  // namespace
}  // namespace dermis::rays
