// SPDX-License-Identifier: MIT
#include "api/reference_view.h"

#include <cmath>

#include "api/choose.h"
#include "api/setup.h"
#include "core/error.h"
#include "scene/framing.h"

namespace dermis::api {

reference::View reference_view(const scene::Scene& scene, const RenderSettings& s) {
  check_settings(s);
  if (s.heads != 1) throw input_error("", "--heads must be 1 for the reference, got {}", s.heads);
  if (static_cast<std::int64_t>(s.width) * s.height > std::int64_t{1} << 26)
    throw input_error("", "--size {}x{} has more than {} pixels, too many for the sums of the reference",
                      s.width, s.height, 1 << 26);
  const scene::BoundingSphere sphere = scene::skin_sphere(scene);
  if (!(sphere.radius_m > 0))
    throw input_error(scene.name, "has nothing to see: all its triangles lie at one point");
  reference::View view;
  view.camera = choose_camera(scene, s, sphere);
  view.width = s.width, view.height = s.height;
  view.lights = choose_lights(scene, s, sphere, scene::head_row_offsets(1, sphere.radius_m));
  view.ambient = s.ambient;
  view.radiance_scale = std::exp2(s.exposure_ev.value_or(0));
  view.specular = s.specular, view.white_albedo = s.white_albedo;
  view.mix = s.mix;
  return view;
}

}  // namespace dermis::api
