// SPDX-License-Identifier: MIT
// Light maps whose texels a compute pass lights, against those that are drawn: the same texels of the same
// charts, the same light, and a map of texels that is drawn again only when it must be.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
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
#include "image/colour.h"
#include "passes/shaders.h"
#include "scene/load.h"
#include "scene/primitives.h"
#include "setup/frame_data.h"
#include "setup/frame_setup.h"
#include "support/assets.h"
#include "support/built_in.h"
#include "techniques/technique.h"

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
  Frames(std::shared_ptr<const scene::Scene> scene, const RenderSettings& settings, bool texel_maps)
      : subject_(setup::examine(std::move(scene))), texel_maps_(texel_maps) {
    set_up(settings);
    scene_ = std::make_unique<passes::GpuScene>(bench()->library, *subject_.scene, subject_.skin);
    look_ = scene_->make_look(bench()->device, {});
    outputs_ = setup_.technique->build(plan_, setup_.plan);
    executor_ = std::make_unique<frame::Executor<passes::FrameData>>(bench()->library, plan_);
  }

  /// Draws a frame; settings may differ from those of before in what needs no other plan.
  void draw(const RenderSettings& settings) {
    set_up(settings);
    for (const techniques::GutterSize& size :
         setup_.technique->gutters(setup_.plan, setup::drawn_heads(setup_)))
      scene_->make_gutters(bench()->device, size.mesh, subject_.skin[size.mesh], size.side,
                           size.width_texels);
    memory_.clear();
    const setup::InstanceOnDevice instance{.scene = scene_.get(), .look = &look_, .sky = {}};
    passes::FrameData data = setup::frame_data(memory_, setup_, outputs_, std::span(&instance, 1), nullptr);
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

  techniques::FrameReport report() const {
    const auto counters = gpu::read_back(bench()->device, executor_->resources().buffer(outputs_.counters));
    std::vector<std::uint32_t> counts(counters.size() / 4);
    std::memcpy(counts.data(), counters.data(), counters.size());
    return setup_.technique->report(setup_.plan, counts, setup::drawn_heads(setup_));
  }

  /// Whether the last frame has drawn the map of texels.
  bool drew_texel_map() const { return kept_.drawn() > drawn_before_; }

 private:
  void set_up(const RenderSettings& settings) {
    setup::PlacedScene placed{
        .name = subject_.scene->name, .instances = {}, .lights = subject_.scene->lights};
    placed.instances.push_back(
        {.asset = subject_.scene, .sphere = subject_.bounds.sphere, .profile = {}, .mix = {}});
    RenderSettings all = settings;
    all.quality.irradiance = texel_maps_ ? IrradianceBy::compute : IrradianceBy::raster;
    setup_ = setup::set_up(placed, std::array<const setup::Subject*, 1>{&subject_}, all, {}, {});
  }

  setup::Subject subject_;
  bool texel_maps_;
  setup::FrameSetup setup_;
  std::unique_ptr<passes::GpuScene> scene_;
  passes::GpuLook look_;
  passes::FramePlan plan_;
  techniques::FrameOutputs outputs_;
  passes::KeptMaps kept_;
  std::uint64_t drawn_before_ = 0;
  std::unique_ptr<frame::Executor<passes::FrameData>> executor_;
  gpu::FrameMemory memory_{bench()->device, "frame"};
};

struct Difference {
  std::size_t texels = 0, charts = 0, beyond = 0;
  double mean = 0, worst = 0;
};

/// `beyond`: texels with a channel further than 1/256 of the brightest light apart.
Difference difference(const std::vector<float>& a, const std::vector<float>& b) {
  Difference d;
  float most = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (i % 4 != 3) most = std::max(most, a[i]);
  for (std::size_t i = 0; i < a.size(); i += 4) {
    if (a[i + 3] != b[i + 3]) ++d.charts;
    if (a[i + 3] == 0) continue;
    ++d.texels;
    double off = 0;
    for (std::size_t c = 0; c < 3; ++c) off = std::max(off, double{std::abs(a[i + c] - b[i + c])} / most);
    if (off > 1.0 / 256) ++d.beyond;
    d.mean += off;
    d.worst = std::max(d.worst, off);
  }
  d.mean /= std::max<double>(1, static_cast<double>(d.texels));
  return d;
}

using ScenePointer = std::shared_ptr<const scene::Scene>;

struct Case {
  const char* name;
  ScenePointer scene;
};

// Both halves of the sphere on the same texels, one of them mirrored.
scene::Scene folded_sphere() {
  scene::Scene made = scene::sphere(0.1, 12);
  for (scene::Primitive& primitive : made.primitives)
    for (scene::Vertex& vertex : primitive.vertices) vertex.uv0.x = std::abs(2 * vertex.uv0.x - 1);
  return made;
}

