// SPDX-License-Identifier: MIT
#include "api/posed_instances.h"

#include <algorithm>
#include <span>
#include <utility>

#include "environment/body_shape.h"
#include "gpu/device.h"
#include "image/colour.h"
#include "render/setup/turned_sky.h"

namespace dermis::api {
namespace {

gpu::Buffer like(gpu::Device& device, const gpu::Buffer& of_asset, const char* what) {
  return {device, of_asset.name() + what,
          gpu::BufferDesc{.bytes = of_asset.desc().bytes, .usage = of_asset.desc().usage}};
}

gpu::Buffer positions(gpu::Device& device, const gpu::Buffer& vertices) {
  return {device, vertices.name() + " before",
          gpu::BufferDesc{.bytes = vertices.desc().bytes / sizeof(io::VertexIo) * sizeof(glm::vec3),
                          .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT}};
}

// A map that a shader writes, where nothing is known yet: no light, nothing occluded.
gpu::Texture written_map(gpu::Device& device, const std::string& name, std::uint32_t side,
                         std::uint32_t layers = 1) {
  gpu::Texture map(device, name,
                   {.width = side,
                    .height = side,
                    .layers = layers,
                    .format = VK_FORMAT_R16G16B16A16_SFLOAT,
                    .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT});
  std::vector<std::uint16_t> halves(std::size_t{side} * side * layers * 4, 0);
  for (std::size_t i = 3; i < halves.size(); i += 4) halves[i] = image::float_to_half(1);
  gpu::upload(device, map, std::as_bytes(std::span(halves)));
  return map;
}

}  // namespace

std::shared_ptr<PosedInstances::Posed> PosedInstances::make(gpu::Device& device, const AssetPointer& asset) {
  passes::GpuAsset& on_device = *asset->gpu;
  on_device.make_rig(device, *asset->data);
  auto posed = std::make_shared<Posed>();
  posed->asset = asset;
  posed->has_shape = asset->has_shape;
  for (std::size_t i = 0; asset->has_shape && i < on_device.skin.size(); ++i)
    on_device.make_rig_curvature(device, i, asset->data->skin[i], environment::curvature_scales);

  std::vector<std::pair<const gpu::Buffer*, const gpu::Buffer*>> copies;
  passes::PosedShape& shape = posed->shape;
  shape.vertices.reserve(on_device.skin.size() + on_device.surfaces.pages.size());
  shape.skin_vertices.reserve(on_device.skin.size());
  const auto add = [&](std::vector<gpu::Buffer>& to, const gpu::Buffer& from, const char* what) {
    to.push_back(like(device, from, what));
    copies.emplace_back(&from, &to.back());
  };
  for (const passes::GpuMesh& mesh : on_device.skin) {
    add(shape.vertices, mesh.vertices, " posed");
    add(shape.skin_vertices, mesh.skin_vertices, " posed");
  }
  for (const passes::GpuSurfaces::Page& page : on_device.surfaces.pages)
    add(shape.vertices, page.vertices, " posed");
  for (const gpu::Buffer& vertices : shape.vertices) shape.before_m.push_back(positions(device, vertices));

  device.run([&](VkCommandBuffer commands) {
    gpu::Cmd cmd(device, commands);
    for (const auto& [from, to] : copies) cmd.copy(*from, *to, from->desc().bytes);
    cmd.barrier_all();
  });
  return posed;
}

void PosedInstances::make_sky(gpu::Device& device, Posed& posed) {
  if (!posed.shape.sky.empty()) return;
  const scene::AssetData& data = *posed.asset->data;
  passes::GpuAsset& on_device = *posed.asset->gpu;
  for (std::size_t i = 0; i < data.skin.size(); ++i) {
    passes::GpuRig::Skin& skin = on_device.rig->skin[i];
    if (skin.sky_texels) continue;
    const setup::SkyTexels texels = setup::sky_texels(data.skin[i], posed.asset->bent_normal[i]);
    skin.sky_texels =
        gpu::make_buffer(device, on_device.skin[i].name + " sky", std::span<const std::uint32_t>(texels.rows),
                         VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    skin.sky_texel_count = texels.count;
  }

  std::vector<passes::PosedShape::Sky> made;
  for (std::size_t i = 0; i < data.skin.size(); ++i) {
    const auto side = static_cast<std::uint32_t>(posed.asset->bent_normal[i].side);
    const std::string& name = on_device.skin[i].name;
    made.push_back({.light = written_map(device, name + " sky posed", side, 2),
                    .bent_normal = written_map(device, name + " bent normal posed", side),
                    .turns = {device, name + " turns",
                              gpu::BufferDesc{.bytes = data.skin[i].vertices.size() * sizeof(glm::vec4),
                                              .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT}}});
  }
  posed.shape.sky = std::move(made);
}

void PosedInstances::keep(gpu::PipelineLibrary& library, const SceneOnDevice& scene,
                          const std::vector<InstanceId>& ids, const setup::PlacedScene& placed,
                          bool recorded) {
  std::map<InstanceId, std::shared_ptr<Posed>> kept;
  std::vector<Current> instances(placed.instances.size());
  for (std::size_t i = 0; i < placed.instances.size(); ++i) {
    const setup::PlacedInstance& instance = placed.instances[i];
    if (!instance.posed) continue;
    const auto before = posed_.find(ids[i]);
    const bool known = before != posed_.end() && before->second->asset == scene.asset(i) &&
                       before->second->has_shape == scene.asset(i)->has_shape;
    kept[ids[i]] = known ? before->second : make(library.device(), scene.asset(i));
    instances[i] = {.posed = kept[ids[i]],
                    .pose = instance.posed,
                    .change = instance.posed_change,
                    .visible = instance.visible,
                    .sky = scene.sky(i)};
    if (recorded) make_recorded(library.device(), instances[i]);
    if (instances[i].sky)
      make_sky(library.device(), *instances[i].posed);
    else
      instances[i].posed->lit_by.reset();
  }

  const bool lit = std::any_of(instances.begin(), instances.end(),
                               [](const Current& current) { return current.sky != nullptr; });
  if (recorded && !kept.empty() && !move_prepared_) {
    move_.prepare(library);
    move_prepared_ = true;
  }
  if (recorded && lit && !turn_prepared_) {
    turn_.prepare(library);
    turn_prepared_ = true;
  }
  recorded_ = recorded;

  // Stretch maps belong to the instances in their order.
  const bool same =
      std::equal(kept.begin(), kept.end(), posed_.begin(), posed_.end(),
                 [](const auto& a, const auto& b) { return a.first == b.first && a.second == b.second; });
  posed_ = std::move(kept);
  instances_ = std::move(instances);
  if (!same) move_all();
}

void PosedInstances::move_all() {
  for (const auto& [id, posed] : posed_) posed->moved = posed->lit = posed->shown = 0;
}

namespace {

std::vector<glm::mat4x3> matrices_of(const setup::PosedAsset& pose) {
  std::vector<glm::mat4x3> matrices;
  for (const glm::dmat4& matrix : pose.rig.matrices) matrices.emplace_back(glm::dmat4x3(matrix));
  return matrices;
}

std::vector<float> weights_of(const setup::PosedAsset& pose) {
  return {pose.rig.weights.begin(), pose.rig.weights.end()};
}

io::SkyHarmonicsIo harmonics_of(const SharedSky& sky) {
  return setup::sky_harmonics_io(sky.sky.sky, sky.sky.bouncing_sky);
}

bool has_copies(const std::vector<passes::GpuSurfaces::Page>& pages) {
  return std::any_of(pages.begin(), pages.end(),
                     [](const passes::GpuSurfaces::Page& page) { return !page.copies.empty(); });
}

}  // namespace

bool PosedInstances::is_lit(const Current& current) {
  const Posed& posed = *current.posed;
  return !current.sky || (posed.lit == current.change && posed.lit_by == current.sky);
}

void PosedInstances::add_move(gpu::FrameMemory& memory, const Current& current, passes::FrameData& data) {
  data.moves.push_back({.shape = &current.posed->shape,
                        .asset = &*current.posed->asset->gpu,
                        .matrices = memory.add(std::span<const glm::mat4x3>(matrices_of(*current.pose))),
                        .weights = memory.add(std::span<const float>(weights_of(*current.pose)))});
  current.posed->moved = current.change;
}

void PosedInstances::add_sky_turn(gpu::FrameMemory& memory, const Current& current, passes::FrameData& data) {
  const io::SkyHarmonicsIo sky = harmonics_of(*current.sky);
  data.sky_turns.push_back({.shape = &current.posed->shape,
                            .asset = &*current.posed->asset->gpu,
                            .sky = memory.add(std::span<const io::SkyHarmonicsIo>(&sky, 1))});
  current.posed->lit = current.change;
  current.posed->lit_by = current.sky;
}

void PosedInstances::make_recorded(gpu::Device& device, const Current& current) {
  Posed& posed = *current.posed;
  if (posed.matrices) return;
  const passes::GpuAsset& on_device = *posed.asset->gpu;
  const auto make = [&](const char* what, std::size_t bytes) {
    return gpu::Buffer(device, what,
                       {.bytes = std::max<std::size_t>(bytes, 4),
                        .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT});
  };
  posed.weights = make("weights of a pose", current.pose->rig.weights.size() * sizeof(float));
  posed.sky = make("sky over a pose", sizeof(io::SkyHarmonicsIo));
  posed.placements.clear();
  if (has_copies(on_device.surfaces.pages))
    for (const passes::GpuSurfaces::Page& page : on_device.surfaces.pages)
      posed.placements.push_back(
          make("placements of a pose", (page.copies.size() + 1) * sizeof(io::PlacementIo)));
  posed.matrices = make("matrices of a pose", current.pose->rig.matrices.size() * sizeof(glm::mat4x3));
}

passes::RigMove PosedInstances::recorded_move(gpu::Cmd& cmd, const Current& current) {
  Posed& posed = *current.posed;
  const std::vector<glm::mat4x3> matrices = matrices_of(*current.pose);
  const std::vector<float> weights = weights_of(*current.pose);
  cmd.update(posed.matrices, std::as_bytes(std::span(matrices)));
  cmd.update(posed.weights, std::as_bytes(std::span(weights)));
  for (std::size_t p = 0; p < posed.placements.size(); ++p) {
    const std::vector<io::PlacementIo> placements =
        passes::posed_placements(posed.asset->gpu->surfaces.pages[p], *posed.asset->data, current.pose->rig);
    cmd.update(posed.placements[p], std::as_bytes(std::span(placements)));
  }
  posed.moved = current.change;
  return {.shape = &posed.shape,
          .asset = &*posed.asset->gpu,
          .matrices = {&posed.matrices},
          .weights = {&posed.weights}};
}

passes::SkyTurn PosedInstances::recorded_turn(gpu::Cmd& cmd, const Current& current) {
  Posed& posed = *current.posed;
  const io::SkyHarmonicsIo sky = harmonics_of(*current.sky);
  cmd.update(posed.sky, std::as_bytes(std::span(&sky, 1)));
  posed.lit = current.change;
  posed.lit_by = current.sky;
  return {.shape = &posed.shape, .asset = &*posed.asset->gpu, .sky = {&posed.sky}};
}

void PosedInstances::record(gpu::Cmd& cmd) {
  const auto is_pending = [](const Current& current) {
    return current.posed && current.visible && (current.posed->moved != current.change || !is_lit(current));
  };
  if (std::none_of(instances_.begin(), instances_.end(), is_pending)) return;

  // Readers of the buffers in the frame before are waited for.
  cmd.barrier_all();
  passes::FrameData data;
  for (const Current& current : instances_) {
    if (!is_pending(current)) continue;
    if (current.posed->moved != current.change) data.moves.push_back(recorded_move(cmd, current));
    if (!is_lit(current)) data.sky_turns.push_back(recorded_turn(cmd, current));
  }
  cmd.barrier_all();
  move_.record(cmd, frame::Resources(), data);
  turn_.record(cmd, frame::Resources(), data);
  cmd.barrier_all();
}

const passes::PosedShape* PosedInstances::shape(std::size_t instance) const {
  const Current& current = instances_[instance];
  return current.posed ? &current.posed->shape : nullptr;
}

std::vector<gpu::BufferBinding> PosedInstances::placements(std::size_t instance) const {
  std::vector<gpu::BufferBinding> bindings;
  if (const std::shared_ptr<Posed>& posed = instances_[instance].posed)
    for (const gpu::Buffer& placements : posed->placements) bindings.push_back({&placements});
  return bindings;
}

void PosedInstances::add_placements(gpu::FrameMemory& memory, const Current& current, passes::Head& head) {
  const std::vector<passes::GpuSurfaces::Page>& pages = head.asset->surfaces.pages;
  for (std::size_t p = 0; has_copies(pages) && p < pages.size(); ++p)
    head.placements.push_back(memory.add(std::span<const io::PlacementIo>(
        passes::posed_placements(pages[p], *current.posed->asset->data, current.pose->rig))));
}

void PosedInstances::fill(gpu::FrameMemory& memory, passes::FrameData& data, bool measured) {
  // Instances that are not seen are moved when they are.
  std::vector<bool> seen(instances_.size(), false), moves(instances_.size(), false);
  for (const passes::Head& head : data.heads)
    if (head.visible) seen[head.instance] = true;

  for (std::size_t i = 0; i < instances_.size(); ++i) {
    const Current& current = instances_[i];
    if (!current.posed || !seen[i]) continue;
    moves[i] = current.posed->shown != current.change;
    if (!measured) current.posed->shown = current.change;
    if (recorded_) continue;
    if (current.posed->moved != current.change) add_move(memory, current, data);
    if (!is_lit(current)) add_sky_turn(memory, current, data);
  }

  for (passes::Head& head : data.heads) {
    const Current& current = instances_[head.instance];
    if (!current.posed) continue;
    head.posed = &current.posed->shape;
    head.moves = moves[head.instance];
    add_placements(memory, current, head);
  }
}

}  // namespace dermis::api
