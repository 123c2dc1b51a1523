// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <chrono>
#include <memory>

#include "base/core/error.h"
#include "base/core/file.h"
#include "cli/command.h"
#include "cli/help.h"
#include "cli/label_files.h"
#include "cli/output.h"
#include "cli/picture_hints.h"
#include "cli/progress.h"

namespace dermis::cli {
namespace {

struct RenderArguments : SceneArguments {
  std::string output, labels, stats;
  DeviceArguments on;
};

std::string summary(const Statistics& s) {
  std::string text = fmt::format("{} ({}, Vulkan {})\n{}, {}x{}, {} light{}", s.device, s.driver, s.api,
                                 s.technique, s.width, s.height, s.lights, s.lights == 1 ? "" : "s");
  text += s.environment_lights > 0 ? fmt::format(", {} of the environment\n", s.environment_lights) : "\n";
  for (const PassStatistics& pass : s.passes)
    text += fmt::format("  {:<32} {:9.2f} ms\n", pass.name, pass.ms);
  text += fmt::format("  {:<32} {:9.2f} ms  (median of {})\n", "frame", s.frame_ms_median, s.frames);
  if (s.skin_mean)
    text += fmt::format("exposure auto: {:.2f} EV; mean luminance of the skin {:.3f}\n", s.exposure_ev,
                        *s.skin_mean);
  text +=
      fmt::format("loading {:.0f} ms, upload {:.0f} ms, pipelines {:.0f} ms, peak device memory {:.0f} MB\n",
                  s.load_ms, s.upload_ms, s.pipeline_ms, static_cast<double>(s.peak_bytes) / 1e6);
  return text;
}

void check_outputs(const RenderArguments& a) {
  check_picture_name(a.output);
  check_scene_output(a, {a.output, a.stats});
  if (!a.labels.empty()) {
    labels_of(a.labels, ending_of(a.output));
    check_writable(label_sheet(a.output));
    if (!a.stats.empty() && same_file(a.stats, label_sheet(a.output)))
      throw input_error(a.stats, "is also the name of what --labels writes; --stats needs a file of its own");
  }
  if (a.stats.empty() || a.stats == "-") return;
  check_writable(a.stats);
  if (same_file(a.stats, a.output))
    throw input_error(a.stats, "is also the name of the picture; --stats needs a file of its own");
}

void render(const RenderArguments& a, int& exit_status) {
  check_outputs(a);
  Renderer renderer({.device = a.on.device, .validate = a.on.validate, .hooks = terminal_hooks()});

  show_line("loading");
  const auto start = std::chrono::steady_clock::now();
  const Scene scene = open_scene(a);
  const double load_ms =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();

  // Ctrl-C while the scene is prepared ends in order, so that no file of the cache is left half-written;
  // later there is nothing to tidy up.
  PreparedFrame frame = [&] {
    const CatchInterrupts here;
    return renderer.prepare(scene, a.settings);
  }();
  if (interrupted_flag()) throw Cancelled("stopped before the first frame");

  show_line("rendering");
  for (int i = 0; i < a.settings.output.frames; ++i) frame.draw();
  Picture picture = frame.picture();
  show_line("");
  picture.statistics.load_ms = load_ms;

  if (tell_validation_messages(renderer)) {
    exit_status = 1;
    return;
  }

  std::vector<PendingFile> files;
  if (!a.labels.empty())
    files =
        label_files(renderer, scene, a.settings, picture, labels_of(a.labels, ending_of(a.output)), a.output);
  if (a.labels.empty() || ending_of(a.output) == ".png") picture.save(a.output);
  for (const PendingFile& file : files) write_file(file.path, file.bytes);
  if (a.settings.output.show == OutputSettings().show)
    hint_at_picture(picture, ending_of(a.output) == ".png");
  save_settings(a);
  save_scene(a, scene);
  if (!a.stats.empty()) write_text(a.stats, picture.statistics.json());
  if (a.stats != "-") fmt::print("{}", summary(picture.statistics));
}

}  // namespace

void add_render_command(CLI::App& app, int& exit_status) {
  CLI::App* command = app.add_subcommand("render", "render a scene to a picture");
  auto arguments = std::make_shared<RenderArguments>();
  add_scene_arguments(*command, *arguments, SceneUse::render);
  command
      ->add_option("-o,--output", arguments->output,
                   "picture to write: .png (display values) or .exr (linear)")
      ->type_name("FILE")
      ->required();
  rare(command
           ->add_option(
               "--labels", arguments->labels,
               "labels of each pixel beside the picture, with a .json: layers of an .exr, or a "
               "16-bit PNG each. A list of instance, material, depth, normal, uv, region, "
               "skin_mesh, unwrap, thickness, matte, part, front, front_part, landmarks (in the .json), or "
               "all")
           ->type_name("NAME,..."));
  command->add_option("--stats", arguments->stats, "write statistics as JSON, - for standard output")
      ->type_name("FILE");
  add_device_arguments(*command, arguments->on);
  command->callback([arguments, &exit_status] { render(*arguments, exit_status); });
}

}  // namespace dermis::cli
