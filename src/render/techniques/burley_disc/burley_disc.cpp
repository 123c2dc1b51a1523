// SPDX-License-Identifier: MIT
#include "render/techniques/burley_disc/burley_disc.h"

#include <algorithm>

#include "render/passes/screen/disc_gather/disc_gather.h"
#include "render/techniques/screen.h"
#include "render/techniques/screen_space.h"
#include "tissue/gaussians/screen_kernels.h"

namespace dermis::techniques {
namespace {

constexpr TapRange disc_taps_range{.least = 1, .most = 4096, .usual = 64};
constexpr double reach_share = 0.997;

// Of a profile without width the disc has none either; nothing of its light is blurred.
bool spreads(const PlannedMesh& part) {
  return std::ranges::any_of(part.profile.terms, [](const Gaussian& term) {
    return term.weight[0] > 0 || term.weight[1] > 0 || term.weight[2] > 0;
  });
}

std::uint32_t disc_taps_per_pixel(const FrameSettings& settings) {
  return settings.taps > 0 ? settings.taps : disc_taps_range.usual;
}

passes::Disc disc_of(const FrameSettings& settings, const PlannedMesh& part) {
  const auto taps = static_cast<int>(disc_taps_per_pixel(settings));
  passes::Disc disc{.taps = std::vector<gaussians::DiscTap>(static_cast<std::size_t>(taps)),
                    .profile = part.profile,
                    .burley_mm = {1, 1, 1},
                    .reach_mm = 0,
                    .mm_per_unit = part.mm_per_unit};
  if (!spreads(part)) return disc;

  if (settings.kernel == ScreenKernel::published) {
    // A channel that does not spread would have a pole: a hundredth of a mm is far below a pixel.
    disc.burley_mm = gaussians::burley_distances_mm(part.profile);
    for (double& d : disc.burley_mm) d = std::max(d, 0.01);
    disc.taps = gaussians::burley_disc_taps(disc.burley_mm, taps);
    disc.reach_mm =
        *std::ranges::max_element(disc.burley_mm) * gaussians::burley_radius_of_share(reach_share);
  } else {
    disc.taps = gaussians::disc_taps(part.profile, taps);
    disc.reach_mm = gaussians::disc_reach_mm(part.profile, reach_share);
  }
  return disc;
}

frame::TextureId add_disc(passes::FramePlan& plan, const FrameSettings& settings,
                          const passes::ScreenSurface& surface) {
  passes::DiscGather::Settings gather{.discs = {},
                                      .burley = settings.kernel == ScreenKernel::published,
                                      .ue = settings.kernel == ScreenKernel::ue};
  for (const PlannedMesh& part : settings.skin) gather.discs.push_back(disc_of(settings, part));
  return plan.add<passes::DiscGather>("disc", {surface}, gather).light;
}

FrameOutputs build_burley_disc(passes::FramePlan& plan, const FrameSettings& settings) {
  return build_in_screen_space(plan, settings, {.blurred = scattered_share, .add = add_disc});
}

}  // namespace

constinit const Technique burley_disc{
    .name = "burley-disc",
    .summary = "light gathered in the picture from a disc of taps (Christensen and Burley 2015)",
    .uses_profile = true,
    .has_light_maps = false,
    .screen_space = true,
    .ue_kernel = true,
    .taps = disc_taps_range,
    .taps_per_pixel = disc_taps_per_pixel,
    .build = build_burley_disc,
    .maps = screen_maps,
    .report = screen_report,
    .gutters = no_gutters};

}  // namespace dermis::techniques
