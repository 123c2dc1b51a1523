// SPDX-License-Identifier: MIT
// What the device makes of a pose, vertex by vertex, against the processor; and that it does nothing for what
// stands still.
#include <gtest/gtest.h>

#include <cstring>

#include "api/posed_instances.h"
#include "api/rig_pose.h"
#include "gpu/device.h"
#include "head/scene/gltf/load.h"
#include "head/scene/surface/measured.h"
#include "render/passes/pose/move_rig/move_rig.h"
#include "render/passes/shaders.h"
#include "support/assets.h"
#include "support/log_lines.h"

namespace dermis::tests {
namespace {

template <class T>
std::vector<T> values_of(gpu::Device& device, const gpu::Buffer& buffer) {
  const std::vector<std::byte> bytes = gpu::read_back(device, buffer);
  std::vector<T> values(bytes.size() / sizeof(T));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
  return values;
}

// Two instances of an asset, without a plan: the pass is recorded alone.
class MovedOnDevice : public testing::Test {
 protected:
  void SetUp() override {
    if (gpu::list_devices().empty()) GTEST_SKIP() << "no Vulkan device";
    device_ = std::make_unique<gpu::Device>(gpu::Device::Options{});
    library_ = std::make_unique<gpu::PipelineLibrary>(*device_, passes::find_shader);
  }

  void open(const char* name) {
    const std::filesystem::path file = asset_cache() / name;
    if (const std::string missing = missing_asset({file}); !missing.empty()) GTEST_SKIP() << missing;
    const LogLines quiet;
    scene_ = scene::measured(scene::load_gltf(file));
    asset_ = std::make_shared<api::SharedAsset>(api::SharedAsset{.data = scene_});
    asset_->gpu.emplace(*library_, *scene_);
    on_device_ = api::SceneOnDevice({asset_, asset_});
    placed_.instances.resize(2);
  }

  void pose(std::size_t instance, double seconds) {
    static std::uint64_t changes = 0;
    placed_.instances[instance].posed =
        api::posed_asset(*scene_, RigPose{.clip = ClipTime{.clip = "", .seconds = seconds}});
    placed_.instances[instance].posed_change = ++changes;
  }

  // Draws a frame of nothing but the pass; returns how many instances it has moved.
  std::size_t frame() {
    posed_.keep(*library_, on_device_, {InstanceId{1}, InstanceId{2}}, placed_);
    gpu::FrameMemory memory(*device_, "frame");
    data_ = {};
    data_.heads.resize(2);
    for (std::size_t i = 0; i < data_.heads.size(); ++i) {
      data_.heads[i].instance = i;
      data_.heads[i].asset = &*asset_->gpu;
    }
    data_.heads[0].visible = first_is_seen_;
    posed_.fill(memory, data_);
    memory.add(std::span<const float>());
    memory.upload();

    passes::MoveRig pass;
    pass.prepare(*library_);
    device_->run([&](VkCommandBuffer commands) {
      gpu::Cmd cmd(*device_, commands);
      pass.record(cmd, frame::Resources(), data_);
    });
    return data_.moves.size();
  }

  std::vector<io::VertexIo> vertices(std::size_t instance, std::size_t mesh) {
    return values_of<io::VertexIo>(*device_, data_.heads[instance].posed->vertices[mesh]);
  }

  // The asset as the processor poses it.
  scene::AssetData moved(std::size_t instance) const {
    scene::AssetData made = *scene_;
    scene::take_pose(*scene_->rig, placed_.instances[instance].posed->rig, made);
    return made;
  }

  void expect_as_on_processor(std::size_t instance, double size_m) {
    const scene::AssetData expected = moved(instance);
    double farthest = 0, normals = 0, tangents = 0;
    const auto compare = [&](const io::VertexIo& found, const scene::Vertex& wanted) {
      farthest = std::max(farthest, double{glm::distance(found.position_m, wanted.position_m)});
      normals = std::max(normals, double{glm::distance(found.normal, wanted.normal)});
      tangents = std::max(tangents, double{glm::distance(found.tangent, wanted.tangent)});
    };
    for (std::size_t m = 0; m < scene_->skin.size(); ++m) {
      const std::vector<io::VertexIo> found = vertices(instance, m);
      const std::vector<scene::PrimitiveVertex>& origins = scene_->skin[m].origins;
      ASSERT_EQ(found.size(), origins.size());
      for (std::size_t v = 0; v < found.size(); ++v)
        compare(found[v], expected.primitives[origins[v].primitive].vertices[origins[v].vertex]);
    }
    for (std::size_t p = 0; p < asset_->gpu->surfaces.pages.size(); ++p) {
      const std::vector<io::VertexIo> found = vertices(instance, scene_->skin.size() + p);
      for (const passes::GpuSurfaces::Page::Part& part : asset_->gpu->surfaces.pages[p].parts) {
        const std::vector<scene::Vertex>& wanted = expected.primitives[part.primitive].vertices;
        for (std::size_t v = 0; v < wanted.size(); ++v) compare(found[part.first_vertex + v], wanted[v]);
      }
    }
    std::printf("%s: positions %.1e of the size, normals %.1e, tangents %.1e\n", scene_->name.c_str(),
                farthest / size_m, normals, tangents);
    EXPECT_LE(farthest, 1e-6 * size_m);
    EXPECT_LE(normals, 2e-5);
    EXPECT_LE(tangents, 1e-4);
  }

