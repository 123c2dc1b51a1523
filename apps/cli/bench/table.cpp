// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "cli/bench/paper.h"
#include "cli/bench/result.h"

namespace dermis::cli::bench {
namespace {

// Widths of columns: heads, distance, a time, a ratio.
constexpr const char* cell_format = "{:>5} {:>8} |";
constexpr const char* time_format = " {:>9}";
constexpr const char* ratio_format = " {:>8}";

// Three digits that count, so that both milliseconds and minutes stay readable.
std::string cell_time_text(double ms) {
  return ms >= 100 ? fmt::format("{:.0f}", ms) : fmt::format("{:.3g}", ms);
}

std::string cell_ratio_text(std::optional<double> ratio) {
  return ratio ? fmt::format("{:.2f}", *ratio) : "-";
}

std::string sizes_text(std::vector<int> sizes) {
  std::erase(sizes, 0);  // heads that are skipped
  if (sizes.empty()) return "-";
  const auto [low, high] = std::minmax_element(sizes.begin(), sizes.end());
  return *low == *high ? std::to_string(*low) : fmt::format("{}-{}", *low, *high);
}

}  // namespace

std::string table_head(const Run& run) {
  const RenderSettings& s = run.settings;
  std::string text = fmt::format(
      "{} ({}, Vulkan {})\n{}: {}x{} pixels, maps of {}, shadow maps of at most {}, {} samples, "
      "{} lights, {} Gaussians\n",
      run.device, run.driver, run.api, run.scene, s.output.width, s.output.height, s.quality.map_size,
      s.quality.shadow_size, s.quality.samples, run.lights, run.gaussians);
  text += fmt::format("frames in ms, medians of {} rounds\n\n", run.rounds) +
          fmt::format(fmt::runtime(cell_format), "heads", "distance");
  for (const Variant& variant : variants_of(s))
    text += fmt::format(fmt::runtime(time_format), variant.heading);
  for (const char* heading :
       {"| speed-up", "over skipping", "paper", "| compute", "over all", "| still", "over all"})
    text += fmt::format(" {}", heading);
  return text + " |   PSNR dB    FLIP | maps of all\n";
}

std::string table_line(const Cell& cell) {
  std::string text = fmt::format(fmt::runtime(cell_format), cell.heads, fmt::format("{:g}", cell.distance));
  for (const Measured& m : cell.measured)
    text += fmt::format(fmt::runtime(time_format), cell_time_text(m.ms()));
  text += fmt::format(" | {:>8} {:>13} {:>5}", cell_ratio_text(cell.speedup()),
                      cell_ratio_text(cell.speedup_over_skipping()),
                      cell_ratio_text(paper_speedup(cell.heads, cell.distance)));
  text += fmt::format(" | {:>7} {:>8}", cell_ratio_text(cell.speedup_of(compute_key, baseline_key)),
                      cell_ratio_text(cell.speedup_of(compute_key, optimised_key)));
  text += fmt::format(" | {:>5} {:>8} |", cell_ratio_text(cell.speedup_of(still_key, baseline_key)),
                      cell_ratio_text(cell.speedup_of(still_key, optimised_key)));
  if (const PictureDifference* d = cell.difference(optimised_key))
    text += fmt::format(" {:>9.2f} {:>7.4f} |", d->psnr_db, d->flip_mean);
  else
    text += fmt::format(" {:>9} {:>7} |", "-", "-");
  return text + fmt::format(" {}\n", sizes_text(cell.of(optimised_key).counts.used_size));
}

std::string paper_table(const Run& run) {
  std::string text = fmt::format("{:>8}", "heads");
  const std::vector<double> distances = distances_of(run.cells);
  for (const double distance : distances) text += fmt::format(" {:>13}", fmt::format("at {:g}", distance));
  for (const int heads : heads_of(run.cells)) {
    text += fmt::format("\n{:>8}", heads);
    for (const double distance : distances) {
      const Cell* cell = find_cell(run.cells, heads, distance);
      const std::string ours = cell ? cell_ratio_text(cell->speedup()) : "-";
      text += fmt::format(" {:>13}",
                          fmt::format("{} ({})", ours, cell_ratio_text(paper_speedup(heads, distance))));
    }
  }
  return text + "\n";
}

std::string table_foot(const Run& run) {
  std::string text = "\n";
  if (!run.cells.empty())
    for (const Measured& m : run.cells.front().measured)
      text += fmt::format("{:<9} {}\n", m.variant.heading, m.variant.meaning);
  text += "PSNR and FLIP: " + difference_meaning(run) + "\n";
  return text + "\nspeed-up of all over the baseline (the paper's, on a GeForce 8800 GTX):\n" +
         paper_table(run);
}

}  // namespace dermis::cli::bench
