// SPDX-License-Identifier: MIT
#include "render/passes/light_map/irradiance/irradiance.h"

#include <fmt/format.h>

#include "frame/resources.h"
#include "render/passes/bindings.h"
#include "render/passes/draw_skin.h"
#include "render/passes/light_map/irradiance/texels_io.h"
#include "render/shared/tiles_io.h"

namespace dermis::passes {

void LitTexels::declare(frame::Declare& d, const Settings& settings, const In& in) {
  d.kind(frame::PassKind::compute);
  d.sample(in.texels);
  d.read(in.lists.tiles);
  d.read(in.lists.counts);
  d.indirect(in.lists.arguments);
  if (!settings.from_host) d.sample(in.shadow);
  if (!settings.through.empty() && in.entering.valid()) d.sample(in.entering);
}

void LitTexels::prepare(gpu::PipelineLibrary& library, const std::string& shader, const Settings& settings,
                        const In& in, gpu::Constants constants) {
  samplers_ = LightingSamplers(library);
  const bool through = !settings.through.empty();
  if (through) {
    through_ = ThroughBindings(library, settings.through);
    constants.emplace_back("entering_stored", in.entering.valid() ? 1u : 0u);
  }
  if (!settings.from_host) constants.emplace_back("soft_shadows", settings.soft_shadows ? 1u : 0u);

  for (const bool cut_out : {false, true}) {
    pipelines_[cut_out].clear();
    if (cut_out && !settings.cut_out) continue;
    gpu::Constants variant = constants;
    variant.emplace_back("cut_out", cut_out ? 1u : 0u);
    if (!through) pipelines_[cut_out].push_back(&library.compute(shader, variant));
    for (const ThroughMesh& mesh : settings.through) {
      gpu::Constants of_mesh = variant;
      of_mesh.emplace_back("through_terms", mesh.mapped_terms());
      of_mesh.emplace_back("slab_gains", mesh.profile.shape ? 1u : 0u);
      pipelines_[cut_out].push_back(&library.compute(shader, of_mesh));
    }
  }
}

void LitTexels::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame,
                       const Settings& settings, const In& in, const Bindings& of_pass) const {
  const bool through = !settings.through.empty();
  for (const UsedSquare& square : used_squares(frame, settings.squares)) {
    const Head& head = head_of(frame, square);
    const std::uint32_t mesh = mesh_in_asset(frame, square);
    const std::size_t entry = through ? through_.entry_of(square.mesh) : 0;

    Bindings bindings = of_pass;
    bindings.add("Frame", frame.frame_io)
        .add("texels", resources.nearest(in.texels))
        .add("Tiles", resources.buffer(in.lists.tiles))
        .add("TileCounts", resources.buffer(in.lists.counts));
    samplers_.offer(bindings, frame, head, resources.texture(in.shadow));
    samplers_.offer_sky(bindings, head, mesh);
    if (through) through_.offer(bindings, resources, in.entering, in.shadow, entry);

    const std::vector<GpuDraw>& draws = head.asset->skin[mesh].draws;
    for (std::size_t k = 0; k < draws.size(); ++k) {
      const GpuMaterial& material = head.look->material(draws[k].material);
      const gpu::Pipeline& pipeline = *pipelines_[material.cut_out][entry];
      const std::uint32_t list = in.lists.of_material(square, k);
      Bindings all = bindings;
      offer_skin(all, head, mesh, material);
      all.bind(cmd, pipeline);
      cmd.push(pipeline, io::TexelsIo{.origin = square.origin,
                                      .side = square.side,
                                      .list = list,
                                      .room = in.lists.room,
                                      .first_triangle = draws[k].first_index / 3,
                                      .end_triangle = (draws[k].first_index + draws[k].index_count) / 3});
      cmd.dispatch_indirect(resources.buffer(in.lists.arguments), list * sizeof(io::TileArgumentsIo));
    }
  }
}

Irradiance::Out Irradiance::declare(frame::Declare& d) {
  LitTexels::declare(d, settings, in.texels);
  d.write(in.light);
  if (in.entered.valid()) d.write(in.entered);
  if (settings.from_host) d.sample(in.host_irradiance);
  if (!settings.through.empty()) {
    DERMIS_ASSERT_LT(in.joining.size(), std::size_t{TRANSMISSION_GROUPS});
    for (const frame::TextureId joining : in.joining) d.write(joining);
  }
  return {in.light};
}

void Irradiance::prepare(gpu::PipelineLibrary& library) {
  if (settings.from_host) {
    lit_.prepare(library, "irradiance_from_host.comp", settings, in.texels, {});
    return;
  }
  const std::size_t groups = settings.through.empty() ? 0 : in.joining.size() + 1;
  gpu::Constants constants{{"environment", settings.environment ? 1u : 0u}};
  if (groups > 0) constants.emplace_back("stores_entered", in.entered.valid() ? 1u : 0u);
  const std::string shader =
      groups > 0 ? fmt::format("irradiance_through_{}.comp", groups) : "irradiance.comp";
  lit_.prepare(library, shader, settings, in.texels, constants);
}

void Irradiance::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  static constexpr const char* joining[] = {"joining_1", "joining_2"};
  Bindings bindings;
  bindings.add("light", resources.storage(in.light));
  bindings.add("entered_light", resources.storage(in.entered.valid() ? in.entered : in.light));
  if (settings.from_host) bindings.add("host_irradiance", resources.nearest(in.host_irradiance));
  if (!settings.through.empty())
    for (std::size_t g = 0; g < in.joining.size(); ++g)
      bindings.add(joining[g], resources.storage(in.joining[g]));
  lit_.record(cmd, resources, frame, settings, in.texels, bindings);
}

TransmissionMisses::Out TransmissionMisses::declare(frame::Declare& d) {
  LitTexels::declare(d, settings.irradiance, in.texels);
  d.runs(frame::Runs::for_statistics);
  d.write(in.counters);
  return {};
}

void TransmissionMisses::prepare(gpu::PipelineLibrary& library) {
  lit_.prepare(library, "transmission_misses.comp", settings.irradiance, in.texels,
               {{"slot", settings.slot}});
}

void TransmissionMisses::record(gpu::Cmd& cmd, const frame::Resources& resources,
                                const FrameData& frame) const {
  Bindings bindings;
  bindings.add("Counters", resources.buffer(in.counters));
  lit_.record(cmd, resources, frame, settings.irradiance, in.texels, bindings);
}

}  // namespace dermis::passes
