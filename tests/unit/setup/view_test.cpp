// SPDX-License-Identifier: MIT
// A view of a host is what a setup of its own would make of it, though its plan is made once.
#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <span>

#include "alone.h"
#include "head/scene/framing.h"
#include "head/scene/import/shapes.h"
#include "head/scene/surface/measured.h"

namespace dermis::setup {
namespace {

// Looks at the origin from (0, 0, distance), depth reversed, clip y down.
CameraMatrices camera_at(double distance_m) {
  CameraMatrices m;
  m.camera_from_world = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -distance_m, 1};
  m.clip_from_camera = {4, 0, 0, 0, 0, -4, 0, 0, 0, 0, 0, -1, 0, 0, 0.05, 0};
  return m;
}

template <class Value>
void expect_equal_bytes(std::span<const Value> a, std::span<const Value> b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size_bytes()), 0);
}

class View : public testing::Test {
 protected:
  // Three heads in a row, and a fourth in the same place as the third, so that their distance is equal.
  View() {
    for (const float x_m : {0.0f, 0.3f, 0.6f, 0.6f}) {
      scene_.instances.push_back(placed(ball_));
      scene_.instances.back().world_from_asset.origin_m = {x_m, 0, 0.1f * x_m};
    }
    scene_.lights.push_back({.colour = {1, 1, 1}, .direction = {0, -1, -1}, .radius = 0.01f});
    host_.part.picture = passes::PictureFormat{};
    host_.part.width = host_.part.height = 512;
  }

  RenderSettings settings_at(double distance_m, int side) const {
    RenderSettings s;
    s.camera.matrices = camera_at(distance_m);
    s.output.width = s.output.height = side;
    return s;
  }
  FrameSetup made_at(const RenderSettings& s) const { return set_up(scene_, s, {}, {}, &host_); }

  std::shared_ptr<const scene::AssetData> ball_ = scene::measured(scene::sphere(0.1));
  PlacedScene scene_{.name = "balls", .instances = {}, .lights = {}};
  HostSetup host_;
};

TEST_F(View, IsThatOfASetupOfItsOwn) {
  FrameSetup setup = made_at(settings_at(0.5, 128));
  // Near, far, behind the heads, and back again.
  for (const double distance_m : {0.3, 40.0, -2.0, 0.12, 0.5}) {
    SCOPED_TRACE(distance_m);
    const RenderSettings s = settings_at(distance_m, 480);
    const FrameSetup wanted = made_at(s);
    set_view(setup, scene_, s, host_);

    EXPECT_EQ(setup.plan, wanted.plan);
    expect_equal_bytes<io::FrameIo>({&setup.frame, 1}, {&wanted.frame, 1});
    ASSERT_EQ(setup.heads.size(), wanted.heads.size());
    for (std::size_t i = 0; i < wanted.heads.size(); ++i) {
      const auto &head = setup.heads[i], &other = wanted.heads[i];
      EXPECT_EQ(head.number, other.number);
      EXPECT_EQ(head.detail, other.detail);
      EXPECT_EQ(head.visible, other.visible);
      EXPECT_EQ(head.area.low, other.area.low);
      EXPECT_EQ(head.area.high, other.area.high);
      EXPECT_EQ(head.shadow_side, other.shadow_side);
      EXPECT_EQ(head.first_shadow_layer, other.first_shadow_layer);
      expect_equal_bytes<io::LightIo>(head.lights, other.lights);
      expect_equal_bytes<glm::mat4>(head.shadow_from_world, other.shadow_from_world);
    }
  }
}

}  // namespace
}  // namespace dermis::setup
