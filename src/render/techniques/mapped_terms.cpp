// SPDX-License-Identifier: MIT
#include "render/techniques/mapped_terms.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "render/passes/scatter/blur/blur.h"
#include "render/passes/scatter/kernels.h"

namespace dermis::techniques {
namespace {

// Sigma, in texels at the mean density, below which a term is lit at the pixel everywhere, also where skin is
// denser: as map_read.glsl has it.
constexpr double mapped_sigma_texels = 0.35;

// Sigma, in pixels, by which a pixel averages light: as a map holds a term of some sigma, it holds light that
// is not blurred where pixels are that coarse. From 0.2 texels on in place of mapped_sigma_texels, pictures
// at their size had 1 to 4 % less error, and super-sampled ones 3 to 21 % more.
constexpr double pixel_sigma = 0.5;
// The rest stays lit at the pixel, where rims that are lit from behind are dark as they should be. The mean
// of both is nearer to the truth than either.
constexpr double most_entered_share = 0.5;

double smoothstep(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// Returns the part of a term that is read from the map.
float mapped_share(const PlannedMesh& part, double sigma_mm, const passes::MapDetail& detail) {
  if (sigma_mm * part.mean_uv_per_mm * detail.side < mapped_sigma_texels) return 0;
  const double over = sigma_mm * detail.pixels_per_mm / least_sigma_pixels(part, sigma_mm) - 1;
  return static_cast<float>(smoothstep(0, 0.5, over));
}

}  // namespace

// Fewer texels raise the error by 3 % on the scan where sigma is under 1.2 pixels, by 9 % in close-ups, and
// nearer than that a coarse unwrap shows its seams.
double held_sigma_texels(const PlannedMesh& part, double sigma_mm, double pixels_per_mm) {
  return sigma_mm >= part.wide_mm && sigma_mm * pixels_per_mm < 1.2 ? 0.7 : 0.9;
}

double least_sigma_pixels(const PlannedMesh& part, double sigma_mm) {
  if (sigma_mm < part.wide_mm) return 2.5;
  const bool widest = sigma_mm * sigma_mm >= part.profile.max_variance_mm2() * (1 - 1e-9);
  return widest ? 0.35 : 0.6;
}

float entered_share(const PlannedMesh& part, const passes::MapDetail& detail) {
  const double sigma_texels = pixel_sigma / detail.pixels_per_mm * part.mean_uv_per_mm * detail.side;
  const double most = smoothstep(mapped_sigma_texels, 1.5 * mapped_sigma_texels, sigma_texels);
  return static_cast<float>(most_entered_share * most);
}

std::uint32_t first_mapped(const PlannedMesh& part, const passes::MapDetail& finest) {
  std::uint32_t first = 0;
  for (const Gaussian& term : part.profile.terms) {
    const double sigma_mm = std::sqrt(term.variance_mm2);
    const bool wide = sigma_mm >= part.wide_mm;
    const passes::MapDetail detail{finest.side,
                                   wide ? std::numeric_limits<double>::infinity() : finest.pixels_per_mm};
    if (mapped_share(part, sigma_mm, detail) == 0) ++first;
  }
  return std::min(first, static_cast<std::uint32_t>(part.profile.terms.size()) - 1);
}

passes::MappedTerms mapped_terms(const FrameSettings& settings, std::uint32_t mesh,
                                 const passes::MapDetail& detail) {
  passes::MappedTerms terms;
  if (!settings.mixes()) return terms;

  const PlannedMesh& part = settings.skin[mesh];
  const std::span<const Gaussian> mapped = part.mapped();
  for (std::size_t i = 0; i < mapped.size(); ++i) {
    terms.shares[i] = mapped_share(part, std::sqrt(mapped[i].variance_mm2), detail);
    if (terms.shares[i] == 0) terms.first_read = static_cast<std::uint32_t>(i) + 1;
  }
  terms.any = terms.first_read < mapped.size();
  if (!terms.any) return terms;
  terms.shown_mm = static_cast<float>(pixel_sigma / detail.pixels_per_mm);
  if (part.reads_entered) terms.shares[mapped.size()] = entered_share(part, detail);

  // From the irradiance, one kernel reaches as far as the first step of blur_steps() does at T_max, counted
  // in texels of this map. The chain starts with the last step within that reach.
  const double reach_mm = passes::kernel_max_sigma / settings.chain_texels_per_mm(part, detail.side);
  double total_mm2 = 0;
  std::uint32_t number = 0, term = 0;
  for (const passes::BlurStep& step : passes::blur_steps(mapped, settings.chain_texels_per_mm(part))) {
    total_mm2 += step.variance_mm2;
    if (total_mm2 <= reach_mm * reach_mm) {
      terms.first_step = number;
      terms.first_written = term;
    }
    ++number;
    if (step.ends_term && term++ == terms.first_read) break;
  }
  return terms;
}

std::vector<passes::MappedTerms> mapped_terms_of(const FrameSettings& settings, const Model& model,
                                                 const passes::MapDetail& detail) {
  std::vector<passes::MappedTerms> terms;
  for (std::uint32_t i = 0; i < model.meshes; ++i)
    terms.push_back(mapped_terms(settings, model.first_mesh + i, detail));
  return terms;
}

std::size_t direct_steps(const FrameSettings& settings, const PlannedMesh& part) {
  constexpr std::size_t most = 2;
  if (!settings.mixes()) return 1;
  const double reach_mm = passes::kernel_max_sigma / settings.chain_texels_per_mm(part);
  const std::vector<std::size_t> groups = part.through_groups();
  const std::span<const Gaussian> mapped = part.mapped();
  std::size_t steps = 0;
  for (; steps < std::min(most, mapped.size()); ++steps) {
    const bool joined = settings.translucency && groups.size() > 1 && steps >= groups[1];
    if (joined || mapped[steps].variance_mm2 > reach_mm * reach_mm) break;
  }
  return std::max<std::size_t>(steps, 1);
}

int mapped_count(const FrameSettings& settings, std::uint32_t mesh, const passes::MapDetail& detail) {
  const passes::MappedTerms terms = mapped_terms(settings, mesh, detail);
  if (!terms.any) return 0;
  return static_cast<int>(settings.skin[mesh].mapped_count() - terms.first_read);
}

}  // namespace dermis::techniques
