// SPDX-License-Identifier: MIT
#include "rays/alpha_test.h"

#include <cmath>

#include "head/scene/wrap.h"

namespace dermis::rays {
namespace {

// Returns alpha of the map, bilinear between pixels unless the map is set to nearest.
double alpha_of(const image::Image8& pixels, const scene::MapRef& map, const glm::dvec2& uv) {
  const glm::dvec2 at = glm::dmat3x2(map.transform) * glm::dvec3(uv, 1);
  if (!std::isfinite(at.x) || !std::isfinite(at.y)) return 0;
  const int w = pixels.width, h = pixels.height;
  const auto alpha = [&](int x, int y) {
    return pixels.at(scene::wrapped(x, w, map.wrap_u), scene::wrapped(y, h, map.wrap_v))[3] / 255.0;
  };

  double fx = 0, fy = 0;
  if (map.nearest) {
    const int x = scene::split(at.x * w, fx), y = scene::split(at.y * h, fy);
    return alpha(x, y);
  }
  const int x = scene::split(at.x * w - 0.5, fx), y = scene::split(at.y * h - 0.5, fy);
  return glm::mix(glm::mix(alpha(x, y), alpha(x + 1, y), fx),
                  glm::mix(alpha(x, y + 1), alpha(x + 1, y + 1), fx), fy);
}

}  // namespace

bool is_cut_away(const scene::AssetData& scene, const SurfacePoint& s) {
  const scene::Material& material = scene.materials[s.material];
  if (material.alpha_mode != AssetAlpha::mask) return false;
  double alpha = double{material.base_colour.a} * s.colour.a;
  const scene::MapRef& map = material.base_colour_map;
  if (map.present())
    alpha *= alpha_of(*scene.images[static_cast<std::size_t>(map.image)].pixels, map,
                      s.uv[static_cast<std::size_t>(map.uv_set)]);
  return alpha < double{material.alpha_cutoff};
}

}  // namespace dermis::rays
