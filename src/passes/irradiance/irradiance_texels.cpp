// SPDX-License-Identifier: MIT
#include "passes/irradiance/irradiance_texels.h"

#include <fmt/format.h>

#include "frame/resources.h"
#include "passes/bindings.h"
#include "passes/draw_skin.h"
#include "passes/irradiance/texels_io.h"
#include "passes/targets.h"
#include "shared/texel_lists_io.h"

namespace dermis::passes {
namespace {

void declare_sources(frame::Declare& d, const Irradiance::Settings& settings, const Irradiance::In& in,
                     const LitTexels& texels) {
  d.kind(frame::PassKind::compute);
  d.sample(texels.map);
  d.sample(texels.lists.entries);
  d.read(texels.lists.lists);
  d.indirect(texels.lists.arguments);
  d.sample(in.shadow);
  if (in.kept.valid()) d.read(in.kept.indices);
  if (!settings.through.empty() && in.entering.valid()) d.sample(in.entering);
}

}  // namespace

void TexelPipelines::prepare(gpu::PipelineLibrary& library, const std::string& shader,
                             const Irradiance::Settings& settings, const gpu::Constants& constants) {
  samplers_ = LightingSamplers(library);
  const bool through = !settings.through.empty();
  if (through) through_ = ThroughBindings(library, settings.through);

  for (const bool cut_out : {false, true}) {
    pipelines_[cut_out].clear();
    if (cut_out && !settings.cut_out) continue;
    gpu::Constants variant = constants;
    variant.emplace_back("cut_out", cut_out ? 1u : 0u);
    variant.emplace_back("clip", settings.clip ? 1u : 0u);
    if (!through) pipelines_[cut_out].push_back(&library.compute(shader, variant));
    for (const ThroughMesh& mesh : settings.through) {
      gpu::Constants of_mesh = variant;
      of_mesh.emplace_back("through_terms", mesh.mapped_terms());
      of_mesh.emplace_back("slab_gains", mesh.profile.shape ? 1u : 0u);
      pipelines_[cut_out].push_back(&library.compute(shader, of_mesh));
    }
  }
}

void TexelPipelines::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame,
                            const Irradiance::Settings& settings, const Irradiance::In& in,
                            const LitTexels& texels, const Bindings& of_pass) const {
  const bool through = !settings.through.empty();
  for (const UsedSquare& square : used_squares(frame, settings.squares)) {
    const Instance& instance = instance_of(frame, square);
    const std::uint32_t mesh = mesh_in_asset(frame, square);
    const std::size_t entry = through ? through_.entry_of(square.mesh) : 0;

    Bindings bindings = of_pass;
    bindings.add("Frame", frame.frame_io)
        .add("texels", resources.nearest(texels.map))
        .add("entries", resources.nearest(texels.lists.entries))
        .add("Lists", resources.buffer(texels.lists.lists));
    samplers_.offer(bindings, frame, instance, resources.texture(in.shadow));
    samplers_.offer_sky(bindings, instance, mesh);
    if (through) through_.offer(bindings, resources, in.entering, in.shadow, entry);
    const std::vector<GpuDraw>& draws = instance.scene->skin[mesh].draws;
    for (std::size_t k = 0; k < draws.size(); ++k) {
      const GpuMaterial& material = instance.look->material(draws[k].material);
      const gpu::Pipeline& pipeline = *pipelines_[material.cut_out][entry];
      const std::uint32_t list = texel_list(texels.lists, square, k);
      Bindings all = bindings;
      offer_skin(all, instance, mesh, material);
      if (in.kept.valid()) all.add("Indices", kept_in(in.kept, resources, square));
      all.bind(cmd, pipeline);
      cmd.push(pipeline, io::TexelsIo{.origin = square.origin, .side = square.side, .list = list});
      cmd.dispatch_indirect(resources.buffer(texels.lists.arguments), list * sizeof(io::TexelArgumentsIo));
    }
  }
}

IrradianceTexels::Out IrradianceTexels::declare(frame::Declare& d) {
  declare_sources(d, settings.irradiance, in.irradiance, in.texels);
  d.write(in.irradiance.light);
  if (!settings.irradiance.through.empty()) {
    DERMIS_ASSERT_LT(in.irradiance.joining.size(), std::size_t{TRANSMISSION_GROUPS});
    for (const frame::TextureId joining : in.irradiance.joining) d.write(joining);
  }
  return {in.irradiance.light};
}

void IrradianceTexels::prepare(gpu::PipelineLibrary& library) {
  const Irradiance::Settings& irradiance = settings.irradiance;
  DERMIS_ASSERT(!irradiance.from_host);
  const bool through = !irradiance.through.empty();
  gpu::Constants constants{{"environment", irradiance.environment ? 1u : 0u},
                           {"soft_shadows", irradiance.soft_shadows ? 1u : 0u}};
  if (through) constants.emplace_back("entering_stored", in.irradiance.entering.valid() ? 1u : 0u);
  pipelines_.prepare(
      library,
      fmt::format("irradiance_texels_{}.comp", through ? in.irradiance.joining.size() + 1 : std::size_t{0}),
      irradiance, constants);
}

void IrradianceTexels::record(gpu::Cmd& cmd, const frame::Resources& resources,
                              const FrameData& frame) const {
  static constexpr const char* joining[] = {"joining_1", "joining_2"};
  Bindings bindings;
  bindings.add("light", resources.storage(in.irradiance.light));
  if (!settings.irradiance.through.empty())
    for (std::size_t g = 0; g < in.irradiance.joining.size(); ++g)
      bindings.add(joining[g], resources.storage(in.irradiance.joining[g]));
  pipelines_.record(cmd, resources, frame, settings.irradiance, in.irradiance, in.texels, bindings);
}

TransmissionMissesOfTexels::Out TransmissionMissesOfTexels::declare(frame::Declare& d) {
  declare_sources(d, settings.irradiance, in.irradiance, in.texels);
  d.runs(frame::Runs::for_statistics);
  d.write(in.counters);
  return {};
}

void TransmissionMissesOfTexels::prepare(gpu::PipelineLibrary& library) {
  pipelines_.prepare(library, "transmission_misses.comp", settings.irradiance,
                     {{"slot", settings.slot},
                      {"soft_shadows", settings.irradiance.soft_shadows ? 1u : 0u},
                      {"entering_stored", in.irradiance.entering.valid() ? 1u : 0u}});
}

void TransmissionMissesOfTexels::record(gpu::Cmd& cmd, const frame::Resources& resources,
                                        const FrameData& frame) const {
  Bindings bindings;
  bindings.add("Counters", resources.buffer(in.counters));
  pipelines_.record(cmd, resources, frame, settings.irradiance, in.irradiance, in.texels, bindings);
}

}  // namespace dermis::passes
