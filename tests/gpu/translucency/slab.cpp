// SPDX-License-Identifier: MIT
#include "gpu/translucency/slab.h"

#include <cmath>

#include "gaussians/known.h"
#include "scene/primitives.h"

namespace dermis::tests {

Renderer& renderer() {
  static Renderer shared;
  return shared;
}

Scene wrap(scene::Scene data) { return Scene(std::make_shared<const scene::Scene>(std::move(data))); }

scene::Scene slab(double thickness_mm) {
  constexpr double side_m = 0.04;
  scene::Scene made = scene::plane(side_m, glm::dmat2(0.46, 0, 0, 0.46), {0.02, 0.02}, 4);
  scene::Primitive back =
      scene::plane(side_m, glm::dmat2(0.46, 0, 0, 0.46), {0.52, 0.52}, 4).primitives.front();

  scene::Primitive& both = made.primitives.front();
  const auto base = static_cast<std::uint32_t>(both.vertices.size());
  for (scene::Vertex v : back.vertices) {
    // Half a turn around y.
    v.position_m = {-v.position_m.x, v.position_m.y, -static_cast<float>(thickness_mm / 1000)};
    v.normal = {-v.normal.x, v.normal.y, -v.normal.z};
    v.tangent = {-v.tangent.x, v.tangent.y, -v.tangent.z, v.tangent.w};
    both.vertices.push_back(v);
  }
  for (const std::uint32_t i : back.indices) both.indices.push_back(base + i);
  made.name = both.name = "slab";

  scene::Camera camera;
  camera.name = "front";
  camera.world_from_camera[3] = glm::vec4(0, 0, 0.1f, 1);
  camera.orthographic = true;
  camera.ymag_m = 0.001f;
  made.cameras = {camera};
  return made;
}

scene::Light from_behind(const glm::vec3& irradiance, double angle_deg) {
  const double a = angle_deg * M_PI / 180;
  scene::Light light;
  light.colour = irradiance;
  light.direction = glm::vec3(std::sin(a), 0, std::cos(a));
  return light;
}

scene::Light spot_behind(const glm::vec3& intensity) {
  scene::Light light = from_behind(intensity);
  light.type = scene::LightType::spot;
  light.position_m = {0, 0, -0.6f};
  light.inner_cone_rad = 0.2f, light.outer_cone_rad = 0.3f;
  return light;
}

scene::Light point_behind(const glm::vec3& intensity) {
  scene::Light light;
  light.type = scene::LightType::point;
  light.colour = intensity;
  light.position_m = {0, 0, -0.3f};
  return light;
}

RenderSettings slab_settings() {
  RenderSettings s;
  s.output.width = s.output.height = 8;
  s.quality.samples = 1;
  s.quality.map_size = s.quality.shadow_size = 512;
  s.lighting.ambient = 0;
  s.output.bloom = 0;
  s.lighting.specular = false;
  s.lighting.white_albedo = true;
  return s;
}

std::array<double, 3> slab_factor(double thickness_mm) {
  std::array<double, 3> sum{};
  for (const gaussians::Gaussian& g : gaussians::skin_six().terms)
    for (std::size_t c = 0; c < 3; ++c)
      sum[c] += g.weight[c] * std::exp(-thickness_mm * thickness_mm / (2 * g.variance_mm2));
  return sum;
}

std::array<double, 3> middle(const Picture& picture) {
  std::array<double, 3> mean{};
  for (std::size_t i = 0; i < picture.linear_rgba.size(); ++i)
    if (i % 4 != 3)
      mean[i % 4] += double{picture.linear_rgba[i]} / static_cast<double>(picture.linear_rgba.size() / 4);
  return mean;
}

}  // namespace dermis::tests
