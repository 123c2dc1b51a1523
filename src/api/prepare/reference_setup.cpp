// SPDX-License-Identifier: MIT
#include "api/prepare/reference_setup.h"

#include <cmath>

#include "base/core/error.h"
#include "head/scene/framing.h"
#include "render/setup/choose.h"
#include "render/setup/frame_setup.h"

namespace dermis::api {

reference::RenderSetup reference_setup(const setup::PlacedScene& scene, const RenderSettings& s) {
  setup::check_settings(s);
  if (s.camera.heads != 1)
    throw input_error("", "camera.heads must be 1 for the reference, got {}", s.camera.heads);
  if (static_cast<std::int64_t>(s.output.width) * s.output.height > std::int64_t{1} << 26)
    throw input_error("",
                      "output.width x output.height, {}x{}, has more than {} pixels, too many for the sums "
                      "of the reference",
                      s.output.width, s.output.height, 1 << 26);
  setup::check_seen(scene);
  const setup::HeadSpheres spheres = setup::head_spheres(scene, s);
  reference::RenderSetup setup;
  setup.camera = setup::choose_camera(scene, s, spheres);
  setup.width = s.output.width, setup.height = s.output.height;
  setup.lights = setup::choose_lights(scene, s, spheres);
  setup.ambient = s.lighting.ambient;
  setup.radiance_scale = std::exp2(s.output.exposure_ev.value_or(0));
  setup.specular = s.lighting.specular, setup.white_albedo = s.lighting.white_albedo;
  setup.mix = s.skin.mix;
  return setup;
}

}  // namespace dermis::api
