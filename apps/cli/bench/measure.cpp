// SPDX-License-Identifier: MIT
#include "cli/bench/measure.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/core/error.h"
#include "cli/bench/contest.h"
#include "cli/bench/pictures.h"
#include "cli/progress.h"

namespace dermis::cli::bench {
namespace {

// The time of a cell beside others, in frames of one head. Work that does not depend on heads costs about
// half a head.
double work_of(const Place& place) { return place.heads + 0.5; }

// Two frames, and as much again for their many pixels.
constexpr double picture_work = 4;

struct Bench {
  Renderer& renderer;
  const Scene& scene;
  const Task& task;
  Run& run;
  Progress progress;

  bool stopped() const { return task.stop && *task.stop; }

  /// None if stopped.
  std::optional<Cell> cell(const Place& place) {
    const std::string where =
        fmt::format("{} head{} at {:g} radii", place.heads, place.heads == 1 ? "" : "s", place.distance);
    std::optional<Contest> contest(std::in_place, renderer, scene, variants_of(settings_at(task, place)),
                                   task.frames_bytes);
    std::optional<Picture> baseline, optimised;
    const auto each = [&](const std::string& what, const auto& action) {
      for (std::size_t i = 0; i < contest->size() && !stopped(); ++i) {
        progress.show(fmt::format("{}, {}: {}", where, what, contest->measured(i).variant.heading));
        action(i);
        progress.done(work_of(place));
      }
    };
    each("warm-up", [&](std::size_t i) {
      Picture picture = contest->warm_up(i);
      const std::string& key = contest->measured(i).variant.key;
      if (key == baseline_key)
        baseline = std::move(picture);
      else if (key == optimised_key)
        optimised = std::move(picture);
    });
    contest->wake_the_device([&] { return stopped(); });
    for (int round = 0; round < task.rounds; ++round)
      each(fmt::format("round {} of {}", round + 1, task.rounds), [&](std::size_t i) { contest->draw(i); });
    if (stopped()) return std::nullopt;
    Cell cell{
        .heads = place.heads, .distance = place.distance, .measured = contest->finish(), .differences = {}};
    contest.reset();  // its memory, before larger pictures are made
    describe(optimised->statistics);
    if (task.keep_pictures) run.pictures.push_back(cut_to_skin(*baseline, *optimised));
    baseline.reset();
    compare(place, where, optimised->statistics.d_ref, cell);
    return stopped() ? std::nullopt : std::optional(std::move(cell));
  }

  void compare(const Place& place, const std::string& where, double d_ref, Cell& cell) {
    if (task.picture_samples == 0) return;
    progress.show(where + ", pictures");
    cell.differences = picture_differences(renderer, scene, cell, d_ref, task.picture_samples);
    progress.done(picture_work * work_of(place));
  }

  void describe(const Statistics& s) {
    run.device = s.device, run.driver = s.driver, run.api = s.api;
    run.timing = s.timing;
    run.lights = s.lights, run.gaussians = s.gaussians;
  }
};

}  // namespace

std::vector<Place> places_of(const Task& task) {
  std::vector<Place> places;
  for (const int heads : task.heads)
    for (const double distance : task.distances) places.push_back({heads, distance});
  return places;
}

RenderSettings settings_at(const Task& task, const Place& place) {
  RenderSettings s = task.settings;
  s.camera.heads = place.heads;
  s.camera.distance = place.distance;
  return s;
}

void measure(Renderer& renderer, const Scene& scene, const Task& task, Run& run,
             const std::function<void(const Cell&)>& after_cell) {
  // Add up the work ahead, in frames of about one head, for the progress line.
  double total = 0;
  const auto frames = static_cast<double>(variants_of(task.settings).size()) * (task.rounds + 1);
  for (const Place& place : places_of(task))
    total += work_of(place) * (frames + (task.picture_samples == 0 ? 0 : picture_work));

  Bench bench{renderer, scene, task, run, Progress(total)};
  for (const Place& place : places_of(task)) {
    std::optional<Cell> cell;
    try {
      cell = bench.cell(place);
    } catch (const Cancelled&) {
      // Stopped while a frame was prepared: the cells before it count.
    }
    if (!cell) break;
    run.cells.push_back(std::move(*cell));
    bench.progress.clear();
    after_cell(run.cells.back());
  }

  run.complete = run.cells.size() == places_of(task).size();
  if (run.pictures.size() > run.cells.size()) run.pictures.pop_back();  // of the cell that was not finished

  if (!task.keep_pictures || run.cells.empty() || bench.stopped()) return;
  const Cell& first = run.cells.front();  // fewest heads, nearest
  run.maps = map_pictures(renderer, scene, first.of(baseline_key).variant.settings,
                          first.of(optimised_key).variant.settings);
}

}  // namespace dermis::cli::bench
