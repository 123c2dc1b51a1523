// SPDX-License-Identifier: MIT
#include "techniques/lambert/lambert.h"

#include "techniques/screen.h"

namespace dermis::techniques {
namespace {

// Draws each head: its shadow maps, its skin with the light at each pixel, and the rest of it.
FrameOutputs build(passes::FramePlan& plan, const FrameSettings& settings) {
  Screen screen(plan, settings);
  screen.add_entries();

  for (std::uint32_t head = 0; head < settings.head_count(); ++head) {
    const Model& model = settings.model_of(head);
    screen.add_shadow(head);
    for (std::uint32_t mesh = model.first_mesh; mesh < model.first_mesh + model.meshes; ++mesh)
      screen.add_skin({.square = {.instance = head, .mesh = mesh}}, {});
    screen.add_surfaces(head);
    screen.add_blended(head);
  }

  return screen.finish();
}

}  // namespace

constinit const Technique lambert{.name = "lambert",
                                  .summary = "the same lights and specular without scattering",
                                  .uses_profile = false,
                                  .has_light_maps = false,
                                  .build = build,
                                  .maps = screen_maps,
                                  .report = screen_report,
                                  .gutters = no_gutters};

}  // namespace dermis::techniques
