// SPDX-License-Identifier: MIT
#include "gpu/support/settings.h"

#include "dermis/renderer.h"
#include "support/files.h"
#include "tissue/gaussians/json.h"

namespace dermis::tests {

RenderSettings small_settings(const std::string& technique, int side, int map_side) {
  RenderSettings s;
  s.technique = technique;
  s.output.width = s.output.height = side;
  s.quality.map_size = s.quality.shadow_size = map_side;
  return s;
}

std::vector<std::string> other_than_published() {
  std::vector<std::string> names = technique_names();
  std::erase(names, "published");
  return names;
}

RenderSettings in_a_furnace(RenderSettings s) {
  s.lighting.ambient = 1;
  s.lighting.rig_lights = 0;
  s.lighting.white_albedo = true;
  s.output.bloom = 0;
  return s;
}

RenderSettings under_lamps_alone(RenderSettings s) {
  s.lighting.ambient = s.output.bloom = 0;
  s.lighting.specular = false;
  s.lighting.white_albedo = true;
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

RenderSettings with_profile(RenderSettings s, const std::string& name, const std::vector<Gaussian>& terms) {
  ScatterProfile sum;
  sum.name = name;
  sum.terms = terms;
  for (std::size_t c = 0; c < 3; ++c) {
    double weights = 0;
    for (const Gaussian& term : terms) weights += term.weight[c];
    for (Gaussian& term : sum.terms) term.weight[c] /= weights;
  }
  s.skin.profile = (program_folder() / (name + ".json")).string();
  write_text(s.skin.profile, gaussians::to_json(sum));
  return s;
}

RenderSettings super_sampled(RenderSettings s, int times) {
  s.output.width *= times;
  s.output.height *= times;
  s.quality.samples = 1;
  return s;
}

}  // namespace dermis::tests
