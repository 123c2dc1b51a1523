// SPDX-License-Identifier: MIT
#include "techniques/lambert/lambert.h"

#include "passes/final_pass/final_pass.h"
#include "techniques/screen.h"

namespace dermis::techniques {
namespace {

// Draws each head: its shadow maps, its skin with the light at each pixel, and the rest of it.
FrameOutputs build(passes::FramePlan& plan, const FrameSettings& settings) {
  Screen screen(plan, settings);

  for (std::uint32_t head = 0; head < settings.head_count(); ++head) {
    const Model& model = settings.model_of(head);
    screen.add_shadow(head);
    for (std::uint32_t mesh = model.first_mesh;
         settings.draws_picture() && mesh < model.first_mesh + model.meshes; ++mesh)
      plan.add<passes::FinalPass>(label("final", settings, head, mesh),
                                  {{}, screen.shadow(), screen.colour(), screen.depth()},
                                  {.square = {.instance = head, .mesh = mesh},
                                   .samples = settings.samples,
                                   .format = settings.picture_format(),
                                   .clear = screen.take_clear(),
                                   .weights = {},
                                   .environment = settings.environment,
                                   .soft_shadows = settings.soft_shadows,
                                   .off_map = settings.skin[mesh].off_map,
                                   .cut_out = settings.skin[mesh].cut_out,
                                   .emits = settings.skin[mesh].emits,
                                   .terms = {},
                                   .through = {}});
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
