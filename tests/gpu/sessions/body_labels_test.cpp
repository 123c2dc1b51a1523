// SPDX-License-Identifier: MIT
// Labels of the body below the skin: its thickness, and where its light map has it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

#include "dermis/session.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "head/scene/import/shapes.h"

namespace dermis::tests {
namespace {

constexpr double depth_mm = 8;

/// A square of 200 mm, and 8 mm behind it one of a metre that looks away.
scene::AssetData slab() {
  scene::AssetData made = scene::plane(0.2);
  scene::Primitive back = scene::plane(1).primitives[0];
  for (scene::Vertex& v : back.vertices) {
    v.position_m.z -= static_cast<float>(depth_mm / 1000);
    v.normal = -v.normal;
  }
  for (std::size_t i = 0; i < back.indices.size(); i += 3) std::swap(back.indices[i], back.indices[i + 1]);
  made.primitives.push_back(back);
  return made;
}

RenderSettings from_the_front() {
  RenderSettings s = small_settings("texture-space", 48, 64);
  s.camera.eye_m = {0, 0, 0.5};
  s.camera.target_m = {0, 0, 0};
  s.output.exposure_ev = 0;
  return s;
}

Results labels_of(const Scene& scene) {
  Session session(renderer(), {.frames_in_flight = 1, .wanted = Outputs::all()});
  return session.results(session.draw(scene, from_the_front()));
}

TEST(BodyLabels, ASlabHasItsThickness) {
  for (const double scale : {1.0, 0.75}) {
    SCOPED_TRACE(scale);
    Scene scene = wrap(slab());
    scene.set_transform(scene.instances()[0], {scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, 1});
    const Results l = labels_of(scene);
    std::size_t skin = 0;
    for (std::size_t i = 0; i < l.skin_mesh.size(); ++i) {
      if (l.instance[i] == 0) {
        EXPECT_EQ(l.skin_mesh[i], 0u);
        EXPECT_EQ(l.thickness_mm[i], 0);
        continue;
      }
      EXPECT_GE(l.skin_mesh[i], 1u);
      EXPECT_NEAR(l.thickness_mm[i], depth_mm * scale, 1e-3) << i;
      ++skin;
    }
    EXPECT_GT(skin, 200u);
  }
}

TEST(BodyLabels, WhatDoesNotCloseIsThick) {
  const Results l = labels_of(wrap(scene::plane(0.2)));
  EXPECT_EQ(*std::max_element(l.thickness_mm.begin(), l.thickness_mm.end()), 50);
}

TEST(BodyLabels, TheLightMapIsLitWhereSkinIsSeen) {
  const Scene scene = wrap(scene::sphere(0.08));
  RenderSettings s = from_the_front();
  s.output.show = "irradiance";
  s.quality.depth = false;
  const Picture map = renderer().render(scene, s);
  const Results l = labels_of(scene);

  std::size_t seen = 0;
  for (std::size_t i = 0; i < l.skin_mesh.size(); ++i) {
    if (l.skin_mesh[i] == 0) continue;
    EXPECT_EQ(l.skin_mesh[i], 1u);
    const auto texel = [&](std::size_t c, int size) {
      return std::clamp(static_cast<int>(l.unwrap[2 * i + c] * static_cast<float>(size)), 0, size - 1);
    };
    const auto at = static_cast<std::size_t>(texel(1, map.height) * map.width + texel(0, map.width));
    EXPECT_GT(map.linear_rgba[4 * at + 3], 0) << i;
    ++seen;
  }
  EXPECT_GT(seen, 300u);
}

}  // namespace
}  // namespace dermis::tests
