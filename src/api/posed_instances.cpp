// SPDX-License-Identifier: MIT
#include "api/posed_instances.h"

#include <algorithm>
#include <span>
#include <utility>

#include "gpu/device.h"
#include "image/colour.h"
#include "setup/turned_sky.h"

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

// A map that a shader writes, where nothing is known yet: no light, nothing occluded.
gpu::Texture written_map(gpu::Device& device, const std::string& name, std::uint32_t side) {
  gpu::Texture map(device, name,
                   {.width = side,
                    .height = side,
                    .format = VK_FORMAT_R16G16B16A16_SFLOAT,
                    .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT});
  std::vector<std::uint16_t> halves(std::size_t{side} * side * 4, 0);
  for (std::size_t i = 3; i < halves.size(); i += 4) halves[i] = image::float_to_half(1);
  gpu::upload(device, map, std::as_bytes(std::span(halves)));
  return map;
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

void PosedInstances::make_sky(gpu::Device& device, Posed& posed) {
  if (!posed.shape.sky.empty()) return;
  const setup::Subject& subject = posed.asset->subject;
  passes::GpuScene& scene = *posed.asset->gpu;
  for (std::size_t i = 0; i < subject.skin.size(); ++i) {
    passes::GpuRig::Skin& skin = scene.rig->skin[i];
    if (skin.sky_texels) continue;
    const setup::SkyTexels texels = setup::sky_texels(subject.skin[i], posed.asset->bent_normal[i]);
    skin.sky_texels =
        gpu::make_buffer(device, scene.skin[i].name + " sky", std::span<const std::uint32_t>(texels.rows),
                         VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    skin.sky_texel_count = texels.count;
  }

  std::vector<passes::PosedShape::Sky> made;
  for (std::size_t i = 0; i < subject.skin.size(); ++i) {
    const auto side = static_cast<std::uint32_t>(posed.asset->bent_normal[i].side);
    const std::string& name = scene.skin[i].name;
    made.push_back({.direct = written_map(device, name + " sky posed", side),
                    .bounced = written_map(device, name + " sky posed, bounced", side),
                    .bent_normal = written_map(device, name + " bent normal posed", side),
                    .turns = {device, name + " turns",
                              gpu::BufferDesc{.bytes = subject.skin[i].vertices.size() * sizeof(glm::vec4),
                                              .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT}}});
  }
  posed.shape.sky = std::move(made);
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
    instances[i] = {
        .posed = kept[ids[i]], .pose = instance.posed, .change = instance.posed_change, .sky = scene.sky(i)};
    if (instances[i].sky)
      make_sky(library.device(), *instances[i].posed);
    else
      instances[i].posed->lit_by.reset();
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
  for (const auto& [id, posed] : posed_) posed->moved = posed->lit = 0;
}

void PosedInstances::add_move(gpu::FrameMemory& memory, const Current& current, passes::FrameData& data) {
  std::vector<glm::mat4x3> matrices;
  for (const glm::dmat4& matrix : current.pose->rig.matrices) matrices.emplace_back(glm::dmat4x3(matrix));
  const std::vector<float> weights(current.pose->rig.weights.begin(), current.pose->rig.weights.end());
  data.moves.push_back({.shape = &current.posed->shape,
                        .scene = &*current.posed->asset->gpu,
                        .matrices = memory.add(std::span<const glm::mat4x3>(matrices)),
                        .weights = memory.add(std::span<const float>(weights))});
  current.posed->moved = current.change;
}

void PosedInstances::add_sky_turn(gpu::FrameMemory& memory, const Current& current, passes::FrameData& data) {
  Posed& posed = *current.posed;
  if (!current.sky || (posed.lit == current.change && posed.lit_by == current.sky)) return;
  const io::SkyHarmonicsIo sky = setup::sky_harmonics_io(current.sky->sky.sky, current.sky->sky.bouncing_sky);
  data.sky_turns.push_back({.shape = &posed.shape,
                            .scene = &*posed.asset->gpu,
                            .sky = memory.add(std::span<const io::SkyHarmonicsIo>(&sky, 1))});
  posed.lit = current.change;
  posed.lit_by = current.sky;
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
  std::vector<bool> seen(instances_.size(), false), moves(instances_.size(), false);
  for (const setup::HeadSetup& head : setup.heads)
    if (head.visible) seen[head.instance] = true;

  for (std::size_t i = 0; i < instances_.size(); ++i) {
    const Current& current = instances_[i];
    if (!current.posed || !seen[i]) continue;
    moves[i] = current.posed->moved != current.change;
    if (moves[i]) add_move(memory, current, data);
    add_sky_turn(memory, current, data);
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
