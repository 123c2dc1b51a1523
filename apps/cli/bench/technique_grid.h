// SPDX-License-Identifier: MIT
// `dermis bench --techniques`: techniques as columns over heads and distances, and where one overtakes
// another.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/bench/measure.h"

namespace dermis::cli::bench {

/// Returns a column per technique with the settings that hold for all. No names: all that can draw the scene;
/// what a named one cannot draw is refused, InputError.
std::vector<Variant> technique_variants(const Scene& scene, const RenderSettings& common,
                                        const std::vector<std::string>& names);

/// Measures all cells of a task into `run`, as measure() does; pictures and their differences are not made.
void measure_techniques(Renderer& renderer, const Scene& scene, const Task& task,
                        const std::vector<Variant>& columns, Run& run,
                        const std::function<void(const Cell&)>& after_cell);

/// Share of the picture that is skin, 0 to 1.
double coverage_of(const Cell& cell, const RenderSettings& settings);

/// Milliseconds of what does not depend on the eye (shadow maps; light maps and their convolutions), and of
/// the rest, which every view has again.
struct ViewCost {
  double shared_ms = 0, per_view_ms = 0;
  double of(int views) const { return shared_ms + views * per_view_ms; }
};
ViewCost view_cost(const Measured& measured);

/// Sentences: in which cells the technique of the first column, in its fastest column there, is faster than
/// each other one, between which coverages and numbers of heads they cross, and with how many views, if light
/// maps were shared by all.
std::vector<std::string> crossovers(const Run& run);

std::string technique_grid_head(const Run& run, const std::vector<Variant>& columns);
std::string technique_grid_line(const Cell& cell, const RenderSettings& settings);
std::string technique_grid_foot(const Run& run);
std::string technique_grid_json(const Run& run);
/// A table, a chart of times over distances for each number of heads, the crossovers.
std::string technique_grid_page(const Run& run);

}  // namespace dermis::cli::bench
