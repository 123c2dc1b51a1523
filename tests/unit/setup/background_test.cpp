// SPDX-License-Identifier: MIT
#include "render/setup/background.h"

#include <gtest/gtest.h>

#include "alone.h"
#include "dermis/error.h"
#include "head/scene/surface/measured.h"
#include "render/setup/frame_setup.h"
#include "support/built_in.h"

namespace dermis::setup {
namespace {

using Kind = passes::Behind::Kind;

TEST(BackgroundNames, AreThreeAndColours) {
  EXPECT_EQ(background_of("black").kind, Kind::black);
  EXPECT_EQ(background_of("studio").kind, Kind::studio);
  EXPECT_EQ(background_of("environment").kind, Kind::environment);
  const passes::Behind colour = background_of("#0080fF");
  EXPECT_EQ(colour.kind, Kind::colour);
  EXPECT_EQ(colour.srgb, glm::vec3(0, 128 / 255.0f, 1));
}

TEST(BackgroundNames, OthersAreRefused) {
  for (const char* name : {"", "white", "Black", "#", "#12345", "#1234567", "#12345g", "#-12345", "# 12345",
                           "123456", "#0x1234", "0,0,0"})
    EXPECT_THROW(background_of(name), InputError) << name;
}

// A host's own picture lies behind the heads.
TEST(BackgroundNames, AHostHasNone) {
  const std::shared_ptr<const scene::AssetData> head = scene::measured(tests::built_in_head());
  RenderSettings settings;
  settings.output.background = "studio";
  EXPECT_EQ(set_up_alone(head, settings).plan.behind.kind, Kind::studio);
  const HostSetup host{.part = {.picture = passes::PictureFormat{}}};
  EXPECT_EQ(set_up_alone(head, settings, {}, &host).plan.behind.kind, Kind::black);
}

}  // namespace
}  // namespace dermis::setup
