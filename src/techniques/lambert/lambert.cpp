// SPDX-License-Identifier: MIT
#include "techniques/lambert/lambert.h"

#include "frame/together.h"
#include "passes/final_pass/final_pass.h"
#include "techniques/screen.h"

namespace dermis::techniques {
namespace {

using passes::FinalPass;

frame::Member<FinalPass> final_of(const FrameSettings& settings, Screen& screen, std::uint32_t mesh,
                                  std::vector<passes::MapSquare> squares) {
  const SkinPart& part = settings.skin[mesh];
  return {.in = {{}, screen.shadow(), screen.colour(), screen.depth()},
          .settings = {.squares = std::move(squares),
                       .samples = settings.samples,
                       .format = settings.picture_format(),
                       .clear = screen.take_clear(),
                       .weights = {},
                       .environment = settings.environment,
                       .soft_shadows = settings.soft_shadows,
                       .off_map = part.off_map,
                       .cut_out = part.cut_out,
                       .emits = part.emits,
                       .terms = {},
                       .through = {}}};
}

// Draws the heads of each batch: their shadow maps, their skin with the light at each pixel, and the rest.
FrameOutputs build(passes::FramePlan& plan, const FrameSettings& settings) {
  Screen screen(plan, settings);

  for (const Batch& batch : batches_of(settings)) {
    screen.add_shadows(batch);

    frame::Together<FinalPass>::In skin;
    const std::vector<passes::MapSquare> squares = squares_of(settings, batch);
    for (const std::uint32_t mesh : meshes_of(squares))
      if (settings.draws_picture())
        skin.members.push_back(final_of(settings, screen, mesh, of_mesh(squares, mesh)));
    if (!skin.members.empty()) plan.add<frame::Together<FinalPass>>(label("final", settings, batch), skin);

    screen.add_surfaces(batch);
    screen.add_blended(batch);
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
