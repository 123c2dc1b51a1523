// SPDX-License-Identifier: MIT
#include "render/passes/pixels/shade/skin_shading.h"

#include <algorithm>
#include <array>
#include <utility>

#include "frame/resources.h"

namespace dermis::passes {
namespace {

double mean(const std::array<double, 3>& rgb) { return (rgb[0] + rgb[1] + rgb[2]) / 3; }

io::ShapeIo shape_io(const ShapeLaws& laws) {
  const auto rgb = [](const std::array<double, 3>& values) {
    return glm::vec3(values[0], values[1], values[2]);
  };
  return {.curvature_mm = rgb(laws.curvature_mm),
          .convex_mm = rgb(laws.convex_mm),
          .concave_mm = rgb(laws.concave_mm),
          .difference_mm = rgb(laws.difference_mm),
          .difference_mm2 = rgb(laws.difference_mm2),
          .front_share = rgb(laws.front_share),
          .front_per_mm = 1.0f / rgb(laws.front_mm),
          .exit_grazing = rgb(laws.exit_grazing),
          .exit_change = rgb(laws.exit_normal) - rgb(laws.exit_grazing)};
}

// Returns the uniform buffer that shaders bind as "Terms": ThroughTermsIo, of which the first part is all
// that shaders without transmitted light declare.
gpu::Buffer make_terms(gpu::Device& device, const SkinLook& look) {
  io::ThroughTermsIo io{};
  for (std::size_t i = 0; i < look.terms.size(); ++i) {
    io.terms.sigma_mm[i] = look.terms[i].sigma_mm;
    io.terms.widest_mm = std::max(io.terms.widest_mm, look.terms[i].sigma_mm);
  }
  if (look.shape) {
    io.terms.shape = shape_io(*look.shape);
    io.terms.exit_offset_m = static_cast<float>(mean(look.shape->exit_offset_mm) / look.mm_per_unit);
    io.terms.m_per_mm = static_cast<float>(1 / look.mm_per_unit);
  }
  if (look.through) {
    io.transmission =
        transmission_io(look.through->profile, look.through->mm_per_unit, look.through->first_mapped);
    io.terms.first_mapped = look.through->first_mapped;
  }
  return gpu::make_buffer(device, "skin terms", std::span<const io::ThroughTermsIo>(&io, 1),
                          VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
}

}  // namespace

SkinShading::SkinShading(SkinLook look, SkinLights lights)
    : look_(std::move(look)), lights_(std::move(lights)) {
  DERMIS_ASSERT_EQ(lights_.maps.size(), look_.terms.size());
  DERMIS_ASSERT_LE(lights_.maps.size(), std::size_t{MOST_TERMS});
}

void SkinShading::declare(frame::Declare& d) const {
  for (const frame::TextureId map : lights_.maps) d.sample(map);
  d.sample(lights_.shadow);
  if (through() && lights_.entering.valid()) d.sample(lights_.entering);
}

void SkinShading::prepare(gpu::PipelineLibrary& library) {
  terms_ = make_terms(library.device(), look_);
  if (through()) through_ = ThroughBindings(library, {*look_.through}, true);
  samplers_ = LightingSamplers(library);
}

std::vector<SkinVariant> SkinShading::variants() const {
  using Lit = SkinVariant::Lit;
  std::vector<SkinVariant> lit{{.lit = look_.terms.empty() ? Lit::at_pixel : lit_by_maps()}};
  if (look_.mixes && !look_.terms.empty()) lit.push_back({.lit = Lit::at_pixel});
  if (look_.off_map) lit.push_back({.lit = Lit::at_pixel, .off_map = true});

  std::vector<SkinVariant> all;
  for (SkinVariant variant : lit)
    for (const bool cut_out : {false, true})
      for (const bool emits : {false, true})
        for (const bool detailed : {false, true}) {
          variant.kind = {.cut_out = cut_out, .emits = emits, .detailed = detailed};
          if (look_.kinds[variant.kind.index()]) all.push_back(variant);
        }
  return all;
}

SkinVariant SkinShading::variant_of(const FrameData& frame, const GpuDraw& draw,
                                    const GpuMaterial& material) const {
  return {.lit = draw.on_map ? lit_of(frame) : SkinVariant::Lit::at_pixel,
          .off_map = !draw.on_map,
          .kind = {.cut_out = material.cut_out, .emits = material.emits, .detailed = material.detailed}};
}

SkinVariant::Lit SkinShading::lit_of(const FrameData& frame) const {
  if (look_.terms.empty() || !terms_of(frame, look_.square).any) return SkinVariant::Lit::at_pixel;
  return lit_by_maps();
}

bool SkinShading::through(const SkinVariant& variant) const {
  return through() && variant.lit != SkinVariant::Lit::on_map;
}

gpu::Constants SkinShading::entry_constants(const SkinVariant& variant) const {
  gpu::Constants constants{
      {"environment", look_.environment ? 1u : 0u},  {"soft_shadows", look_.soft_shadows ? 1u : 0u},
      {"off_map", variant.off_map ? 1u : 0u},        {"emits", variant.kind.emits ? 1u : 0u},
      {"detailed", variant.kind.detailed ? 1u : 0u}, {"multisampled", look_.samples > 1 ? 1u : 0u},
      {"light_samples", look_.light_samples}};
  if (!through(variant)) return constants;
  const std::size_t terms = look_.through->profile.terms.size();
  constants.emplace_back("through_terms", static_cast<std::uint32_t>(terms));
  constants.emplace_back("slab_gains", look_.through->profile.shape ? 1u : 0u);
  constants.emplace_back("entering_stored", lights_.entering.valid() ? 1u : 0u);
  return constants;
}

gpu::Constants SkinShading::constants(const SkinVariant& variant) const {
  const auto terms = static_cast<std::uint32_t>(look_.terms.size());
  const bool at_pixel = variant.lit == SkinVariant::Lit::at_pixel;
  gpu::Constants constants = entry_constants(variant);
  constants.insert(constants.end(),
                   {{"term_count", at_pixel ? 0u : terms},
                    {"entered_term", look_.reads_entered() && !at_pixel ? terms - 1 : ~0u},
                    {"direct", variant.lit != SkinVariant::Lit::on_map ? 1u : 0u},
                    {"mixed", look_.mixes && variant.lit == SkinVariant::Lit::mixed ? 1u : 0u},
                    {"shape_aware", look_.shape ? 1u : 0u},
                    {"cut_out", variant.kind.cut_out ? 1u : 0u}});
  return constants;
}

io::ShadeIo SkinShading::io(const FrameData& frame) const {
  const MappedTerms mapped = terms_of(frame, look_.square);
  const bool at_pixel = look_.terms.empty() || look_.off_map || !mapped.any;
  const UsedSquare used = used_square(frame, look_.square);
  io::ShadeIo io{.weights = {},
                 .map_origin = used.origin.x | used.origin.y << 16,
                 .side = used.side,
                 .shown_mm = mapped.shown_mm,
                 .through_rays = at_pixel ? 1u : 0u,
                 .part = 0,
                 .first_triangle = 0,
                 .first_row = 0,
                 .width = 0};
  for (std::size_t i = 0; i < look_.terms.size(); ++i) {
    io.weights[i] = mapped.shares[i] * look_.terms[i].weight;
    if (look_.terms[i].sigma_mm > 0 && mapped.shares[i] < 1) io.through_rays = 1;
  }
  return io;
}

void SkinShading::offer_maps(Bindings& bindings, const frame::Resources& resources, const Head& head) const {
  static constexpr std::array names{"light_0", "light_1", "light_2", "light_3",
                                    "light_4", "light_5", "light_6", "light_7"};
  static_assert(names.size() == MOST_TERMS);

  // A binding without a term is never read, but a sampled texture must be bound.
  for (std::size_t i = 0; i < names.size(); ++i)
    bindings.add(names[i], i < lights_.maps.size() ? resources.linear(lights_.maps[i])
                                                   : resources.linear(head.asset->white()));
  bindings.add("Terms", terms_);
}

void SkinShading::offer(Bindings& bindings, const frame::Resources& resources, const FrameData& frame) const {
  const Head& head = head_of(frame, look_.square);
  bindings.add("Frame", frame.frame_io);
  samplers_.offer(bindings, frame, head, resources.texture(lights_.shadow));
  samplers_.offer_sky(bindings, head, mesh_in_asset(frame, look_.square));
  if (through()) through_.offer(bindings, resources, lights_.entering, lights_.shadow, 0);
  offer_maps(bindings, resources, head);
}

}  // namespace dermis::passes
