// SPDX-License-Identifier: MIT
#include "passes/irradiance/irradiance.h"

#include "frame/resources.h"
#include "passes/draw_skin.h"
#include "passes/targets.h"

namespace dermis::passes {

Irradiance::Out Irradiance::declare(frame::Declare& d) {
  d.kind(frame::PassKind::raster);
  d.colour(in.light);
  d.sample(in.shadow);
  if (in.kept.valid()) d.indices(in.kept.indices);
  if (settings.from_host) d.sample(in.host_irradiance);
  if (!settings.through.empty()) {
    DERMIS_ASSERT_LT(in.joining.size(), std::size_t{TRANSMISSION_GROUPS});
    if (in.entering.valid()) d.sample(in.entering);
    for (const frame::TextureId joining : in.joining) d.colour(joining);
  }
  return {in.light};
}

void Irradiance::prepare(gpu::PipelineLibrary& library) {
  gpu::GraphicsDesc desc{.vertex = settings.clip ? "irradiance_clipped.vert" : "irradiance.vert",
                         .fragment = settings.from_host ? "irradiance_from_host.frag" : "irradiance.frag",
                         .constants = {},
                         .colour_formats = {light_format}};
  if (!settings.from_host) {
    desc.constants.emplace_back("environment", settings.environment ? 1u : 0u);
    desc.constants.emplace_back("soft_shadows", settings.soft_shadows ? 1u : 0u);
  }
  const bool through = !settings.through.empty();
  if (through) {
    desc.fragment = fmt::format("irradiance_through_{}.frag", in.joining.size() + 1);
    desc.colour_formats.assign(in.joining.size() + 1, light_format);
    through_ = ThroughBindings(library, settings.through);
  }
  samplers_ = LightingSamplers(library);

  for (const bool cut_out : {false, true}) {
    pipelines_[cut_out].clear();
    if (cut_out && !settings.cut_out) continue;
    gpu::GraphicsDesc variant = desc;
    variant.constants.emplace_back("cut_out", cut_out ? 1u : 0u);
    if (!through) pipelines_[cut_out].push_back(&library.graphics(variant));
    for (const ThroughMesh& mesh : settings.through) {
      gpu::GraphicsDesc of_mesh = variant;
      of_mesh.constants.emplace_back("through_terms", mesh.mapped_terms());
      of_mesh.constants.emplace_back("slab_gains", mesh.profile.shape ? 1u : 0u);
      of_mesh.constants.emplace_back("entering_stored", in.entering.valid() ? 1u : 0u);
      pipelines_[cut_out].push_back(&library.graphics(of_mesh));
    }
  }
}

void Irradiance::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  std::vector<gpu::ColourTarget> targets;
  const auto add_target = [&](frame::TextureId id) {
    targets.push_back({.texture = &resources.texture(id), .clear = no_light});
  };
  add_target(in.light);
  for (const frame::TextureId joining : in.joining) add_target(joining);

  const bool through = !settings.through.empty();
  for (const UsedSquare& square : used_squares(frame, settings.squares)) {
    const Instance& instance = instance_of(frame, square);
    const std::uint32_t mesh = mesh_in_asset(frame, square);
    const std::size_t entry = through ? through_.entry_of(square.mesh) : 0;
    Bindings bindings;
    bindings.add("Frame", frame.frame_io);
    samplers_.offer(bindings, frame, instance, resources.texture(in.shadow));
    samplers_.offer_sky(bindings, instance, mesh);
    if (settings.from_host) bindings.add("host_irradiance", resources.nearest(in.host_irradiance));
    if (through) through_.offer(bindings, resources, in.entering, in.shadow, entry);

    cmd.begin_rendering_area(targets, {}, square.area(), true);
    draw_skin(
        cmd, instance, mesh, bindings,
        [&](const GpuDraw&, const GpuMaterial& material) { return pipelines_[material.cut_out][entry]; },
        nullptr, in.kept.valid() ? kept_in(in.kept, resources, square) : gpu::BufferBinding{});
    cmd.end_rendering();
  }
}

}  // namespace dermis::passes
