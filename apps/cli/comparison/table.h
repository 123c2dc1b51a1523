// SPDX-License-Identifier: MIT
// `dermis compare --scene --table`: every technique over sizes, distances and test scenes, with what it
// costs, how far it is from the truth, and where it is the right choice.
#pragma once

#include <string>
#include <vector>

#include "cli/scene_comparison.h"

namespace dermis::cli::comparison {

struct PictureSize {
  int width = 0, height = 0;  ///< pixels
};

struct TableSettings {
  SceneComparisonSettings comparison;  ///< of all cases; size and distance are those of the case
  std::vector<PictureSize> sizes{{1280, 720}, {640, 360}};
  std::vector<double> distances{2.5, 10};  ///< radii of the head's sphere
  /// names of test scenes, drawn at the smallest of the sizes: their own cameras and lights
  std::vector<std::string> test_scenes;
};

/// One comparison of the table.
struct Case {
  std::string name;   ///< "1280x720, 2.5 radii", "test:nose"
  std::string shows;  ///< of a test scene: what it is for
  bool is_test = false;
  SceneComparison found;
};

struct Table {
  std::string scene;
  SettingsFile settings;  ///< as they were given
  std::vector<Case> cases;
  bool complete = true;  ///< false: stopped by a hook, with the cases that were done
};

/// Returns what the names of --test-scenes mean: "all", "none", or names with or without "test:". Throws
/// InputError for an unknown one.
std::vector<std::string> test_scenes_of(const std::vector<std::string>& names);

/// Compares case by case; ends early when hooks of the settings say so, unless no case is there: then throws
/// Cancelled. Throws as compare_scene() does, before the first case for what is refused.
Table compare_table(const Scene& scene, const TableSettings& settings);

/// Returns relMSE less the noise of the reference where that is known; at least a hundredth of the noise.
double less_noise(const RegionError& error);

/// Cost and error of one technique in one case, over skin.
struct Figures {
  double ms = 0, taps_per_pixel = 0, device_mb = 0;
  double rel_mse = 0;  ///< less_noise() of the picture that took this time
  double larger = 0;   ///< the same of larger pictures, averaged down
  double flip = 0;     ///< of these
};
Figures figures_of(const ComparedTechnique& technique);

/// Returns the table in words. For every case: the nearest technique, the fastest, and others that are worth
/// their time. For every technique: where it is the right choice, and where none is. A row with one Gaussian
/// is not a technique of its own here.
std::vector<std::string> verdict(const Table& table);

std::string table_text(const Table& table);
std::string table_json(const Table& table);
/// Verdict, tables, curves of error over cost, and for each case all that scene_comparison_page() has.
std::string table_page(const Table& table);

}  // namespace dermis::cli::comparison