std::vector<Case> cases() {
  std::vector<Case> all{{"sphere", std::make_shared<scene::Scene>(scene::sphere(0.1, 12))},
                        {"folded sphere", std::make_shared<scene::Scene>(folded_sphere())},
                        {"built-in head", std::make_shared<scene::Scene>(built_in_head())}};
  const auto mesh_head = asset_cache() / "makehuman/mh-african-man-young.glb";
  if (missing_asset({mesh_head}).empty())
    all.push_back({"MakeHuman", std::make_shared<scene::Scene>(scene::load_gltf(mesh_head))});
  if (missing_scan().empty())
    all.push_back({"scan", std::make_shared<scene::Scene>(scene::load_gltf(scan_manifest()))});
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

// Without cull the texels are those that are drawn: who owns one is decided by the same draw.
TEST_F(Texels, AreThoseThatAreDrawn) {
  for (const bool translucency : {false, true})
    for (const Case& c : cases()) {
      RenderSettings s = small();
      s.skin.translucency = translucency;
      Frames drawn(c.scene, s, false), computed(c.scene, s, true);
      drawn.draw(s);
      computed.draw(s);

      const Difference d = difference(drawn.light(), computed.light());
      std::printf("%-14s %s: %zu texels, %zu beyond 1/256, mean %.2e, most %.2e\n", c.name,
                  translucency ? "translucent" : "opaque     ", d.texels, d.beyond, d.mean, d.worst);
      EXPECT_GT(d.texels, 1000u) << c.name;
      EXPECT_EQ(d.charts, 0u) << c.name;
      EXPECT_LE(static_cast<double>(d.beyond), 0.001 * static_cast<double>(d.texels)) << c.name;
      EXPECT_EQ(drawn.report().irradiance_texels, computed.report().irradiance_texels) << c.name;
      EXPECT_EQ(computed.report().transmission_misses, drawn.report().transmission_misses) << c.name;
    }
}

// One that nobody sees does not take the texels of one that is seen, from either side.
TEST_F(Texels, OfTrianglesThatOverlapShowTheKeptOne) {
  const auto scene = std::make_shared<scene::Scene>(folded_sphere());
  RenderSettings s = small();
  s.quality.cull = s.quality.clip = true;
  Frames drawn(scene, s, false), computed(scene, s, true);
  for (const double azimuth_deg : {30.0, 150.0, 240.0}) {
    s.camera.orbit_deg = {azimuth_deg, 0};
    drawn.draw(s);
    computed.draw(s);
    EXPECT_TRUE(computed.drew_texel_map()) << azimuth_deg;

    const Difference d = difference(drawn.light(), computed.light());
    EXPECT_GT(d.texels, 1000u) << azimuth_deg;
    EXPECT_EQ(d.charts, 0u) << azimuth_deg;
    EXPECT_LE(static_cast<double>(d.beyond), 0.001 * static_cast<double>(d.texels)) << azimuth_deg;
    EXPECT_EQ(drawn.report().irradiance_texels, computed.report().irradiance_texels) << azimuth_deg;
  }
}

// Penumbrae, and skin of which an alpha test leaves stripes of eight pixels.
TEST_F(Texels, HaveSoftShadowsAndAreCutOut) {
  image::Image8 pixels{.width = 64, .height = 64, .rgba = {}};
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      for (const int value : {255, 160, 120, x % 16 < 8 ? 255 : 0})
        pixels.rgba.push_back(static_cast<std::uint8_t>(value));
  scene::Scene made = scene::sphere(0.1, 12);
  scene::Material& skin = made.materials.front();
  skin.alpha_mode = scene::AlphaMode::mask;
  skin.base_colour_map.image = static_cast<int>(made.images.size());
  made.images.push_back({.name = "mask", .pixels = std::make_shared<const image::Image8>(std::move(pixels))});

  RenderSettings s = small();
  s.lighting.light_radius_m = 0.1;
  Frames drawn(std::make_shared<scene::Scene>(made), s, false),
      computed(std::make_shared<scene::Scene>(made), s, true);
  drawn.draw(s);
  computed.draw(s);
  const Difference d = difference(drawn.light(), computed.light());
  std::printf("%zu texels, %zu beyond 1/256, %zu of another chart\n", d.texels, d.beyond, d.charts);
  EXPECT_EQ(d.charts, 0u);
  EXPECT_LE(static_cast<double>(d.beyond), 0.001 * static_cast<double>(d.texels));
  EXPECT_EQ(drawn.report().irradiance_texels, computed.report().irradiance_texels);
}

TEST_F(Texels, HaveEqualBitsFromFrameToFrame) {
  const auto scene = std::make_shared<scene::Scene>(built_in_head());
  const RenderSettings s = small();
  Frames one(scene, s, true), other(scene, s, true);
  one.draw(s);
  other.draw(s);
  other.draw(s);
  EXPECT_EQ(one.light(), other.light());
}

// Cull leaves out the same triangles; clip, texel by texel, may differ at the edges of the picture.
TEST_F(Texels, LeaveOutWhatIsNotSeen) {
  const auto scene = std::make_shared<scene::Scene>(built_in_head());
  const auto texels = [&](bool cull, bool clip, bool texel_maps) {
    RenderSettings s = small();
    s.quality.cull = cull;
    s.quality.clip = clip;
    s.quality.clip_margin_mm = 0;
    s.camera.fov_deg = 4;
    s.camera.distance = 3;
    Frames frames(scene, s, texel_maps);
    frames.draw(s);
    return static_cast<double>(frames.report().irradiance_texels);
  };
  const double whole = texels(false, false, true), culled = texels(true, false, true),
               clipped = texels(false, true, true), drawn = texels(false, true, false);
  std::printf("%.0f texels, %.0f culled, %.0f clipped (drawn: %.0f)\n", whole, culled, clipped, drawn);
  EXPECT_EQ(culled, texels(true, false, false));
  EXPECT_LT(culled, 0.9 * whole);
  EXPECT_NEAR(clipped, drawn, 0.01 * drawn);
  EXPECT_LT(clipped, 0.5 * whole);
}

TEST_F(Texels, MapIsDrawnAgainOnlyForAnotherSide) {
  const auto scene = std::make_shared<scene::Scene>(built_in_head());
  RenderSettings s = small();
  s.quality.depth = true;
  s.quality.map_size = 512;
  s.output.width = s.output.height = 192;
  s.camera.distance = 2;
  Frames frames(scene, s, true);
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
