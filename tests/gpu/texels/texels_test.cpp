// SPDX-License-Identifier: MIT
// The texels of light maps: a lit tile has the bits that it has where all are lit, and the map of texels is
// drawn again only when it must be.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>

#include "dermis/error.h"
#include "frame/executor.h"
#include "gpu/device.h"
#include "gpu/frame_memory.h"
#include "gpu/support/renderer.h"
#include "gpu/transfer.h"
#include "head/scene/gltf/load.h"
#include "head/scene/import/shapes.h"
#include "head/scene/surface/measured.h"
#include "image/colour.h"
#include "render/passes/asset/gutter_list.h"
#include "render/passes/shaders.h"
#include "render/setup/frame_data.h"
#include "render/setup/frame_setup.h"
#include "render/techniques/technique.h"
#include "support/assets.h"
#include "support/built_in.h"
#include "unit/setup/alone.h"

namespace dermis::tests {
namespace {

struct Bench {
  gpu::Device device{gpu::Device::Options{.validate = true}};
  gpu::PipelineLibrary library{device, passes::find_shader};
};

Bench* bench() {
  static std::unique_ptr<Bench> made = []() -> std::unique_ptr<Bench> {
    try {
      with_the_last_test([] { made.reset(); });
      return std::make_unique<Bench>();
    } catch (const DeviceError&) { return nullptr; }
  }();
  return made.get();
}

RenderSettings small(int map_size = 128) {
  RenderSettings s;
  s.output.width = s.output.height = 48;
  s.output.bloom = 0;
  s.quality.map_size = map_size;
  s.quality.shadow_size = 128;
  s.quality.cull = s.quality.depth = s.quality.clip = false;
  s.lighting.rig_lights = 2;
  return s;
}

/// A plan and its memory, for frames of one head.
class Frames {
 public:
  Frames(std::shared_ptr<const scene::AssetData> asset, const RenderSettings& settings)
      : asset_(std::move(asset)) {
    setup_ = setup::set_up_alone(asset_, settings);
    scene_ = std::make_unique<passes::GpuAsset>(bench()->library, *asset_);
    look_ = scene_->make_look(bench()->device, {});
    outputs_ = setup_.technique->build(plan_, setup_.plan);
    executor_ = std::make_unique<frame::Executor<passes::FrameData>>(bench()->library, plan_);
  }

  /// Draws a frame; settings may differ from those of before in what needs no other plan.
  void draw(const RenderSettings& settings) {
    setup_ = setup::set_up_alone(asset_, settings);
    for (const techniques::GutterSize& size : setup_.technique->gutters(setup_.plan, setup_.heads))
      scene_->make_gutters(bench()->device, size.mesh, asset_->skin[size.mesh], size.side, size.width_texels);
    memory_.clear();
    passes::FrameData data = setup::frame_data(memory_, setup_, outputs_, nullptr);
    data.heads.front().asset = scene_.get();
    data.heads.front().look = &look_;
    data.kept_texels = &kept_;
    drawn_before_ = kept_.drawn();
    memory_.upload();
    executor_->draw(data, {.changed = true, .statistics = true});
  }

  /// RGBA of the first skin mesh's square.
  std::vector<float> light() const {
    const techniques::Shown& shown = outputs_.shows.at("irradiance");
    const gpu::Texture& texture = executor_->resources().texture(shown.map);
    const auto bytes = gpu::read_back(bench()->device, texture, executor_->layout_of(shown.map));
    std::vector<float> values;
    const auto side = static_cast<std::size_t>(setup_.heads[0].detail.side);
    for (std::size_t y = 0; y < side; ++y)
      for (std::size_t x = 0; x < 4 * side; ++x) {
        std::uint16_t half = 0;
        std::memcpy(&half, bytes.data() + 2 * (y * texture.desc().width * 4 + x), 2);
        values.push_back(image::half_to_float(half));
      }
    return values;
  }

  /// Returns which texels of that square are gutters.
  std::vector<bool> gutters() const {
    const auto side = static_cast<std::size_t>(setup_.heads[0].detail.side);
    std::vector<bool> is_gutter(side * side);
    for (const techniques::GutterSize& size : setup_.technique->gutters(setup_.plan, setup_.heads)) {
      if (size.mesh != 0 || size.side != side) continue;
      const passes::GutterList list =
          passes::gutter_list(asset_->skin[0], static_cast<int>(side), size.width_texels);
      for (const scene::GutterTexel& t : list.texels) is_gutter[t.y * side + t.x] = true;
    }
    return is_gutter;
  }

  techniques::FrameReport report() const {
    const auto counters = gpu::read_back(bench()->device, executor_->resources().buffer(outputs_.counters));
    std::vector<std::uint32_t> counts(counters.size() / 4);
    std::memcpy(counts.data(), counters.data(), counters.size());
    return setup_.technique->report(setup_.plan, counts, setup_.heads);
  }

  /// Whether the last frame has drawn the map of texels.
  bool drew_texel_map() const { return kept_.drawn() > drawn_before_; }

