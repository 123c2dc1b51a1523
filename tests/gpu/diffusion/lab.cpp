// SPDX-License-Identifier: MIT
#include "lab.h"

#include <gtest/gtest.h>

#include <cstring>

#include "dermis/error.h"
#include "frame/executor.h"
#include "gpu/device.h"
#include "head/scene/surface/unwrap.h"
#include "image/colour.h"
#include "render/passes/asset/offer.h"
#include "render/passes/bindings.h"
#include "render/passes/clear_buffers.h"
#include "render/passes/frame_data.h"
#include "render/passes/light_map/gutters/gutters.h"
#include "render/passes/light_map/light_pool.h"
#include "render/passes/light_map/stretch/stretch.h"
#include "render/passes/light_map/tiles/tiles.h"
#include "render/passes/pose/move_rig/move_rig.h"
#include "render/passes/scatter/blur/blur.h"
#include "render/passes/shaders.h"
#include "render/shared/tiles_io.h"

namespace dermis::test_diffusion {
std::span<const std::uint32_t> find_shader(std::string_view name);
}

namespace dermis::lab {
namespace {

/// Stands where the irradiance pass stands in the product.
class Paint {
 public:
  struct Settings {
    io::PaintIo io{};
  } settings;
  struct In {
    frame::TextureId light;
  } in;
  struct Out {};

  Out declare(frame::Declare& d) {
    d.kind(frame::PassKind::raster);
    d.colour(in.light);
    return {};
  }

  void prepare(gpu::PipelineLibrary& library) {
    pipeline_ = &library.graphics({.vertex = "paint.vert",
                                   .fragment = "paint.frag",
                                   .colour_formats = {VK_FORMAT_R16G16B16A16_SFLOAT}});
  }

  void record(gpu::Cmd& cmd, const frame::Resources& resources, const passes::FrameData& frame) const {
    const gpu::Texture& target = resources.texture(in.light);
    const gpu::ColourTarget colour{.texture = &target, .clear = std::array{0.0f, 0.0f, 0.0f, 0.0f}};
    cmd.begin_rendering(std::span(&colour, 1), {}, {target.desc().width, target.desc().height}, true);

    passes::Bindings bindings;
    passes::offer_mesh(frame.heads[0], 0, bindings);
    bindings.bind(cmd, *pipeline_);
    cmd.push(*pipeline_, settings.io);
    const passes::GpuMesh& mesh = frame.heads[0].asset->skin[0];
    for (const passes::GpuDraw& draw : mesh.draws)
      cmd.draw_indexed({&mesh.indices}, draw.index_count, draw.first_index);
    cmd.end_rendering();
  }

 private:
  const gpu::Pipeline* pipeline_ = nullptr;
};

/// Marks all tiles of a map as seen.
class SeeAllTiles {
 public:
  struct Settings {
  } settings;
  struct In {
    passes::TileLists lists;
  } in;
  struct Out {};

