// SPDX-License-Identifier: MIT
#include "render/techniques/published/irradiance.h"

#include <fmt/format.h>

#include "frame/resources.h"
#include "render/passes/draw_skin.h"
#include "render/passes/targets.h"

namespace dermis::techniques::papers {
namespace {

void declare_lights(frame::Declare& d, const LitMesh& mesh) {
  d.sample(mesh.shadow);
  if (mesh.kept.valid()) d.indices(mesh.kept);
  if (mesh.through && mesh.entering.valid()) d.sample(mesh.entering);
}

gpu::GraphicsDesc desc_of(const LitMesh& mesh) {
  gpu::GraphicsDesc desc{.vertex =
                             mesh.clip ? "published/irradiance_clipped.vert" : "published/irradiance.vert"};
  if (mesh.through) {
    const std::size_t terms = mesh.through->profile.terms.size();
    desc.constants.emplace_back("through_terms", static_cast<std::uint32_t>(terms));
    desc.constants.emplace_back("entering_stored", mesh.entering.valid() ? 1u : 0u);
  }
  return desc;
}

passes::Bindings bindings_of(const LitMesh& mesh, const frame::Resources& resources, const FrameData& frame,
                             const passes::LightingSamplers& samplers,
                             const passes::ThroughBindings& through) {
  const passes::Head& head = head_of(frame, mesh.object);
  passes::Bindings bindings;
  bindings.add("Frame", frame.frame_io);
  samplers.offer(bindings, frame, head, resources.texture(mesh.shadow));
  samplers.offer_sky(bindings, head, mesh_in_asset(frame, mesh.object));
  if (mesh.through) through.offer(bindings, resources, mesh.entering, mesh.shadow, 0);
  return bindings;
}

gpu::BufferBinding triangles_of(const LitMesh& mesh, const frame::Resources& resources) {
  return mesh.kept.valid() ? gpu::BufferBinding{&resources.buffer(mesh.kept)} : gpu::BufferBinding{};
}

}  // namespace

Irradiance::Out Irradiance::declare(frame::Declare& d) {
  d.kind(frame::PassKind::raster);
  d.colour(in.light);
  for (const frame::TextureId joining : in.joining) d.colour(joining);
  declare_lights(d, settings.mesh);
  return {};
}

void Irradiance::prepare(gpu::PipelineLibrary& library) {
  const LitMesh& mesh = settings.mesh;
  gpu::GraphicsDesc desc = desc_of(mesh);
  desc.fragment = "published/irradiance.frag";
  if (mesh.through)
    desc.fragment = fmt::format("published/irradiance_through_{}.frag", in.joining.size() + 1);
  desc.colour_formats.assign(in.joining.size() + 1, passes::light_format);
  desc.constants.emplace_back("environment", mesh.environment ? 1u : 0u);
  desc.constants.emplace_back("soft_shadows", mesh.soft_shadows ? 1u : 0u);
  desc.constants.emplace_back("cut_out", 0u);

  for (const bool cut_out : {false, true}) {
    desc.constants.back().second = cut_out ? 1u : 0u;
    if (!cut_out || mesh.cut_out) pipelines_[cut_out] = &library.graphics(desc);
  }
  samplers_ = passes::LightingSamplers(library);
  if (mesh.through) through_ = passes::ThroughBindings(library, {*mesh.through});
}

void Irradiance::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const LitMesh& mesh = settings.mesh;
  if (!is_lit(frame, mesh.object)) return;
  // [JG08] sec. 5: alpha is 0 where nothing is drawn, which propagates what is culled and clipped.
  std::vector<gpu::ColourTarget> targets{
      {.texture = &resources.texture(in.light), .clear = passes::no_light}};
  for (const frame::TextureId joining : in.joining)
    targets.push_back({.texture = &resources.texture(joining), .clear = passes::no_light});

  cmd.begin_rendering_area(targets, {}, used_area(frame, mesh.object), true);
  passes::draw_skin(
      cmd, head_of(frame, mesh.object), mesh_in_asset(frame, mesh.object),
      bindings_of(mesh, resources, frame, samplers_, through_),
      [&](const passes::GpuDraw&, const passes::GpuMaterial& material) {
        return pipelines_[material.cut_out];
      },
      nullptr, triangles_of(mesh, resources));
  cmd.end_rendering();
}

MissedLight::Out MissedLight::declare(frame::Declare& d) {
  d.kind(frame::PassKind::raster);
  d.runs(frame::Runs::for_statistics);
  declare_lights(d, settings.mesh);
  d.write(in.counters);
  return {};
}

void MissedLight::prepare(gpu::PipelineLibrary& library) {
  gpu::GraphicsDesc desc = desc_of(settings.mesh);
  desc.fragment = "published/missed_light.frag";
  desc.constants.emplace_back("slot", settings.slot);
  pipeline_ = &library.graphics(desc);
  samplers_ = passes::LightingSamplers(library);
  through_ = passes::ThroughBindings(library, {*settings.mesh.through});
}

void MissedLight::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const LitMesh& mesh = settings.mesh;
  if (!is_lit(frame, mesh.object)) return;
  passes::Bindings bindings = bindings_of(mesh, resources, frame, samplers_, through_);
  bindings.add("Counters", resources.buffer(in.counters));

  cmd.begin_rendering_area({}, {}, used_area(frame, mesh.object), true);
  passes::draw_skin(
      cmd, head_of(frame, mesh.object), mesh_in_asset(frame, mesh.object), bindings,
      [&](const passes::GpuDraw&, const passes::GpuMaterial&) { return pipeline_; }, nullptr,
      triangles_of(mesh, resources));
  cmd.end_rendering();
}

}  // namespace dermis::techniques::papers