 private:
  std::shared_ptr<const scene::AssetData> asset_;
  setup::FrameSetup setup_;
  std::unique_ptr<passes::GpuAsset> scene_;
  passes::GpuLook look_;
  passes::FramePlan plan_;
  techniques::FrameOutputs outputs_;
  passes::KeptMaps kept_;
  std::uint64_t drawn_before_ = 0;
  std::unique_ptr<frame::Executor<passes::FrameData>> executor_;
  gpu::FrameMemory memory_{bench()->device, "frame"};
};

struct Case {
  const char* name;
  std::shared_ptr<const scene::AssetData> head;
};

std::vector<Case> cases() {
  std::vector<Case> all{{"sphere", scene::measured(scene::sphere(0.1, 12))},
                        {"built-in head", scene::measured(built_in_head())}};
  const auto mesh_head = asset_cache() / "makehuman/mh-african-man-young.glb";
  if (missing_asset({mesh_head}).empty())
    all.push_back({"MakeHuman", scene::measured(scene::load_gltf(mesh_head))});
  if (missing_scan().empty()) all.push_back({"scan", scene::measured(scene::load_gltf(scan_manifest()))});
  return all;
}

class Texels : public testing::Test {
 protected:
  void SetUp() override {
    if (!bench()) GTEST_SKIP() << "no Vulkan device with the validation layer";
  }
  void TearDown() override {
    if (!bench()) return;
    EXPECT_EQ(bench()->device.validation_messages(), std::vector<std::string>());
  }
};

// Only gutters may differ, whose source may lie on a chart of which nothing is seen.
TEST_F(Texels, OfSeenTilesHaveTheBitsOfAllTiles) {
  for (const bool translucency : {false, true})
    for (const Case& c : cases()) {
      RenderSettings s = small();
      s.skin.translucency = translucency;
      s.lighting.light_radius_m = translucency ? 0.0 : 0.1;
      s.camera.fov_deg = 12;
      s.quality.clip_margin_mm = 0;
      Frames all(c.head, s);
      all.draw(s);
      s.quality.cull = s.quality.clip = true;
      Frames seen(c.head, s);
      seen.draw(s);

      const std::vector<float> whole = all.light(), part = seen.light();
      const std::vector<bool> is_gutter = all.gutters();
      ASSERT_EQ(whole.size(), 4 * is_gutter.size());
      std::size_t lit = 0, other = 0;
      for (std::size_t i = 0; i < is_gutter.size(); ++i) {
        if (part[4 * i + 3] == 0 || is_gutter[i]) continue;
        ++lit;
        other += std::memcmp(&whole[4 * i], &part[4 * i], 4 * sizeof(float)) != 0 ? 1 : 0;
      }
      const auto whole_texels = all.report().irradiance_texels, seen_texels = seen.report().irradiance_texels;
      std::printf("%-14s %s: %llu of %llu texels lit\n", c.name, translucency ? "translucent" : "opaque",
                  static_cast<unsigned long long>(seen_texels),
                  static_cast<unsigned long long>(whole_texels));
      EXPECT_EQ(other, 0u) << c.name;
      EXPECT_GT(lit, 500u) << c.name;
      EXPECT_LT(seen_texels, whole_texels) << c.name;
      EXPECT_EQ(seen.report().transmission_misses, 0u) << c.name;
    }
}

TEST_F(Texels, HaveEqualBitsFromFrameToFrame) {
  const auto head = scene::measured(built_in_head());
  const RenderSettings s = small();
  Frames one(head, s), other(head, s);
  one.draw(s);
  other.draw(s);
  other.draw(s);
  EXPECT_EQ(one.light(), other.light());
}

TEST_F(Texels, LeaveOutWhatIsNotSeen) {
  const auto head = scene::measured(built_in_head());
  const auto texels = [&](bool cull, bool clip) {
    RenderSettings s = small(256);
    s.quality.cull = cull;
    s.quality.clip = clip;
    s.quality.clip_margin_mm = 0;
    s.camera.fov_deg = 4;
    s.camera.distance = 3;
    Frames frames(head, s);
    frames.draw(s);
    return static_cast<double>(frames.report().irradiance_texels);
  };
  const double whole = texels(false, false), culled = texels(true, false), clipped = texels(false, true);
  std::printf("%.0f texels, %.0f culled, %.0f clipped\n", whole, culled, clipped);
  EXPECT_LT(culled, 0.9 * whole);
  EXPECT_LT(clipped, 0.6 * whole);
  EXPECT_LT(texels(true, true), std::min(culled, clipped));
}

TEST_F(Texels, MapIsDrawnAgainOnlyForAnotherSide) {
  const auto head = scene::measured(built_in_head());
  RenderSettings s = small();
  s.quality.depth = true;
  s.quality.map_size = 512;
  s.output.width = s.output.height = 192;
  s.camera.distance = 2;
  Frames frames(head, s);
  const auto drew = [&](double distance) {
    s.camera.distance = distance;
    frames.draw(s);
    return frames.drew_texel_map();
  };
  EXPECT_TRUE(drew(2));
  EXPECT_FALSE(drew(2));
  EXPECT_FALSE(drew(2.01));
  EXPECT_TRUE(drew(8));
  EXPECT_FALSE(drew(8));
  const std::vector<float> there = frames.light();
  EXPECT_TRUE(drew(2));
  EXPECT_TRUE(drew(8));
  EXPECT_EQ(frames.light(), there);
}

}  // namespace
}  // namespace dermis::tests