  Out declare(frame::Declare& d) {
    d.kind(frame::PassKind::copy);
    d.copy_to(in.lists.marks);
    return {};
  }
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const passes::FrameData&) const {
    cmd.fill(resources.buffer(in.lists.marks), TILE_SEEN);
  }
};

std::span<const std::uint32_t> find_any(std::string_view name) {
  const auto found = passes::find_shader(name);
  return found.empty() ? test_diffusion::find_shader(name) : found;
}

struct Bench {
  gpu::Device device{gpu::Device::Options{.validate = false}};
  gpu::PipelineLibrary library{device, find_any};
};

Bench* bench() {
  static const std::unique_ptr<Bench> instance = []() -> std::unique_ptr<Bench> {
    try {
      return std::make_unique<Bench>();
    } catch (const DeviceError&) { return nullptr; }
  }();
  return instance.get();
}

Map read(const frame::GraphExecutor& executor, frame::TextureId id) {
  const gpu::Texture& texture = executor.resources().texture(id);
  const std::vector<std::byte> bytes =
      gpu::read_back(executor.device(), texture, frame::final_layout(executor.graph(), id, {}));
  Map map{static_cast<int>(texture.desc().width), std::vector<float>(bytes.size() / 2)};
  for (std::size_t i = 0; i < map.rgba.size(); ++i) {
    std::uint16_t half = 0;
    std::memcpy(&half, bytes.data() + 2 * i, 2);
    map.rgba[i] = image::half_to_float(half);
  }
  return map;
}

// What moves the one skin mesh of a scene, and its moved vertices.
struct Moved {
  Moved(gpu::Device& device, passes::GpuAsset& scene, const scene::PosedRig& pose) {
    const auto copied = [&](std::vector<gpu::Buffer>& to, const gpu::Buffer& from) {
      to.push_back(
          {device, "posed", gpu::BufferDesc{.bytes = from.desc().bytes, .usage = from.desc().usage}});
      device.run([&](VkCommandBuffer commands) {
        gpu::Cmd(device, commands).copy(from, to.back(), from.desc().bytes);
      });
    };
    copied(shape.vertices, scene.skin[0].vertices);
    copied(shape.before_m, scene.skin[0].vertices);  // larger than it must be
    copied(shape.skin_vertices, scene.skin[0].skin_vertices);
    std::vector<glm::mat4x3> m;
    for (const glm::dmat4& matrix : pose.matrices) m.emplace_back(glm::dmat4x3(matrix));
    const std::vector<float> w(pose.weights.begin(), pose.weights.end());
    matrices = gpu::make_buffer(device, "matrices", std::span<const glm::mat4x3>(m),
                                VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    weights =
        gpu::make_buffer(device, "weights", std::span<const float>(w), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    move = {.shape = &shape, .asset = &scene, .matrices = {&matrices}, .weights = {&weights}};
  }

  passes::PosedShape shape;
  gpu::Buffer matrices, weights;
  passes::RigMove move;
};

using passes::Gutters;

ScatterProfile profile_of(const Experiment& e) {
  ScatterProfile profile;
  for (const double v : e.variances_mm2) profile.terms.push_back({.variance_mm2 = v, .weight = {}});
  return profile;
}

passes::Head head_of(const passes::GpuAsset& asset, const passes::GpuLook& look, std::uint32_t side) {
  passes::Head head;
  head.asset = &asset;
  head.look = &look;
  head.detail.side = side;
  return head;
}

// Adds the blurs of an experiment; their maps are read back.
class Blurs {
 public:
  struct Maps {
    frame::TextureId stretch, painted, scratch, narrower;
  };
  Blurs(passes::FramePlan& plan, const Maps& maps, const passes::TileLists& tiles,
        const std::vector<passes::MapSquare>& whole, const gpu::TextureDesc& desc)
      : plan_(&plan), maps_(maps), tiles_(tiles), whole_(whole), desc_(desc) {}

  // Both of two, as their first axis shares the reads.
  std::vector<frame::TextureId> from_light(const Experiment& e) const {
    const double narrow_mm2 = e.variances_mm2[0], wide_mm2 = e.variances_mm2[1];
    plan_->add<passes::Blur>("u",
                             {.light = maps_.painted,
                              .stretch = maps_.stretch,
                              .target = maps_.scratch,
                              .lists = tiles_,
                              .narrower = maps_.narrower},
                             {.squares = whole_,
                              .variance_mm2 = wide_mm2,
                              .texel_averaged = true,
                              .narrower = passes::ChainStep{.number = 0, .total_mm2 = narrow_mm2}});
    return {along_v(maps_.narrower, narrow_mm2, true), along_v(maps_.scratch, wide_mm2, true)};
  }

  // Each from the one before.
  std::vector<frame::TextureId> in_turn(const Experiment& e, double density) const {
    std::vector<frame::TextureId> levels;
    frame::TextureId light = maps_.painted;
    for (const passes::BlurStep& step : passes::blur_steps(e.variances_mm2, density)) {
      const bool first = light == maps_.painted;
      const double v = step.variance_mm2 * e.variance_factor;
      plan_->add<passes::Blur>("u", {light, maps_.stretch, maps_.scratch, tiles_},
                               {.squares = whole_, .variance_mm2 = v, .axis = 0, .texel_averaged = first});
      light = along_v(maps_.scratch, v, first);
      if (step.ends_term) levels.push_back(light);
    }
    return levels;
  }

 private:
  frame::TextureId along_v(frame::TextureId from, double variance_mm2, bool texel_averaged) const {
    const frame::TextureId target = plan_->texture("level", desc_);
    plan_->add<passes::Blur>(
        "v", {from, maps_.stretch, target, tiles_},
        {.squares = whole_, .variance_mm2 = variance_mm2, .axis = 1, .texel_averaged = texel_averaged});
    plan_->add<Gutters>("gutters", {target}, {.squares = whole_});
    plan_->read_back(target);
    return target;
  }

  passes::FramePlan* plan_;
  Maps maps_;
  passes::TileLists tiles_;
  std::vector<passes::MapSquare> whole_;
  gpu::TextureDesc desc_;
};

}  // namespace

bool available() { return bench() != nullptr; }

Result run(const Experiment& e) {
  scene::AssetData asset = e.scene;
  asset.skin = scene::skin_meshes(asset);
  scene::SkinMesh& skin = asset.skin[0];
  const double density = scene::unwrap_density(skin, asset.mm_per_unit).largest_uv_per_mm.p95 * e.map_size;
  if (e.drop_shear)
    for (glm::vec3& g : skin.metric) g.y = 0;

  const ScatterProfile profile = profile_of(e);
  passes::GpuAsset gpu_asset(bench()->library, asset);
  const passes::GpuLook look = gpu_asset.make_look(bench()->device, {});
  if (e.gutters)
    gpu_asset.make_gutters(bench()->device, 0, skin, static_cast<std::uint32_t>(e.map_size),
                           passes::gutter_width(profile, density));

  passes::FramePlan plan;
  const auto side = static_cast<std::uint32_t>(e.map_size);
  const gpu::TextureDesc desc{.width = side, .height = side, .format = VK_FORMAT_R16G16B16A16_SFLOAT};
  const std::vector<passes::MapSquare> whole(1);
  if (e.pose) plan.add<passes::MoveRig>("pose", {}, {});
  const frame::TextureId stretch = plan.texture("stretch", desc, frame::Lifetime::persistent),
                         painted = plan.texture("painted", desc), scratch = plan.texture("scratch", desc),
                         narrower = plan.texture("narrower scratch", desc);
  plan.add<passes::Stretch>("stretch", {stretch}, {});
  plan.add<Gutters>("stretch gutters", {stretch}, {.squares = whole, .what = Gutters::What::stretch});
  plan.add<Paint>("paint", {painted}, {e.paint});
  plan.add<Gutters>("paint gutters", {painted}, {.squares = whole});
  plan.read_back(painted);

  const passes::TileLists tiles = passes::make_tile_lists(plan, 1, side, 1);
  const frame::BufferId counters = plan.buffer("counters", {.bytes = sizeof(std::uint32_t)});
  plan.add<passes::ClearBuffers>("clear tiles", {{tiles.counts, tiles.arguments}});
  plan.add<SeeAllTiles>("see all tiles", {tiles});
  plan.add<passes::Tiles>("tiles", {tiles, counters, {scratch, narrower}}, {.squares = whole});

  const Blurs blurs{plan, {stretch, painted, scratch, narrower}, tiles, whole, desc};
  const std::vector<frame::TextureId> levels = e.from_light ? blurs.from_light(e) : blurs.in_turn(e, density);

  passes::FrameData data;
  data.heads = {head_of(gpu_asset, look, side)};
  std::optional<Moved> moved;
  if (e.pose) {
    gpu_asset.make_rig(bench()->device, asset);
    moved.emplace(bench()->device, gpu_asset, *e.pose);
    data.heads[0].posed = &moved->shape;
    if (!e.keep_metric) data.moves = {moved->move};
  }

  frame::Executor executor(bench()->library, plan);
  executor.draw(data, frame::whole_frame);
  Result result{.painted = read(executor, painted), .levels = {}};
  for (const frame::TextureId id : levels) result.levels.push_back(read(executor, id));
  return result;
}

}  // namespace dermis::lab
