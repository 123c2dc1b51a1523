// SPDX-License-Identifier: MIT
// Light that meets the inside of an open mesh (a mask, a bust from its neck) enters no skin, at whatever edge
// of a triangle, with every technique; a closed mesh of the same front glows where it is thin.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "gpu/translucency/slab.h"
#include "head/scene/import/shapes.h"

namespace dermis::tests {
namespace {

/// The half of an egg that faces the camera, with few triangles and thus with kinks, or all of it.
Scene egg(double depth_m, bool open, const glm::vec3& light) {
  scene::AssetData made = scene::ellipsoid({0.04, 0.06, depth_m}, 24);
  scene::Primitive& primitive = made.primitives[0];
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i < primitive.indices.size(); i += 3) {
    float z = HUGE_VALF;
    for (std::size_t k = 0; k < 3; ++k)
      z = std::min(z, primitive.vertices[primitive.indices[i + k]].position_m.z);
    // A mask ends before its rim, which a lamp behind it would light.
    if (!open || z > 0.005f) kept.insert(kept.end(), &primitive.indices[i], &primitive.indices[i] + 3);
  }
  primitive.indices = kept;
  made.cameras = {camera_from_above(0.07, {0, 0, 0.5f})};
  made.lights = {directional_light(light, {3, 3, 3})};
  return wrap(std::move(made));
}

RenderSettings dark(const std::string& technique, double mix) {
  RenderSettings s = under_lamps_alone(small_settings(technique, 96, 256));
  s.skin.mix = mix;
  return s;
}

float brightest(const Picture& picture) {
  float most = 0;
  for (std::size_t i = 0; i < picture.linear_rgba.size(); i += 4)
    most = std::max({most, picture.linear_rgba[i], picture.linear_rgba[i + 1], picture.linear_rgba[i + 2]});
  return most;
}

TEST(OpenMesh, LitFromInsideStaysDark) {
  std::vector<std::string> techniques = other_than_published();
  techniques.emplace_back("published");
  for (const std::string& technique : techniques)
    for (const double mix : {0.0, 0.5}) {
      SCOPED_TRACE(technique + (mix > 0 ? ", with a mix" : ""));
      EXPECT_LT(brightest(renderer().render(egg(0.05, true, {0, 0, 1}), dark(technique, mix))), 5e-3f);
    }
}

TEST(OpenMesh, OfABodyThinPartsGlow) {
  for (const double mix : {0.0, 0.5})
    EXPECT_GT(brightest(renderer().render(egg(0.002, false, {0, 0, 1}), dark("texture-space", mix))), 0.01f);
}

// From aside part of the front faces the lamp; what lies beyond the terminator has no body behind it.
TEST(OpenMesh, BeyondTheTerminatorItIsAsDarkAsASurface) {
  RenderSettings without = dark("texture-space", 0);
  without.skin.translucency = false;
  const glm::vec3 aside = glm::normalize(glm::vec3(-1, 0, 0.7f));
  const Picture seen = renderer().render(egg(0.05, true, aside), dark("texture-space", 0)),
                expected = renderer().render(egg(0.05, true, aside), without);
  for (std::size_t i = 0; i < seen.linear_rgba.size(); ++i)
    ASSERT_NEAR(seen.linear_rgba[i], expected.linear_rgba[i], 0.02f) << i;
}

}  // namespace
}  // namespace dermis::tests
