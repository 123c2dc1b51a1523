// SPDX-License-Identifier: MIT
#include "gpu/translucency/slab.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"

#include <cmath>

#include "tissue/gaussians/known.h"

namespace dermis::tests {

scene::AssetData slab(double thickness_mm) {
  scene::AssetData made = two_planes(0.04, 4, [&](scene::Vertex& v) {
    // Half a turn around y.
    v.position_m = {-v.position_m.x, v.position_m.y, -static_cast<float>(thickness_mm / 1000)};
    v.normal = {-v.normal.x, v.normal.y, -v.normal.z};
    v.tangent = {-v.tangent.x, v.tangent.y, -v.tangent.z, v.tangent.w};
  });
  made.name = made.primitives.front().name = "slab";
  made.cameras = {camera_from_above(0.001, {0, 0, 0.1f})};
  return made;
}

scene::Light from_behind(const glm::vec3& irradiance, double angle_deg) {
  const double a = angle_deg * M_PI / 180;
  return directional_light({std::sin(a), 0, std::cos(a)}, irradiance);
}

scene::Light spot_behind(const glm::vec3& intensity) {
  scene::Light light = from_behind(intensity);
  light.type = LightType::spot;
  light.position_m = {0, 0, -0.6f};
  light.inner_cone_rad = 0.2f, light.outer_cone_rad = 0.3f;
  return light;
}

scene::Light point_behind(const glm::vec3& intensity) {
  scene::Light light;
  light.type = LightType::point;
  light.colour = intensity;
  light.position_m = {0, 0, -0.3f};
  return light;
}

RenderSettings slab_settings() {
  RenderSettings s = small_settings("texture-space", 8, 512);
  s.quality.samples = 1;
  s.lighting.ambient = 0;
  s.output.bloom = 0;
  s.lighting.specular = false;
  s.lighting.white_albedo = true;
  return s;
}

std::array<double, 3> slab_factor(double thickness_mm) {
  std::array<double, 3> sum{};
  for (const Gaussian& g : gaussians::skin_six().terms)
    for (std::size_t c = 0; c < 3; ++c)
      sum[c] += g.weight[c] * std::exp(-thickness_mm * thickness_mm / (2 * g.variance_mm2));
  return sum;
}

}  // namespace dermis::tests
