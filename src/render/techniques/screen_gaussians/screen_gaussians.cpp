// SPDX-License-Identifier: MIT
#include "render/techniques/screen_gaussians/screen_gaussians.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/passes/screen/screen_gaussian/screen_gaussian.h"
#include "render/techniques/screen.h"
#include "render/techniques/screen_space.h"
#include "tissue/gaussians/screen_kernels.h"

namespace dermis::techniques {
namespace {

// Taps of one axis of one Gaussian; those of the authors are always seven.
constexpr TapRange gaussian_taps{.least = 5, .most = 13, .usual = 13, .odd = true, .published = 7};

// The published skin has a part that is not blurred, whatever the profile, unless no light is to scatter at
// all.
gaussians::Rgb share_of_gaussians(const FrameSettings& settings, const PlannedMesh& part) {
  gaussians::Rgb share = scattered_share(settings, part);
  if (settings.kernel != ScreenKernel::published || share == gaussians::Rgb{}) return share;
  for (std::size_t c = 0; c < 3; ++c) share[c] = 1 - gaussians::published_skin_gaussians().unblurred[c];
  return share;
}

// The steps of the chain of a skin mesh, narrow to wide, with weights that sum to 1.
std::vector<passes::GaussianStep> gaussian_steps(const FrameSettings& settings, const PlannedMesh& part) {
  const std::vector<Gaussian> terms = settings.kernel == ScreenKernel::published
                                          ? gaussians::published_skin_gaussians().terms
                                          : part.profile.terms;
  gaussians::Rgb sum{};
  for (const Gaussian& term : terms)
    for (std::size_t c = 0; c < 3; ++c) sum[c] += term.weight[c];

  std::vector<passes::GaussianStep> steps;
  double done_mm2 = 0;
  for (const Gaussian& term : terms) {
    passes::GaussianStep step{.variance_mm2 = term.variance_mm2 - done_mm2,
                              .weight = term.weight,
                              .mm_per_unit = part.mm_per_unit,
                              .reach_mm = gaussians::line_kernel_reach_mm(part.profile)};
    for (std::size_t c = 0; c < 3; ++c) step.weight[c] /= sum[c] > 0 ? sum[c] : 1;
    steps.push_back(step);
    done_mm2 = term.variance_mm2;
  }
  return steps;
}

std::uint32_t gaussian_taps_of(const FrameSettings& settings) {
  return settings.taps > 0 ? settings.taps : gaussian_taps.usual;
}

// In two passes per Gaussian of the longest chain; the authors take seven in each.
std::uint32_t gaussian_taps_per_pixel(const FrameSettings& settings) {
  const bool published = settings.kernel == ScreenKernel::published;
  std::size_t longest = 0;
  for (const PlannedMesh& part : settings.skin)
    longest = std::max(longest, gaussian_steps(settings, part).size());
  return static_cast<std::uint32_t>(longest) * 2 *
         (published ? gaussian_taps.published : gaussian_taps_of(settings));
}

frame::TextureId add_gaussians(passes::FramePlan& plan, const FrameSettings& settings,
                               const passes::ScreenSurface& surface) {
  std::vector<std::vector<passes::GaussianStep>> chains;
  std::size_t longest = 0;
  for (const PlannedMesh& part : settings.skin) {
    chains.push_back(gaussian_steps(settings, part));
    longest = std::max(longest, chains.back().size());
  }

  const auto taps = static_cast<int>(gaussian_taps_of(settings));
  const gpu::TextureDesc desc = passes::screen_light(settings.width, settings.height);
  const frame::TextureId half = plan.texture("half blurred light", desc),
                         whole = plan.texture("blurred light", desc),
                         sum = plan.texture("sum of blurred light", desc);
  for (std::size_t i = 0; i < longest; ++i) {
    passes::ScreenGaussian::Settings blur{.steps = {},
                                          .axis = 0,
                                          .radius = taps / 2,
                                          .published = settings.kernel == ScreenKernel::published,
                                          .begins = i == 0};
    for (const std::vector<passes::GaussianStep>& chain : chains)
      blur.steps.push_back(i < chain.size() ? chain[i] : passes::GaussianStep{});
    plan.add<passes::ScreenGaussian>(fmt::format("gaussian {} 1", i),
                                     {i == 0 ? surface.light : whole, half, sum, surface}, blur);
    blur.axis = 1;
    plan.add<passes::ScreenGaussian>(fmt::format("gaussian {} 2", i), {half, whole, sum, surface}, blur);
  }
  return sum;
}

FrameOutputs build_screen_gaussians(passes::FramePlan& plan, const FrameSettings& settings) {
  return build_in_screen_space(plan, settings, {.blurred = share_of_gaussians, .add = add_gaussians});
}

}  // namespace

constinit const Technique screen_gaussians{
    .name = "screen-gaussians",
    .summary = "light blurred in the picture by each Gaussian (Jimenez, Sundstedt, Gutierrez 2009)",
    .uses_profile = true,
    .has_light_maps = false,
    .screen_space = true,
    .taps = gaussian_taps,
    .taps_per_pixel = gaussian_taps_per_pixel,
    .build = build_screen_gaussians,
    .maps = screen_maps,
    .report = screen_report,
    .gutters = no_gutters};

}  // namespace dermis::techniques
