// SPDX-License-Identifier: MIT
#include "render/passes/pixels/labels/labels.h"

#include <array>
#include <limits>
#include <vector>

#include "base/core/assert.h"
#include "frame/resources.h"
#include "render/passes/draw_skin.h"
#include "render/passes/targets.h"

namespace dermis::passes {
namespace {

constexpr VkFormat words_format = VK_FORMAT_R32G32B32A32_UINT;

std::uint32_t words_of(std::uint32_t labels) {
  std::uint32_t words = 0;
  for (std::uint32_t i = 0; i < LABEL_COUNT; ++i)
    if ((labels >> i & 1) != 0) words += label_words[i];
  return words;
}

// Labels of a pixel where nothing is: the same bits as words.
std::array<float, 4 * Labels::most_targets> nothing(std::uint32_t labels) {
  std::array<float, 4 * Labels::most_targets> words{};
  if ((labels & LABEL_DEPTH) != 0)
    words[words_of(labels & (LABEL_DEPTH - 1))] = std::numeric_limits<float>::infinity();
  return words;
}

io::LabelsIo labels_io(const Labels::Settings& settings, const Head& head, const GpuMaterial& material,
                       std::uint32_t skin_mesh) {
  const auto number = &material - head.look->materials.data();
  return {.instance = head.number + 1,
          .material = static_cast<std::uint32_t>(number) + 1,
          .skin_mesh = skin_mesh,
          .size = {settings.width, settings.height}};
}

// Offers positions before the last frame that moved the head. Where none did, the shader reads none: any
// buffer will do.
void offer_before(const Head& head, std::size_t buffer, const gpu::Buffer& any, Bindings& bindings) {
  bindings.add("Before", head.before).add("BeforePositions", head.posed ? head.posed->before_m[buffer] : any);
}

}  // namespace

std::size_t Labels::targets() const { return (words_of(settings.labels) + 3) / 4; }

Labels::Out Labels::declare(frame::Declare& d) {
  DERMIS_ASSERT(settings.labels != 0);
  d.kind(frame::PassKind::raster);
  gpu::TextureDesc desc{.width = settings.width, .height = settings.height, .format = words_format};
  for (std::size_t i = 0; i < targets(); ++i) {
    out_.words[i] = d.create(fmt::format("label words {}", i), desc);
    d.colour(out_.words[i]);
  }
  desc.format = depth_format;
  out_.depth = d.create("label depths", desc);
  d.depth(out_.depth);
  return out_;
}

void Labels::prepare(gpu::PipelineLibrary& library) {
  for (const bool skin : {false, true})
    for (const bool double_sided : {false, true})
      for (const bool cut_out : {false, true})
        pipelines_[skin][double_sided][cut_out] = &library.graphics(
            {.vertex = "labels.vert",
             .fragment = targets() > 1 ? fmt::format("labels_{}.frag", targets()) : "labels.frag",
             .constants = {{"skin", skin ? 1u : 0u},
                           {"cut_out", cut_out ? 1u : 0u},
                           {"labels", settings.labels},
                           {"body", needs_body(settings.labels) ? 1u : 0u}},
             .colour_formats = std::vector<VkFormat>(targets(), words_format),
             .depth_format = depth_format,
             .cull = double_sided ? gpu::Cull::none : gpu::Cull::back,
             .depth_test = true,
             .depth_write = true});
}

void Labels::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const auto clear = nothing(settings.labels);
  std::vector<gpu::ColourTarget> targets;
  for (std::size_t i = 0; i < this->targets(); ++i)
    targets.push_back(
        {.texture = &resources.texture(out_.words[i]),
         .clear = std::array{clear[4 * i], clear[4 * i + 1], clear[4 * i + 2], clear[4 * i + 3]}});
  const gpu::DepthTarget depth{
      .texture = &resources.texture(out_.depth), .clear = 0.0f, .store = settings.keeps_depth};

  cmd.begin_rendering(targets, depth, {settings.width, settings.height});
  for (const Head& head : frame.heads) {
    if (!head.visible) continue;
    draw_skin(cmd, frame, head);
    draw_surfaces(cmd, frame, head);
  }
  cmd.end_rendering();
}

const gpu::Pipeline* Labels::pipeline_of(const GpuMaterial& material, bool skin) const {
  return pipelines_[skin][material.double_sided][material.alpha_mode == AssetAlpha::mask];
}

void Labels::draw_skin(gpu::Cmd& cmd, const FrameData& frame, const Head& head) const {
  for (std::size_t mesh = 0; mesh < head.asset->skin.size(); ++mesh) {
    Bindings bindings;
    bindings.add("Frame", frame.frame_io)
        .add("Placements", head.asset->unmoved)
        .add("BeforePlacements", head.asset->unmoved)
        .add("LabelVertices",
             needs_body(settings.labels) ? head.asset->skin[mesh].label_vertices : head.asset->unmoved);
    offer_before(head, mesh, head.asset->unmoved, bindings);
    passes::draw_skin(
        cmd, head, mesh, bindings,
        [&](const GpuDraw&, const GpuMaterial& material) { return pipeline_of(material, true); },
        [&](const GpuDraw&, const GpuMaterial& material) {
          return labels_io(settings, head, material, static_cast<std::uint32_t>(mesh) + 1);
        });
  }
}

void Labels::draw_surfaces(gpu::Cmd& cmd, const FrameData& frame, const Head& head) const {
  const GpuSurfaces& surfaces = head.asset->surfaces;
  for (const GpuSurfaces::Group& group : surfaces.groups) {
    const GpuMaterial& material = head.look->material(group.material);
    const gpu::Pipeline& pipeline = *pipeline_of(material, false);
    bind_label_surface(cmd, pipeline, frame, head, group.page, material, needs_body(settings.labels));
    cmd.push(pipeline, labels_io(settings, head, material, 0));
    for (const GpuSurfaces::Draw& draw : group.draws) surfaces.record(cmd, group.page, draw);
  }
}

void bind_label_surface(gpu::Cmd& cmd, const gpu::Pipeline& pipeline, const FrameData& frame,
                        const Head& head, std::uint32_t page, const GpuMaterial& material, bool body) {
  const GpuSurfaces::Page& of_page = head.asset->surfaces.pages[page];
  Bindings bindings;
  bindings.add("Frame", frame.frame_io)
      .add("Head", head.io)
      .add("LabelVertices", body ? of_page.label_vertices : head.asset->unmoved)
      .add("SkinVertices", of_page.vertex_extras);  // any buffer: only skin reads it
  offer_page(head, page, bindings);
  offer_before(head, head.asset->skin.size() + page, head.asset->unmoved, bindings);
  bindings.add("BeforePlacements",
               head.placements_before.empty() ? placements_of(head, page) : head.placements_before[page]);
  material.offer(bindings);
  bindings.bind(cmd, pipeline);
}

}  // namespace dermis::passes
