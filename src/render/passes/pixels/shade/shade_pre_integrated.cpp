// SPDX-License-Identifier: MIT
#include "render/passes/pixels/shade/shade_pre_integrated.h"

#include <cmath>

#include "frame/resources.h"
#include "image/colour.h"
#include "render/passes/pixels/shade/pre_integrated_io.h"
#include "render/passes/pixels/shade/shade_parts.h"
#include "tissue/gaussians/pre_integrated.h"

namespace dermis::passes {
namespace {

constexpr int lit_columns = 256, lit_rows = 64, edge_columns = 256;

gpu::Texture upload_table(gpu::Device& device, const std::string& name, const gaussians::LightTable& table) {
  std::vector<std::uint16_t> halves;
  for (const gaussians::Rgb& light : table.light)
    for (std::size_t c = 0; c < 4; ++c)
      halves.push_back(image::float_to_half(c < 3 ? static_cast<float>(light[c]) : 1.0f));
  gpu::Texture texture(device, name,
                       {.width = static_cast<std::uint32_t>(table.columns),
                        .height = static_cast<std::uint32_t>(table.rows),
                        .format = VK_FORMAT_R16G16B16A16_SFLOAT,
                        .usage = VK_IMAGE_USAGE_SAMPLED_BIT});
  gpu::upload(device, texture, std::as_bytes(std::span(std::as_const(halves))));
  return texture;
}

}  // namespace

ShadePreIntegrated::Out ShadePreIntegrated::declare(frame::Declare& d) {
  d.kind(frame::PassKind::compute);
  DERMIS_ASSERT(settings.look.terms.empty());
  shading_ = SkinShading(settings.look, in.lights);
  shading_.declare(d);
  d.read(in.curvature);
  in.entries.declare_shading(d);
  return {};
}

void ShadePreIntegrated::prepare(gpu::PipelineLibrary& library) {
  const bool all_scatters = settings.scattered == std::array<float, 3>{1, 1, 1};
  for (const SkinVariant& variant : shading_.variants()) {
    gpu::Constants constants = shading_.entry_constants(variant);
    constants.emplace_back("shadow_taps", settings.shadow_taps);
    constants.emplace_back("unscattered", all_scatters ? 0u : 1u);
    pipelines_[variant.index()] = &library.compute(
        shading_.through(variant) ? "shade_pre_integrated_through.comp" : "shade_pre_integrated.comp",
        constants);
  }
  shading_.prepare(library);
  sampler_ = library.sampler({.filter = gpu::Filter::linear});

  gpu::Device& device = library.device();
  lit_ = upload_table(device, "lit table",
                      gaussians::lit_table(settings.profile, lit_columns, lit_rows, settings.ring));
  edge_ = upload_table(device, "edge table", gaussians::edge_table(settings.profile, edge_columns));
  const auto& [r, g, b] = settings.scattered;
  const io::PreIntegratedIo scatter{
      .scattered = {r, g, b},
      .mm_per_unit = static_cast<float>(settings.mm_per_unit),
      .normal_mm = static_cast<float>(std::sqrt(settings.profile.max_variance_mm2())),
      .filter_mm = static_cast<float>(gaussians::shadow_filter_mm(settings.profile)),
      .most_curvature_per_mm = static_cast<float>(gaussians::most_curvature_per_mm)};
  scatter_ =
      gpu::make_buffer(device, "pre-integrated skin", std::span<const io::PreIntegratedIo>(&scatter, 1),
                       VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
}

void ShadePreIntegrated::record(gpu::Cmd& cmd, const frame::Resources& resources,
                                const FrameData& frame) const {
  Bindings bindings;
  bindings.add("Curvature", resources.buffer(in.curvature))
      .add("PreIntegrated", scatter_)
      .add("lit_table", gpu::SampledBinding{&lit_, sampler_})
      .add("edge_table", gpu::SampledBinding{&edge_, sampler_});
  shade_parts(cmd, resources, frame, {settings.look.square, settings.first_part}, in.entries, shading_,
              pipelines_, bindings);
}

}  // namespace dermis::passes
