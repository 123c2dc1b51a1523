// SPDX-License-Identifier: MIT
#include "cli/profile_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>

#include "base/core/channels.h"
#include "base/core/error.h"
#include "tissue/gaussians/exchange.h"
#include "tissue/gaussians/json.h"
#include "tissue/optics/media.h"
#include "tissue/profile/noise.h"
#include "tissue/profile/shape_laws.h"

namespace dermis::cli {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double worth_a_note = 1e-4;  // of the light

/// A stack that gives everything back has no diffuse length; its equivalent medium is held just short of
/// that.
double diffuse_length_mm(const Source& source, int c, double total) {
  if (source.equivalent && total >= 1 - 1e-6) return infinite;
  return source.medium[c].diffuse_mean_free_path().mm;
}

/// JSON has no infinity; 0 is "unknown" in the file.
gaussians::Rgb finite_or_0(gaussians::Rgb lengths_mm) {
  for (double& mm : lengths_mm)
    if (!(mm >= 0 && mm < 1e9)) mm = 0;
  return lengths_mm;
}

bool usable(const std::vector<gaussians::Term>& terms) {
  double sum = 0;
  for (const gaussians::Term& term : terms) sum += term.weight;
  return !terms.empty() && std::isfinite(sum) && sum > 0;
}

/// Weights that no renderer can use must not reach a file.
void check_weights(const Source& source, const Fitted& fitted, int terms) {
  int bad = 0;
  while (bad < 3 && usable(normalised(fitted, bad))) ++bad;
  if (bad == 3) return;
  // Shared variances take all channels down with one: which it is, each by itself tells.
  if (!fitted.shared.terms.empty())
    for (int c = 2; c >= 0; --c)
      if (!usable(gaussians::fit_channel(*source.profiles[c], terms).terms)) bad = c;
  throw input_error(
      source.name,
      "{}: no sum of Gaussians fits this profile; is its total 0, or its reach out of all proportion?",
      channel_names[bad]);
}

std::string row(const std::string& label, const gaussians::Rgb& values) {
  std::string line = fmt::format("{:<34}", label);
  for (const double value : values)
    line += std::isinf(value) ? fmt::format("{:>12}", "infinite") : fmt::format("{:>12.6g}", value);
  return line + "\n";
}

bool any_pole(const Source& source) {
  return std::any_of(source.profiles.begin(), source.profiles.end(),
                     [](const auto& profile) { return profile->has_pole(); });
}

/// Remarks that a number alone would not tell.
std::string notes(const Source& source, const Fitted& fitted) {
  std::string text = source.note.empty() ? "" : source.note + "\n";
  for (int c = 0; c < 3; ++c) {
    if (fitted.model_total[c] > 1 + worth_a_note)
      text += fmt::format(
          "{}: this model gives back {:.4g} times the light that entered; the total is cut to 1\n",
          channel_names[c], fitted.model_total[c]);
    const auto sampled = profile::sampled(*source.profiles[c]);
    if (sampled && sampled->cut > worth_a_note)
      text += fmt::format(
          "{}: {:.2g} % of the light is missing; Monte-Carlo gives photons up after 200,000 scatterings\n",
          channel_names[c], 100 * sampled->cut);
  }
  return text;
}

/// The meaning of the error in per cent, and the part of chance in it.
std::string error_rows(const Source& source, const Fitted& fitted) {
  // A profile with a pole has no mean square: it is compared as a narrow beam would see it, and that number
  // is no dipole's.
  std::string text =
      row(any_pole(source) ? "error through a narrow beam, %" : "error, %", fitted.error_percent);
  gaussians::Rgb sigma_mm{}, noise_percent{};
  bool noisy = false;
  for (int c = 0; c < 3; ++c) {
    if (source.profiles[c]->has_pole())
      sigma_mm[c] = std::sqrt(gaussians::core_variance_mm2(*source.profiles[c]));
    if (const auto sampled = profile::sampled(*source.profiles[c]))
      noise_percent[c] = sampled->noise_percent, noisy = true;
  }
  if (any_pole(source)) text += row("sigma of that beam, mm", sigma_mm);
  if (noisy) text += row("Monte-Carlo noise, %", noise_percent);
  return text;
}

/// The laws of shape for a few bodies: light that leaves, relative to a flat half-space.
std::string shape_rows(const Source& source) {
  if (!optics::coefficients_of(source.medium)) return "";
  const ShapeLaws laws = profile::shape_laws(source.medium);
  gaussians::Rgb sphere{}, hollow{}, cylinder{}, front{}, back{};
  constexpr double slab_mm = 2;
  for (std::size_t c = 0; c < 3; ++c) {
    sphere[c] = profile::curved_total(laws, c, 0.1, 0);
    hollow[c] = profile::curved_total(laws, c, -0.1, 0);
    cylinder[c] = profile::curved_total(laws, c, 0.1, 0.1);
    front[c] = profile::slab_front(laws, c, slab_mm);
    back[c] = profile::slab_backs(source.medium[c], std::span(&slab_mm, 1)).front();
  }
  return "light that leaves, over that of a flat half-space (docs/theory.md, Shapes)\n" +
         row("  sphere of 10 mm", sphere) + row("  hollow of 10 mm", hollow) +
         row("  cylinder of 5 mm", cylinder) + row("  front of a slab of 2 mm", front) +
         row("  back of a slab of 2 mm", back) + row("  towards the normal", laws.exit_normal) +
         row("  at grazing angles", laws.exit_grazing) +
         row("  comes from further away, mm", laws.exit_offset_mm);
}

std::string per_channel_json(const Source& source, const Fitted& fitted) {
  nlohmann::ordered_json root;
  root["name"] = source.name;
  root["model"] = source.model;

  // Pad every channel to the longest, with terms of weight 0.
  std::size_t terms = 0;
  for (const auto& channel : fitted.channels) terms = std::max(terms, channel.terms.size());
  for (std::size_t i = 0; i < terms; ++i) {
    gaussians::Rgb variance{}, weight{};
    for (int c = 0; c < 3; ++c) {
      const std::vector<gaussians::Term> channel = normalised(fitted, c);
      variance[c] = channel[std::min(i, channel.size() - 1)].variance_mm2;
      weight[c] = i < channel.size() ? channel[i].weight : 0;
    }

    root["variances_mm2"].push_back(variance);
    root["weights"].push_back(weight);
  }

  root["error_percent"] = fitted.error_percent;
  root["total_reflectance"] = fitted.total;
  root["mean_free_path_mm"] = finite_or_0(fitted.mean_free_path_mm);
  root["diffuse_mean_free_path_mm"] = finite_or_0(fitted.diffuse_mean_free_path_mm);
  return root.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace

Fitted fit(const Source& source, int terms, bool shared, ProfileFit measure) {
  Fitted out;
  for (int c = 0; c < 3; ++c) {
    out.model_total[c] = source.profiles[c]->total();
    out.total[c] = std::min(out.model_total[c], 1.0);  // a conservative medium may round past 1
    out.mean_free_path_mm[c] = source.medium[c].mean_free_path().mm;
    out.diffuse_mean_free_path_mm[c] = diffuse_length_mm(source, c, out.model_total[c]);
  }

  if (shared) {
    out.shared = gaussians::fit_shared(source.profiles, terms, source.name, measure);
    out.error_percent = out.shared.error_percent;
  } else {
    for (int c = 0; c < 3; ++c) {
      out.channels[c] = gaussians::fit_channel(*source.profiles[c], terms, measure);
      out.error_percent[c] = out.channels[c].error_percent;
    }
  }

  check_weights(source, out, terms);
  return out;
}

std::vector<gaussians::Term> normalised(const Fitted& fitted, int c) {
  std::vector<gaussians::Term> terms = fitted.channels[c].terms;
  const double sum = fitted.channels[c].weight_sum();
  for (gaussians::Term& term : terms) term.weight /= sum;
  for (const Gaussian& gaussian : fitted.shared.terms)
    terms.push_back({gaussian.variance_mm2, gaussian.weight[c]});
  return terms;
}

std::string table(const Source& source, const Fitted& fitted) {
  std::string text = fmt::format("{}: {}\n", source.name, source.model) + notes(source, fitted);
  text += fmt::format("{:<34}{:>12}{:>12}{:>12}\n", "", "red", "green", "blue");
  for (const Gaussian& term : fitted.shared.terms)
    text += row(fmt::format("variance {:>10.5g} mm^2    weights", term.variance_mm2), term.weight);
  if (fitted.shared.terms.empty())
    for (int c = 0; c < 3; ++c)
      for (const gaussians::Term& term : normalised(fitted, c))
        text += fmt::format("{:<6} variance {:>10.5g} mm^2   weight {:>12.6g}\n", channel_names[c],
                            term.variance_mm2, term.weight);
  text += error_rows(source, fitted);
  text += row("total reflectance", fitted.total);
  const char* which = source.equivalent ? " (equivalent)" : "";
  text += row(fmt::format("mean free path{}, mm", which), fitted.mean_free_path_mm);
  text += row(fmt::format("diffuse m.f.p.{}, mm", which), fitted.diffuse_mean_free_path_mm);
  return text + shape_rows(source);
}

std::string differences(const PlottedSum& fit, const std::vector<PlottedSum>& others) {
  std::string text;
  for (const PlottedSum& other : others) {
    gaussians::Rgb percent{};
    for (int c = 0; c < 3; ++c)
      percent[c] = gaussians::difference_percent(fit.channels[c], other.channels[c]);
    text += row(fmt::format("difference from {}, %", other.label), percent);
  }
  return text;
}

std::string profile_json(const Source& source, const Fitted& fitted) {
  if (fitted.shared.terms.empty()) return per_channel_json(source, fitted);
  ScatterProfile sum = fitted.shared;
  sum.model = source.model;
  sum.total_reflectance = fitted.total;
  sum.mean_free_path_mm = finite_or_0(fitted.mean_free_path_mm);
  sum.diffuse_mean_free_path_mm = finite_or_0(fitted.diffuse_mean_free_path_mm);
  sum.medium = optics::coefficients_of(source.medium);
  if (sum.medium) sum.shape = profile::shape_laws(source.medium);
  return gaussians::to_json(sum);
}

PlottedSum plotted(const Fitted& fitted) {
  PlottedSum sum;
  std::size_t terms = 0;  // fewer than asked for where two would coincide
  for (int c = 0; c < 3; ++c) {
    sum.channels[c] = normalised(fitted, c);
    terms = std::max(terms, sum.channels[c].size());
  }
  sum.label = fmt::format("{} Gaussian{}", terms, terms == 1 ? "" : "s");
  return sum;
}

PlottedSum plotted(const std::string& name_or_path) {
  ScatterProfile sum = gaussians::from_name_or_file(name_or_path);
  sum.total_reflectance = {1, 1, 1};
  PlottedSum out{.label = sum.name.empty() ? name_or_path : sum.name, .channels = {}};
  for (int c = 0; c < 3; ++c) out.channels[c] = gaussians::channel(sum, c);
  return out;
}

std::string exported(const Source& source, const Fitted& fitted, const std::string& system) {
  gaussians::Exported input{
      .name = source.name, .profiles = source.profiles, .terms = {}, .medium = source.medium};
  for (int c = 0; c < 3; ++c)
    for (const gaussians::Term& term : normalised(fitted, c))
      input.terms[c].push_back({term.variance_mm2, term.weight});
  return gaussians::export_text(system, input);
}

}  // namespace dermis::cli
