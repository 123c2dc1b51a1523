// SPDX-License-Identifier: MIT
#include "passes/final_pass/final_pass.h"

#include <algorithm>

#include "frame/resources.h"
#include "passes/draw_skin.h"
#include "passes/final_pass/final_pass_io.h"
#include "passes/targets.h"

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
  io.even_uv_per_mm = terms.even_uv_per_mm;
  io.largest_side = static_cast<float>(terms.largest_side);
  return gpu::make_buffer(device, "skin terms", std::span<const io::SkinTermsIo>(&io, 1),
                          VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
}

float direct_share(float sigma_texels, float shrink) {
  return smoothstep(1, 1.4f, shrink) * (1 - smoothstep(0.35f, 0.8f, sigma_texels));
}

float share_at_pixel(float sigma_mm, float texels_per_mm, std::uint32_t largest_side, std::uint32_t side) {
  const float shrink = static_cast<float>(largest_side) / static_cast<float>(side);
  return direct_share(sigma_mm * texels_per_mm / shrink, shrink);
}

FinalPass::Out FinalPass::declare(frame::Declare& d) {
  d.kind(frame::PassKind::raster);
  DERMIS_ASSERT_EQ(in.lights.size(), settings.summed ? 1 : settings.weights.size());
  DERMIS_ASSERT_LE(in.lights.size(), std::size_t{MOST_TERMS});
  for (const frame::TextureId light : in.lights) d.sample(light);
  d.sample(in.shadow);
  if (through() && in.entering.valid()) d.sample(in.entering);
  d.colour(in.colour);
  d.depth(in.depth);
  return {in.colour, in.depth};
}

FinalPass::Pipelines FinalPass::make_pipelines(gpu::PipelineLibrary& library, Lit lit, bool off_map) const {
  const bool progressive = !settings.halvings.empty() && settings.halvings.back() > 0;
  const auto terms = static_cast<std::uint32_t>(settings.weights.size());
  const bool through = this->through() && lit != Lit::on_map;

  Pipelines out;
  for (const bool double_sided : {false, true})
    for (const bool cut_out : {false, true})
      for (const bool emits : {false, true}) {
        if ((cut_out && !settings.cut_out) || (emits && !settings.emits)) continue;
        gpu::GraphicsDesc desc{.vertex = "final_pass.vert",
                               .fragment = through ? "final_pass_through.frag" : "final_pass.frag",
                               .constants = {{"term_count", lit == Lit::at_pixel ? 0u : terms},
                                             {"direct", lit != Lit::on_map ? 1u : 0u},
                                             {"environment", settings.environment ? 1u : 0u},
                                             {"soft_shadows", settings.soft_shadows ? 1u : 0u},
                                             {"progressive", progressive ? 1u : 0u},
                                             {"summed", settings.summed ? 1u : 0u},
                                             {"off_map", off_map ? 1u : 0u},
                                             {"coarse", settings.terms.coarse ? 1u : 0u},
                                             {"cut_out", cut_out ? 1u : 0u},
                                             {"emits", emits ? 1u : 0u}},
                               .colour_formats = {settings.format.colour},
                               .depth_format = settings.format.depth,
                               .samples = settings.samples,
                               .cull = double_sided ? gpu::Cull::none : gpu::Cull::back,
                               .depth_test = true,
                               .depth_write = true,
                               .depth_compare = settings.format.nearer()};
        if (through) {
          desc.constants.emplace_back("through_terms", terms);
          desc.constants.emplace_back("entering_stored", in.entering.valid() ? 1u : 0u);
        }
        out.made[double_sided][cut_out][emits] = &library.graphics(desc);
      }
  return out;
}

const FinalPass::Pipelines& FinalPass::pipelines_of(const GpuDraw& draw, Lit lit) const {
  if (!draw.on_map) return off_map_;
  switch (lit) {
    case Lit::on_map: return mapped_;
    case Lit::mixed: return mixed_;
    case Lit::at_pixel: break;
  }
  return at_pixel_;
}

