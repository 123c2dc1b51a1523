// SPDX-License-Identifier: MIT
// A program adds a technique of its own to the list.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "dermis/error.h"
#include "dermis/renderer.h"
#include "gpu/support/renderer.h"
#include "render/techniques/technique.h"

namespace dermis {
namespace techniques {
extern const Technique backdrop;
}

namespace {

double sum_of_light(const Picture& picture) {
  double sum = 0;
  for (std::size_t i = 0; i < picture.linear_rgba.size(); i += 4) sum += picture.linear_rgba[i];
  return sum;
}

TEST(OwnTechnique, JoinsTheList) {
  ASSERT_THROW(techniques::find_technique("backdrop"), InputError);
  techniques::add(techniques::backdrop);
  EXPECT_THROW(techniques::add(techniques::backdrop), InputError) << "each name once";
  const std::vector<std::string> names = technique_names();
  EXPECT_EQ(names.back(), "backdrop");
  EXPECT_EQ(names.front(), "texture-space");

  RenderSettings settings{.quality = {.map_size = 256, .shadow_size = 256},
                          .output = {.width = 48, .height = 54, .bloom = 0}};
  settings.technique = "lambert";
  const Picture whole = tests::renderer().render(Scene::built_in(), settings);
  settings.technique = "backdrop";
  const Picture drawn = tests::renderer().render(Scene::built_in(), settings);

  // Hair and eyes are there, the cheek is not.
  EXPECT_GT(sum_of_light(drawn), 0);
  EXPECT_LT(sum_of_light(drawn), 0.7 * sum_of_light(whole));
  constexpr std::size_t cheek = 4 * (32 * 48 + 17);
  EXPECT_GT(whole.linear_rgba[cheek], 0.02f);
  EXPECT_EQ(drawn.linear_rgba[cheek], 0);
}

}  // namespace
}  // namespace dermis
