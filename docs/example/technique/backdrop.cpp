// SPDX-License-Identifier: MIT
// A technique, whole: it draws all but the skin (hair, eyes, clothes). ARCHITECTURE.md, "Adding a technique".
#include "render/techniques/screen.h"
#include "render/techniques/technique.h"

namespace dermis::techniques {
namespace {

FrameOutputs build_backdrop(passes::FramePlan& plan, const FrameSettings& settings) {
  Screen screen(plan, settings);

  for (const Batch& batch : batches_of(settings)) {
    screen.add_shadows(batch);
    screen.add_surfaces(batch);
    screen.add_blended(batch);
  }
  return screen.finish();
}

}  // namespace

extern const Technique backdrop;
constinit const Technique backdrop{.name = "backdrop",
                                   .summary = "everything but skin",
                                   .uses_profile = false,
                                   .has_light_maps = false,
                                   .build = build_backdrop,
                                   .maps = screen_maps,
                                   .report = screen_report,
                                   .gutters = no_gutters};

}  // namespace dermis::techniques
