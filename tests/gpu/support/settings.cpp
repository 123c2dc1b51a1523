// SPDX-License-Identifier: MIT
#include "gpu/support/settings.h"

namespace dermis::tests {

RenderSettings small_settings(const std::string& technique, int side, int map_side) {
  RenderSettings s;
  s.technique = technique;
  s.output.width = s.output.height = side;
  s.quality.map_size = s.quality.shadow_size = map_side;
  return s;
}

RenderSettings in_a_furnace(RenderSettings s) {
  s.lighting.ambient = 1;
  s.lighting.rig_lights = 0;
  s.lighting.white_albedo = true;
  s.output.bloom = 0;
  return s;
}

RenderSettings furnace_settings(const std::string& technique, bool specular) {
  RenderSettings s = in_a_furnace(small_settings(technique));
  s.lighting.specular = specular;
  return s;
}

RenderSettings unoptimised(RenderSettings s) {
  s.quality.cull = s.quality.depth = s.quality.clip = false;
  return s;
}

RenderSettings super_sampled(RenderSettings s, int times) {
  s.output.width *= times;
  s.output.height *= times;
  s.quality.samples = 1;
  return s;
}

}  // namespace dermis::tests
