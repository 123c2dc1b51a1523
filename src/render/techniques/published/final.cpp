// SPDX-License-Identifier: MIT
#include "render/techniques/published/final.h"

#include "frame/resources.h"
#include "render/passes/draw_skin.h"
#include "render/passes/targets.h"

namespace dermis::techniques::papers {

using passes::GpuDraw;
using passes::GpuMaterial;

Final::Out Final::declare(frame::Declare& d) {
  d.kind(frame::PassKind::raster);
  for (const frame::TextureId light : in.lights) d.sample(light);
  d.sample(in.shadow);
  d.colour(in.colour);
  d.depth(in.depth);
  return {};
}

gpu::GraphicsDesc Final::desc_of(bool on_map) const {
  const bool direct = !on_map || settings.part.unscattered != gaussians::Rgb{};
  return {.vertex = "published/final.vert",
          .fragment = "published/final.frag",
          .constants = {{"term_count", on_map ? static_cast<std::uint32_t>(in.lights.size()) : 0u},
                        {"direct", direct ? 1u : 0u},
                        {"environment", settings.environment ? 1u : 0u},
                        {"soft_shadows", settings.soft_shadows ? 1u : 0u},
                        {"off_map", on_map ? 0u : 1u}},
          .colour_formats = {settings.format.colour},
          .depth_format = settings.format.depth,
          .samples = settings.samples,
          .depth_test = true,
          .depth_write = true,
          .depth_compare = settings.format.nearer()};
}

void Final::prepare(gpu::PipelineLibrary& library) {
  for (const bool on_map : {true, false})
    for (std::size_t number = 0; number < passes::SkinKind::count; ++number) {
      if (!settings.part.kinds[number] || (!on_map && !settings.part.off_map)) continue;
      const passes::SkinKind kind{
          .cut_out = (number & 4) != 0, .emits = (number & 2) != 0, .detailed = (number & 1) != 0};
      gpu::GraphicsDesc desc = desc_of(on_map);
      desc.constants.emplace_back("cut_out", kind.cut_out ? 1u : 0u);
      desc.constants.emplace_back("emits", kind.emits ? 1u : 0u);
      desc.constants.emplace_back("detailed", kind.detailed ? 1u : 0u);

      for (const bool double_sided : {false, true}) {
        desc.cull = double_sided ? gpu::Cull::none : gpu::Cull::back;
        pipelines_[on_map][kind.index()][double_sided] = &library.graphics(desc);
      }
    }
  samplers_ = passes::LightingSamplers(library);
}

io::PaperFinalIo Final::io_of(const FrameData& frame) const {
  io::PaperFinalIo io{.weights = {}, .side = used_side(frame, settings.object), .slot = 0};
  for (std::size_t i = 0; i < in.lights.size(); ++i) {
    const auto& [r, g, b] = settings.part.profile.terms[i].weight;
    io.weights[i] = glm::vec3(static_cast<float>(r), static_cast<float>(g), static_cast<float>(b));
  }
  return io;
}

void Final::offer(passes::Bindings& bindings, const frame::Resources& resources,
                  const FrameData& frame) const {
  static constexpr std::array names{"light_0", "light_1", "light_2", "light_3",
                                    "light_4", "light_5", "light_6", "light_7"};
  static_assert(names.size() == MOST_TERMS);
  const passes::Head& head = head_of(frame, settings.object);
  bindings.add("Frame", frame.frame_io);
  samplers_.offer(bindings, frame, head, resources.texture(in.shadow));
  samplers_.offer_sky(bindings, head, mesh_in_asset(frame, settings.object));

  // A binding without a term is never read, but a sampled texture must be bound.
  for (std::size_t i = 0; i < names.size(); ++i)
    bindings.add(names[i], i < in.lights.size() ? resources.linear(in.lights[i])
                                                : resources.linear(head.asset->white()));
}

void Final::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const passes::Head& head = head_of(frame, settings.object);
  if (!settings.clear && !head.is_drawn()) return;
  passes::begin_picture(cmd, resources.texture(in.colour), resources.texture(in.depth), settings.clear,
                        frame.area);
  if (head.is_drawn()) {
    passes::Bindings bindings;
    offer(bindings, resources, frame);
    passes::draw_skin(
        cmd, head, mesh_in_asset(frame, settings.object), bindings,
        [&](const GpuDraw& draw, const GpuMaterial& material) {
          const passes::SkinKind kind{
              .cut_out = material.cut_out, .emits = material.emits, .detailed = material.detailed};
          return pipelines_.at(draw.on_map)[kind.index()][material.double_sided];
        },
        [io = io_of(frame)](const GpuDraw&, const GpuMaterial&) { return io; },
        passes::first_corners(head, mesh_in_asset(frame, settings.object)));
  }
  cmd.end_rendering();
}

UnshadedReads::Out UnshadedReads::declare(frame::Declare& d) {
  d.kind(frame::PassKind::raster);
  d.runs(frame::Runs::for_statistics);
  d.sample(in.light);
  d.depth(in.depth);
  d.write(in.counters);
  return {};
}

void UnshadedReads::prepare(gpu::PipelineLibrary& library) {
  for (const bool double_sided : {false, true})
    for (const bool cut_out : {false, true})
      if (!cut_out || settings.cut_out)
        pipelines_[double_sided][cut_out] =
            &library.graphics({.vertex = "published/final.vert",
                               .fragment = "published/unshaded_reads.frag",
                               .constants = {{"cut_out", cut_out ? 1u : 0u}},
                               .depth_format = passes::depth_format,
                               .samples = settings.samples,
                               .cull = double_sided ? gpu::Cull::none : gpu::Cull::back,
                               .depth_test = true});
}

void UnshadedReads::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  if (!is_lit(frame, settings.object)) return;
  const passes::Head& head = head_of(frame, settings.object);
  const std::uint32_t mesh = mesh_in_asset(frame, settings.object);
  const gpu::Texture& depth = resources.texture(in.depth);
  passes::Bindings bindings;
  bindings.add("Frame", frame.frame_io)
      .add("light_0", resources.nearest(in.light))
      .add("Counters", resources.buffer(in.counters));
  const io::PaperFinalIo io{.weights = {}, .side = used_side(frame, settings.object), .slot = settings.slot};

  cmd.begin_rendering({}, gpu::DepthTarget{.texture = &depth}, {depth.desc().width, depth.desc().height});
  passes::draw_skin(
      cmd, head, mesh, bindings,
      [&](const GpuDraw& draw, const GpuMaterial& material) {
        return draw.on_map ? pipelines_[material.double_sided][material.cut_out] : nullptr;
      },
      [&](const GpuDraw&, const GpuMaterial&) { return io; }, passes::first_corners(head, mesh));
  cmd.end_rendering();
}

}  // namespace dermis::techniques::papers
