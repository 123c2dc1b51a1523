// SPDX-License-Identifier: MIT
// Labels of blended parts: what they cover, and which of them stands nearest.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "dermis/session.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "head/scene/import/shapes.h"
#include "support/scenes.h"

namespace dermis::tests {
namespace {

struct Sheet {
  float alpha = 1, z_m = 0.01f;
  const char* name = "sheet";
};

// A square of skin of 200 mm, and blended sheets over its right half.
Scene covered(const std::vector<Sheet>& sheets) {
  scene::AssetData made = scene::plane(0.2);
  for (const Sheet& sheet : sheets) {
    add_sheet(made, 0.1f, sheet.z_m);
    made.materials.back().alpha_mode = AssetAlpha::blend;
    made.materials.back().base_colour.a = sheet.alpha;
    made.materials.back().name = sheet.name;
  }
  return wrap(made);
}

struct Pixel {
  double front = 0;
  std::uint32_t front_part = 0, part = 0;
};

// In the middle of the right half; `left`: of the other one.
Pixel shown(const std::vector<Sheet>& sheets, bool left = false) {
  RenderSettings s = small_settings("lambert", 48, 64);
  s.camera.eye_m = {0, 0, 0.7};
  s.camera.target_m = {0, 0, 0};
  s.output.exposure_ev = 0;
  Session session(
      renderer(),
      {.frames_in_flight = 1, .wanted = {Output::part, Output::front, Output::front_part, Output::instance}});
  const Scene scene = covered(sheets);
  const Results l = session.results(session.draw(scene, s));
  const std::size_t at = 24 * 48 + (left ? 16 : 31);
  EXPECT_EQ(l.instance[at], 1u);
  EXPECT_EQ(l.front[0], 0) << "a corner that shows nothing";
  EXPECT_EQ(l.front_part[0], Results::nothing);
  EXPECT_EQ(l.part[0], Results::nothing);
  return {l.front[at], l.front_part[at], l.part[at]};
}

TEST(FrontLayer, CoversByItsAlpha) {
  EXPECT_EQ(shown({}).front, 0);
  EXPECT_NEAR(shown({{.alpha = 0.9f}}).front, 0.9, 1e-3);
  EXPECT_EQ(shown({{.alpha = 0.9f}}, true).front, 0);
  EXPECT_NEAR(shown({{.alpha = 0.5f}, {.alpha = 0.6f, .z_m = 0.02f}}).front, 0.8, 1e-3)
      << "two let through the product of what each lets through";
  EXPECT_EQ(shown({{.alpha = 0.9f, .z_m = -0.01f}}).front, 0) << "behind the skin nothing is seen of it";
}

TEST(FrontLayer, IsNamedWhereItCoversAHalf) {
  const Sheet lash{.alpha = 0.7f, .z_m = 0.01f, .name = "lash"},
      hair{.alpha = 0.7f, .z_m = 0.02f, .name = "hair"}, veil{.alpha = 0.3f, .z_m = 0.03f, .name = "veil"};
  EXPECT_EQ(shown({lash}).front_part, Results::lashes);
  EXPECT_EQ(shown({lash}).part, Results::face) << "what lies behind is the label of the pixel";
  EXPECT_EQ(shown({lash}, true).front_part, Results::nothing);
  EXPECT_EQ(shown({lash, hair}).front_part, Results::hair) << "the nearest";
  EXPECT_EQ(shown({hair, lash}).front_part, Results::hair) << "in whatever order they come";
  EXPECT_EQ(shown({lash, veil}).front_part, Results::lashes) << "a veil covers less than a half";
  EXPECT_EQ(shown({veil}).front_part, Results::nothing);
  EXPECT_EQ(shown({{.alpha = 0.7f, .name = "glass"}}).front_part, Results::other);
  // The sheet lies on +X, the person's left.
  EXPECT_EQ(shown({{.alpha = 0.7f, .name = "brow"}}).front_part, Results::left_brow);
}

}  // namespace
}  // namespace dermis::tests
