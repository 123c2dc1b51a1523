// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <ctime>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/core/error.h"
#include "base/core/file.h"
#include "base/settings/names.h"
#include "cli/command.h"
#include "cli/command_line.h"
#include "cli/output.h"
#include "cli/progress.h"
#include "dermis/reference.h"

namespace dermis::cli {
namespace {

struct ReferenceArguments : SceneArguments {
  bool resume = false;
  std::string output, variance, stats;
};

void show_progress(const ReferenceProgress& p) {
  static auto last = std::chrono::steady_clock::time_point();
  const auto now = std::chrono::steady_clock::now();
  if (now - last < std::chrono::milliseconds(200)) return;
  last = now;
  fmt::print(stderr, "\r\033[K{} samples, noise {:.2f} %, {} gone, {} left", p.samples, p.noise_percent,
             duration(p.seconds), duration(p.seconds_left));
}

void check_own_name(const std::string& path, const char* option, std::initializer_list<std::string> others) {
  check_writable(path);
  for (const std::string& other : others)
    if (!other.empty() && same_file(path, other))
      throw input_error(path, "is also the name of another output; {} needs its own", option);
}

void check_files(const ReferenceArguments& a) {
  check_picture_name(a.output);
  check_scene_output(a, {a.output, a.variance, a.stats});
  if (!a.stats.empty() && a.stats != "-") check_own_name(a.stats, "--stats", {a.output, a.variance});
  if (a.variance.empty()) return;
  if (ending_of(a.variance) != ".exr") throw input_error(a.variance, "the variance is written as .exr");
  check_own_name(a.variance, "--variance", {a.output});
}

struct Cost {
  double seconds = 0, cpu_seconds = 0;
};

std::string summary(const ReferenceArguments& a, const ReferencePicture& out, const Cost& cost) {
  std::string text =
      fmt::format("{}, {}x{}, {} samples per pixel, noise {:.3f} %\n{:.1f} s, {:.1f} s of processor time\n",
                  name_of(a.reference->model), out.picture.width, out.picture.height, out.samples,
                  out.noise_percent, cost.seconds, cost.cpu_seconds);
  if (out.lost_percent > 0)
    text += fmt::format("{:.3f} % of the walks left through holes or folds of the mesh\n", out.lost_percent);
  return text;
}

std::string statistics_json(const ReferenceArguments& a, const std::string& scene,
                            const ReferencePicture& out, const Cost& cost) {
  const nlohmann::ordered_json json{{"dermis", DERMIS_VERSION},
                                    {"scene", scene},
                                    {"settings", json_of(settings_file(a))},
                                    {"size", {out.picture.width, out.picture.height}},
                                    {"samples", out.samples},
                                    {"noise_percent", out.noise_percent},
                                    {"lost_percent", out.lost_percent},
                                    {"complete", out.complete},
                                    {"seconds", cost.seconds},
                                    {"cpu_seconds", cost.cpu_seconds}};
  // Names of files need not be UTF-8.
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void run(ReferenceArguments& a, int& exit_status) {
  check_files(a);
  ReferenceSettings reference = *a.reference;
  reference.resume = a.resume;
  reference.checkpoint = a.output + ".resume";
  const Scene scene = open_scene(a);

  // From the first sample on, the line says more than how far the work is.
  Hooks hooks = terminal_hooks();
  const bool terminal = ::isatty(STDERR_FILENO);
  if (terminal) {
    const auto sampled = std::make_shared<bool>(false);
    reference.after_sample = [sampled](const ReferenceProgress& p) {
      *sampled = true;
      show_progress(p);
    };
    hooks.progress = [sampled, show = hooks.progress](const WorkProgress& work) {
      return *sampled || show(work);
    };
  }
  catch_interrupts();

  const auto start = std::chrono::steady_clock::now();
  const std::clock_t cpu_start = std::clock();
  const ReferencePicture out = render_reference(scene, a.settings, reference, hooks);
  const Cost cost{.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
                  .cpu_seconds = static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC};
  if (terminal) fmt::print(stderr, "\r\033[K");
  out.picture.save(a.output);
  save_settings(a);
  save_scene(a, scene);
  if (!a.variance.empty()) out.save_variance(a.variance);
  if (!a.stats.empty()) write_text(a.stats, statistics_json(a, scene.name(), out, cost));
  if (a.stats != "-") fmt::print("{}", summary(a, out, cost));

  if (!out.complete) {
    fmt::print(stderr,
               "dermis: stopped after {} samples; the picture holds them, and --resume goes on from there\n",
               out.samples);
    exit_status = 1;
    return;
  }

  std::error_code ignored;  // most runs never had one
  std::filesystem::remove(reference.checkpoint, ignored);
}

}  // namespace

void add_reference_command(CLI::App& app, int& exit_status) {
  CLI::App* command = app.add_subcommand(
      "reference", "ground truth on the processor: the same scene without the approximations of real time");
  auto a = std::make_shared<ReferenceArguments>();
  a->settings.output.width = a->settings.output.height = 512;
  add_scene_arguments(*command, *a, SceneUse::reference);
  command->add_option("-o,--output", a->output, "picture to write: .exr (linear) or .png (display values)")
      ->type_name("FILE")
      ->required();
  command->add_option("--variance", a->variance, "write the variance of each value of the picture, .exr")
      ->type_name("FILE");
  command->add_option("--stats", a->stats, "write statistics as JSON, - for standard output")
      ->type_name("FILE");
  command->add_flag("--resume", a->resume, "go on from OUTPUT.resume, which a stopped run leaves")
      ->group(truth_group);
  command->callback([a, &exit_status] { run(*a, exit_status); });
}

}  // namespace dermis::cli
