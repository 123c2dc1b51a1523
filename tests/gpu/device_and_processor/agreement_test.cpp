// SPDX-License-Identifier: MIT
// The renderer and the reference hold the same equations, written twice: a difference that is not one of
// method is a mistake in one of them.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/file.h"
#include "dermis/reference.h"
#include "gpu/support/renderer.h"

namespace dermis::tests {
namespace {

struct Agreement {
  std::array<double, 3> ratio{};  ///< of the means, reference over renderer
  double typical = 0;             ///< median over pixels of the relative difference of the green channel
  int pixels = 0;
};

/// Over pixels that are all skin in both.
Agreement compare(const Picture& reference, const Picture& rendered) {
  Agreement out;
  std::array<double, 3> a{}, b{};
  std::vector<double> differences;
  for (std::size_t i = 0; i < reference.linear_rgba.size(); i += 4) {
    if (reference.linear_rgba[i + 3] < 1 || rendered.linear_rgba[i + 3] < 1) continue;
    for (std::size_t c = 0; c < 3; ++c)
      a[c] += reference.linear_rgba[i + c], b[c] += rendered.linear_rgba[i + c];
    differences.push_back(std::abs(double(reference.linear_rgba[i + 1]) / rendered.linear_rgba[i + 1] - 1));
    ++out.pixels;
  }
  for (std::size_t c = 0; c < 3; ++c) out.ratio[c] = a[c] / b[c];
  std::nth_element(differences.begin(), differences.begin() + out.pixels / 2, differences.end());
  out.typical = differences[static_cast<std::size_t>(out.pixels / 2)];
  return out;
}

RenderSettings settings() {
  RenderSettings s;
  s.output.width = s.output.height = 192;
  s.lighting.rig_lights = 3;
  s.quality.map_size = 1024;
  s.quality.shadow_size = 4096;
  s.output.bloom = 0;
  return s;
}

Agreement agreement(const std::string& technique, RenderSettings s, int samples) {
  static const Scene head = Scene::built_in();
  s.technique = technique;
  const ReferencePicture reference = render_reference(head, s, {.samples = samples});
  const Agreement a = compare(reference.picture, renderer().render(head, s));
  std::printf("%s, specular %s: ratio %.4f %.4f %.4f, typical difference %.4f over %d pixels\n",
              technique.c_str(), s.lighting.specular ? "on" : "off", a.ratio[0], a.ratio[1], a.ratio[2],
              a.typical, a.pixels);
  return a;
}

// A Gaussian of a hundredth of a millimetre leaves light where it fell: that is Lambert.
TEST(Agreement, DirectLight) {
  const auto narrow =
      std::filesystem::path(testing::TempDir()) / ("dermis_narrow_" + std::to_string(::getpid()) + ".json");
  write_file(narrow,
             std::string_view(R"({"name": "narrow", "variances_mm2": [1e-4], "weights": [[1, 1, 1]]})"));

  for (const bool specular : {false, true}) {
    RenderSettings s = settings();
    s.skin.profile = narrow.string();
    s.lighting.specular = specular;
    // Software drivers approximate the sRGB curve (0.3 % in dark colours); and where a pixel holds many
    // texels of the normal map, filtered normals are not what the mean of their light is.
    s.lighting.white_albedo = true;
    s.output.width = s.output.height = 512;

    const Agreement a = agreement("lambert", s, 8);
    EXPECT_GT(a.pixels, 5000);
    for (const double ratio : a.ratio) EXPECT_NEAR(ratio, 1, 0.01);
    EXPECT_LT(a.typical, 0.01);
  }

  std::filesystem::remove(narrow);
}

TEST(Agreement, ScatteredLight) {
  const Agreement a = agreement("texture-space", settings(), 32);
  // Not noise, which ten thousand pixels average out, but the method: light maps of 1024 texels
  // and a blur along the surface instead of the straight line through it.
  for (const double ratio : a.ratio) EXPECT_NEAR(ratio, 1, 0.015);
}

}  // namespace
}  // namespace dermis::tests
