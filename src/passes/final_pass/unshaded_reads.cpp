// SPDX-License-Identifier: MIT
#include "frame/resources.h"
#include "passes/final_pass/final_pass.h"
#include "passes/final_pass/final_pass_io.h"

namespace dermis::passes {

UnshadedReads::Out UnshadedReads::declare(frame::Declare& d, const In& in) {
  d.kind(frame::PassKind::raster);
  d.runs(frame::Runs::for_statistics);
  in_ = in;
  d.sample(in.light);
  d.depth(in.depth);
  d.write(in.counters);
  return {};
}

void UnshadedReads::prepare(gpu::PipelineLibrary& library) {
  for (const bool double_sided : {false, true})
    for (const bool cut_out : {false, true})
      if (!cut_out || settings_.cut_out)
        pipelines_[double_sided][cut_out] = &library.graphics(
            {.vertex = "final_pass.vert",
             .fragment = "unshaded_reads.frag",
             .constants = {{"cut_out", cut_out ? 1u : 0u}, {"coarse", settings_.terms.coarse ? 1u : 0u}},
             .depth_format = VK_FORMAT_D32_SFLOAT,
             .samples = settings_.samples,
             .cull = double_sided ? gpu::Cull::none : gpu::Cull::back,
             .depth_test = true});
  terms_ = make_terms(library.device(), settings_.terms);
  sampler_ = library.sampler({.filter = gpu::Filter::nearest});
}

void UnshadedReads::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const Instance& instance = instance_of(frame, settings_.square);
  if (!instance.visible) return;
  const GpuMesh& mesh = frame.scene->skin[settings_.square.mesh];
  const gpu::Texture& depth = resources.texture(in_.depth);
  cmd.begin_rendering({}, gpu::DepthTarget{.texture = &depth}, {depth.desc().width, depth.desc().height});
  for (const GpuDraw& draw : mesh.draws) {
    if (!draw.on_map) continue;

    const GpuMaterial& material = frame.scene->materials[static_cast<std::size_t>(draw.material)];
    const gpu::Pipeline& pipeline = *pipelines_[material.double_sided][material.cut_out];
    Bindings bindings;
    mesh.offer(bindings);
    material.offer(bindings);
    bindings.add("Frame", frame.frame_io)
        .add("light_0", resources.sampled(in_.light, sampler_))
        .add("Terms", terms_)
        .add("Counters", resources.buffer(in_.counters));
    bindings.bind(cmd, pipeline);
    cmd.push(pipeline, io::FinalPassIo{.offset_m = instance.offset_m,
                                       .weights = {},
                                       .map_origin = settings_.square.origin,
                                       .map_side = side_of(frame, settings_.square),
                                       .slot = settings_.slot});
    cmd.draw(draw.index_count, 1, draw.first_index);
  }
  cmd.end_rendering();
}

}  // namespace dermis::passes
