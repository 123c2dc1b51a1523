// SPDX-License-Identifier: MIT
// Takes the times of the cells.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <vector>

#include "cli/bench/result.h"
#include "dermis/renderer.h"

namespace dermis::cli::bench {

struct Task {
  RenderSettings settings;  ///< common; heads and distance are those of the cell
  std::vector<int> heads;
  std::vector<double> distances;
  int rounds = 5;
  int picture_samples = 4;     ///< super-samples along each axis for the picture difference; 0: no difference
  bool keep_pictures = false;  ///< for a page
  /// Device memory that the frames of a cell may hold while they wait for their turn, given the name of the
  /// device.
  std::function<std::uint64_t(const std::string&)> frames_bytes;
  const std::atomic<bool>* stop = nullptr;
};

/// The cells of a task in the order they are measured: few heads first.
struct Place {
  int heads = 1;
  double distance = 0;
};
std::vector<Place> places_of(const Task& task);

/// The settings of a cell.
RenderSettings settings_at(const Task& task, const Place& place);

/// Measures all cells into `run`; after_cell is called with each as soon as it is there (then run has its
/// device, too). Stops early, with run.complete = false, when the task says so. Every variant has warmed up
/// before it is timed; a round draws each variant once, in turns, so that what changes on the machine in the
/// meantime changes all alike. Errors as Renderer::prepare().
void measure(Renderer& renderer, const Scene& scene, const Task& task, Run& run,
             const std::function<void(const Cell&)>& after_cell);

}  // namespace dermis::cli::bench
