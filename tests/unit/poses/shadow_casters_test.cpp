// SPDX-License-Identifier: MIT
// What shadow maps are fitted to while a head moves.
#include <algorithm>
#include <cmath>

#include "../gltf/support.h"
#include "api/asset_state.h"
#include "api/rig_pose.h"
#include "scene/enclosure.h"
#include "scene/load.h"
#include "scene/placement.h"
#include "setup/frame_camera.h"
#include "setup/subject.h"
#include "support/thrown.h"

namespace dermis::scene::test {
namespace {

Reach reach_of_vertices(const Scene& scene) {
  std::vector<glm::vec3> points_m;
  for (const Primitive& primitive : scene.primitives)
    for (const Vertex& v : primitive.vertices) points_m.push_back(v.position_m);
  return reach_of(points_m);
}

// Edges of shadows crawl where the fit changes from frame to frame: over a clip of 48 frames it does so a few
// times, all vertices stay within, and texels are not much larger than those of a fit to each frame.
void expect_few_fits(const fs::path& file) {
  const Warnings quiet;
  const auto scene = std::make_shared<const Scene>(load_gltf(file));
  const setup::Subject subject = setup::examine(scene);

  int fits = 0, bodies = 0;
  double largest = 0;
  setup::Casters last;
  for (int frame = 0; frame < 48; ++frame) {
    const auto posed = api::posed_asset(*scene, RigPose{.clip = ClipTime{"", frame / 8.0}});
    const setup::Casters casters = setup::shadow_casters(subject, posed.get());
    fits +=
        casters.sphere.centre_m != last.sphere.centre_m || casters.sphere.radius_m != last.sphere.radius_m;
    bodies += casters.corners_m != last.corners_m;
    last = casters;

    Scene moved = *scene;
    take_pose(*scene->rig, posed->rig, moved);
    const Reach held = reach_of(casters.corners_m), needed = reach_of_vertices(moved);
    for (std::size_t i = 0; i < held.size(); ++i) {
      EXPECT_GE(held[i], needed[i]) << "direction " << i << " of frame " << frame;
      const std::size_t back = i ^ 1;
      largest = std::max(largest, (held[i] + held[back]) / (needed[i] + needed[back]));
    }
    for (const Primitive& primitive : moved.primitives)
      for (const Vertex& v : primitive.vertices)
        EXPECT_LE(glm::distance(v.position_m, casters.sphere.centre_m), casters.sphere.radius_m * (1 + 1e-6));
  }
  std::printf("%s, 48 frames: %d spheres, %d bodies; at most %.2f times as wide as the vertices\n",
              scene->name.c_str(), fits, bodies, largest);
  EXPECT_LE(fits, 4);
  EXPECT_LE(bodies, 9);
  EXPECT_LE(largest, 1.55);

  // Without a pose they are those of the asset.
  const setup::Casters rest = setup::shadow_casters(subject, nullptr);
  EXPECT_EQ(rest.corners_m, subject.caster_corners_m);
  EXPECT_EQ(rest.sphere.radius_m, subject.casters.radius_m);
}

TEST(ShadowCasters, HoldMovingHeadsInFewFits) {
  DERMIS_NEED_ASSETS(folder);
  expect_few_fits(*folder / "makehuman" / "mh-african-man-young.glb");
  expect_few_fits(*folder / "ict-facekit" / "ict-mean-animated.glb");
}

}  // namespace
}  // namespace dermis::scene::test
