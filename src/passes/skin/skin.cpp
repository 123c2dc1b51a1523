// SPDX-License-Identifier: MIT
#include "passes/skin/skin.h"

#include "frame/executor.h"
#include "passes/skin/skin_io.h"

namespace dermis::passes {

Skin::Out Skin::declare(frame::Declare& d, const In& in) {
  d.kind(frame::PassKind::raster);
  DERMIS_ASSERT_EQ(in.lights.size(), settings_.weights.size());
  DERMIS_ASSERT_LE(in.lights.size(), 8u);
  in_ = in;
  for (const frame::TextureId light : in.lights) d.sample(light);
  d.sample(in.shadow);
  d.colour(in.colour);
  d.depth(in.depth);
  return {in.colour, in.depth};
}

void Skin::prepare(gpu::PipelineLibrary& library) {
  gpu::GraphicsDesc desc{.vertex = "skin.vert",
                         .fragment = "skin.frag",
                         .constants = {{"term_count", static_cast<std::uint32_t>(settings_.weights.size())}},
                         .colour_formats = {VK_FORMAT_R16G16B16A16_SFLOAT},
                         .depth_format = VK_FORMAT_D32_SFLOAT,
                         .samples = settings_.samples,
                         .cull = gpu::Cull::back,
                         .depth_test = true,
                         .depth_write = true};
  single_sided_ = &library.graphics(desc);
  desc.cull = gpu::Cull::none;
  double_sided_ = &library.graphics(desc);
  samplers_ = LightingSamplers(library);
  light_sampler_ = library.sampler({.filter = gpu::Filter::linear});
}

void Skin::record(gpu::Cmd& cmd, const frame::Resources& resources, const frame::FrameData& frame) const {
  const gpu::Texture& colour = resources.texture(in_.colour);
  const GpuMesh& mesh = frame.scene->skin[settings_.square.mesh];
  const frame::Instance& instance = instance_of(frame, settings_.square);
  if (!instance.visible && !settings_.clear) return;
  gpu::ColourTarget colour_target{.texture = &colour};
  gpu::DepthTarget depth_target{.texture = &resources.texture(in_.depth)};
  if (settings_.clear) colour_target.clear = std::array{0.0f, 0.0f, 0.0f, 0.0f}, depth_target.clear = 0.0f;
  cmd.begin_rendering(std::span(&colour_target, 1), depth_target, {colour.desc().width, colour.desc().height});
  io::SkinIo io{
      .offset_m = instance.offset_m, .weights = {}, .map_origin = settings_.square.origin, .map_side = instance.map_side, .slot = 0};
  for (std::size_t i = 0; i < settings_.weights.size(); ++i)
    io.weights[i] = {settings_.weights[i][0], settings_.weights[i][1], settings_.weights[i][2]};
  static constexpr std::array names{"light_0", "light_1", "light_2", "light_3", "light_4", "light_5", "light_6", "light_7"};
  for (const GpuDraw& draw : mesh.draws) {
    if (!instance.visible) break;
    const GpuMaterial& material = frame.scene->materials[static_cast<std::size_t>(draw.material)];
    const gpu::Pipeline& pipeline = material.double_sided ? *double_sided_ : *single_sided_;
    Bindings bindings;
    mesh.offer(bindings);
    material.offer(bindings);
    samplers_.offer(bindings, frame, instance, resources.texture(in_.shadow));
    // A binding without a term is never read, but must be bound: any sampled texture serves.
    for (std::size_t i = 0; i < names.size(); ++i)
      bindings.add(names[i], i < in_.lights.size() ? resources.sampled(in_.lights[i], light_sampler_)
                                                   : gpu::SampledBinding{&frame.scene->white(), light_sampler_});
    bindings.bind(cmd, pipeline);
    cmd.push(pipeline, io);
    cmd.draw(draw.index_count, 1, draw.first_index);
  }
  cmd.end_rendering();
}

}  // namespace dermis::passes
