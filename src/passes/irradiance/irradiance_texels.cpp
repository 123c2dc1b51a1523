// SPDX-License-Identifier: MIT
#include "passes/irradiance/irradiance_texels.h"

#include <fmt/format.h>

#include "frame/resources.h"
#include "passes/bindings.h"
#include "passes/irradiance/texels_io.h"

namespace dermis::passes {
namespace {

void declare_sources(frame::Declare& d, const Irradiance::Settings& settings, const Irradiance::In& in,
                     const TexelMaps& texels) {
  d.kind(frame::PassKind::compute);
  d.sample(texels.numbers);
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
      of_mesh.emplace_back("through_terms", static_cast<std::uint32_t>(mesh.profile.terms.size()));
      pipelines_[cut_out].push_back(&library.compute(shader, of_mesh));
    }
  }
}

void TexelPipelines::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame,
                            const Irradiance::Settings& settings, const Irradiance::In& in,
                            const TexelMaps& texels, const Bindings& of_pass) const {
  const bool through = !settings.through.empty();
  for (const UsedSquare& square : used_squares(frame, settings.squares)) {
    const Instance& instance = instance_of(frame, square);
    const std::uint32_t mesh = mesh_in_asset(frame, square);
    const std::size_t entry = through ? through_.entry_of(square.mesh) : 0;

    Bindings bindings = of_pass;
    bindings.add("Frame", frame.frame_io).add("texels", resources.nearest(texels.numbers));
    samplers_.offer(bindings, frame, instance, resources.texture(in.shadow));
    samplers_.offer_sky(bindings, instance, mesh);
    if (through) through_.offer(bindings, resources, in.entering, in.shadow, entry);
    bindings.add("Instance", instance.transform);
    instance.scene->skin[mesh].offer(bindings);
    if (mesh < instance.vertices.size()) bindings.add("Vertices", instance.vertices[mesh]);
    if (in.kept.valid()) bindings.add("Indices", kept_in(in.kept, resources, square));
    dispatch(cmd, square, instance, mesh, entry, bindings);
  }
}

// A dispatch for each material: texels of other materials end at once.
void TexelPipelines::dispatch(gpu::Cmd& cmd, const UsedSquare& square, const Instance& instance,
                              std::uint32_t mesh, std::size_t entry, const Bindings& bindings) const {
  const std::vector<GpuDraw>& draws = instance.scene->skin[mesh].draws;
  for (const GpuDraw& draw : draws) {
    const GpuMaterial& material = instance.look->material(draw.material);
    const gpu::Pipeline& pipeline = *pipelines_[material.cut_out][entry];
    Bindings all = bindings;
    material.offer(all);
    all.bind(cmd, pipeline);
    cmd.push(pipeline, io::TexelsIo{.origin = square.origin,
                                    .side = square.side,
                                    .first_triangle = draw.first_index / 3,
                                    .end_triangle = (draw.first_index + draw.index_count) / 3,
                                    .clears = &draw == draws.data() ? 1u : 0u});
    cmd.dispatch_over(pipeline, square.side, square.side);
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
