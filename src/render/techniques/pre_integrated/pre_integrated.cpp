// SPDX-License-Identifier: MIT
#include "render/techniques/pre_integrated/pre_integrated.h"

#include <algorithm>

#include "base/core/assert.h"
#include "frame/together.h"
#include "render/passes/pose/curvature/curvature.h"
#include "render/techniques/screen.h"
#include "render/techniques/screen_space.h"

namespace dermis::techniques {
namespace {

// Of the filter of shadows.
constexpr TapRange shadow_taps{.least = 1, .most = 1024, .usual = 32};

// Each skin mesh has its curvature once, whichever head shows it.
std::vector<frame::BufferId> add_curvatures(passes::FramePlan& plan, const FrameSettings& settings) {
  std::vector<frame::BufferId> curvatures(settings.skin.size());
  frame::Together<passes::Curvature>::In rigid, posed;
  for (std::uint32_t head = 0; head < settings.head_count(); ++head) {
    const Model& model = settings.model_of(head);
    for (std::uint32_t mesh = model.first_mesh; mesh < model.first_mesh + model.meshes; ++mesh) {
      if (curvatures[mesh].valid()) continue;
      const PlannedMesh& part = settings.skin[mesh];
      curvatures[mesh] =
          plan.buffer(label_part("curvature", settings, mesh),
                      {.bytes = std::max(part.vertices, 1u) * sizeof(float)}, frame::Lifetime::persistent);
      (part.posed ? posed : rigid)
          .members.push_back({{curvatures[mesh]},
                              {.square = {.head = head, .mesh = mesh},
                               .vertices = part.vertices,
                               .triangles = part.triangles,
                               .posed = part.posed}});
    }
  }

  if (!rigid.members.empty()) plan.add<frame::Together<passes::Curvature>>("curvature", rigid);
  if (!posed.members.empty()) plan.add<frame::Together<passes::Curvature>>("curvature of poses", posed);
  return curvatures;
}

FrameOutputs build_pre_integrated(passes::FramePlan& plan, const FrameSettings& s) {
  Screen screen(plan, s);
  const std::vector<frame::BufferId> curvatures = add_curvatures(plan, s);
  const std::uint32_t taps = s.taps > 0 ? s.taps : shadow_taps.usual;

  for (const Batch& batch : batches_of(s)) {
    screen.begin_batch(batch);
    const std::vector<passes::MapSquare> skin = squares_of(s, batch);
    if (!skin.empty()) screen.add_pre_integrated_skin(skin, curvatures, taps, label("shade", s, batch));
    screen.end_batch(batch);
  }
  return screen.finish();
}

}  // namespace

constinit const Technique pre_integrated{
    .name = "pre-integrated",
    .summary = "scattering from tables over angle and curvature (Penner 2011, as FaceWorks has it)",
    .uses_profile = true,
    .has_light_maps = false,
    .screen_space = true,
    .curvature = true,
    .taps = shadow_taps,
    .build = build_pre_integrated,
    .maps = screen_maps,
    .report = screen_report,
    .gutters = no_gutters};

}  // namespace dermis::techniques
