// SPDX-License-Identifier: MIT
#include <algorithm>

#include "frame/resources.h"
#include "passes/draw_skin.h"
#include "passes/final_pass/final_pass.h"
#include "passes/targets.h"

namespace dermis::passes {

UnshadedReads::Out UnshadedReads::declare(frame::Declare& d) {
  d.kind(frame::PassKind::raster);
  d.runs(frame::Runs::for_statistics);
  for (const frame::TextureId light : in.lights) d.sample(light);
  d.depth(in.depth);
  d.write(in.counters);
  return {};
}

void UnshadedReads::prepare(gpu::PipelineLibrary& library) {
  for (const bool double_sided : {false, true})
    for (const bool cut_out : {false, true})
      if (!cut_out || settings.cut_out)
        pipelines_[double_sided][cut_out] =
            &library.graphics({.vertex = "final_pass.vert",
                               .fragment = "unshaded_reads.frag",
                               .constants = {{"cut_out", cut_out ? 1u : 0u},
                                             {"mixed", settings.mixes ? 1u : 0u},
                                             {"shape_aware", settings.terms.shape ? 1u : 0u}},
                               .depth_format = depth_format,
                               .samples = settings.samples,
                               .cull = double_sided ? gpu::Cull::none : gpu::Cull::back,
                               .depth_test = true});
  terms_ = make_terms(library.device(), settings.terms);
}

// Returns the first map that the head reads.
frame::TextureId UnshadedReads::first_read(const FrameData& frame, const MapSquare& square) const {
  return in.lights[terms_of(frame, square).first_read];
}

bool UnshadedReads::reads(const FrameData& frame, const MapSquare& square) const {
  return instance_of(frame, square).visible && terms_of(frame, square).any;
}

bool UnshadedReads::draws(const FrameData& frame) const {
  return std::ranges::any_of(settings.squares, [&](const MapSquare& square) { return reads(frame, square); });
}

void UnshadedReads::begin(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData&, bool) const {
  const gpu::Texture& depth = resources.texture(in.depth);
  cmd.begin_rendering({}, gpu::DepthTarget{.texture = &depth}, {depth.desc().width, depth.desc().height});
}

void UnshadedReads::draw_square(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame,
                                const MapSquare& read) const {
  const Instance& instance = instance_of(frame, read);
  const UsedSquare square = used_square(frame, read);
  const std::uint32_t mesh = mesh_in_asset(frame, square);
  Bindings bindings;
  bindings.add("Frame", frame.frame_io)
      .add("light_0", resources.nearest(first_read(frame, read)))
      .add("Terms", terms_)
      .add("Counters", resources.buffer(in.counters));
  const io::FinalPassIo io{.weights = {},
                           .map_origin = square.origin,
                           .map_side = square.side,
                           .slot = settings.slot,
                           .through_rays = 0};

  draw_skin(
      cmd, instance, mesh, bindings,
      [&](const GpuDraw& draw, const GpuMaterial& material) {
        return draw.on_map ? pipelines_[material.double_sided][material.cut_out] : nullptr;
      },
      [&](const GpuMaterial&) { return io; }, first_corners(instance, mesh));
}

void UnshadedReads::draw(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  for (const MapSquare& square : settings.squares)
    if (reads(frame, square)) draw_square(cmd, resources, frame, square);
}

}  // namespace dermis::passes
