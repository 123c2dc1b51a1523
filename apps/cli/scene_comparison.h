// SPDX-License-Identifier: MIT
// `dermis compare --scene`: every technique against ground truth from the same scene, cost and error side by
// side.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "dermis/reference.h"
#include "dermis/renderer.h"
#include "image/image.h"
#include "settings/json.h"

namespace dermis::cli {

/// What is compared with what.
struct SceneComparisonSettings {
  RenderSettings render;  ///< size, camera, lights, maps of all techniques; the technique itself is not used
  ReferenceSettings reference;
  std::vector<std::string> techniques;  ///< none: all
  bool each_optimisation = false;       ///< rows for none, cull, depth, clip and all as well
  bool one_gaussian = true;  ///< a row with a single Gaussian of each technique that has light maps
  bool curves = false;       ///< SceneComparison::curves
  /// errors are of pictures this many times as wide and high, averaged down
  int supersample = 4;
  std::string reference_file;  ///< linear EXR; empty: rendered
  std::string variance_file;   ///< of reference_file; empty: none
  std::string device = "best";
  Hooks hooks{};  ///< for all of it
};

/// Over the pixels of a region.
struct RegionError {
  double flip = 0;      ///< mean, of display values
  double hdr_flip = 0;  ///< mean, of linear light
  double psnr_db = 0;   ///< of display values
  double rel_mse = 0;   ///< of linear light
  /// The same less what the reference's noise adds to it, which its variance says; may fall below 0 by
  /// chance.
  std::optional<double> rel_mse_unbiased;
  double share = 0;  ///< of the summed FLIP over skin, 0 to 1
};

struct ComparedTechnique {
  std::string name;                                ///< for people: "texture-space, one Gaussian"
  Statistics statistics;                           ///< of frames at the size of the picture, drawn in turns
  std::vector<std::optional<RegionError>> errors;  ///< one a region; none: the region is empty
  /// Over skin, of the picture itself, not of a larger one: filtering and the resolution of a blur in the
  /// picture count. None: supersample is 1, and `errors` say it.
  std::optional<RegionError> at_size;

  double ms() const { return statistics.frame_ms_median; }
  image::Image8 shown;
  image::ImageF flip_map;
};

/// Returns taps of blurs per pixel of skin; 0: not counted, or none.
inline double taps_per_pixel(const Statistics& s) {
  return s.skin_pixels == 0 ? 0 : static_cast<double>(s.light_reads) / static_cast<double>(s.skin_pixels);
}

/// A technique with one of its quality settings.
struct QualityPoint {
  std::string curve, label;    ///< as comparison::QualitySetting
  double ms = 0;               ///< median, of the same turns as the techniques
  double taps_per_pixel = 0;   ///< as ComparedTechnique
  RegionError error, at_size;  ///< over skin
};

struct SceneComparison {
  std::string scene, tone_map, model;
  SettingsFile settings;         ///< as they were given
  std::string reference_file;    ///< empty: rendered now
  int samples = 0;               ///< of the reference, if it was rendered now
  double noise_percent = 0;      ///< the same
  double reference_seconds = 0;  ///< the same
  int width = 0, height = 0, supersample = 1;
  double exposure_ev = 0;  ///< of all pictures; chosen by a frame of texture-space where none was given
  std::vector<PictureRegion> regions;  ///< "skin" first
  image::Image8 shown_reference;
  std::vector<ComparedTechnique> techniques;
  std::vector<QualityPoint> curves;
  /// What the reference's own noise adds up to, measured as an error: the reference against itself with noise
  /// of its variance.
  std::optional<std::vector<std::optional<RegionError>>> noise;
};

/// Throws InputError for what can be refused before anything is drawn: an unknown technique, a size.
void check_comparison(const SceneComparisonSettings& settings);

/// InputError: a setting out of range, an unknown technique (lists the known ones), a reference of another
/// size, no skin in the picture. DeviceError: as the renderer.
SceneComparison compare_scene(const Scene& scene, const SceneComparisonSettings& settings);

std::string scene_comparison_text(const SceneComparison& comparison);
std::string scene_comparison_json(const SceneComparison& comparison);
nlohmann::ordered_json scene_comparison_object(const SceneComparison& comparison);
/// Tables, error over cost, the reference, its regions, and for each technique a slider against it and a map
/// of the error, all maps on one scale.
std::string scene_comparison_page(const SceneComparison& comparison);
/// The same without the frame of a document. `id`: what the names of its pictures begin with.
std::string scene_comparison_body(const SceneComparison& comparison, const std::string& id);
/// A chart of the points of the curves, and of the techniques where there are none; empty without either.
std::string error_over_cost(const SceneComparison& comparison);

}  // namespace dermis::cli
