// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <ctime>
#include <filesystem>
#include <memory>

#include "cli/command.h"
#include "cli/command_line.h"
#include "cli/progress.h"
#include "core/error.h"
#include "core/file.h"
#include "dermis/reference.h"

namespace dermis::cli {
namespace {

struct ReferenceArguments : SceneArguments {
  ReferenceSettings reference;
  std::string output, variance;
};

void show_progress(const ReferenceProgress& p) {
  static auto last = std::chrono::steady_clock::time_point();
  const auto now = std::chrono::steady_clock::now();
  if (now - last < std::chrono::milliseconds(200)) return;
  last = now;
  fmt::print(stderr, "\r\033[K{} samples, noise {:.2f} %, {} gone, {} left", p.samples, p.noise_percent,
             duration(p.seconds), duration(p.seconds_left));
}

void check_files(const ReferenceArguments& a) {
  check_picture_name(a.output);
  if (a.variance.empty()) return;
  if (std::filesystem::path(a.variance).extension() != ".exr")
    throw input_error(a.variance, "the variance is written as .exr");
  check_writable(a.variance);
  if (same_file(a.variance, a.output))
    throw input_error(a.variance, "is also the name of the picture; --variance needs its own");
}

void run(ReferenceArguments& a, int& exit_status) {
  check_files(a);
  const bool terminal = ::isatty(STDERR_FILENO);
  if (terminal) a.reference.progress = show_progress;
  a.reference.checkpoint = a.output + ".resume";
  const Scene scene = open_scene(a);
  a.reference.stop = &catch_interrupts();

  const auto start = std::chrono::steady_clock::now();
  const std::clock_t cpu_start = std::clock();
  const ReferencePicture out = render_reference(scene, a.settings, a.reference);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const double cpu_seconds = static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC;
  if (terminal) fmt::print(stderr, "\r\033[K");
  if (out.samples == 0)
    throw input_error(a.output, "stopped before every pixel had a sample: nothing to write");

  out.picture.save(a.output);
  save_settings(a);
  if (!a.variance.empty()) out.save_variance(a.variance);
  fmt::print("{}, {}x{}, {} samples per pixel, noise {:.3f} %\n{:.1f} s, {:.1f} s of processor time\n",
             a.reference.model, out.picture.width, out.picture.height, out.samples, out.noise_percent,
             seconds, cpu_seconds);
  if (out.lost_percent > 0)
    fmt::print("{:.3f} % of the walks left through holes or folds of the mesh\n", out.lost_percent);

  if (!out.complete) {
    fmt::print(stderr,
               "dermis: stopped after {} samples; the picture holds them, and --resume goes on from there\n",
               out.samples);
    exit_status = 1;
    return;
  }

  std::error_code ignored;  // most runs never had one
  std::filesystem::remove(a.reference.checkpoint, ignored);
}

}  // namespace

void add_reference_options(CLI::App& command, ReferenceSettings& settings) {
  std::string models;
  for (const std::string& name : reference_models()) models += (models.empty() ? "" : ", ") + name;

  command.add_option("--model", settings.model, models)->group("Model");
  command
      .add_option("--medium", settings.medium,
                  "volume: a measured material, or 'sigma_a=.. sigma_s=.. g=.. eta=..' per mm (default: what "
                  "the profile was made of)")
      ->group("Model");

  command
      .add_option("--samples", settings.samples,
                  "samples of a pixel (default: 64, or as many as --noise takes); with --noise, at most")
      ->group("Quality");
  command
      .add_option("--noise", settings.noise_percent,
                  "end when the mean standard error over skin is this many per cent of the mean")
      ->group("Quality");
  add_count(command, "--seed", settings.seed, "of the random numbers; equal seeds give equal bits",
            "0 to 2^64 - 1")
      ->group("Quality");
  command.add_option("--threads", settings.threads, "0: all cores; makes no difference to the picture")
      ->group("Quality");
}

void add_reference_command(CLI::App& app, int& exit_status) {
  CLI::App* command = app.add_subcommand(
      "reference", "ground truth on the processor: the same scene without the approximations of real time");
  auto a = std::make_shared<ReferenceArguments>();
  a->settings.output.width = a->settings.output.height = 512;
  add_scene_arguments(*command, *a, SceneUse::reference);
  command->add_option("-o,--output", a->output, "picture to write: .exr (linear) or .png (display values)")
      ->required();
  command->add_option("--variance", a->variance, "write the variance of each value of the picture, .exr");
  add_reference_options(*command, a->reference);
  command->add_flag("--resume", a->reference.resume, "go on from OUTPUT.resume, which a stopped run leaves")
      ->group("Quality");
  command->callback([a, &exit_status] { run(*a, exit_status); });
}

}  // namespace dermis::cli
