// SPDX-License-Identifier: MIT
// The renderer and the reference hold the same equations, written twice: a difference that is not one of
// method is a mistake in one of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "dermis/reference.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "head/scene/import/shapes.h"

namespace dermis::tests {
namespace {

struct Agreement {
  std::array<double, 3> ratio{};  ///< of the means, reference over renderer
  double typical = 0;             ///< median over pixels of the relative difference of the green channel
  double mean = 0;                ///< of the absolute difference of that channel over its mean
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
    const double wanted = reference.linear_rgba[i + 1], found = rendered.linear_rgba[i + 1];
    differences.push_back(wanted == found ? 0 : std::abs(wanted / found - 1));  // in the shadow both are 0
    out.mean += std::abs(wanted - found);
    ++out.pixels;
  }
  for (std::size_t c = 0; c < 3; ++c) out.ratio[c] = a[c] / b[c];
  out.mean /= b[1];
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

// Sculpted once for all that look at it.
const Scene& built_in_head() {
  static const Scene head = Scene::built_in();
  return head;
}

Agreement agreement(const Scene& scene, const std::string& technique, RenderSettings s, int samples) {
  s.technique = technique;
  const ReferencePicture reference = render_reference(scene, s, {.samples = samples});
  const Agreement a = compare(reference.picture, renderer().render(scene, s));
  std::printf("%s, specular %s: ratio %.4f %.4f %.4f, typical difference %.4f, mean %.4f over %d pixels\n",
              technique.c_str(), s.lighting.specular ? "on" : "off", a.ratio[0], a.ratio[1], a.ratio[2],
              a.typical, a.mean, a.pixels);
  return a;
}

// A Gaussian of a hundredth of a millimetre leaves light where it fell: that is Lambert.
RenderSettings without_scattering(const RenderSettings& s) {
  return with_profile(s, "narrow", {{.variance_mm2 = 1e-4, .weight = {1, 1, 1}}});
}

TEST(Agreement, DirectLight) {
  for (const bool specular : {false, true}) {
    RenderSettings s = without_scattering(settings());
    s.lighting.specular = specular;
    // Software drivers approximate the sRGB curve (0.3 % in dark colours); and where a pixel holds many
    // texels of the normal map, filtered normals are not what the mean of their light is.
    s.lighting.white_albedo = true;
    s.output.width = s.output.height = 512;

    const Agreement a = agreement(built_in_head(), "lambert", s, 8);
    EXPECT_GT(a.pixels, 5000);
    for (const double ratio : a.ratio) EXPECT_NEAR(ratio, 1, 0.01);
    EXPECT_LT(a.typical, 0.01);
  }
}

/// A light of each type, in metres from the middle of a ball of 0.1: a spot whose cone ends on it, a point
/// whose range does, a point so near that its shadow takes six maps.
struct KindOfLight {
  const char* name;
  LightType type;
  glm::vec3 position_m{0}, direction{0, 0, -1};
  float range_m = 0;
};
const KindOfLight kinds_of_light[] = {
    {.name = "directional", .type = LightType::directional, .direction = {-0.5f, -0.4f, -0.75f}},
    {.name = "spot",
     .type = LightType::spot,
     .position_m = {0.12f, 0.08f, 0.3f},
     .direction = {-0.12f, -0.08f, -0.25f}},
    {.name = "point", .type = LightType::point, .position_m = {-0.15f, 0.1f, 0.2f}},
    {.name = "point with a range",
     .type = LightType::point,
     .position_m = {0.1f, 0.08f, 0.2f},
     .range_m = 0.2f},
    {.name = "point inside", .type = LightType::point, .position_m = {-0.04f, 0.05f, 0.12f}}};

/// A ball, and a small one before it that shades it.
Scene balls_under(const KindOfLight& kind) {
  scene::AssetData made = scene::sphere(0.1, 64);
  const scene::AssetData small = scene::sphere(0.015, 24);
  made.primitives.push_back(small.primitives.front());
  made.primitives.back().node = 1;  // with a light map of its own
  for (scene::Vertex& v : made.primitives.back().vertices) v.position_m += glm::vec3(0.03f, 0.03f, 0.12f);

  scene::Light light;
  light.type = kind.type;
  light.colour = glm::vec3(3, 2.5f, 2);
  light.direction = glm::normalize(kind.direction);
  light.position_m = kind.position_m;
  light.range_m = kind.range_m;
  light.inner_cone_rad = 0.05f, light.outer_cone_rad = 0.25f;
  // As much light in the middle as from the directional one.
  if (kind.type != LightType::directional) light.colour *= glm::dot(light.position_m, light.position_m);

  made.lights = {light};
  return wrap(std::move(made));
}

TEST(Agreement, EveryKindOfLight) {
  for (const KindOfLight& kind : kinds_of_light) {
    SCOPED_TRACE(kind.name);
    RenderSettings s = without_scattering(settings());
    s.output.width = s.output.height = 128;
    s.lighting.rig_lights.reset();
    s.lighting.ambient = 0;
    s.lighting.white_albedo = true;
    const Agreement a = agreement(balls_under(kind), "lambert", s, 16);
    EXPECT_GT(a.pixels, 5000);

    // Edges of shadows, some 100 pixels long of 10,000, may lie off by half a pixel: 0.5 %. The filter of
    // shadow maps is narrower.
    for (const double ratio : a.ratio) EXPECT_NEAR(ratio, 1, 0.005);
    // Where the reference's sixteen samples lie within a pixel is random: 0.3 / sqrt(16) of what light
    // changes by from pixel to pixel, which is up to a fifth of the mean where a cone or a reflection ends.
    // Edges of shadows come on top.
    EXPECT_LT(a.mean, 0.02);
  }
}

TEST(Agreement, ScatteredLight) {
  const Agreement a = agreement(built_in_head(), "texture-space", settings(), 32);
  // Not noise, which ten thousand pixels average out, but the method: light maps of 1024 texels
  // and a blur along the surface instead of the straight line through it, which is shorter across lids and
  // between lips.
  for (const double ratio : a.ratio) EXPECT_NEAR(ratio, 1, 0.018);
}

}  // namespace
}  // namespace dermis::tests
