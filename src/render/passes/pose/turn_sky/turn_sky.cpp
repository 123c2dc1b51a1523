// SPDX-License-Identifier: MIT
#include "render/passes/pose/turn_sky/turn_sky.h"

#include <algorithm>
#include <vector>

#include "render/passes/bindings.h"
#include "render/passes/pose/turn_sky/turn_sky_io.h"

namespace dermis::passes {
namespace {

// Changes the layout of all maps that the frame writes. The maps are none of the plan's: what reads them in
// the frame before and in this one waits here.
void change_layout(gpu::Cmd& cmd, const std::vector<SkyTurn>& turns, VkImageLayout from, VkImageLayout to) {
  std::vector<VkImageMemoryBarrier2> barriers;
  for (const SkyTurn& turn : turns)
    for (const PosedShape::Sky& sky : turn.shape->sky)
      for (const gpu::Texture* map : {&sky.light, &sky.bent_normal}) {
        VkImageMemoryBarrier2& barrier = barriers.emplace_back(VkImageMemoryBarrier2{});
        barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
        barrier.srcStageMask = barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
        barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
        barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
        barrier.oldLayout = from;
        barrier.newLayout = to;
        barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
        barrier.image = map->handle();
        barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, map->desc().layers};
      }

  VkDependencyInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
  info.imageMemoryBarrierCount = static_cast<std::uint32_t>(barriers.size());
  info.pImageMemoryBarriers = barriers.data();
  cmd.barrier(info);
}

}  // namespace

TurnSky::Out TurnSky::declare(frame::Declare& d) {
  d.kind(frame::PassKind::compute);
  return {};
}

void TurnSky::prepare(gpu::PipelineLibrary& library) {
  turns_ = &library.compute("skin_turns.comp");
  light_ = &library.compute("turn_sky.comp");
  nearest_ = library.sampler({.filter = gpu::Filter::nearest});
}

void TurnSky::record_turns(gpu::Cmd& cmd, const SkyTurn& turn) const {
  for (std::size_t i = 0; i < turn.shape->sky.size(); ++i) {
    Bindings()
        .add("Vertices", turn.shape->vertices[i])
        .add("RestVertices", turn.asset->skin[i].vertices)
        .add("Turns", turn.shape->sky[i].turns)
        .bind(cmd, *turns_);

    const std::uint32_t vertices = turn.asset->rig->parts[i].count;
    for (std::uint32_t first = 0; first < vertices; first += gpu::most_in_row) {
      const std::uint32_t count = std::min(vertices - first, gpu::most_in_row);
      cmd.push(*turns_, io::TurnSkyIo{.first = first, .count = count});
      cmd.dispatch_over(*turns_, count, 1);
    }
  }
}

void TurnSky::record_light(gpu::Cmd& cmd, const SkyTurn& turn) const {
  for (std::size_t i = 0; i < turn.shape->sky.size(); ++i) {
    const GpuRig::Skin& skin = turn.asset->rig->skin[i];
    if (skin.sky_texel_count == 0) continue;
    const PosedShape::Sky& sky = turn.shape->sky[i];
    Bindings()
        .add("SkyTexels", skin.sky_texels)
        .add("Turns", sky.turns)
        .add("Sky", turn.sky)
        .add("rest_bent_normal", gpu::SampledBinding{&turn.asset->skin[i].bent_normal, nearest_})
        .add("sky_light", gpu::StorageImageBinding{&sky.light})
        .add("bent_normal", gpu::StorageImageBinding{&sky.bent_normal})
        .bind(cmd, *light_);
    // At most 512 x 512 texels: environment::occlusion_side().
    DERMIS_ASSERT_LE(skin.sky_texel_count, gpu::most_in_row);
    cmd.push(*light_, io::TurnSkyIo{.first = 0, .count = skin.sky_texel_count});
    cmd.dispatch_over(*light_, skin.sky_texel_count, 1);
  }
}

void TurnSky::record(gpu::Cmd& cmd, const frame::Resources&, const FrameData& frame) const {
  if (frame.sky_turns.empty()) return;
  change_layout(cmd, frame.sky_turns, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, VK_IMAGE_LAYOUT_GENERAL);
  cmd.barrier_all();
  for (const SkyTurn& turn : frame.sky_turns) record_turns(cmd, turn);
  cmd.barrier_all();
  for (const SkyTurn& turn : frame.sky_turns) record_light(cmd, turn);
  change_layout(cmd, frame.sky_turns, VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
}

}  // namespace dermis::passes
