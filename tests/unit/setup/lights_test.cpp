// SPDX-License-Identifier: MIT
// Lights of a scene as shaders get them.
#include <gtest/gtest.h>

#include <string>

#include "alone.h"
#include "dermis/error.h"
#include "head/scene/import/shapes.h"
#include "head/scene/surface/measured.h"
#include "render/setup/frame_setup.h"
#include "support/thrown.h"

namespace dermis::setup {
namespace {

FrameSetup set_up_under(LightType type) {
  scene::AssetData made = scene::plane(0.1);
  made.lights.push_back({.name = "lamp", .type = type, .position_m = {0, 0, 1}});
  return set_up_alone(scene::measured(std::move(made)), RenderSettings{});
}

TEST(Lights, EachTypeHasItsNumber) {
  const auto number_of = [](LightType type) { return set_up_under(type).heads.at(0).lights.at(0).type; };
  EXPECT_EQ(number_of(LightType::directional), LIGHT_DIRECTIONAL);
  EXPECT_EQ(number_of(LightType::spot), LIGHT_SPOT);
  EXPECT_EQ(number_of(LightType::point), LIGHT_POINT);
}

// A mistake of ours, which must not be drawn as some other light.
TEST(Lights, ATypeWithoutANumberIsNoPoint) {
  const std::string said = tests::thrown<InternalError>([] { set_up_under(static_cast<LightType>(3)); });
  EXPECT_NE(said.find("a light has a LightType: 3"), std::string::npos) << said;
}

}  // namespace
}  // namespace dermis::setup
