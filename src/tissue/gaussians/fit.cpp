// SPDX-License-Identifier: MIT
#include "tissue/gaussians/fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/core/assert.h"
#include "base/core/channels.h"
#include "base/core/error.h"
#include "base/core/hooks.h"
#include "base/core/parallel.h"
#include "tissue/gaussians/projection.h"

namespace dermis::gaussians {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using std::numbers::pi;

constexpr const char* work_name = "fitting Gaussians";
// Of a fit of three channels, whose other steps evaluate a profile each.
constexpr std::size_t search_steps = 3;

/// Bounds and starting points of the search.
struct Range {
  double low = 0, high = 0;  // log of the variance of the narrowest and the widest structure
  double floor = 0;          // lower bound of the log-variances
};

/// Minimises over the log-variances by Levenberg-Marquardt, until steps hardly reduce the residual.
Projected descend(std::span<const Target> channels, VectorXd& log_variance, const Range& range) {
  constexpr int most_steps = 150;
  Steps steps(work_name, most_steps);
  Projected here = project(channels, log_variance);
  double damping = 1e-3;

  for (int step = 0, stalled = 0; step < most_steps && stalled < 3 && damping < 1e9; ++step) {
    steps.done();
    Eigen::MatrixXd normal = here.normal;
    const double floor = 1e-12 * std::max(normal.trace(), 1e-300);
    for (Index j = 0; j < normal.rows(); ++j) normal(j, j) += damping * normal(j, j) + floor;
    VectorXd change = normal.ldlt().solve(-here.gradient);
    if (!change.allFinite()) break;

    // Limits the step to a factor of e in each variance.
    change *= std::min(1.0, 1.0 / std::max(change.cwiseAbs().maxCoeff(), 1e-300));
    VectorXd there_at = (log_variance + change).cwiseMax(range.floor).cwiseMin(range.high + 9);

    Projected there = project(channels, there_at);
    if (there.residual2 < here.residual2) {
      const bool stalls = here.residual2 - there.residual2 < 1e-9 * here.residual2;
      stalled = stalls ? stalled + 1 : 0;
      log_variance = there_at;
      here = std::move(there);
      // Where little of the profile can be fitted, steps overshoot to the other side of the optimum, equally
      // far: damping shortens them.
      damping = stalls ? std::max(damping * 4, 0.5) : std::max(damping * 0.2, 1e-12);
    } else {
      damping *= 4;
    }
  }

  return here;
}

VectorXd spread(const Range& range, Index count) {
  VectorXd start(count);
  for (Index j = 0; j < count; ++j) {
    const double part = count == 1 ? 0.5 : static_cast<double>(j) / static_cast<double>(count - 1);
    start[j] = range.low + (range.high - range.low) * part;
  }
  return start;
}

/// Returns starts with one more term than a solution: in its widest gap, or past either end.
std::vector<VectorXd> with_one_more(VectorXd smaller) {
  std::sort(smaller.begin(), smaller.end());
  std::vector<double> extra{smaller[0] - 1.5, smaller[smaller.size() - 1] + 1.5};
  Index widest = 0;
  for (Index j = 0; j + 1 < smaller.size(); ++j)
    if (smaller[j + 1] - smaller[j] > smaller[widest + 1] - smaller[widest]) widest = j;
  if (smaller.size() > 1) extra.push_back((smaller[widest] + smaller[widest + 1]) / 2);
  std::vector<VectorXd> starts;
  for (const double value : extra) {
    VectorXd start(smaller.size() + 1);
    start << smaller, value;
    starts.push_back(start);
  }
  return starts;
}

struct Solution {
  VectorXd log_variance;
  Projected projected;
};

/// Searches from three families of starts, because the residual has local minima (two terms sharing one
/// hump). They are evenly spread, spread over the upper part of the range, and grown from the solution with
/// one term fewer.
Solution search(std::span<const Target> channels, const Range& range, int terms) {
  Solution best;
  constexpr std::size_t most_descents = 6;
  Steps descents(work_name, terms > 1 ? most_descents : 2, search_steps);
  std::vector<VectorXd> starts{
      spread(range, terms),
      spread({.low = range.low + 0.2 * (range.high - range.low), .high = range.high}, terms)};
  if (terms > 1) {
    VectorXd smaller = spread(range, terms - 1);
    descend(channels, smaller, range);
    descents.done();
    for (VectorXd& start : with_one_more(smaller)) starts.push_back(std::move(start));
  }

  std::vector<Projected> ends(starts.size());
  parallel_for(starts.size(), [&](std::size_t i) {
    ends[i] = descend(channels, starts[i], range);
    descents.done();
  });
  for (std::size_t i = 0; i < starts.size(); ++i)
    if (best.log_variance.size() == 0 || ends[i].residual2 < best.projected.residual2)
      best = {starts[i], std::move(ends[i])};

  for (Index c = 0; c < best.projected.weights.cols(); ++c) {
    const bool finite = best.log_variance.allFinite() && best.projected.weights.col(c).allFinite() &&
                        std::isfinite(best.projected.residual2);
    const bool some = best.projected.weights.col(c).sum() > 0;
    if (!finite || !some) throw input_error(channels[c].where(), "no sum of Gaussians fits this profile");
  }

  return best;
}

Range range_of(const profile::RadialProfile& profile) {
  const double high = std::log(1.5 * profile.outer_mm() * profile.outer_mm());
  if (profile.has_pole()) {
    const double beam = std::log(core_variance_mm2(profile));
    return {.low = beam, .high = high, .floor = beam - 2};
  }
  const double low = std::log(0.15 * profile.inner_mm() * profile.inner_mm());
  return {.low = low, .high = high, .floor = low - 14};
}

std::vector<Index> narrow_to_wide(const VectorXd& log_variance) {
  std::vector<Index> order(static_cast<std::size_t>(log_variance.size()));
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return log_variance[a] < log_variance[b]; });
  return order;
}

