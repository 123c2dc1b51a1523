// SPDX-License-Identifier: MIT
#include "passes/final_pass/final_pass.h"

#include <algorithm>

#include "frame/resources.h"
#include "passes/final_pass/final_pass_io.h"

namespace dermis::passes {
namespace {

float smoothstep(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

float too_few(float x) { return 1 - smoothstep(0.075f, 0.15f, x); }

}  // namespace

bool is_coarse(float widest_mm, float texels_per_mm, float even_texels_per_mm) {
  return coarse_share(0, widest_mm, texels_per_mm, even_texels_per_mm) > 0;
}

float coarse_share(float sigma_mm, float widest_mm, float texels_per_mm, float even_texels_per_mm) {
  const float poor =
      std::max(too_few(texels_per_mm / even_texels_per_mm), too_few(widest_mm * texels_per_mm));
  return poor * (1 - smoothstep(0.2f, 0.4f, sigma_mm * texels_per_mm));
}

gpu::Buffer make_terms(gpu::Device& device, const TermsOnMap& terms) {
  io::SkinTermsIo io{};
  std::copy(terms.sigmas_mm.begin(), terms.sigmas_mm.end(), io.sigma_mm);
  io.widest_mm = terms.sigmas_mm.empty() ? 0 : terms.sigmas_mm.back();
  io.even_texels_per_mm = terms.even_texels_per_mm;
  io.largest_side = static_cast<float>(terms.largest_side);
  return gpu::make_buffer(device, "skin terms", std::span<const io::SkinTermsIo>(&io, 1),
                          VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
}

float direct_share(float sigma_texels, float shrink) {
  return smoothstep(1, 1.4f, shrink) * (1 - smoothstep(0.35f, 0.8f, sigma_texels));
}

FinalPass::Out FinalPass::declare(frame::Declare& d, const In& in) {
  d.kind(frame::PassKind::raster);
  DERMIS_ASSERT_EQ(in.lights.size(), settings_.weights.size());
  DERMIS_ASSERT_LE(in.lights.size(), 8u);
  in_ = in;
  for (const frame::TextureId light : in.lights) d.sample(light);
  d.sample(in.shadow);
  if (through() && in.entering.valid()) d.sample(in.entering);
  d.colour(in.colour);
  d.depth(in.depth);
  return {in.colour, in.depth};
}

FinalPass::Pipelines FinalPass::make_pipelines(gpu::PipelineLibrary& library, Lit lit, bool off_map) const {
  const bool progressive = !settings_.halvings.empty() && settings_.halvings.back() > 0;
  const auto terms = static_cast<std::uint32_t>(settings_.weights.size());
  const bool through = this->through() && lit != Lit::on_map;

  Pipelines out;
  for (const bool double_sided : {false, true})
    for (const bool cut_out : {false, true})
      for (const bool emits : {false, true}) {
        if ((cut_out && !settings_.cut_out) || (emits && !settings_.emits)) continue;
        gpu::GraphicsDesc desc{.vertex = "final_pass.vert",
                               .fragment = through ? "final_pass_through.frag" : "final_pass.frag",
                               .constants = {{"term_count", lit == Lit::at_pixel ? 0u : terms},
                                             {"direct", lit != Lit::on_map ? 1u : 0u},
                                             {"environment", settings_.environment ? 1u : 0u},
                                             {"soft_shadows", settings_.soft_shadows ? 1u : 0u},
                                             {"progressive", progressive ? 1u : 0u},
                                             {"off_map", off_map ? 1u : 0u},
                                             {"coarse", settings_.terms.coarse ? 1u : 0u},
                                             {"cut_out", cut_out ? 1u : 0u},
                                             {"emits", emits ? 1u : 0u}},
                               .colour_formats = {VK_FORMAT_R16G16B16A16_SFLOAT},
                               .depth_format = VK_FORMAT_D32_SFLOAT,
                               .samples = settings_.samples,
                               .cull = double_sided ? gpu::Cull::none : gpu::Cull::back,
                               .depth_test = true,
                               .depth_write = true};
        if (through) {
          desc.constants.emplace_back("through_terms", terms);
          desc.constants.emplace_back("entering_stored", in_.entering.valid() ? 1u : 0u);
        }
        out.made[double_sided][cut_out][emits] = &library.graphics(desc);
      }
  return out;
}

const FinalPass::Pipelines& FinalPass::pipelines_of(const GpuDraw& draw, bool mixed) const {
  if (!draw.on_map) return off_map_;
  return mixed ? mixed_ : mapped_;
}

void FinalPass::prepare(gpu::PipelineLibrary& library) {
  mapped_ = make_pipelines(library, settings_.weights.empty() ? Lit::at_pixel : Lit::on_map, false);
  terms_ = make_terms(library.device(), settings_.terms);
  if (settings_.mixes || settings_.terms.coarse) mixed_ = make_pipelines(library, Lit::mixed, false);
  if (settings_.off_map) off_map_ = make_pipelines(library, Lit::at_pixel, true);
  if (through()) through_ = ThroughBindings(library, {*settings_.through}, settings_.mm_per_unit);
  samplers_ = LightingSamplers(library);
  light_sampler_ = library.sampler({.filter = gpu::Filter::linear});
}

void FinalPass::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const gpu::Texture& colour = resources.texture(in_.colour);
  const GpuMesh& mesh = frame.scene->skin[settings_.square.mesh];
  const Instance& instance = instance_of(frame, settings_.square);
  if (!instance.visible && !settings_.clear) return;

  gpu::ColourTarget colour_target{.texture = &colour};
  gpu::DepthTarget depth_target{.texture = &resources.texture(in_.depth)};
  if (settings_.clear) {
    colour_target.clear = std::array{0.0f, 0.0f, 0.0f, 0.0f};
    depth_target.clear = 0.0f;
  }
  cmd.begin_rendering(std::span(&colour_target, 1), depth_target,
                      {colour.desc().width, colour.desc().height});

  io::FinalPassIo io{.offset_m = instance.offset_m,
                     .weights = {},
                     .map_origin = settings_.square.origin,
                     .map_side = instance.map_side,
                     .slot = 0,
                     .halvings = 0};

  // Sets each term's weight on the map, and in 4 bits how often its map is halved.
  bool mixed = settings_.terms.coarse;
  for (std::size_t i = 0; i < settings_.weights.size(); ++i) {
    const float shrink =
        static_cast<float>(settings_.terms.largest_side) / static_cast<float>(instance.map_side);
    const float share =
        settings_.mixes
            ? direct_share(settings_.terms.sigmas_mm[i] * settings_.texels_per_mm / shrink, shrink)
            : 0.0f;
    mixed = mixed || share > 0;

    const std::uint32_t side =
        halved_side(instance.map_side, settings_.terms.largest_side, settings_.halvings[i]);
    while (instance.map_side >> (io.halvings >> 4 * i & 15u) > side) io.halvings += 1u << 4 * i;
    io.weights[i] =
        (1 - share) * glm::vec3(settings_.weights[i][0], settings_.weights[i][1], settings_.weights[i][2]);
  }

  static constexpr std::array names{"light_0", "light_1", "light_2", "light_3",
                                    "light_4", "light_5", "light_6", "light_7"};
  for (const GpuDraw& draw : mesh.draws) {
    if (!instance.visible) break;
    const GpuMaterial& material = frame.scene->materials[static_cast<std::size_t>(draw.material)];
    const gpu::Pipeline& pipeline = pipelines_of(draw, mixed).of(material);

    Bindings bindings;
    mesh.offer(bindings);
    material.offer(bindings);
    samplers_.offer(bindings, frame, instance, resources.texture(in_.shadow));
    samplers_.offer_sky(bindings, frame, settings_.square.mesh);
    if (through()) through_.offer(bindings, resources, in_.entering, in_.shadow, 0);
    // A binding without a term is never read, but must be bound: any sampled texture serves.
    for (std::size_t i = 0; i < names.size(); ++i)
      bindings.add(names[i], i < in_.lights.size()
                                 ? resources.sampled(in_.lights[i], light_sampler_)
                                 : gpu::SampledBinding{&frame.scene->white(), light_sampler_});

    bindings.add("Terms", terms_);
    bindings.bind(cmd, pipeline);
    cmd.push(pipeline, io);
    cmd.draw(draw.index_count, 1, draw.first_index);
  }

  cmd.end_rendering();
}

}  // namespace dermis::passes
