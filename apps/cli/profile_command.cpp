// SPDX-License-Identifier: MIT
#include "cli/profile_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "base/core/error.h"
#include "base/core/file.h"
#include "base/core/hooks.h"
#include "base/core/known_names.h"
#include "base/settings/check.h"
#include "base/settings/profile_fields.h"
#include "cli/help.h"
#include "cli/output.h"
#include "cli/profile_export.h"
#include "cli/profile_report.h"
#include "cli/profile_source.h"
#include "cli/profile_swatches.h"
#include "cli/progress.h"
#include "cli/settings_options.h"
#include "image/codec.h"
#include "tissue/gaussians/known.h"
#include "tissue/optics/presets.h"
#include "tissue/optics/skin_colour.h"
#include "tissue/profile/spectral.h"

namespace dermis::cli {
namespace {

struct ProfileArguments {
  SourceOptions source;
  std::string variances = "shared";
  std::string output, plot, swatches;
  ExportOptions exports;
  std::vector<std::string> compare;
};

/// Nothing that is written may be something else that is written or read.
void check_files(const ProfileArguments& options) {
  struct File {
    const char* option;
    std::string path;
  };

  std::vector<File> files{{"-o", options.output},
                          {"--plot", options.plot},
                          {"--swatches", options.swatches},
                          {"--melanin-map", options.source.melanin_map},
                          {"--haemoglobin-map", options.source.haemoglobin_map}};
  const std::size_t outputs = files.size();
  files.insert(
      files.end(),
      {{"--layers", options.source.layers}, {"--csv", options.source.csv}, {"--head", options.source.head}});
  const auto known = gaussians::known_names();
  for (const std::string& name : options.compare)
    if (std::find(known.begin(), known.end(), name) == known.end()) files.push_back({"--compare", name});

  for (std::size_t i = 0; i < outputs; ++i) {
    if (files[i].path.empty() || files[i].path == "-") continue;
    check_writable(files[i].path);
    for (std::size_t j = i + 1; j < files.size(); ++j)
      if (!files[j].path.empty() && same_file(files[i].path, files[j].path))
        throw input_error(files[i].path,
                          "{} and {} name the same file; what is written needs a name of its own",
                          files[i].option, files[j].option);
  }

  const std::filesystem::path& cache = options.source.cache;
  std::error_code ignored;
  if (!cache.empty() && std::filesystem::exists(cache, ignored) &&
      !std::filesystem::is_directory(cache, ignored))
    throw input_error(cache.string(), "is a file; --cache needs a folder");
}

/// Refuses options before the long work.
void check(const ProfileArguments& options) {
  check_ranges(options.source.profile);
  if (options.variances != "shared" && options.variances != "per-channel")
    throw input_error("--variances", "{}", unknown_name(options.variances, {"shared", "per-channel"}));
  for (const std::string& picture :
       {options.plot, options.swatches, options.source.melanin_map, options.source.haemoglobin_map})
    if (picture == "-") throw input_error("--plot, --swatches and maps", "need a file, not standard output");
  check_export(options.exports);
  if (!options.exports.name.empty() && options.output == "-")
    throw input_error("--export", "both it and -o - would write to standard output");
  if (options.compare.size() > 3)
    throw input_error("--compare", "at most 3 sums, got {}", options.compare.size());
  check_files(options);
}

/// Opens the source, with a line on how far the work is where a person waits for it.
Source open_with_progress(const SourceOptions& options) {
  const CatchInterrupts here;
  const HookScope scope(terminal_hooks());
  Source source = open_source(options);
  show_line("");
  return source;
}

void run(const ProfileArguments& options) {
  check(options);
  std::vector<PlottedSum> others;
  for (const std::string& name : options.compare) others.push_back(plotted(name));
  const Source source = open_with_progress(options.source);
  const Fitted fitted = fit(source, options.source.profile.gaussians, options.variances == "shared",
                            options.source.profile.fit);
  const ProfilePlot plot{.title = source.name + ": " + source.model,
                         .profiles = source.profiles,
                         .fit = plotted(fitted),
                         .others = std::move(others)};
  if (!options.plot.empty()) write_file(options.plot, profile_svg(plot));
  if (!options.swatches.empty())
    image::save_png(options.swatches, skin_swatches(source.skin.value_or(SpectralSkin{})));
  if (!options.output.empty()) write_text(options.output, profile_json(source, fitted));
  if (options.output == "-") return;  // only JSON goes to standard output
  write_text("-", options.exports.name.empty() ? table(source, fitted) + differences(plot.fit, plot.others)
                                               : exported(source, fitted, options.exports));
}

constexpr const char* source_group = "Source (exactly one)";

/// An option given without content is a slip (an unset variable of a script), not an option that was left
/// out.
CLI::Option* add_text(CLI::App& command, const std::string& name, std::string& value, const std::string& type,
                      const std::string& help) {
  const auto check = [](const std::string& text) {
    return text.empty() ? std::string("must not be empty") : std::string();
  };
  return command.add_option(name, value, help)->check(check)->type_name(type);
}

/// The members of spectral skin: melanin makes it a source, the others refine it, or the skin of a colour.
void add_skin_options(CLI::App& command, SourceOptions& source) {
  const std::string refining = "Spectral skin (with --melanin or --colour)";
  const SpectralSkin measured = optics::measured_skin();

  const auto one = [&](const auto& field) {
    double& value = source.skin.*field.member;
    const std::string spelt(field.about.option), name(field.name);
    const bool is_melanin = name == "melanin";
    std::string help = help_with_range(field.about);
    if (!is_melanin && measured.*field.member != value)
      help += fmt::format(" (default {:g}; {:g} with --colour)", value, measured.*field.member);
    else if (!is_melanin)
      help += fmt::format(" (default {:g})", value);

    std::string names = "--" + spelt;
    if (name == "haemoglobin") names += ",--haemoglobin";  // the other spelling, too
    const auto read = [&source, &value, name](double given) { value = given, source.given.insert(name); };
    file_under(is_melanin ? source_group : refining, field.about,
               command.add_option_function<double>(names, read, help));
  };
  std::apply([&](const auto&... field) { (one(field), ...); }, fields_of<SpectralSkin>);
}

void add_source_options(CLI::App& command, SourceOptions& source) {
  const auto add = [&](const char* name, std::string& value, const std::string& type, const char* help) {
    add_text(command, name, value, type, help)->group(source_group);
  };

  add("--preset", source.preset, one_of(optics::preset_names()), "a measured material");
  add("--coefficients", source.coefficients, "TEXT", "\"sigma_a=R,G,B sigma_s=R,G,B g=0 eta=1.4\", per mm");
  add("--layers", source.layers, "FILE",
      "JSON list of {sigma_a_per_mm, sigma_s_reduced_per_mm, eta, thickness_mm}, from the surface down");
  add("--colour,--color", source.colour, "COLOUR",
      "the skin nearest to \"#rrggbb\" (sRGB) or \"L,a,b\" (CIELAB)");
  add("--head", source.head, "FILE",
      "glTF head: the mean skin of its colour map; --melanin-map and --haemoglobin-map write that of each "
      "texel");
  add("--burley", source.burley, "TEXT",
      "\"reflectance=R,G,B mfp_mm=R,G,B\" (or dmfp_mm, or shape_mm): normalised diffusion");
  add("--csv", source.csv, "FILE", "table with the header r_mm,R,G,B; mm and 1/mm^2");
  add("--import", source.import, "TEXT", import_help);

  add_skin_options(command, source);
  const auto add_of_head = [&](const char* name, std::string& value, const char* type, const char* help) {
    add_text(command, name, value, type, help)->group("Head (with --head)");
  };
  const About skin{.help = "a material that is skin, or a pattern of names, as 'render' takes it",
                   .values = "NAME"};
  AddOption{command}("--skin", skin, source.skin_material)->group("Head (with --head)");
  add_of_head(
      "--melanin-map", source.melanin_map, "FILE",
      "PNG to write: 0 to 255 are fractions of 0.0005 to 0.5, evenly in their logarithms; 'render' takes it");
  add_of_head("--haemoglobin-map", source.haemoglobin_map, "FILE", "the same of blood, 0.0005 to 0.1");
  for_each_setting(source.profile,
                   [&](const std::string&, const About& about, auto& value, std::string_view) {
                     CLI::Option* option = AddOption{command}("--" + std::string(about.option), about, value);
                     if (!range_text(about).empty()) option->description(help_with_range(about));
                     file_under("Options", about, option);
                   });
  rare(command
           .add_option("--cache", source.cache,
                       "Monte-Carlo: folder that keeps results (default: none are kept)")
           ->type_name("FOLDER"));
}

}  // namespace

void add_profile_command(CLI::App& app, int&) {
  CLI::App* command = app.add_subcommand(
      "profile", "compute how light spreads in skin, and the sum of Gaussians that `render --profile` takes");
  auto options = std::make_shared<ProfileArguments>();
  add_source_options(*command, options->source);

  rare(command
           ->add_option("--variances", options->variances,
                        "shared (one set for three channels, what render takes) or per-channel")
           ->type_name("shared|per-channel")
           ->capture_default_str());

  add_text(*command, "-o,--output", options->output, "FILE", "the profile as JSON; - for standard output");
  add_text(*command, "--plot", options->plot, "FILE",
           "SVG: r R(r) and the fit per channel, the residual, and light that bleeds from a white edge");
  command
      ->add_option("--compare", options->compare,
                   "published sum or profile file to draw and measure beside; up to 3 times")
      ->type_name("NAME|FILE")
      ->allow_extra_args(false)
      ->default_str("");
  add_text(*command, "--export", options->exports.name, one_of(export_names()),
           "print the parameters of another system, or a kernel, as JSON instead of the table");
  rare(add_text(*command, "--export-to", options->exports.folder, "FOLDER",
                "folder for a kernel's files in place of printing it: JSON, arrays of C and GLSL, EXR"));
  rare(command->add_option(
      "--export-taps", options->exports.taps,
      "of a kernel: separable-kernel 3 to 33, odd (default 25); burley-disc 1 to 4096 (default 64)"));
  rare(add_text(*command, "--swatches", options->swatches, "FILE",
                "PNG: colours of spectral skin, melanin to the right, hemoglobin downwards"));

  command->callback([options] { run(*options); });
}

}  // namespace dermis::cli