/// The terms of channel c as fitted.
std::vector<Term> terms_of(const Solution& solution, int c) {
  std::vector<Term> terms;
  for (Index j = 0; j < solution.log_variance.size(); ++j)
    terms.push_back({std::exp(solution.log_variance[j]), solution.projected.weights(j, c)});
  return terms;
}

constexpr double same_variance = 1e-6;  // relative: closer terms are joined

}  // namespace

double ChannelFit::weight_sum() const {
  return std::accumulate(terms.begin(), terms.end(), 0.0,
                         [](double sum, const Term& term) { return sum + term.weight; });
}

ChannelFit fit_channel(const profile::RadialProfile& profile, int terms, Measure measure) {
  DERMIS_ASSERT(terms >= 1 && terms <= max_terms);
  const Target target(profile, profile.name(), measure);
  const Solution solution = search({&target, 1}, range_of(profile), terms);
  ChannelFit fit;
  fit.error_percent = 100 * std::sqrt(solution.projected.residual2);
  for (const Index j : narrow_to_wide(solution.log_variance)) {
    const double variance = std::exp(solution.log_variance[j]), weight = solution.projected.weights(j, 0);
    if (!fit.terms.empty() && variance < fit.terms.back().variance_mm2 * (1 + same_variance))
      fit.terms.back().weight += weight;
    else if (weight != 0)
      fit.terms.push_back({variance, weight});
  }
  if (measure != Measure::plane) fit.error_percent = error_percent(profile, fit.terms);
  return fit;
}

ScatterProfile fit_shared(const std::array<profile::ProfilePtr, 3>& profiles, int terms,
                          const std::string& name, Measure measure) {
  DERMIS_ASSERT(terms >= 1 && terms <= max_terms);

  Steps steps(work_name, 3 + search_steps);
  std::vector<Target> targets;
  Range range{.low = 1e300, .high = -1e300, .floor = 1e300};
  for (int c = 0; c < 3; ++c) {
    targets.emplace_back(*profiles[c], name + ": " + channel_names[c], measure);
    const Range one = range_of(*profiles[c]);
    range = {.low = std::min(range.low, one.low),
             .high = std::max(range.high, one.high),
             .floor = std::min(range.floor, one.floor)};
    steps.done();
  }

  const Solution solution = search(targets, range, terms);
  steps.done(search_steps);
  ScatterProfile sum;
  sum.name = name;
  for (int c = 0; c < 3; ++c) {
    sum.total_reflectance[c] = profiles[c]->total();
    sum.error_percent[c] = measure == Measure::plane
                               ? 100 * std::sqrt(solution.projected.channel_residual2[c])
                               : error_percent(*profiles[c], terms_of(solution, c));
  }

  for (const Index j : narrow_to_wide(solution.log_variance)) {
    Gaussian term{.variance_mm2 = std::exp(solution.log_variance[j]), .weight = {}};
    for (int c = 0; c < 3; ++c)
      term.weight[c] = solution.projected.weights(j, c) / solution.projected.weights.col(c).sum();

    // Joins terms whose variances hardly differ, and drops terms without weight.
    if (!sum.terms.empty() && term.variance_mm2 < sum.terms.back().variance_mm2 * (1 + same_variance)) {
      for (int c = 0; c < 3; ++c) sum.terms.back().weight[c] += term.weight[c];
    } else if (term.weight != Rgb{}) {
      sum.terms.push_back(term);
    }
  }

  return sum;
}

double error_percent(const profile::RadialProfile& profile, std::span<const Term> terms) {
  const Target target(profile, profile.name());
  VectorXd residual = target.value(), basis(target.rows()), slope(target.rows());
  for (const Term& term : terms) {
    target.column(term.variance_mm2, basis, slope);
    residual -= term.weight * basis;
  }
  return 100 * residual.norm();
}

std::vector<Term> channel(const ScatterProfile& sum, int c) {
  std::vector<Term> terms;
  for (const Gaussian& gaussian : sum.terms)
    terms.push_back({gaussian.variance_mm2, gaussian.weight[c] * sum.total_reflectance[c]});
  return terms;
}

double evaluate(std::span<const Term> terms, double radius_mm) {
  double sum = 0;
  for (const Term& term : terms)
    sum += term.weight * std::exp(-radius_mm * radius_mm / (2 * term.variance_mm2)) /
           (2 * pi * term.variance_mm2);
  return sum;
}

double edge_response(std::span<const Term> terms, double x_mm) {
  double sum = 0;
  for (const Term& term : terms) sum += term.weight * std::erfc(x_mm / std::sqrt(2 * term.variance_mm2)) / 2;
  return sum;
}

double difference_percent(std::span<const Term> sum, std::span<const Term> other) {
  const auto product = [](std::span<const Term> a, std::span<const Term> b) {
    double value = 0;
    for (const Term& s : a)
      for (const Term& t : b)
        value += s.weight * t.weight / (4 * pi * pi * (s.variance_mm2 + t.variance_mm2));
    return value;
  };
  const double own = product(sum, sum);
  return 100 * std::sqrt(std::max(0.0, own - 2 * product(sum, other) + product(other, other)) / own);
}

}  // namespace dermis::gaussians
