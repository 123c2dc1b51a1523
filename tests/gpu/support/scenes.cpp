// SPDX-License-Identifier: MIT
#include "gpu/support/scenes.h"
#include "api/asset_state.h"

#include <utility>

#include "head/scene/import/shapes.h"
#include "head/scene/surface/measured.h"

namespace dermis::tests {

Scene wrap(scene::AssetData data) { return Scene(Asset::State::make(scene::measured(std::move(data)))); }

Scene sphere(double radius_m) { return wrap(scene::sphere(radius_m)); }

Scene sheared_plane() { return wrap(scene::plane(0.1, glm::dmat2(0.5, 0, 0.5, 0.5), {}, 8)); }

Scene sphere_lit_from_the_camera(double radius_m) {
  scene::AssetData data = scene::sphere(radius_m);
  data.lights = {directional_light({0, 0, -1}, glm::vec3(3))};
  return wrap(std::move(data));
}

scene::AssetData two_planes(double side_m, int cells, const std::function<void(scene::Vertex&)>& place) {
  const auto chart = [&](double from) {
    return scene::plane(side_m, glm::dmat2(0.46), glm::dvec2(from), cells);
  };
  scene::AssetData made = chart(0.02);
  const scene::Primitive second = chart(0.52).primitives.front();

  scene::Primitive& both = made.primitives.front();
  const auto base = static_cast<std::uint32_t>(both.vertices.size());
  for (scene::Vertex v : second.vertices) {
    place(v);
    both.vertices.push_back(v);
  }
  for (const std::uint32_t i : second.indices) both.indices.push_back(base + i);
  return made;
}

}  // namespace dermis::tests
