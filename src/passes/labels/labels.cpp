// SPDX-License-Identifier: MIT
#include "passes/labels/labels.h"

#include <array>
#include <limits>

#include "frame/resources.h"
#include "passes/draw_skin.h"
#include "passes/targets.h"

namespace dermis::passes {
namespace {

constexpr VkFormat surface_format = VK_FORMAT_R32G32B32A32_SFLOAT;
constexpr VkFormat names_format = VK_FORMAT_R32G32B32A32_UINT;
constexpr VkFormat motion_format = VK_FORMAT_R32G32_SFLOAT;
constexpr VkFormat body_format = VK_FORMAT_R32G32B32A32_SFLOAT;
constexpr std::array no_surface{0.0f, 0.0f, 0.0f, std::numeric_limits<float>::infinity()};
constexpr std::array nothing{0.0f, 0.0f, 0.0f, 0.0f};  // the bits of the number 0, too

io::LabelsIo labels_io(const Labels::Settings& settings, const Instance& instance,
                       const GpuMaterial& material, std::uint32_t skin_mesh) {
  const auto number = &material - instance.look->materials.data();
  return {.instance = instance.number + 1,
          .material = static_cast<std::uint32_t>(number) + 1,
          .skin_mesh = skin_mesh,
          .size = {settings.width, settings.height}};
}

// Offers positions before the last frame that moved the instance. Where none did, the shader reads none: any
// buffer will do.
void offer_before(const Instance& instance, std::size_t buffer, const gpu::Buffer& any, Bindings& bindings) {
  bindings.add("Before", instance.before)
      .add("BeforePositions", instance.posed ? instance.posed->before_m[buffer] : any);
}

}  // namespace

Labels::Out Labels::declare(frame::Declare& d) {
  d.kind(frame::PassKind::raster);
  gpu::TextureDesc desc{.width = settings.width, .height = settings.height, .format = surface_format};
  out_.surface = d.create("label surfaces", desc);
  desc.format = names_format;
  out_.names = d.create("label names", desc);
  desc.format = motion_format;
  out_.motion = d.create("label motions", desc);
  desc.format = body_format;
  out_.body = d.create("label bodies", desc);
  desc.format = depth_format;
  depth_ = d.create("label depths", desc);

  d.colour(out_.surface);
  d.colour(out_.names);
  d.colour(out_.motion);
  d.colour(out_.body);
  d.depth(depth_);
  return out_;
}

void Labels::prepare(gpu::PipelineLibrary& library) {
  for (const bool skin : {false, true})
    for (const bool double_sided : {false, true})
      for (const bool cut_out : {false, true})
        pipelines_[skin][double_sided][cut_out] =
            &library.graphics({.vertex = "labels.vert",
                               .fragment = "labels.frag",
                               .constants = {{"skin", skin ? 1u : 0u}, {"cut_out", cut_out ? 1u : 0u}},
                               .colour_formats = {surface_format, names_format, motion_format, body_format},
                               .depth_format = depth_format,
                               .cull = double_sided ? gpu::Cull::none : gpu::Cull::back,
                               .depth_test = true,
                               .depth_write = true});
}

void Labels::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const std::array targets{
      gpu::ColourTarget{.texture = &resources.texture(out_.surface), .clear = no_surface},
      gpu::ColourTarget{.texture = &resources.texture(out_.names), .clear = nothing},
      gpu::ColourTarget{.texture = &resources.texture(out_.motion), .clear = nothing},
      gpu::ColourTarget{.texture = &resources.texture(out_.body), .clear = nothing}};
  const gpu::DepthTarget depth{.texture = &resources.texture(depth_), .clear = 0.0f, .store = false};

  cmd.begin_rendering(targets, depth, {settings.width, settings.height});
  for (const Instance& instance : frame.instances) {
    if (!instance.visible) continue;
    draw_skin(cmd, frame, instance);
    draw_surfaces(cmd, frame, instance);
  }
  cmd.end_rendering();
}

const gpu::Pipeline* Labels::pipeline_of(const GpuMaterial& material, bool skin) const {
  return pipelines_[skin][material.double_sided][material.alpha_mode == scene::AlphaMode::mask];
}

void Labels::draw_skin(gpu::Cmd& cmd, const FrameData& frame, const Instance& instance) const {
  for (std::size_t mesh = 0; mesh < instance.scene->skin.size(); ++mesh) {
    Bindings bindings;
    bindings.add("Frame", frame.frame_io)
        .add("Placements", instance.scene->unmoved)
        .add("BeforePlacements", instance.scene->unmoved)
        .add("LabelVertices", instance.scene->skin[mesh].label_vertices);
    offer_before(instance, mesh, instance.scene->unmoved, bindings);
    passes::draw_skin(
        cmd, instance, mesh, bindings,
        [&](const GpuDraw&, const GpuMaterial& material) { return pipeline_of(material, true); },
        [&](const GpuDraw&, const GpuMaterial& material) {
          return labels_io(settings, instance, material, static_cast<std::uint32_t>(mesh) + 1);
        });
  }
}

void Labels::draw_surfaces(gpu::Cmd& cmd, const FrameData& frame, const Instance& instance) const {
  const GpuSurfaces& surfaces = instance.scene->surfaces;
  for (const GpuSurfaces::Group& group : surfaces.groups) {
    const GpuMaterial& material = instance.look->material(group.material);
    const gpu::Pipeline& pipeline = *pipeline_of(material, false);
    Bindings bindings;
    bindings.add("Frame", frame.frame_io)
        .add("Head", instance.io)
        .add("LabelVertices", instance.scene->unmoved)  // any buffers: only skin reads these
        .add("SkinVertices", surfaces.pages[group.page].vertex_extras);
    offer_page(instance, group.page, bindings);
    offer_before(instance, instance.scene->skin.size() + group.page, instance.scene->unmoved, bindings);
    bindings.add("BeforePlacements", instance.placements_before.empty()
                                         ? placements_of(instance, group.page)
                                         : instance.placements_before[group.page]);
    material.offer(bindings);
    bindings.bind(cmd, pipeline);
    cmd.push(pipeline, labels_io(settings, instance, material, 0));
    for (const GpuSurfaces::Draw& draw : group.draws) surfaces.record(cmd, group.page, draw);
  }
}

}  // namespace dermis::passes
