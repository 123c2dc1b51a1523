// SPDX-License-Identifier: MIT
// All techniques share lights, shadow maps and shading: without width, they make one picture.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <tuple>

#include "gpu/support/heads.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/settings.h"
#include "image/metrics.h"
#include "render/techniques/technique.h"

namespace dermis::tests {
namespace {

RenderSettings shaded(const std::string& technique, int samples) {
  RenderSettings s = small_settings(technique);
  s.quality.samples = samples;
  s.output.bloom = 0;
  return s;
}

// By how many roundings of a half float a value is off at most; light below this counts as this.
double largest_roundings(const Picture& a, const Picture& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.linear_rgba.size(); ++i) {
    const double wanted = a.linear_rgba[i], off = std::abs(wanted - b.linear_rgba[i]);
    most = std::max(most, off / (half_rounding * std::max(wanted, 1e-3)));
  }
  return most;
}

RenderSettings without_width(const std::string& technique, int samples, ScreenKernel kernel) {
  RenderSettings s =
      with_profile(shaded(technique, samples), "no width", {{.variance_mm2 = 0, .weight = {1, 1, 1}}});
  s.quality.kernel = kernel;
  return s;
}

// Drawn once for all techniques that are shaded alike.
const Picture& lambert_as(const Scene& scene, const RenderSettings& s) {
  static std::map<std::tuple<int, ScreenKernel, int>, Picture> drawn;
  const auto [at, added] = drawn.try_emplace({s.quality.samples, s.quality.kernel, s.quality.light_samples});
  RenderSettings lambert = s;
  lambert.technique = "lambert";
  if (added) at->second = renderer().render(scene, lambert);
  return at->second;
}

class ZeroWidth : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Techniques, ZeroWidth, testing::ValuesIn(technique_names()),
                         [](const auto& technique) { return test_name_of(technique.param); });

// A profile whose only Gaussian has no width. Light is stored twice on its way: with and without what is not
// blurred.
TEST_P(ZeroWidth, EveryTechniqueMakesThePictureOfLambert) {
  const Scene scene = subject("built-in head").open();
  for (const int samples : {1, 4})
    for (const ScreenKernel kernel : {ScreenKernel::profile, ScreenKernel::published}) {
      SCOPED_TRACE(std::to_string(samples) + " samples");
      RenderSettings s = without_width(GetParam(), samples, kernel);
      // The papers' technique reflects by another lobe, and shades triangles where they are drawn.
      const bool as_published = techniques::find_technique(GetParam()).as_published;
      s.lighting.specular = !as_published;
      if (as_published) s.quality.light_samples = 1;
      const Picture& lambert = lambert_as(scene, s);
      EXPECT_GT(skin_range(lambert).mean[0], 0.01);
      const Picture drawn = renderer().render(scene, s);
      if (as_published)
        EXPECT_GE(image::psnr_db(shown(lambert), shown(drawn), skin_mask(lambert)), samples == 1 ? 45 : 36);
      else
        EXPECT_LE(largest_roundings(lambert, drawn), 2);
    }
}

// Half of the light has no width. The rest of it is the profile's, in full: the picture lies between the two.
TEST_P(ZeroWidth, APartWithoutWidthIsLitAtThePixel) {
  const Scene scene = subject("built-in head").open();
  const auto drawn = [&](const std::string& name, const std::vector<Gaussian>& terms) {
    RenderSettings s = with_profile(shaded(GetParam(), 4), name, terms);
    s.skin.translucency = false;
    return renderer().render(scene, s);
  };
  const Gaussian none{.variance_mm2 = 0, .weight = {1, 1, 1}}, wide{.variance_mm2 = 4, .weight = {1, 1, 1}};
  const Picture sharp = drawn("no width", {none}), blurred = drawn("one width", {wide}),
                both = drawn("half without width", {none, wide});
  double most = 0;
  for (std::size_t i = 0; i < both.linear_rgba.size(); ++i) {
    const double mean = (double{sharp.linear_rgba[i]} + double{blurred.linear_rgba[i]}) / 2;
    most = std::max(most, std::abs(both.linear_rgba[i] - mean));
  }
  EXPECT_LE(most, 4 * half_rounding);
}

}  // namespace
}  // namespace dermis::tests
