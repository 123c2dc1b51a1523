// SPDX-License-Identifier: MIT
#include "render/techniques/lambert/lambert.h"

#include "render/techniques/screen.h"

namespace dermis::techniques {
namespace {

// Draws the heads of each batch: their shadow maps, their skin with the light at each pixel, and the rest.
FrameOutputs build_lambert(passes::FramePlan& plan, const FrameSettings& settings) {
  Screen screen(plan, settings);

  for (const Batch& batch : batches_of(settings)) {
    screen.begin_batch(batch);

    std::vector<SkinOnScreen> skin;
    for (const passes::MapSquare& square : squares_of(settings, batch))
      skin.push_back({.look = {.square = square}, .maps = {}});
    screen.add_skin(skin, label("shade", settings, batch));

    screen.end_batch(batch);
  }

  return screen.finish();
}

}  // namespace

constinit const Technique lambert{.name = "lambert",
                                  .summary = "the same lights and specular without scattering",
                                  .uses_profile = false,
                                  .has_light_maps = false,
                                  .build = build_lambert,
                                  .maps = screen_maps,
                                  .report = screen_report,
                                  .gutters = no_gutters};

}  // namespace dermis::techniques
