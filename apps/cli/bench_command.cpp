// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <thread>

#include "api/compare/held_frames.h"
#include "base/core/error.h"
#include "base/core/file.h"
#include "cli/bench/measure.h"
#include "cli/bench/page.h"
#include "cli/bench/paper.h"
#include "cli/bench/recorded.h"
#include "cli/bench/technique_grid.h"
#include "cli/command.h"
#include "cli/help.h"
#include "cli/output.h"
#include "cli/progress.h"
#include "cli/version.h"
#include "render/setup/frame_setup.h"

namespace dermis::cli {
namespace {

struct BenchArguments : SceneArguments {
  std::vector<int> heads{bench::paper_heads.begin(), bench::paper_heads.end()};
  std::vector<double> distances{bench::paper_distances.begin(), bench::paper_distances.end()};
  int rounds = 5, picture_samples = 4;
  std::optional<double> frames_mb;
  bool quick = false, fail_if_slower = false;
  std::vector<std::string> techniques;  // none: the paper's test
  std::vector<std::string> compare;     // old, new
  std::string json, html, device = "best";
};

// The paper's test at three sixteenths of its scale: as many texels per pixel, a thirtieth of the work.
// Options of the command line stay.
void scale_down(BenchArguments& a, const CLI::App& command) {
  const auto given = [&](const char* name) { return command.get_option(name)->count() > 0; };
  RenderSettings& s = a.settings;
  if (!given("--size")) s.output.width = 360, s.output.height = 225;
  if (!given("--map-size")) s.quality.map_size = 384;
  if (!given("--shadow-size")) s.quality.shadow_size = 384;
  if (!given("--heads")) a.heads = {1, 4};
  if (!given("--distances")) a.distances = {2.5, 10, 50};
  if (!given("--rounds")) a.rounds = 3;
  if (!given("--picture-samples")) a.picture_samples = 2;
}

template <class T>
void sort_list(const char* name, std::vector<T>& values) {
  std::sort(values.begin(), values.end());
  const auto twice = std::adjacent_find(values.begin(), values.end());
  if (twice != values.end()) throw input_error("", "{} names {} twice", name, *twice);
}

void check_files(const BenchArguments& a) {
  if (a.html == "-") throw input_error("--html", "needs a file, not standard output");
  if (!a.html.empty()) check_writable(a.html);
  if (a.json.empty() || a.json == "-") return;
  check_writable(a.json);
  if (!a.html.empty() && same_file(a.json, a.html))
    throw input_error(a.json, "is also the name of the page; --json needs its own");
}

// All that can be wrong with a cell hours from now is said at once.
void check(const BenchArguments& a, const bench::Task& task) {
  constexpr int largest_side = 16384;  // pixels; what devices commonly can
  if (a.rounds < 1 || a.rounds > 100'000)
    throw input_error("", "--rounds must be 1 to 100000, got {}", a.rounds);
  if (a.picture_samples < 0 || a.picture_samples > 16)
    throw input_error("", "--picture-samples must be 0 to 16, got {}", a.picture_samples);
  for (const bench::Place& place : bench::places_of(task))
    setup::check_settings(bench::settings_at(task, place));
  if (a.frames_mb && !(*a.frames_mb >= 0 && *a.frames_mb <= 1e9))
    throw input_error("", "--frames-memory must be 0 to 1e+09 MB, got {}", *a.frames_mb);
  const RenderSettings& s = a.settings;
  if (std::max(s.output.width, s.output.height) > largest_side / std::max(a.picture_samples, 1))
    throw input_error(
        "", "--picture-samples {} of {}x{} pixels is a picture of more than {} pixels' width or height",
        a.picture_samples, s.output.width, s.output.height, largest_side);
  check_files(a);
}

bench::Task task_of(const BenchArguments& a) {
  const auto frames_bytes = [given = a.frames_mb,
                             half = std::optional<std::uint64_t>()](const std::string& device) mutable {
    if (given) return static_cast<std::uint64_t>(*given * 1e6);
    if (!half) half = api::half_of_device(device);
    return *half;
  };
  return {.settings = a.settings,
          .heads = a.heads,
          .distances = a.distances,
          .rounds = a.rounds,
          .picture_samples = a.picture_samples,
          .keep_pictures = !a.html.empty(),
          .frames_bytes = frames_bytes};
}

void compare(const BenchArguments& a, int& exit_status) {
  if (!a.scene.empty())
    throw input_error(a.scene, "--compare takes two results and renders nothing; it needs no scene");
  if (!a.html.empty())
    throw input_error("--html", "is for runs; --compare writes text, and JSON with --json");
  if (!a.json.empty() && a.json != "-") {
    check_writable(a.json);
    for (const std::string& read : a.compare)
      if (same_file(a.json, read))
        throw input_error(a.json, "is also what is compared; --json needs a name of its own");
  }
  const bench::RunComparison found =
      bench::compare_runs(bench::read_recorded(a.compare[0]), bench::read_recorded(a.compare[1]));
  if (!a.json.empty()) write_text(a.json, bench::comparison_json(found));
  if (a.json != "-") write_text("-", bench::comparison_text(found));
  if (!a.fail_if_slower || found.slower == 0) return;
  fmt::print(stderr, "dermis: {} of {} times are slower beyond the spread\n", found.slower, found.compared);
  exit_status = 1;
}

void check_some(const bench::Run& found) {
  if (found.cells.empty())
    throw input_error("", "stopped before the first cell was measured: nothing to write");
}

void run_paper(const BenchArguments& a, Renderer& renderer, const Scene& scene, const bench::Task& task,
               bench::Run& found) {
  bool first = true;
  bench::measure(renderer, scene, task, found, [&](const bench::Cell& cell) {
    if (a.json == "-") return;
    if (std::exchange(first, false)) write_text("-", bench::table_head(found));
    write_text("-", bench::table_line(cell));
  });

  check_some(found);
  const std::string page = a.html.empty() ? "" : bench::run_page(found);
  if (!a.html.empty()) write_file(a.html, page);
  if (!a.json.empty()) write_text(a.json, bench::run_json(found));
  if (a.json != "-") write_text("-", bench::table_foot(found));
}

void run_techniques(const BenchArguments& a, Renderer& renderer, const Scene& scene, const bench::Task& task,
                    bench::Run& found) {
  std::vector<std::string> names = a.techniques;
  if (names == std::vector<std::string>{"all"}) names.clear();
  const std::vector<bench::Variant> columns = bench::technique_variants(scene, task.settings, names);
  if (a.json != "-") write_text("-", bench::technique_grid_head(found, columns));
  bench::measure_techniques(renderer, scene, task, columns, found, [&](const bench::Cell& cell) {
    if (a.json != "-") write_text("-", bench::technique_grid_line(cell, found.settings));
  });

  check_some(found);
  if (!a.html.empty()) write_file(a.html, bench::technique_grid_page(found));
  if (!a.json.empty()) write_text(a.json, bench::technique_grid_json(found));
  if (a.json != "-") write_text("-", bench::technique_grid_foot(found));
}

void run(BenchArguments& a, const CLI::App& command, int& exit_status) {
  if (!a.compare.empty()) return compare(a, exit_status);
  if (a.fail_if_slower) throw input_error("--fail-if-slower", "is for --compare");
  if (a.quick) scale_down(a, command);

  sort_list("--heads", a.heads);
  sort_list("--distances", a.distances);
  bench::Task task = task_of(a);
  check(a, task);

  task.stop = &catch_interrupts();
  Renderer renderer({.device = a.device, .validate = false, .hooks = terminal_hooks()});
  const Scene scene = open_scene(a);
  const bool of_techniques = !a.techniques.empty();
  bench::Run found{
      .version = DERMIS_VERSION, .commit = commit(), .command = command_line(), .scene = scene.name()};
  found.cores = static_cast<int>(std::thread::hardware_concurrency());
  found.rounds = a.rounds;
  found.settings = a.settings;
  found.options = a.options;

  of_techniques ? run_techniques(a, renderer, scene, task, found)
                : run_paper(a, renderer, scene, task, found);
  save_settings(a);

  if (found.complete) return;
  fmt::print(stderr, "dermis: stopped after {} of {} cells; what is written holds those\n",
             found.cells.size(), bench::places_of(task).size());
  exit_status = 1;
}

void add_cells(CLI::App& command, BenchArguments& a) {
  const char* group = "Cells";
  command.add_option("--heads", a.heads, "numbers of heads in a row, 1.6 radii apart")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("N,N,..")
      ->default_str(fmt::format("{}", fmt::join(a.heads, ",")))
      ->group(group);
  command
      .add_option("--distances", a.distances,
                  "from the eye to the middle head, in radii of its bounding sphere")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("D,D,..")
      ->default_str(fmt::format("{}", fmt::join(a.distances, ",")))
      ->group(group);

  rare(command
           .add_option("--rounds", a.rounds,
                       "times that each variant is drawn, in turns, after it has warmed up")
           ->group(group));
  rare(command
           .add_option("--picture-samples", a.picture_samples,
                       "super-samples along each axis for the difference of the pictures; 0: no difference")
           ->group(group));

  command
      .add_option("--techniques", a.techniques,
                  "columns are techniques (all, or names of `render --technique`) instead of the paper's "
                  "optimisations: where does one overtake another?")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("all|" + one_of(technique_names()))
      ->default_str("")
      ->group(group);
}

}  // namespace

void add_bench_command(CLI::App& app, int& exit_status) {
  CLI::App* command = app.add_subcommand("bench",
                                         "the paper's test: heads in a row near and far, with and without "
                                         "the optimisations, next to the published speed-ups");

  auto a = std::make_shared<BenchArguments>();
  a->settings.output.width = 1920;
  a->settings.output.height = 1200;
  a->settings.quality.shadow_size = 2048;
  a->settings.lighting.rig_lights = 2;
  a->settings.skin.profile = "skin";
  a->settings.skin.translucency = false;  // [JG08] sec. 7: their test has none
  add_scene_arguments(*command, *a, SceneUse::bench);

  // Of the paper's test, whatever the scene brings along.
  command->get_option("--lights")->description("lights of the rig: key, fill, rim, further ones");
  command->get_option("--profile")
      ->description("diffusion profile: skin, a preset of `dermis profile`, or a JSON file");
  command->get_option("--fov")->description("vertical field of view, degrees")->default_str("20");

  add_cells(*command, *a);
  command->add_flag("--quick", a->quick,
                    "for a first look, where not given: 360x225 pixels, maps of 384, 1 and 4 heads, 3 "
                    "distances, 3 rounds, 2 super-samples");
  command->add_option("--json", a->json, "write the results as JSON, - for standard output")
      ->type_name("FILE");
  command
      ->add_option(
          "--html", a->html,
          "write a page: tables, curves, bars of passes, pictures of every cell under a slider; one file")
      ->type_name("FILE");
  add_device_option(*command, a->device);
  rare(
      command->add_option("--frames-memory", a->frames_mb,
                          "device memory for frames that wait for their turn, MB; those beyond are made anew "
                          "each time (default: half of it)"));

  command
      ->add_option("--compare", a->compare,
                   "two results written with --json, old and new: what has become slower or faster beyond "
                   "the spread; renders nothing")
      ->expected(2)
      ->type_name("OLD NEW")
      ->default_str("")
      ->group("Comparison");
  command
      ->add_flag("--fail-if-slower", a->fail_if_slower, "with --compare: exit status 1 if anything is slower")
      ->group("Comparison");

  command->callback([a, command, &exit_status] { run(*a, *command, exit_status); });
}

}  // namespace dermis::cli
