// SPDX-License-Identifier: MIT
#include "tissue/gaussians/scatter_profile.h"

#include <cmath>

#include "base/core/channels.h"
#include "base/core/error.h"
#include "base/core/one_line.h"
#include "tissue/gaussians/shape_json.h"
#include "tissue/optics/media.h"
#include "tissue/profile/shape_laws.h"

namespace dermis::gaussians {

namespace {

void check_terms(const ScatterProfile& profile, const std::string& where) {
  const std::vector<Gaussian>& terms = profile.terms;
  if (terms.empty() || terms.size() > max_terms)
    throw input_error(where, "terms must be 1 to {}, there are {}", max_terms, terms.size());
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const double v = terms[i].variance_mm2;
    if (!(v > 0) || !std::isfinite(v))
      throw input_error(where, "terms[{}].variance_mm2 must be > 0 mm^2 and finite, got {}", i, v);
    if (i > 0 && !(v > terms[i - 1].variance_mm2))
      throw input_error(where, "variances of terms must rise, but {} follows {}", v,
                        terms[i - 1].variance_mm2);
  }

  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0;
    for (std::size_t i = 0; i < terms.size(); ++i) {
      const double weight = terms[i].weight[c];
      if (!(weight >= 0) || !std::isfinite(weight))
        throw input_error(where, "terms[{}].weight of {} must be >= 0 and finite, got {}", i,
                          channel_names[c], weight);
      sum += weight;
    }
    if (!(std::abs(sum - 1) <= weight_tolerance))
      throw input_error(where, "weights of {} must sum to 1 within {}, they sum to {:.6g}", channel_names[c],
                        weight_tolerance, sum);
  }
}

/// Checks the numbers of a profile beside its terms.
void check_numbers(const ScatterProfile& profile, const std::string& where) {
  const auto check = [&](const char* name, const Rgb& values, double most) {
    for (std::size_t c = 0; c < 3; ++c) {
      if (values[c] >= 0 && values[c] <= most && std::isfinite(values[c])) continue;
      const std::string range = most < HUGE_VAL ? fmt::format("0 to {}", most) : ">= 0 and finite";
      throw input_error(where, "{} of {} must be {}, got {}", name, channel_names[c], range, values[c]);
    }
  };
  check("error_percent", profile.error_percent, HUGE_VAL);
  check("total_reflectance", profile.total_reflectance, 1);
  check("mean_free_path_mm", profile.mean_free_path_mm, HUGE_VAL);
  check("diffuse_mean_free_path_mm", profile.diffuse_mean_free_path_mm, HUGE_VAL);
}

}  // namespace

ScatterProfile checked_profile(const ScatterProfile& profile, const std::string& where) {
  const std::string place = where.empty() ? fmt::format("profile '{}'", one_line(profile.name, 80)) : where;
  check_terms(profile, place);
  check_numbers(profile, place);
  if (profile.medium) optics::check(optics::rgb_medium(*profile.medium), place + ": medium");
  if (profile.shape) check_shape(*profile.shape, place);
  if (profile.shape && !profile.medium)
    throw input_error(place, "shape needs the medium that it is of: medium is not given");

  ScatterProfile checked = profile;
  checked.model_total = checked.noise_percent = checked.missing_light = {};
  checked.model_reason.clear();
  checked.model_curves.reset();
  if (checked.medium && !checked.shape)
    checked.shape = profile::shape_laws(optics::rgb_medium(*checked.medium));
  return checked;
}

}  // namespace dermis::gaussians
