// SPDX-License-Identifier: MIT
#include "gaussians/scatter_profile.h"

#include <cmath>

#include "core/channels.h"
#include "core/error.h"
#include "core/one_line.h"
#include "gaussians/shape_json.h"
#include "optics/media.h"
#include "profile/shape_laws.h"

namespace dermis::gaussians {

namespace {

void check_variances(const ScatterProfile& profile, const std::string& where) {
  const std::vector<double>& v = profile.variances_mm2;
  if (v.empty() || v.size() > max_terms)
    throw input_error(where, "variances_mm2 must have 1 to {} terms, has {}", max_terms, v.size());
  if (profile.weights.size() != v.size())
    throw input_error(where, "weights must have as many terms as variances_mm2, {}, has {}", v.size(),
                      profile.weights.size());

  for (std::size_t i = 0; i < v.size(); ++i) {
    if (!(v[i] > 0) || !std::isfinite(v[i]))
      throw input_error(where, "variances_mm2[{}] must be > 0 mm^2 and finite, got {}", i, v[i]);
    if (i > 0 && !(v[i] > v[i - 1]))
      throw input_error(where, "variances_mm2 must rise, but {} follows {}", v[i], v[i - 1]);
  }
}

void check_weights(const ScatterProfile& profile, const std::string& where) {
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0;
    for (std::size_t i = 0; i < profile.weights.size(); ++i) {
      const double weight = profile.weights[i][c];
      if (!(weight >= 0) || !std::isfinite(weight))
        throw input_error(where, "weights[{}] of {} must be >= 0 and finite, got {}", i, channel_names[c],
                          weight);
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

SumOfGaussians checked_sum(const ScatterProfile& profile, const std::string& where) {
  const std::string place = where.empty() ? fmt::format("profile '{}'", one_line(profile.name, 80)) : where;
  check_variances(profile, place);
  check_weights(profile, place);
  check_numbers(profile, place);
  if (profile.medium) optics::check(optics::rgb_medium(*profile.medium), place + ": medium");
  if (profile.shape) check_shape(*profile.shape, place);
  if (profile.shape && !profile.medium)
    throw input_error(place, "shape needs the medium that it is of: medium is not given");

  SumOfGaussians sum{.name = profile.name,
                     .model = profile.model,
                     .terms = {},
                     .total_reflectance = profile.total_reflectance,
                     .error_percent = profile.error_percent,
                     .mean_free_path_mm = profile.mean_free_path_mm,
                     .diffuse_mean_free_path_mm = profile.diffuse_mean_free_path_mm,
                     .medium = profile.medium,
                     .shape = profile.shape};
  for (std::size_t i = 0; i < profile.weights.size(); ++i)
    sum.terms.push_back({profile.variances_mm2[i], profile.weights[i]});
  if (sum.medium && !sum.shape) sum.shape = profile::shape_laws(optics::rgb_medium(*sum.medium));
  return sum;
}

ScatterProfile scatter_profile(const SumOfGaussians& sum) {
  ScatterProfile profile;
  profile.name = sum.name;
  profile.model = sum.model;
  for (const Gaussian& term : sum.terms) {
    profile.variances_mm2.push_back(term.variance_mm2);
    profile.weights.push_back(term.weight);
  }
  profile.error_percent = sum.error_percent;
  profile.total_reflectance = sum.total_reflectance;
  profile.model_total = sum.total_reflectance;
  profile.mean_free_path_mm = sum.mean_free_path_mm;
  profile.diffuse_mean_free_path_mm = sum.diffuse_mean_free_path_mm;
  profile.medium = sum.medium;
  profile.shape = sum.shape;
  return profile;
}

}  // namespace dermis::gaussians
