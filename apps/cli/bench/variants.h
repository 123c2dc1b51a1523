// SPDX-License-Identifier: MIT
// The variants that a cell of the benchmark draws in turns.
#pragma once

#include <string>
#include <vector>

#include "dermis/renderer.h"

namespace dermis::cli::bench {

struct Variant {
  std::string key;      ///< of JSON: KEY_ms
  std::string heading;  ///< of a column
  std::string meaning;  ///< one line
  RenderSettings settings;
  bool compared = false;  ///< its picture, with the baseline's
};

inline constexpr const char* baseline_key = "baseline";  ///< of speed-ups
/// the second baseline: without heads that no part of is in the picture
inline constexpr const char* skipping_key = "skip";
inline constexpr const char* optimised_key = "all";  ///< whose speed-up and picture are reported
/// clipped at the very edge of the picture, as in [JG08]
inline constexpr const char* at_edge_key = "all_margin_0";
/// all, by texture-space, with ids
inline constexpr const char* compute_key = "compute";
inline constexpr const char* still_key = "still";  ///< `compute`, with the shadow maps of the frame before
inline constexpr const char* floor_key = "lambert";

/// All variants of one cell, from settings that hold for each of them: same shaders, same sizes, same lights.
/// Their differences stand here and nowhere else. The baselines and `lambert` are not optimised, whatever
/// the settings say, and only the variants of the steps beyond the paper take these.
std::vector<Variant> variants_of(const RenderSettings& common);

}  // namespace dermis::cli::bench
