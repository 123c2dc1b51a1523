// SPDX-License-Identifier: MIT
#include "render/techniques/sides_by_need.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/techniques/mapped_terms.h"

namespace dermis::techniques {
namespace {

constexpr std::uint32_t least_side = 32;

// Returns the texels of a side on which the narrowest term is held for which `wanted`, at these pixels per
// mm; 0: there is none.
template <class Wanted>
double texels_for(const PlannedMesh& part, double pixels_per_mm, const Wanted& wanted) {
  if (!(part.mean_uv_per_mm > 0)) return 0;
  for (const Gaussian& term : part.profile.terms) {
    const double sigma_mm = std::sqrt(term.variance_mm2);
    if (wanted(sigma_mm))
      return held_sigma_texels(part, sigma_mm, pixels_per_mm) / (sigma_mm * part.mean_uv_per_mm);
  }
  return 0;
}

}  // namespace

std::vector<std::uint32_t> sides_by_need(std::uint32_t most) {
  std::vector<std::uint32_t> sides{most};
  std::uint32_t power = least_side;
  while (power <= most / 2) power *= 2;
  for (; power >= least_side; power /= 2)
    for (const std::uint32_t side : {power + power / 2, power})
      if (side < sides.back()) sides.push_back(side);
  return sides;
}

std::uint32_t side_of(double texels, std::uint32_t most) {
  const std::vector<std::uint32_t> sides = sides_by_need(most);
  const auto smaller =
      std::ranges::find_if(sides, [&](std::uint32_t side) { return static_cast<double>(side) < texels; });
  return smaller == sides.begin() ? sides.front() : *(smaller - 1);
}

std::uint32_t near_side(const PlannedMesh& part, std::uint32_t most) {
  const auto is_wide = [&](double sigma_mm) { return sigma_mm >= part.wide_mm; };
  return side_of(texels_for(part, std::numeric_limits<double>::infinity(), is_wide), most);
}

std::uint32_t side_by_need(const FrameSettings& settings, const Model& model, double pixels_per_mm,
                           std::uint32_t most) {
  double texels = 0;
  for (std::uint32_t mesh = model.first_mesh; mesh < model.first_mesh + model.meshes; ++mesh) {
    const PlannedMesh& part = settings.skin[mesh];
    const auto shows = [&](double sigma_mm) {
      return sigma_mm * pixels_per_mm > least_sigma_pixels(part, sigma_mm);
    };
    texels = std::max(texels, texels_for(part, pixels_per_mm, shows));
  }
  return side_of(texels, most);
}

}  // namespace dermis::techniques
