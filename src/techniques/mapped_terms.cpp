// SPDX-License-Identifier: MIT
#include "techniques/mapped_terms.h"

#include <algorithm>
#include <cmath>

#include "passes/blur/blur.h"
#include "passes/final_pass/skin_shading.h"
#include "passes/kernels.h"
#include "techniques/cascade_plan.h"

namespace dermis::techniques {
namespace {

// Returns the narrowest term with a weight on the map, the number of terms if there is none. The share per
// pixel falls with the width of a term, so all wider terms have a weight, too.
std::uint32_t first_read(const FrameSettings& settings, const SkinPart& part, std::uint32_t side) {
  const auto texels_per_mm = static_cast<float>(part.mean_texels_per_mm);
  std::uint32_t term = 0;
  for (const gaussians::Gaussian& gaussian : part.profile.terms) {
    const auto sigma_mm = static_cast<float>(std::sqrt(gaussian.variance_mm2));
    if (passes::share_at_pixel(sigma_mm, texels_per_mm, settings.map_size, side) < 1) break;
    ++term;
  }
  return term;
}

// Returns what a cascade needs to know: which terms it spreads from the light itself, with which step it
// ends, and the weights, of which the sum consists.
passes::MappedTerms cascade_terms(const FrameSettings& settings, const SkinPart& part, std::uint32_t side) {
  const CascadePlan cascade = cascade_plan(settings, part);
  passes::MappedTerms terms;
  if (settings.terms_by_need()) terms.first_read = first_read(settings, part, side);
  terms.any = terms.first_read < part.profile.terms.size();
  if (!terms.any) return terms;

  const double texels_per_mm = part.mean_texels_per_mm * side / settings.map_size;
  const std::uint32_t narrow =
      passes::narrow_terms(cascade.variances_mm2, texels_per_mm, cascade.most_narrow);
  const std::uint32_t done = std::max(narrow, terms.first_read);  // without wide steps
  terms.first_wide = narrow;
  terms.first_step = cascade.first_step_over(done == 0 ? 0 : cascade.variances_mm2[done - 1]);

  for (std::size_t i = 0; i < part.profile.terms.size(); ++i) {
    const gaussians::Gaussian& term = part.profile.terms[i];
    const float at_pixel =
        settings.mixes()
            ? passes::share_at_pixel(static_cast<float>(std::sqrt(term.variance_mm2)),
                                     static_cast<float>(part.mean_texels_per_mm), settings.map_size, side)
            : 0.0f;
    for (std::size_t c = 0; c < 3; ++c)
      terms.weights[i][c] = (1 - at_pixel) * static_cast<float>(term.weight[c]);
  }
  return terms;
}

}  // namespace

passes::MappedTerms mapped_terms(const FrameSettings& settings, std::uint32_t mesh, std::uint32_t side) {
  const SkinPart& part = settings.skin[mesh];
  if (settings.cascade) return cascade_terms(settings, part, side);
  if (!settings.terms_by_need()) return {};
  passes::MappedTerms terms{.first_read = first_read(settings, part, side)};
  terms.any = terms.first_read < part.profile.terms.size();
  if (!terms.any || terms.first_read == 0) return terms;

  // From the irradiance, one kernel reaches as far as the first step of blur_steps() does at T_max, counted
  // in texels of this map. The chain starts with the last step within that reach.
  const double max_texels_per_mm = part.max_texels_per_mm * side / settings.map_size;
  const double reach_mm = passes::kernel_max_sigma / max_texels_per_mm;
  double total_mm2 = 0;
  std::uint32_t number = 0, term = 0;
  for (const passes::BlurStep& step : passes::blur_steps(part.profile, part.max_texels_per_mm)) {
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
                                                 std::uint32_t side) {
  std::vector<passes::MappedTerms> terms;
  for (std::uint32_t i = 0; i < model.meshes; ++i)
    terms.push_back(mapped_terms(settings, model.first_mesh + i, side));
  return terms;
}

int mapped_count(const FrameSettings& settings, std::uint32_t mesh, std::uint32_t side) {
  const passes::MappedTerms terms = mapped_terms(settings, mesh, side);
  if (!terms.any) return 0;
  return static_cast<int>(settings.skin[mesh].profile.terms.size()) - static_cast<int>(terms.first_read);
}

}  // namespace dermis::techniques
