// SPDX-License-Identifier: MIT
// The results of a run of the benchmark.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/bench/statistics.h"
#include "cli/bench/variants.h"
#include "dermis/renderer.h"
#include "image/image.h"

namespace dermis::cli::bench {

/// One variant of a cell.
struct Measured {
  Variant variant;
  std::vector<double> rounds_ms;       ///< of whole frames, in the order they were drawn
  std::vector<PassStatistics> passes;  ///< merged over heads, medians over rounds
  Statistics counts;                   ///< of a frame that was not timed: texels, sizes, mask

  Spread spread() const { return spread_of(rounds_ms); }
  double ms() const { return spread().median; }
};

/// The picture of a variant against the baseline's, over the pixels that are skin in either.
struct PictureDifference {
  double psnr_db = 0, flip_mean = 0;
  std::uint64_t pixels = 0;
  int samples = 0;  ///< super-samples along each axis
};

struct Cell {
  int heads = 1;
  double distance = 0;  ///< sphere radii
  std::vector<Measured> measured;
  /// By the key of Variant::compared; none: not asked for, or no skin in the picture.
  std::map<std::string, PictureDifference> differences;

  const Measured& of(const std::string& key) const;
  bool has(const std::string& key) const;
  /// nullptr: none.
  const PictureDifference* difference(const std::string& key) const;
  double speedup() const { return of(baseline_key).ms() / of(optimised_key).ms(); }
  double speedup_over_skipping() const { return of(skipping_key).ms() / of(optimised_key).ms(); }
  /// Returns how many times faster than another variant one is; none: the cell has it not.
  std::optional<double> speedup_of(const std::string& key, const std::string& over) const;
  /// Returns how many ms more than a frame without scattering (`floor`) a variant takes; none: likewise.
  std::optional<double> ms_over(const std::string& key, const std::string& floor) const;
};

/// For the page: display pictures, cut to where skin is.
struct CellPictures {
  image::Image8 baseline, optimised;
};

/// Light maps of one cell, coloured as in [JG08] figure 3.
struct MapPictures {
  int heads = 1;
  double distance = 0;
  image::Image8 irradiance, visibility, picture;
};

struct Run {
  std::string version, commit, command, scene;
  std::string device, driver, api, timing;
  int cores = 0;
  int lights = 0, gaussians = 0, rounds = 0;
  RenderSettings settings;  ///< common to all cells and variants
  SceneOptions options;
  std::vector<Cell> cells;
  bool complete = true;                ///< false: stopped by Ctrl-C
  std::vector<CellPictures> pictures;  ///< one per cell, or none
  std::optional<MapPictures> maps;
};

/// Returns times, passes and settings of a variant, as `variants` of a cell has them.
nlohmann::ordered_json variant_object(const Measured& measured);

/// For programs. Keys that others rely on: see docs/methodology.md.
std::string run_json(const Run& run);

/// Returns the two pictures that PSNR and FLIP of a cell compare, in words, with the tone map of their
/// display values.
std::string difference_meaning(const Run& run);

/// For people: a line for a cell as soon as it is there, and what stands above and below the lines.
std::string table_head(const Run& run);
std::string table_line(const Cell& cell);
std::string table_foot(const Run& run);
/// Speed-ups laid out as [JG08] table 1, ours over the paper's.
std::string paper_table(const Run& run);

/// Heads and distances that have a cell, ascending.
std::vector<int> heads_of(const std::vector<Cell>& cells);
std::vector<double> distances_of(const std::vector<Cell>& cells);
/// nullptr: none.
const Cell* find_cell(const std::vector<Cell>& cells, int heads, double distance);

}  // namespace dermis::cli::bench
