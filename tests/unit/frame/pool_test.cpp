// SPDX-License-Identifier: MIT
// The number of heads that are lit together.
#include "render/setup/pool.h"

#include <gtest/gtest.h>

#include <utility>

#include "render/techniques/technique.h"
#include "tissue/gaussians/known.h"

namespace dermis::setup::test {
namespace {

// 64 far heads have small maps, but each has a layer per lamp.
TEST(Pool, HeadsTogetherFitTheLayersOfATexture) {
  for (const auto& [lamps, together] : {std::pair{2u, 64u}, std::pair{40u, 51u}, std::pair{3000u, 1u}}) {
    techniques::FrameSettings plan;
    plan.skin.push_back({.profile = gaussians::skin_six()});
    plan.models = {{.meshes = 1}};
    plan.heads.assign(64, 0);
    plan.set_most_side(64);
    plan.shadow_size = 48;
    plan.shadow_layers = lamps;
    plan.optimise.cull = true;
    set_up_pool(plan, techniques::find_technique("texture-space"), {.count = 64, .used_side = 64}, {},
                {.max_array_layers = 2048});
    EXPECT_EQ(plan.heads_per_batch, together) << lamps;
  }
}

}  // namespace
}  // namespace dermis::setup::test
