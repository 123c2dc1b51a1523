// SPDX-License-Identifier: MIT
#include "gpu/unwraps/made_up.h"
#include "gpu/support/settings.h"

#include <cmath>
#include <limits>

#include "head/scene/import/shapes.h"

namespace dermis::tests {
namespace {

void move_maps(scene::Material& m, const glm::dmat2& factor, const glm::dvec2& offset) {
  if (glm::determinant(factor) == 0) return;
  const glm::dmat2 inverse = glm::inverse(factor);
  scene::SkinMaterial& s = m.skin_settings;
  for (scene::MapRef* map : {&m.base_colour_map, &m.metallic_roughness_map, &m.normal_map, &m.occlusion_map,
                             &s.specular, &s.roughness, &s.displacement, &s.detail}) {
    const glm::dmat3x2 before(map->transform);
    const glm::dmat2 linear = glm::dmat2(before[0], before[1]) * inverse;
    const glm::dvec2 moved_by = before[2] - linear * offset;
    map->transform = glm::mat3x2(glm::vec2(linear[0]), glm::vec2(linear[1]), glm::vec2(moved_by));
  }
}

glm::vec2 corner_uv(std::size_t k, float size) { return {k == 1 ? size : 0.0f, k == 2 ? size : 0.0f}; }

}  // namespace

RenderSettings tiny_settings(int side, int map_size) {
  RenderSettings s = small_settings("texture-space", side, 64);
  s.quality.map_size = map_size;
  s.output.bloom = 0;
  return s;
}

scene::AssetData moved(scene::AssetData scene, const glm::dmat2& factor, const glm::dvec2& offset) {
  for (scene::Primitive& p : scene.primitives) {
    if (!scene.materials[static_cast<std::size_t>(p.material)].skin) continue;
    for (scene::Vertex& v : p.vertices) v.uv0 = glm::vec2(factor * glm::dvec2(v.uv0) + offset);
  }
  for (scene::Material& m : scene.materials)
    if (m.skin) move_maps(m, factor, offset);
  return scene;
}

scene::AssetData with_triangles(scene::AssetData scene,
                                const std::function<void(std::size_t, scene::Vertex*)>& change) {
  scene::Primitive& p = scene.primitives.front();
  std::vector<scene::Vertex> vertices;
  for (const std::uint32_t index : p.indices) vertices.push_back(p.vertices[index]);
  for (std::size_t t = 0; t < p.indices.size() / 3; ++t) change(t, &vertices[3 * t]);
  for (std::size_t i = 0; i < p.indices.size(); ++i) p.indices[i] = static_cast<std::uint32_t>(i);
  p.vertices = std::move(vertices);
  return scene;
}

std::vector<MadeUp> made_up_unwraps() {
  const scene::AssetData sphere = scene::sphere(0.1, 8);
  std::vector<MadeUp> all{
      {"as it is", sphere},
      {"a tenth", moved(sphere, glm::dmat2(0.1))},
      {"a hundredth", moved(sphere, glm::dmat2(0.01))},
      {"a thousandth", moved(sphere, glm::dmat2(0.001))},
      {"a thousandth in the middle", moved(sphere, glm::dmat2(0.001), glm::dvec2(0.5))},
      {"a hundred-thousandth in the middle", moved(sphere, glm::dmat2(1e-5), glm::dvec2(0.5))},
      {"far outside", moved(sphere, glm::dmat2(30), glm::dvec2(-700, 90))},
      {"flipped", moved(sphere, glm::dmat2(-0.2, 0, 0, 0.2))},
      {"sheared", moved(sphere, glm::dmat2(0.3, 0, 0.3, 0.1))},
      {"a line", moved(sphere, glm::dmat2(0.4, 0.2, 0, 0))},
      {"nearly a line", moved(sphere, glm::dmat2(1, 1, 1e-6, -1e-6))},
      {"a point", moved(sphere, glm::dmat2(0), glm::dvec2(0.3))}};

  const auto add = [&](const char* name, const std::function<void(std::size_t, scene::Vertex*)>& change) {
    all.push_back({name, with_triangles(sphere, change)});
  };

  add("half without area", [](std::size_t t, scene::Vertex* v) {
    if (t % 2 == 0) v[1].uv0 = v[2].uv0 = v[0].uv0;
  });
  add("half not a number", [](std::size_t t, scene::Vertex* v) {
    if (t % 2 == 0) v[1].uv0.x = std::numeric_limits<float>::quiet_NaN();
  });
  add("one far away", [](std::size_t t, scene::Vertex* v) {
    if (t == 300) v[0].uv0 += glm::vec2(300, -4000);
  });

  add("all on one square", [](std::size_t, scene::Vertex* v) {
    for (std::size_t k = 0; k < 3; ++k) v[k].uv0 = corner_uv(k, 1);
  });
  add("all on one small square", [](std::size_t, scene::Vertex* v) {
    for (std::size_t k = 0; k < 3; ++k) v[k].uv0 = corner_uv(k, 0.001f);
  });

  add("each far from the next", [](std::size_t t, scene::Vertex* v) {
    const auto at = glm::vec2(static_cast<float>(t % 28), static_cast<float>(t / 28)) / 28.0f;
    for (std::size_t k = 0; k < 3; ++k) v[k].uv0 = at + corner_uv(k, 0.001f);
  });
  add("two islands at the ends", [](std::size_t t, scene::Vertex* v) {
    for (std::size_t k = 0; k < 3; ++k) v[k].uv0 = v[k].uv0 * 0.02f + glm::vec2(t % 2 == 0 ? 0.0f : 0.98f);
  });

  scene::AssetData without = moved(sphere, glm::dmat2(0));
  without.primitives[0].has_uv = false;
  all.push_back({"none at all", without});
  return all;
}

}  // namespace dermis::tests
