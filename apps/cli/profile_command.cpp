// SPDX-License-Identifier: MIT
#include "cli/profile_command.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/profile_source.h"
#include "cli/profile_swatches.h"
#include "core/error.h"
#include "core/file.h"
#include "gaussians/exchange.h"
#include "gaussians/fit.h"
#include "gaussians/json.h"
#include "gaussians/plot.h"
#include "image/codec.h"

namespace dermis::cli {
namespace {

struct ProfileOptions {
  SourceOptions source;
  int gaussians = 6;
  std::string variances = "shared";
  std::string output, plot, swatches, export_to;
  std::vector<std::string> compare;
};

/// A fit in either form, ready to be printed.
struct Fitted {
  gaussians::SumOfGaussians shared;               ///< terms empty if per channel
  std::array<gaussians::ChannelFit, 3> channels;  ///< terms empty if shared
  gaussians::Rgb error_percent{}, total{}, mean_free_path_mm{}, diffuse_mean_free_path_mm{};
};

Fitted fit(const Source& source, const ProfileOptions& options) {
  Fitted out;
  for (int c = 0; c < 3; ++c) {
    out.total[c] = std::min(source.profiles[c]->total(), 1.0);  // a conservative medium may round past 1
    out.mean_free_path_mm[c] = source.medium[c].mean_free_path().mm;
    const double diffuse_mm = source.medium[c].diffuse_mean_free_path().mm;
    out.diffuse_mean_free_path_mm[c] = diffuse_mm < 1e9 ? diffuse_mm : 0;  // JSON has no infinity; 0 is "unknown" in the file
  }
  if (options.variances == "shared") {
    out.shared = gaussians::fit_shared(source.profiles, options.gaussians, source.name);
    out.shared.model = source.model;
    out.shared.total_reflectance = out.total;
    out.shared.mean_free_path_mm = out.mean_free_path_mm;
    out.shared.diffuse_mean_free_path_mm = out.diffuse_mean_free_path_mm;
    out.error_percent = out.shared.error_percent;
    return out;
  }
  for (int c = 0; c < 3; ++c) {
    out.channels[c] = gaussians::fit_channel(*source.profiles[c], options.gaussians);
    out.error_percent[c] = out.channels[c].error_percent;
  }
  return out;
}

std::string row(const std::string& label, const gaussians::Rgb& values) {
  return fmt::format("{:<34}{:>12.6g}{:>12.6g}{:>12.6g}\n", label, values[0], values[1], values[2]);
}

std::string table(const Source& source, const Fitted& fitted) {
  std::string text = fmt::format("{}: {}\n", source.name, source.model);
  if (!source.note.empty()) text += source.note + "\n";
  text += fmt::format("{:<34}{:>12}{:>12}{:>12}\n", "", "red", "green", "blue");
  for (const gaussians::Gaussian& term : fitted.shared.terms)
    text += row(fmt::format("variance {:>10.5g} mm^2    weights", term.variance_mm2), term.weight);
  constexpr const char* channel[] = {"red", "green", "blue"};
  for (int c = 0; c < 3; ++c)
    for (const gaussians::Term& term : fitted.channels[c].terms)
      text += fmt::format("{:<6} variance {:>10.5g} mm^2   weight {:>12.6g}\n", channel[c], term.variance_mm2,
                          term.weight / fitted.channels[c].weight_sum());
  text += row("error, %", fitted.error_percent);
  text += row("total reflectance", fitted.total);
  const char* which = source.equivalent ? " (equivalent)" : "";
  text += row(fmt::format("mean free path{}, mm", which), fitted.mean_free_path_mm);
  text += row(fmt::format("diffuse m.f.p.{}, mm", which), fitted.diffuse_mean_free_path_mm);
  return text;
}

/// The profile file with variances_mm2 [k][3]. A channel with fewer terms is filled with terms of weight 0.
std::string per_channel_json(const Source& source, const Fitted& fitted) {
  nlohmann::ordered_json root;
  root["name"] = source.name;
  root["model"] = source.model;
  std::size_t terms = 0;
  for (const auto& channel : fitted.channels) terms = std::max(terms, channel.terms.size());
  for (std::size_t i = 0; i < terms; ++i) {
    gaussians::Rgb variance{}, weight{};
    for (int c = 0; c < 3; ++c) {
      const auto& channel = fitted.channels[c];
      const gaussians::Term& term = channel.terms[std::min(i, channel.terms.size() - 1)];
      variance[c] = term.variance_mm2;
      weight[c] = i < channel.terms.size() ? term.weight / channel.weight_sum() : 0;
    }
    root["variances_mm2"].push_back(variance);
    root["weights"].push_back(weight);
  }
  root["error_percent"] = fitted.error_percent;
  root["total_reflectance"] = fitted.total;
  root["mean_free_path_mm"] = fitted.mean_free_path_mm;
  root["diffuse_mean_free_path_mm"] = fitted.diffuse_mean_free_path_mm;
  return root.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

/// Terms of one channel with weights that sum to 1.
std::vector<gaussians::Term> normalised(const Fitted& fitted, int c) {
  std::vector<gaussians::Term> terms = fitted.channels[c].terms;
  const double sum = fitted.channels[c].weight_sum();
  for (gaussians::Term& term : terms) term.weight /= sum;
  for (const gaussians::Gaussian& gaussian : fitted.shared.terms) terms.push_back({gaussian.variance_mm2, gaussian.weight[c]});
  return terms;
}

gaussians::Plot make_plot(const Source& source, const Fitted& fitted, const ProfileOptions& options) {
  gaussians::Plot plot{.title = source.name + ": " + source.model, .profiles = source.profiles, .fit = {}, .others = {}};
  plot.fit.label = fmt::format("{} Gaussians", options.gaussians);
  for (int c = 0; c < 3; ++c) plot.fit.channels[c] = normalised(fitted, c);
  for (const std::string& name : options.compare) {
    gaussians::SumOfGaussians sum = gaussians::from_name_or_file(name);
    sum.total_reflectance = {1, 1, 1};
    gaussians::PlottedSum other{.label = sum.name.empty() ? name : sum.name, .channels = {}};
    for (int c = 0; c < 3; ++c) other.channels[c] = gaussians::channel(sum, c);
    plot.others.push_back(std::move(other));
  }
  return plot;
}

std::string differences(const gaussians::Plot& plot) {
  std::string text;
  for (const gaussians::PlottedSum& other : plot.others) {
    gaussians::Rgb percent{};
    for (int c = 0; c < 3; ++c) percent[c] = gaussians::difference_percent(plot.fit.channels[c], other.channels[c]);
    text += row(fmt::format("difference from {}, %", other.label), percent);
  }
  return text;
}

std::string exported(const Source& source, const Fitted& fitted, const std::string& system) {
  gaussians::Exported input{.name = source.name, .profiles = source.profiles, .terms = {}, .medium = source.medium};
  for (int c = 0; c < 3; ++c)
    for (const gaussians::Term& term : normalised(fitted, c)) input.terms[c].push_back({term.variance_mm2, term.weight});
  return gaussians::export_text(system, input);
}

/// What can be refused before the long work.
void check(const ProfileOptions& options) {
  if (options.gaussians < 1 || options.gaussians > gaussians::max_terms)
    throw input_error("--gaussians", "1 to {}, got {}", gaussians::max_terms, options.gaussians);
  if (options.variances != "shared" && options.variances != "per-channel")
    throw input_error("--variances", "'{}' is not known; known: shared, per-channel", options.variances);
  for (const std::string& path : {options.output, options.plot, options.swatches})
    if (!path.empty() && path != "-") check_writable(path);
  if (options.plot == "-" || options.swatches == "-") throw input_error("--plot, --swatches", "need a file, not standard output");
  const auto systems = gaussians::exchange_names();
  if (!options.export_to.empty() && std::find(systems.begin(), systems.end(), options.export_to) == systems.end())
    throw input_error("--export", "no system '{}'; known: {}", options.export_to, fmt::join(systems, ", "));
  if (!options.export_to.empty() && options.output == "-") throw input_error("--export", "both it and -o - would write to standard output");
  if (options.compare.size() > 3) throw input_error("--compare", "at most 3 sums, got {}", options.compare.size());
}

void run(const ProfileOptions& options) {
  check(options);
  const Source source = open_source(options.source);
  const Fitted fitted = fit(source, options);
  const gaussians::Plot plot = make_plot(source, fitted, options);
  if (!options.plot.empty()) write_file(options.plot, gaussians::svg_plot(plot));
  if (!options.swatches.empty()) image::save_png(options.swatches, skin_swatches(source.skin.value_or(optics::Skin{})));
  const std::string json = options.variances == "shared" ? gaussians::to_json(fitted.shared) : per_channel_json(source, fitted);
  if (options.output == "-") {
    std::fputs(json.c_str(), stdout);
    return;  // only JSON goes to standard output
  }
  if (!options.output.empty()) write_file(options.output, json);
  if (!options.export_to.empty())
    std::fputs(exported(source, fitted, options.export_to).c_str(), stdout);
  else
    std::fputs((table(source, fitted) + differences(plot)).c_str(), stdout);
}

void add_source_options(CLI::App& command, SourceOptions& source) {
  const std::string group = "Source (exactly one)";
  command
      .add_option("--preset", source.preset, "a measured material: skin1, skin2, marble, ..., or skin-layers (an unknown name lists all)")
      ->group(group);
  command.add_option("--coefficients", source.coefficients, "\"sigma_a=R,G,B sigma_s=R,G,B g=0 eta=1.4\", per mm")->group(group);
  command
      .add_option("--layers", source.layers,
                  "JSON list of {sigma_a_per_mm, sigma_s_reduced_per_mm, eta, thickness_mm}, from the surface down")
      ->group(group);
  command.add_option("--melanin", source.melanin, "spectral skin: volume fraction of melanin in the epidermis, 0 to 0.5")->group(group);
  command.add_option("--colour,--color", source.colour, "the skin nearest to \"#rrggbb\" (sRGB) or \"L,a,b\" (CIELAB)")->group(group);
  command.add_option("--burley", source.burley, "\"reflectance=R,G,B mfp_mm=R,G,B\" (or dmfp_mm, or shape_mm): normalised diffusion")
      ->group(group);
  command.add_option("--csv", source.csv, "table with the header r_mm,R,G,B; mm and 1/mm^2")->group(group);
  command
      .add_option("--import", source.import,
                  "another system's values: \"unity reflectance=R,G,B scattering_distance=R,G,B\", unreal, cycles, openpbr, gltf")
      ->group(group);
  const std::string spectral = "Spectral skin (with --melanin or --colour)";
  command.add_option("--blend", source.blend, "eumelanin's share, 0 to 1 (default 0.7; 0.1 with --colour)")->group(spectral);
  command.add_option("--hemoglobin,--haemoglobin", source.haemoglobin, "volume fraction of blood in the dermis, 0 to 0.1 (default 0.01)")
      ->group(spectral);
  command.add_option("--oxygenation", source.oxygenation, "0 to 1 (default 0.75)")->group(spectral);
  command.add_option("--oiliness", source.oiliness, "strength of the surface reflection, 0 to 1 (default 0.3)")->group(spectral);
  command.add_option("--epidermis-mm", source.epidermis_mm, "thickness in mm, 0.01 to 2 (default 0.25; 0.12 with --colour)")
      ->group(spectral);
  command.add_option("--model", source.model, "dipole, better, multipole, beam, monte-carlo or auto")->capture_default_str();
  command.add_option("--photons", source.monte_carlo.photons, "Monte-Carlo: photons a channel, 1000 to 1e9")->capture_default_str();
  command.add_option("--seed", source.monte_carlo.seed, "Monte-Carlo: equal seeds give equal bits")->capture_default_str();
  command.add_option("--cache", source.monte_carlo.cache, "Monte-Carlo: folder that keeps results (default: none are kept)");
}

}  // namespace

void add_profile_command(CLI::App& app, int&) {
  CLI::App* command =
      app.add_subcommand("profile", "compute how light spreads in skin, and the sum of Gaussians that `render --profile` takes");
  auto options = std::make_shared<ProfileOptions>();
  add_source_options(*command, options->source);
  command->add_option("--gaussians", options->gaussians, "terms of the sum, 1 to 8")->capture_default_str();
  command->add_option("--variances", options->variances, "shared (one set for three channels, what render takes) or per-channel")
      ->capture_default_str();
  command->add_option("-o,--output", options->output, "the profile as JSON; - for standard output");
  command->add_option("--plot", options->plot,
                      "SVG: r R(r) and the fit per channel, the residual, and light that bleeds from a white edge");
  command->add_option("--compare", options->compare, "published sum or profile file to draw and measure beside; up to 3 times")
      ->allow_extra_args(false);
  command->add_option(
      "--export", options->export_to,
      "print the parameters of another system as JSON instead of the table: separable, unity, unreal, gltf, openpbr or cycles");
  command->add_option("--swatches", options->swatches, "PNG: colours of spectral skin, melanin to the right, hemoglobin downwards");
  command->callback([options] { run(*options); });
}

}  // namespace dermis::cli
