// SPDX-License-Identifier: MIT
#include "render/techniques/screen_space.h"

#include "base/core/assert.h"
#include "render/techniques/screen.h"

namespace dermis::techniques {

gaussians::Rgb scattered_share(const FrameSettings&, const PlannedMesh& part) {
  gaussians::Rgb share{};
  for (std::size_t c = 0; c < 3; ++c) share[c] = 1 - part.unscattered[c];
  return share;
}

namespace {

// Into the targets of a host skin goes first, whole. Heads that are lit in turn need their shadow maps again.
void add_over_skin(Screen& screen, const std::vector<Batch>& batches) {
  for (const Batch& batch : batches) {
    if (batches.size() > 1 && screen.has_other_parts(batch)) screen.add_shadows(batch);
    screen.end_batch(batch);
  }
}

}  // namespace

FrameOutputs build_in_screen_space(passes::FramePlan& plan, const FrameSettings& s, const ScreenBlur& blur) {
  Screen screen(plan, s);

  passes::ScreenSurface surface;
  if (s.has_skin()) surface = passes::make_screen_surface(plan, s.width, s.height, s.samples);
  std::vector<gaussians::Rgb> blurred;
  for (const PlannedMesh& part : s.skin) blurred.push_back(blur.blurred(s, part));

  const std::vector<Batch> batches = batches_of(s);
  for (const Batch& batch : batches) {
    screen.begin_batch(batch);
    const std::vector<passes::MapSquare> skin = squares_of(s, batch);
    if (!skin.empty()) screen.add_split_skin(skin, blurred, surface, label("shade", s, batch));
    if (!s.host) screen.end_batch(batch);
  }

  if (s.has_skin()) screen.add_scattered(blur.add(plan, s, surface), surface);
  if (s.host) add_over_skin(screen, batches);
  return screen.finish();
}

}  // namespace dermis::techniques
