// SPDX-License-Identifier: MIT
#include "passes/irradiance/irradiance.h"

#include "frame/resources.h"
#include "passes/cull.h"

namespace dermis::passes {

Irradiance::Out Irradiance::declare(frame::Declare& d, const In& in) {
  d.kind(frame::PassKind::raster);
  in_ = in;
  d.colour(in.light);
  d.sample(in.shadow);
  if (!settings_.through.empty()) {
    DERMIS_ASSERT_LT(in.joining.size(), std::size_t{TRANSMISSION_GROUPS});
    if (in.entering.valid()) d.sample(in.entering);
    for (const frame::TextureId joining : in.joining) d.colour(joining);
  }
  return {in.light};
}

void Irradiance::prepare(gpu::PipelineLibrary& library) {
  gpu::GraphicsDesc desc{.vertex = settings_.clip ? "irradiance_clipped.vert" : "irradiance.vert",
                         .fragment = "irradiance.frag",
                         .constants = {{"cull", settings_.cull ? 1u : 0u},
                                       {"environment", settings_.environment ? 1u : 0u},
                                       {"soft_shadows", settings_.soft_shadows ? 1u : 0u}},
                         .colour_formats = {VK_FORMAT_R16G16B16A16_SFLOAT}};
  const bool through = !settings_.through.empty();
  if (through) {
    desc.fragment = fmt::format("irradiance_through_{}.frag", in_.joining.size() + 1);
    desc.colour_formats.assign(in_.joining.size() + 1, VK_FORMAT_R16G16B16A16_SFLOAT);
    through_ = ThroughBindings(library, settings_.through, settings_.mm_per_unit);
  }
  samplers_ = LightingSamplers(library);

  for (const bool cut_out : {false, true}) {
    pipelines_[cut_out].clear();
    if (cut_out && !settings_.cut_out) continue;
    gpu::GraphicsDesc variant = desc;
    variant.constants.emplace_back("cut_out", cut_out ? 1u : 0u);
    if (!through) pipelines_[cut_out].push_back(&library.graphics(variant));
    for (const gaussians::SumOfGaussians& profile : settings_.through) {
      gpu::GraphicsDesc of_mesh = variant;
      of_mesh.constants.emplace_back("through_terms", static_cast<std::uint32_t>(profile.terms.size()));
      of_mesh.constants.emplace_back("entering_stored", in_.entering.valid() ? 1u : 0u);
      pipelines_[cut_out].push_back(&library.graphics(of_mesh));
    }
  }
}

void Irradiance::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  std::vector<gpu::ColourTarget> targets;
  const auto add_target = [&](frame::TextureId id) {
    targets.push_back({.texture = &resources.texture(id), .clear = std::array{0.0f, 0.0f, 0.0f, 0.0f}});
  };
  add_target(in_.light);
  for (const frame::TextureId joining : in_.joining) add_target(joining);

  const bool through = !settings_.through.empty();
  for (const MapSquare& square : settings_.squares) {
    const GpuMesh& mesh = frame.scene->skin[square.mesh];
    const Instance& instance = instance_of(frame, square);
    if (!instance.visible) continue;

    cmd.begin_rendering_area(targets, {}, used_area(frame, square), true);
    for (const GpuDraw& draw : mesh.draws) {
      const GpuMaterial& material = frame.scene->materials[static_cast<std::size_t>(draw.material)];
      const gpu::Pipeline& pipeline = *pipelines_[material.cut_out][through ? square.mesh : 0];

      Bindings bindings;
      mesh.offer(bindings);
      material.offer(bindings);
      samplers_.offer(bindings, frame, instance, resources.texture(in_.shadow));
      samplers_.offer_sky(bindings, frame, square.mesh);
      if (through) through_.offer(bindings, resources, in_.entering, in_.shadow, square.mesh);

      bindings.bind(cmd, pipeline);
      cmd.push(pipeline, cull_io(frame, instance, material));
      cmd.draw(draw.index_count, 1, draw.first_index);
    }
    cmd.end_rendering();
  }
}

}  // namespace dermis::passes