  // The metric against that of the posed mesh, relative to its larger direction.
  void expect_metric(std::size_t instance) {
    const std::vector<scene::SkinMesh> expected = scene::skin_meshes(moved(instance));
    double apart = 0, at_rest = 0;
    for (std::size_t m = 0; m < expected.size(); ++m) {
      const auto found = values_of<io::SkinVertexIo>(*device_, data_.heads[instance].posed->skin_vertices[m]);
      ASSERT_EQ(found.size(), expected[m].metric.size());
      std::size_t off = 0;
      for (std::size_t v = 0; v < found.size(); ++v) {
        const glm::vec3 g = expected[m].metric[v];
        const double size = double{g.x} + double{g.z};
        off += glm::distance(found[v].metric_mm2, g) > 1e-3 * size ? 1 : 0;
        apart = std::max(apart, double{glm::distance(found[v].metric_mm2, g)} / size);
        at_rest = std::max(at_rest, double{glm::distance(scene_->skin[m].metric[v], g)} / size);
      }
      // Which slivers are left out is decided once; few vertices have one.
      EXPECT_LE(off, found.size() / 500);
    }
    std::printf("%s: metric %.1e apart, at rest %.2f\n", scene_->name.c_str(), apart, at_rest);
    EXPECT_GT(at_rest, 0.2) << "this pose stretches no skin";
  }

  std::unique_ptr<gpu::Device> device_;
  std::unique_ptr<gpu::PipelineLibrary> library_;
  std::shared_ptr<const scene::AssetData> scene_;
  api::AssetPointer asset_;
  api::SceneOnDevice on_device_;
  setup::PlacedScene placed_;
  bool first_is_seen_ = true;
  api::PosedInstances posed_;
  passes::FrameData data_;
};

TEST_F(MovedOnDevice, SkinsAndMorphsAreThoseOfTheProcessor) {
  open("makehuman/mh-african-man-young.glb");
  if (!scene_) return;
  pose(0, 1.3);
  pose(1, 0.4);
  EXPECT_EQ(frame(), 2u);
  for (const std::size_t instance : {0u, 1u}) expect_as_on_processor(instance, 0.4);
  expect_metric(0);
}

TEST_F(MovedOnDevice, MorphsAreThoseOfTheProcessor) {
  open("ict-facekit/ict-mean-animated.glb");
  if (!scene_) return;
  pose(0, 1.0);
  EXPECT_EQ(frame(), 1u);
  expect_as_on_processor(0, 0.4);
  expect_metric(0);
}

TEST_F(MovedOnDevice, OnlyWhatMovesIsMoved) {
  open("makehuman/mh-african-man-young.glb");
  if (!scene_) return;
  pose(0, 0.5);
  EXPECT_EQ(frame(), 1u) << "the other is as it was loaded, and has no vertices of its own";
  EXPECT_EQ(data_.heads[1].posed, nullptr);
  EXPECT_TRUE(data_.heads[0].moves);
  const std::vector<io::VertexIo> first = vertices(0, 0);

  EXPECT_EQ(frame(), 0u) << "nothing has moved";
  EXPECT_FALSE(data_.heads[0].moves);
  ASSERT_NE(data_.heads[0].posed, nullptr);

  // The positions of the frame before are kept.
  pose(0, 1.2);
  EXPECT_EQ(frame(), 1u);
  const auto before = values_of<glm::vec3>(*device_, data_.heads[0].posed->before_m[0]);
  ASSERT_EQ(before.size(), first.size());
  double moved_m = 0;
  const std::vector<io::VertexIo> second = vertices(0, 0);
  for (std::size_t v = 0; v < first.size(); ++v) {
    EXPECT_EQ(before[v], first[v].position_m);
    moved_m = std::max(moved_m, double{glm::distance(before[v], second[v].position_m)});
  }
  EXPECT_GT(moved_m, 1e-3);

  // What is not seen waits until it is.
  pose(0, 0.1);
  first_is_seen_ = false;
  EXPECT_EQ(frame(), 0u);
  first_is_seen_ = true;
  EXPECT_EQ(frame(), 1u);

  // A frame that was not drawn, or another set of instances: all move again.
  posed_.move_all();
  EXPECT_EQ(frame(), 1u);
  pose(1, 0.3);
  EXPECT_EQ(frame(), 2u);
  placed_.instances[0].posed = nullptr;
  EXPECT_EQ(frame(), 1u);
  EXPECT_EQ(data_.heads[0].posed, nullptr);
}

}  // namespace
}  // namespace dermis::tests
