// SPDX-License-Identifier: MIT
// A prepared frame keeps what it shows when a change is refused.
#include <gtest/gtest.h>

#include "dermis/error.h"
#include "gpu/support/heads.h"
#include "gpu/support/renderer.h"
#include "gpu/support/settings.h"

namespace dermis::tests {
namespace {

RenderSettings refused_for(const std::string& reason, RenderSettings s) {
  if (reason == "an unknown map") s.output.show = "blurred";
  if (reason == "a map of another technique") {
    s.technique = "lambert";
    s.output.show = "irradiance";
  }
  if (reason == "a setting out of range") s.camera.fov_deg = 500;
  if (reason == "maps that no budget holds") s.quality.map_budget_mb = 0.001;
  if (reason == "an unknown camera") s.camera.name = "nobody";
  return s;
}

TEST(PreparedFrames, StayAsTheyWereWhenAChangeIsRefused) {
  const Scene head = Scene::built_in();
  const RenderSettings s = small_settings("texture-space", 32, 64);
  PreparedFrame frame = renderer().prepare(head, s);
  const Picture before = frame.picture();

  for (const char* reason : {"an unknown map", "a map of another technique", "a setting out of range",
                             "maps that no budget holds", "an unknown camera"}) {
    EXPECT_THROW(frame.set(refused_for(reason, s)), InputError) << reason;
    EXPECT_EQ(frame.picture().linear_rgba, before.linear_rgba) << reason;
    EXPECT_GT(frame.draw(), 0) << reason;
  }
}

}  // namespace
}  // namespace dermis::tests