FinalPass::Lit FinalPass::lit_of(const Instance& instance) const {
  bool mixed = settings.terms.coarse, mapped = settings.weights.empty();
  for (std::size_t i = 0; i < settings.weights.size(); ++i) {
    const float share = share_of(i, instance);
    mixed = mixed || share > 0;
    mapped = mapped || share < 1;
  }
  if (!mapped) return Lit::at_pixel;
  return mixed ? Lit::mixed : Lit::on_map;
}

void FinalPass::prepare(gpu::PipelineLibrary& library) {
  mapped_ = make_pipelines(library, settings.weights.empty() ? Lit::at_pixel : Lit::on_map, false);
  terms_ = make_terms(library.device(), settings.terms);
  if (settings.mixes || settings.terms.coarse) mixed_ = make_pipelines(library, Lit::mixed, false);
  if (settings.mixes) at_pixel_ = make_pipelines(library, Lit::at_pixel, false);
  if (settings.off_map) off_map_ = make_pipelines(library, Lit::at_pixel, true);
  if (through()) through_ = ThroughBindings(library, {*settings.through});
  samplers_ = LightingSamplers(library);
}

io::FinalPassIo FinalPass::final_io(const FrameData& frame) const {
  const Instance& instance = instance_of(frame, settings.square);
  io::FinalPassIo io{.weights = {},
                     .map_origin = used_square(frame, settings.square).origin,
                     .map_side = instance.map_side,
                     .slot = 0,
                     .halvings = 0};

  for (std::size_t i = 0; i < settings.weights.size(); ++i) {
    const auto& [r, g, b] = settings.weights[i];
    io.weights[i] = (1 - share_of(i, instance)) * glm::vec3(r, g, b);

    // In 4 bits how often the term's map is halved.
    const std::uint32_t side =
        halved_side(instance.map_side, settings.terms.largest_side, settings.halvings[i]);
    while (instance.map_side >> (io.halvings >> 4 * i & 15u) > side) io.halvings += 1u << 4 * i;
  }
  return io;
}

float FinalPass::share_of(std::size_t term, const Instance& instance) const {
  if (!settings.mixes) return 0;
  return share_at_pixel(settings.terms.sigmas_mm[term], settings.texels_per_mm, settings.terms.largest_side,
                        instance.map_side);
}

void FinalPass::offer_light(Bindings& bindings, const frame::Resources& resources,
                            const Instance& instance) const {
  static constexpr std::array names{"light_0", "light_1", "light_2", "light_3",
                                    "light_4", "light_5", "light_6", "light_7"};
  static_assert(names.size() == MOST_TERMS);

  // A binding without a term is never read, but a sampled texture must be bound.
  for (std::size_t i = 0; i < names.size(); ++i)
    bindings.add(names[i], i < in.lights.size() ? resources.linear(in.lights[i])
                                                : resources.linear(instance.scene->white()));
  bindings.add("Terms", terms_);
}

void FinalPass::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const Instance& instance = instance_of(frame, settings.square);
  if (!instance.is_drawn() && !settings.clear) return;

  begin_picture(cmd, resources.texture(in.colour), resources.texture(in.depth), settings.clear, frame.area);
  if (instance.is_drawn()) {
    const std::uint32_t mesh = mesh_in_asset(frame, settings.square);
    Bindings bindings;
    bindings.add("Frame", frame.frame_io);
    samplers_.offer(bindings, frame, instance, resources.texture(in.shadow));
    samplers_.offer_sky(bindings, instance, mesh);
    if (through()) through_.offer(bindings, resources, in.entering, in.shadow, 0);
    offer_light(bindings, resources, instance);

    const Lit lit = lit_of(instance);
    draw_skin(
        cmd, instance, mesh, bindings,
        [&](const GpuDraw& draw, const GpuMaterial& material) {
          return pipelines_of(draw, lit).of(material);
        },
        [&, io = final_io(frame)](const GpuMaterial&) { return io; }, first_corners(instance, mesh));
  }
  cmd.end_rendering();
}

}  // namespace dermis::passes
