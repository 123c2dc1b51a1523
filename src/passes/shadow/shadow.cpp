// SPDX-License-Identifier: MIT
#include "passes/shadow/shadow.h"

#include "frame/resources.h"

namespace dermis::passes {
Shadow::Out Shadow::declare(frame::Declare& d, const In& in) {
  d.kind(frame::PassKind::raster);
  in_ = in;
  d.depth(in.shadow);
  if (in.entering.valid()) d.colour(in.entering);
  return {in.shadow};
}

void Shadow::prepare(gpu::PipelineLibrary& library) {
  for (const bool skin : {false, true})
    for (const bool cut_out : {false, true})
      for (const bool mixed : {false, true}) {
        gpu::GraphicsDesc desc{.vertex = "shadow.vert",
                               .constants = {{"grown", settings_.grown ? 1u : 0u}},
                               .depth_format = VK_FORMAT_D32_SFLOAT,
                               .depth_test = true,
                               .depth_write = true};

        if (cut_out) desc.fragment = "shadow.frag";
        if (in_.entering.valid()) {
          desc.fragment = "shadow_entering.frag";
          desc.constants.emplace_back("skin", skin ? 1u : 0u);
          desc.constants.emplace_back("cut_out", cut_out ? 1u : 0u);
          desc.constants.emplace_back("mixed", mixed ? 1u : 0u);
          desc.colour_formats = {VK_FORMAT_R8G8B8A8_UNORM};
        }

        pipelines_[skin][cut_out][mixed] = &library.graphics(desc);
      }
}

// Whether a material casts a shadow in this round: blended parts (lashes, brows) would cast that of their
// whole card.
bool Shadow::casts(const GpuMaterial& material, bool cut_out) {
  return material.alpha_mode == (cut_out ? scene::AlphaMode::mask : scene::AlphaMode::opaque);
}

void Shadow::bind(gpu::Cmd& cmd, const FrameData& frame, Bindings bindings, const GpuMaterial& material,
                  const gpu::Pipeline& pipeline, const io::ShadowIo& io) const {
  material.offer(bindings);
  bindings.add("Frame", frame.frame_io);
  bindings.bind(cmd, pipeline);
  cmd.push(pipeline, io);
}

void Shadow::draw_skin(gpu::Cmd& cmd, const FrameData& frame, bool cut_out, const io::ShadowIo& io) const {
  for (const GpuMesh& mesh : frame.scene->skin)
    for (const GpuDraw& draw : mesh.draws) {
      const GpuMaterial& material = frame.scene->materials[static_cast<std::size_t>(draw.material)];
      if (!casts(material, cut_out)) continue;
      Bindings bindings;
      mesh.offer(bindings);
      bindings.add("Placements", frame.scene->unmoved);
      bind(cmd, frame, bindings, material, *pipelines_[true][cut_out][material.mixed], io);
      cmd.draw(draw.index_count, 1, draw.first_index);
    }
}

void Shadow::draw_surfaces(gpu::Cmd& cmd, const FrameData& frame, bool cut_out,
                           const io::ShadowIo& io) const {
  const GpuSurfaces& surfaces = frame.scene->surfaces;
  for (const GpuSurfaces::Group& group : surfaces.groups) {
    const GpuMaterial& material = frame.scene->materials[static_cast<std::size_t>(group.material)];
    if (!casts(material, cut_out)) continue;
    Bindings bindings;
    surfaces.offer(bindings, group.page);
    bind(cmd, frame, bindings, material, *pipelines_[false][cut_out][false], io);
    for (const GpuSurfaces::Draw& draw : group.draws)
      cmd.draw(draw.index_count, draw.placements, draw.first_index, draw.first_placement);
  }
}

void Shadow::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const gpu::Texture& shadow = resources.texture(in_.shadow);
  const Instance& instance = frame.instances[settings_.instance];
  if (!instance.visible) return;

  for (std::uint32_t layer = 0; layer < settings_.layers; ++layer) {
    const std::uint32_t target = instance.first_shadow_layer + layer;
    std::vector<gpu::ColourTarget> colour;
    if (in_.entering.valid())
      colour.push_back({.texture = &resources.texture(in_.entering),
                        .layer = target,
                        .clear = std::array{0.0f, 0.0f, 0.0f, 0.0f}});
    cmd.begin_rendering(colour, gpu::DepthTarget{.texture = &shadow, .layer = target, .clear = 0.0f},
                        {shadow.desc().width, shadow.desc().height}, true);

    if (layer < instance.shadow_from_world.size()) {
      const io::ShadowIo io{.shadow_from_world = instance.shadow_from_world[layer],
                            .offset_m = instance.offset_m,
                            .grow = 2.0f / static_cast<float>(shadow.desc().width)};
      for (const bool cut_out : {false, true}) draw_skin(cmd, frame, cut_out, io);
      for (const bool cut_out : {false, true}) draw_surfaces(cmd, frame, cut_out, io);
    }
    cmd.end_rendering();
  }
}

}  // namespace dermis::passes
