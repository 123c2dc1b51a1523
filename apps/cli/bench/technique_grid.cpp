// SPDX-License-Identifier: MIT
#include "cli/bench/technique_grid.h"

#include <fmt/format.h>

#include "base/core/error.h"
#include "base/core/log.h"
#include "cli/bench/contest.h"
#include "cli/progress.h"
#include "render/techniques/technique.h"

namespace dermis::cli::bench {
namespace {

void add_columns(const Scene& scene, const RenderSettings& common, const std::string& name,
                 std::vector<Variant>& to) {
  RenderSettings s = common;
  s.technique = name;
  s.quality.keep_shadows = false;  // a frame in which everything moves
  describe_plan(scene, s);
  const techniques::Technique& technique = techniques::find_technique(name);
  to.push_back({name, name, std::string(technique.summary), s});
}

/// None if stopped.
std::optional<Cell> technique_cell(Renderer& renderer, const Scene& scene, const Task& task,
                                   const Place& place, const std::vector<Variant>& columns, Run& run) {
  const auto stopped = [&] { return task.stop && *task.stop; };
  std::vector<Variant> variants = columns;
  for (Variant& variant : variants) {
    variant.settings.camera.heads = place.heads;
    variant.settings.camera.distance = place.distance;
  }

  Contest contest(renderer, scene, std::move(variants), task.frames_bytes);
  const auto each = [&](const std::string& what, const auto& action) {
    for (std::size_t i = 0; i < contest.size() && !stopped(); ++i) {
      show_line(fmt::format("{} heads at {:g} radii, {}: {}", place.heads, place.distance, what,
                            contest.measured(i).variant.heading));
      action(i);
    }
  };

  each("warm-up", [&](std::size_t i) {
    const Statistics s = contest.warm_up(i).statistics;
    run.device = s.device, run.driver = s.driver, run.api = s.api, run.timing = s.timing;
    run.lights = s.lights, run.gaussians = std::max(run.gaussians, s.gaussians);
  });
  contest.wake_the_device(stopped);
  for (int round = 0; round < task.rounds; ++round)
    each(fmt::format("round {} of {}", round + 1, task.rounds), [&](std::size_t i) { contest.draw(i); });
  if (stopped()) return std::nullopt;
  return Cell{
      .heads = place.heads, .distance = place.distance, .measured = contest.finish(), .differences = {}};
}

}  // namespace

std::vector<Variant> technique_variants(const Scene& scene, const RenderSettings& common,
                                        const std::vector<std::string>& names) {
  std::vector<Variant> columns;
  if (!names.empty()) {
    for (const std::string& name : names) add_columns(scene, common, name, columns);
    return columns;
  }

  for (const std::string& name : technique_names()) {
    try {
      add_columns(scene, common, name, columns);
    } catch (const InputError& why) { warn("technique '{}' is left out: {}", name, why.what()); }
  }
  if (columns.empty()) add_columns(scene, common, technique_names().front(), columns);
  return columns;
}

void measure_techniques(Renderer& renderer, const Scene& scene, const Task& task,
                        const std::vector<Variant>& columns, Run& run,
                        const std::function<void(const Cell&)>& after_cell) {
  const std::vector<Place> places = places_of(task);
  for (const Place& place : places) {
    std::optional<Cell> cell;
    try {
      cell = technique_cell(renderer, scene, task, place, columns, run);
    } catch (const Cancelled&) {
      // Stopped while a frame was prepared: the cells before it count.
    }
    if (!cell) break;
    run.cells.push_back(std::move(*cell));
    show_line("");
    after_cell(run.cells.back());
  }
  run.complete = run.cells.size() == places.size();
}

}  // namespace dermis::cli::bench
