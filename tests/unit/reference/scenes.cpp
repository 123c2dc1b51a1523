// SPDX-License-Identifier: MIT
#include "unit/reference/scenes.h"

#include "head/scene/framing.h"
#include "tissue/gaussians/known.h"

namespace dermis::tests {

scene::AssetData box(double depth_mm, double half_mm) {
  scene::AssetData made;
  made.name = "box";
  made.materials.push_back({.name = "skin", .skin = true});
  made.materials.back().ior = 1.4f;
  scene::Primitive p{.name = "box", .has_uv = true};
  for (int i = 0; i < 8; ++i) {
    scene::Vertex v;
    v.position_m =
        glm::vec3(i & 1 ? half_mm : -half_mm, i & 2 ? half_mm : -half_mm, i & 4 ? 0 : -depth_mm) / 1000.0f;
    p.vertices.push_back(v);
  }
  // Counter-clockwise as seen from outside: top, bottom, and the four sides.
  p.indices = {4, 5, 7, 4, 7, 6, 0, 3, 1, 0, 2, 3, 0, 1, 5, 0, 5, 4,
               1, 3, 7, 1, 7, 5, 3, 2, 6, 3, 6, 7, 2, 0, 4, 2, 4, 6};
  made.primitives.push_back(std::move(p));
  return made;
}

reference::Job furnace(const scene::AssetData& scene, int side) {
  reference::Job job;
  job.setup.camera = scene::framing_camera(scene::skin_bounds(scene).sphere, 1);
  job.setup.width = job.setup.height = side;
  job.setup.ambient = 1;
  job.setup.white_albedo = true;
  job.profiles.assign(scene.materials.size(), gaussians::skin_six());
  return job;
}

reference::Film rendered(const reference::Tracer& tracer, std::uint32_t samples, std::uint64_t seed,
                         int threads) {
  reference::Film film(tracer.width(), tracer.height());
  reference::render(tracer, film,
                    {.samples = samples, .noise_percent = {}, .seed = seed, .threads = threads});
  return film;
}

}  // namespace dermis::tests
