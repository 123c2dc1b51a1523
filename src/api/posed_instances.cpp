// SPDX-License-Identifier: MIT
#include "api/posed_instances.h"

#include <algorithm>
#include <span>
#include <utility>

#include "gpu/device.h"

namespace dermis::api {
namespace {

gpu::Buffer like(gpu::Device& device, const gpu::Buffer& of_asset, const char* what) {
  return {device, of_asset.name() + what,
          gpu::BufferDesc{.bytes = of_asset.desc().bytes, .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT}};
}

gpu::Buffer positions(gpu::Device& device, const gpu::Buffer& vertices) {
  return {device, vertices.name() + " before",
          gpu::BufferDesc{.bytes = vertices.desc().bytes / sizeof(io::VertexIo) * sizeof(glm::vec3),
                          .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT}};
}

}  // namespace

std::shared_ptr<PosedInstances::Posed> PosedInstances::make(gpu::Device& device, const AssetPointer& asset) {
  passes::GpuScene& scene = *asset->gpu;
  scene.make_rig(device, *asset->subject.scene, asset->subject.skin);
  auto posed = std::make_shared<Posed>();
  posed->asset = asset;

  std::vector<std::pair<const gpu::Buffer*, const gpu::Buffer*>> copies;
  passes::PosedShape& shape = posed->shape;
  shape.vertices.reserve(scene.skin.size() + scene.surfaces.pages.size());
  shape.skin_vertices.reserve(scene.skin.size());
  const auto add = [&](std::vector<gpu::Buffer>& to, const gpu::Buffer& from, const char* what) {
    to.push_back(like(device, from, what));
    copies.emplace_back(&from, &to.back());
  };
  for (const passes::GpuMesh& mesh : scene.skin) {
    add(shape.vertices, mesh.vertices, " posed");
    add(shape.skin_vertices, mesh.skin_vertices, " posed");
  }
  for (const passes::GpuSurfaces::Page& page : scene.surfaces.pages)
    add(shape.vertices, page.vertices, " posed");
  for (const gpu::Buffer& vertices : shape.vertices) shape.before_m.push_back(positions(device, vertices));

  device.run([&](VkCommandBuffer commands) {
    gpu::Cmd cmd(device, commands);
    for (const auto& [from, to] : copies) cmd.copy(*from, *to, from->desc().bytes);
    cmd.barrier_all();
  });
  return posed;
}

void PosedInstances::keep(gpu::PipelineLibrary& library, const SceneOnDevice& scene,
                          const std::vector<InstanceId>& ids, const setup::PlacedScene& placed) {
  std::map<InstanceId, std::shared_ptr<Posed>> kept;
  std::vector<Current> instances(placed.instances.size());
  for (std::size_t i = 0; i < placed.instances.size(); ++i) {
    const setup::PlacedAsset& instance = placed.instances[i];
    if (!instance.posed) continue;
    const auto before = posed_.find(ids[i]);
    const bool known = before != posed_.end() && before->second->asset == scene.asset(i);
    kept[ids[i]] = known ? before->second : make(library.device(), scene.asset(i));
    instances[i] = {.posed = kept[ids[i]], .pose = instance.posed, .change = instance.posed_change};
  }

  // Stretch maps belong to the instances in their order.
  const bool same =
      std::equal(kept.begin(), kept.end(), posed_.begin(), posed_.end(),
                 [](const auto& a, const auto& b) { return a.first == b.first && a.second == b.second; });
  posed_ = std::move(kept);
  instances_ = std::move(instances);
  if (!same) move_all();
}

void PosedInstances::move_all() {
  for (const auto& [id, posed] : posed_) posed->moved = 0;
}

void PosedInstances::add_placements(gpu::FrameMemory& memory, const Current& current,
                                    passes::Instance& instance) {
  const std::vector<passes::GpuSurfaces::Page>& pages = instance.scene->surfaces.pages;
  const bool any = std::any_of(pages.begin(), pages.end(),
                               [](const passes::GpuSurfaces::Page& page) { return !page.copies.empty(); });
  for (std::size_t p = 0; any && p < pages.size(); ++p)
    instance.placements.push_back(memory.add(std::span<const io::PlacementIo>(
        passes::posed_placements(pages[p], *current.posed->asset->subject.scene, current.pose->rig))));
}

void PosedInstances::fill(gpu::FrameMemory& memory, const setup::FrameSetup& setup, passes::FrameData& data) {
  // What is not seen is moved when it is.
  std::vector<bool> moves(instances_.size(), false);
  for (const setup::HeadSetup& head : setup.heads) {
    const Current& current = instances_[head.instance];
    if (current.posed && head.visible && current.posed->moved != current.change) moves[head.instance] = true;
  }

  for (std::size_t i = 0; i < instances_.size(); ++i) {
    if (!moves[i]) continue;
    const Current& current = instances_[i];
    std::vector<glm::mat4x3> matrices;
    for (const glm::dmat4& matrix : current.pose->rig.matrices) matrices.emplace_back(glm::dmat4x3(matrix));
    const std::vector<float> weights(current.pose->rig.weights.begin(), current.pose->rig.weights.end());
    data.moves.push_back({.shape = &current.posed->shape,
                          .scene = &*current.posed->asset->gpu,
                          .matrices = memory.add(std::span<const glm::mat4x3>(matrices)),
                          .weights = memory.add(std::span<const float>(weights))});
    current.posed->moved = current.change;
  }

  for (std::size_t h = 0; h < setup.heads.size(); ++h) {
    const std::size_t number = setup.heads[h].instance;
    const Current& current = instances_[number];
    if (!current.posed) continue;
    data.instances[h].posed = &current.posed->shape;
    data.instances[h].moves = moves[number];
    add_placements(memory, current, data.instances[h]);
  }
}

}  // namespace dermis::api
