// SPDX-License-Identifier: MIT
#include "render/techniques/separable/separable.h"

#include "render/passes/screen/separable_blur/separable_blur.h"
#include "render/techniques/screen.h"
#include "render/techniques/screen_space.h"
#include "tissue/gaussians/screen_kernels.h"

namespace dermis::techniques {
namespace {

constexpr TapRange line_taps_range{
    .least = gaussians::least_line_taps, .most = gaussians::most_line_taps, .usual = 25, .odd = true};

bool is_published(const FrameSettings& settings) { return settings.kernel == ScreenKernel::published; }

// The published kernel knows no profile, and has a part that stays where it is. It blurs all light, unless no
// light is to scatter at all.
gaussians::Rgb blurred(const FrameSettings& settings, const PlannedMesh& part) {
  const gaussians::Rgb share = scattered_share(settings, part);
  if (!is_published(settings)) return share;
  return share == gaussians::Rgb{} ? share : gaussians::Rgb{1, 1, 1};
}

std::uint32_t line_taps(const FrameSettings& settings) {
  return settings.taps > 0 ? settings.taps : line_taps_range.usual;
}

// Both passes.
std::uint32_t line_taps_per_pixel(const FrameSettings& settings) { return 2 * line_taps(settings); }

passes::LineKernel kernel_of(const FrameSettings& settings, const PlannedMesh& part) {
  const auto taps = static_cast<int>(line_taps(settings));
  return {.taps = is_published(settings) ? gaussians::published_line_kernel(taps)
                                         : gaussians::line_spread_kernel(part.profile, taps),
          .mm_per_unit = part.mm_per_unit,
          .reach_mm = gaussians::line_kernel_reach_mm(part.profile)};
}

frame::TextureId add_lines(passes::FramePlan& plan, const FrameSettings& settings,
                           const passes::ScreenSurface& surface) {
  passes::SeparableBlur::Settings blur{.kernels = {}, .axis = 0, .published = is_published(settings)};
  for (const PlannedMesh& part : settings.skin) blur.kernels.push_back(kernel_of(settings, part));
  const frame::TextureId rows =
      plan.add<passes::SeparableBlur>("separable 1", {surface.light, surface}, blur).light;
  blur.axis = 1;
  return plan.add<passes::SeparableBlur>("separable 2", {rows, surface}, blur).light;
}

FrameOutputs build_separable(passes::FramePlan& plan, const FrameSettings& settings) {
  return build_in_screen_space(plan, settings, {.blurred = blurred, .add = add_lines});
}

}  // namespace

constinit const Technique separable{
    .name = "separable",
    .summary = "light blurred in the picture by two passes (Jimenez et al. 2015)",
    .uses_profile = true,
    .has_light_maps = false,
    .screen_space = true,
    .taps = line_taps_range,
    .taps_per_pixel = line_taps_per_pixel,
    .build = build_separable,
    .maps = screen_maps,
    .report = screen_report,
    .gutters = no_gutters};

}  // namespace dermis::techniques
