// SPDX-License-Identifier: MIT
// Light is linear: two lights show the sum of what each shows, none twice.
#include <gtest/gtest.h>

#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "head/scene/import/shapes.h"

namespace dermis::tests {
namespace {

Picture lit_by(const std::vector<scene::Light>& lights, const RenderSettings& settings) {
  scene::AssetData made = scene::sphere(0.1, 16);
  made.cameras = {camera_from_above(0.12, {0, 0, 0.5f})};
  made.lights = lights;
  return renderer().render(wrap(std::move(made)), settings);
}

TEST(Lights, AddUp) {
  const scene::Light left = directional_light({1, 0, -1}, {3, 2, 1}),
                     right = directional_light({-1, 0, -1}, {1, 2, 2});
  for (const std::string& technique : other_than_published()) {
    SCOPED_TRACE(technique);
    RenderSettings s = under_lamps_alone(small_settings(technique, 48, 128));
    s.skin.translucency = false;  // with it: Slab.LightsAddUp
    s.lighting.specular = true;
    const Picture both = lit_by({left, right}, s), first = lit_by({left}, s), second = lit_by({right}, s);
    float most = 0;
    for (std::size_t i = 0; i < both.linear_rgba.size(); ++i) {
      if (i % 4 == 3) continue;
      const float sum = first.linear_rgba[i] + second.linear_rgba[i];
      ASSERT_NEAR(both.linear_rgba[i], sum, 0.01f + 0.01f * sum) << i;
      most = std::max(most, sum);
    }
    EXPECT_GT(most, 0.3f);
  }
}

}  // namespace
}  // namespace dermis::tests
