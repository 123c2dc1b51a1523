// SPDX-License-Identifier: MIT
#include "render/passes/pixels/ids/ids.h"

#include "frame/resources.h"
#include "render/passes/draw_skin.h"
#include "render/passes/pixels/ids/ids_io.h"
#include "render/passes/targets.h"

namespace dermis::passes {
namespace {

constexpr VkFormat id_format = VK_FORMAT_R8G8B8A8_UNORM;

}  // namespace

Ids::Out Ids::declare(frame::Declare& d) {
  d.kind(frame::PassKind::raster);
  gpu::TextureDesc desc = d.desc(in.depth);
  desc.format = id_format;
  out_.ids = d.create("ids", desc);
  d.colour(out_.ids);
  d.depth(in.depth);
  for (const frame::BufferId buffer : in.buffers) d.copy_to(buffer);
  return out_;
}

void Ids::prepare(gpu::PipelineLibrary& library) {
  for (const bool double_sided : {false, true})
    for (const bool cut_out : {false, true}) {
      if (cut_out && !settings.cut_out) continue;
      gpu::GraphicsDesc desc{
          .vertex = "ids.vert",
          .fragment = cut_out ? "ids_cut_out.frag" : "ids.frag",
          .colour_formats = {id_format},
          .depth_format = depth_format,
          .samples = settings.samples,
          .cull = double_sided ? gpu::Cull::none : gpu::Cull::back,
          .depth_test = true,
          .depth_write = true,
          .depth_compare = PictureFormat{.reversed_depth = settings.reversed_depth}.nearer()};
      if (cut_out) desc.constants = {{"cut_out", 1u}};
      pipelines_[double_sided][cut_out] = &library.graphics(desc);
    }
}

void Ids::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  for (const frame::BufferId buffer : in.buffers) cmd.fill(resources.buffer(buffer), 0);
  const gpu::ColourTarget ids{.texture = &resources.texture(out_.ids), .clear = no_light};
  const gpu::DepthTarget depth{.texture = &resources.texture(in.depth),
                               .clear = settings.reversed_depth ? 0.0f : 1.0f};
  const VkRect2D all{{0, 0}, {ids.texture->desc().width, ids.texture->desc().height}},
      picture = frame.area.value_or(all), drawn = settings.whole ? picture : frame.with_heads.rectangle();
  if (drawn.extent.width == 0) return;
  cmd.begin_rendering_area(std::span(&ids, 1), depth, drawn);
  cmd.set_viewport(picture, false);
  cmd.set_scissor(drawn);

  for (const SkinParts& mesh : settings.meshes) {
    const Head& head = head_of(frame, mesh.square);
    if (!head.is_drawn()) continue;
    const std::uint32_t number = mesh_in_asset(frame, mesh.square);
    Bindings bindings;
    bindings.add("Frame", frame.frame_io);
    std::uint32_t part = mesh.first_part;
    draw_skin(
        cmd, head, number, bindings,
        [&](const GpuDraw&, const GpuMaterial& m) { return pipelines_[m.double_sided][m.cut_out]; },
        [&](const GpuDraw& draw, const GpuMaterial&) {
          // That of triangle 0 of the mesh, modulo 2^32. Ids of the parts of a draw follow each other.
          const std::uint32_t first = first_id(part) - draw.first_index / 3;
          part += draw.parts();
          return io::IdsIo{.first_id = first};
        },
        first_corners(head, number));
  }
  cmd.end_rendering();
}

}  // namespace dermis::passes
