// SPDX-License-Identifier: MIT
#include "render/passes/shadow/shadow.h"

#include "frame/resources.h"
#include "render/passes/draw_skin.h"
#include "render/passes/targets.h"

namespace dermis::passes {
Shadow::Out Shadow::declare(frame::Declare& d) {
  d.kind(frame::PassKind::raster);
  d.depth(in.shadow);
  if (in.entering.valid()) {
    d.colour(in.entering);
    stored_ = d.desc(in.entering).format;
  }
  return {in.shadow};
}

void Shadow::prepare(gpu::PipelineLibrary& library) {
  for (const bool skin : {false, true})
    for (const bool cut_out : {false, true})
      for (const bool mixed : {false, true}) {
        gpu::GraphicsDesc desc{.vertex = "shadow.vert",
                               .constants = {{"grown", settings.grown ? 1u : 0u}},
                               .depth_format = depth_format,
                               .depth_test = true,
                               .depth_write = true};

        if (cut_out) desc.fragment = "shadow.frag";
        if (in.entering.valid()) {
          desc.fragment = "shadow_entering.frag";
          desc.constants.emplace_back("skin", skin ? 1u : 0u);
          desc.constants.emplace_back("cut_out", cut_out ? 1u : 0u);
          desc.constants.emplace_back("mixed", mixed ? 1u : 0u);
          desc.constants.emplace_back("facing", stored_ == facing_format ? 1u : 0u);
          desc.colour_formats = {stored_};
        }

        pipelines_[skin][cut_out][mixed] = &library.graphics(desc);
      }

  if (!settings.host_maps) return;
  DERMIS_ASSERT(!in.entering.valid());
  host_map_ = &library.graphics({.vertex = "shadow_of_host.vert",
                                 .fragment = "shadow_of_host.frag",
                                 .constants = {},
                                 .colour_formats = {},
                                 .depth_format = depth_format,
                                 .depth_write = true});
  nearest_ = library.sampler({.filter = gpu::Filter::nearest});
}

// Returns whether a material casts a shadow in this round. Blended parts (lashes, brows) cast none, which
// would be that of their whole card.
bool Shadow::casts(const GpuMaterial& material, bool cut_out) {
  return material.alpha_mode == (cut_out ? AssetAlpha::mask : AssetAlpha::opaque);
}

void Shadow::draw_skin(gpu::Cmd& cmd, const FrameData& frame, const Head& head, bool cut_out,
                       const io::ShadowIo& io) const {
  Bindings bindings;
  bindings.add("Frame", frame.frame_io).add("Placements", head.asset->unmoved);
  for (std::size_t mesh = 0; mesh < head.asset->skin.size(); ++mesh)
    passes::draw_skin(
        cmd, head, mesh, bindings,
        [&](const GpuDraw&, const GpuMaterial& material) {
          return casts(material, cut_out) ? pipelines_[true][cut_out][material.mixed] : nullptr;
        },
        [&](const GpuDraw&, const GpuMaterial&) { return io; });
}

void Shadow::draw_surfaces(gpu::Cmd& cmd, const FrameData& frame, const Head& head, bool cut_out,
                           const io::ShadowIo& io) const {
  const GpuSurfaces& surfaces = head.asset->surfaces;
  for (const GpuSurfaces::Group& group : surfaces.groups) {
    const GpuMaterial& material = head.look->material(group.material);
    if (!casts(material, cut_out)) continue;
    const gpu::Pipeline& pipeline = *pipelines_[false][cut_out][false];
    Bindings bindings;
    bindings.add("Frame", frame.frame_io).add("Head", head.io);
    offer_page(head, group.page, bindings);
    material.offer(bindings);
    bindings.bind(cmd, pipeline);
    cmd.push(pipeline, io);
    for (const GpuSurfaces::Draw& draw : group.draws) surfaces.record(cmd, group.page, draw);
  }
}

// Copies the host's depth texel by texel, from its nearest where it has another size.
void Shadow::take_host_map(gpu::Cmd& cmd, const HostShadowMap& map, const gpu::Texture& shadow) const {
  Bindings().add("host_depth", gpu::SampledBinding{map.depth, nearest_}).bind(cmd, *host_map_);
  cmd.push(*host_map_, io::HostShadowIo{.texel = 1.0f / static_cast<float>(shadow.desc().width),
                                        .reversed = map.reversed ? 1u : 0u});
  cmd.draw(3);
}

void Shadow::draw_layer(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame,
                        const Head& head, std::uint32_t layer) const {
  const gpu::Texture& shadow = resources.texture(in.shadow);
  const std::uint32_t target = head.first_shadow_layer + layer;
  std::vector<gpu::ColourTarget> colour;
  if (in.entering.valid())
    colour.push_back({.texture = &resources.texture(in.entering), .layer = target, .clear = no_light});
  // The map of a host takes the whole layer, and so does the light that enters there.
  const bool whole_layer = layer < head.host_shadows.size() && head.host_shadows[layer].depth;
  const bool of_host = settings.host_maps && whole_layer;
  const std::uint32_t side = whole_layer ? shadow.desc().width : head.shadow_side;
  cmd.begin_rendering(colour, gpu::DepthTarget{.texture = &shadow, .layer = target, .clear = 0.0f},
                      {side, side}, true);

  if (of_host) {
    take_host_map(cmd, head.host_shadows[layer], shadow);
  } else if (layer < head.shadow_from_world.size()) {
    const io::ShadowIo io{.shadow_from_world = head.shadow_from_world[layer],
                          .grow = 2.0f / static_cast<float>(side),
                          .is_turned = glm::determinant(head.shadow_from_world[layer]) < 0 ? 1u : 0u};
    for (const bool cut_out : {false, true}) draw_skin(cmd, frame, head, cut_out, io);
    for (const bool cut_out : {false, true}) draw_surfaces(cmd, frame, head, cut_out, io);
  }
  cmd.end_rendering();
}

void Shadow::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  for (std::uint32_t i = 0; i < settings.heads; ++i) {
    const Head& head = frame.heads[settings.first_head + i];
    const bool must_draw = head.visible && (!frame.kept_shadows || frame.kept_shadows->must_draw(
                                                                       in.shadow, head.first_shadow_layer,
                                                                       settings.layers, head.shadow_version));
    if (!must_draw) continue;
    for (std::uint32_t layer = 0; layer < settings.layers; ++layer)
      draw_layer(cmd, resources, frame, head, layer);
  }
}

}  // namespace dermis::passes
