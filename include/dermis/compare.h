// SPDX-License-Identifier: MIT
/// Distances of pictures: FLIP, relative squared error, PSNR. And every technique of a scene against its
/// ground truth, as rows.
///
///   const dermis::Flip f = dermis::flip({truth.display_rgba, 512, 512}, {picture.display_rgba, 512, 512});
///   const dermis::SceneComparison table =
///       dermis::compare_scene(scene, {.render = settings, .techniques = {"texture-space", "lambert"}});
///   for (const dermis::ComparedTechnique& row : table.techniques) use(row.name, row.ms(), row.errors[0]);
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dermis/reference.h"
#include "dermis/renderer.h"

namespace dermis {

/// Pixels of a caller, rows from top to bottom, without padding: `channels` values each, 3 or 4. The fourth
/// is not compared.
template <class Value>
struct Pixels {
  std::span<const Value> values;
  int width = 0, height = 0;
  int channels = 4;
};
using DisplayPixels = Pixels<std::uint8_t>;  ///< sRGB, as a display shows them
using LinearPixels = Pixels<float>;          ///< linear light

/// Pixels that count: empty (all), or one value per pixel, 0: it does not.
using PixelMask = std::span<const std::uint8_t>;

/// FLIP: how large a difference looks to someone who flips between two pictures on a screen with 67 pixels
/// per degree. 0 (none) to 1.
struct Flip {
  std::vector<float> map;  ///< one per pixel
  double mean = 0;         ///< over the mask
  /// Exposures at which a reference of linear light was shown: from, to, how many. Else 0.
  double start_exposure = 0, stop_exposure = 0;
  int exposures = 0;
};

// All throw InputError: sizes or channels that differ, values that are too few or too many, a value that is
// not finite. Also a mask of another size or without a pixel.

/// FLIP of display values [Andersson et al. 2020].
Flip flip(const DisplayPixels& reference, const DisplayPixels& test, PixelMask mask = {});
/// HDR-FLIP of linear light [Andersson et al. 2021]: the largest FLIP over exposures, which the reference
/// chooses.
Flip flip(const LinearPixels& reference, const LinearPixels& test, PixelMask mask = {});
/// Returns 10 log10(255^2 / mean squared difference) of R, G and B, at most 100 (equal pictures).
double psnr_db(const DisplayPixels& reference, const DisplayPixels& test, PixelMask mask = {});
/// Returns the mean of (test - reference)^2 / (reference^2 + 0.01) over R, G and B [Rousselle et al. 2011].
double relative_mse(const LinearPixels& reference, const LinearPixels& test, PixelMask mask = {});
/// Returns an estimate of relative_mse() against a reference without noise. `variance`: of its values, the
/// squares of their standard errors, at least 0. Below 0 by chance.
double relative_mse_less_noise(const LinearPixels& reference, const LinearPixels& variance,
                               const LinearPixels& test, PixelMask mask = {});

/// Settings of compare_scene().
struct SceneComparisonSettings {
  RenderSettings render{};  ///< of all techniques: size, camera, lights, maps; its own technique is not used
  ReferenceSettings reference{};
  std::vector<std::string> techniques{};  ///< names of technique_names(); none: all that can draw the scene
  bool each_optimisation = false;         ///< rows for none, cull, depth, clip and all as well
  bool one_gaussian = true;  ///< a row with a single Gaussian of each technique that has light maps
  bool curves = false;       ///< SceneComparison::curves
  /// errors are of pictures this many times as wide and high, averaged down; 1 to 16
  int supersample = 4;
  std::string reference_file{};  ///< linear EXR; empty: rendered
  std::string variance_file{};   ///< of reference_file; empty: none
  /// in place of both: a truth that is there, of the same size and exposure; must outlive the call
  const ReferencePicture* truth = nullptr;
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

/// A row of the table.
struct ComparedTechnique {
  std::string name;                                ///< for people: "texture-space, one Gaussian"
  Statistics statistics;                           ///< of frames at the size of the picture, drawn in turns
  std::vector<std::optional<RegionError>> errors;  ///< one a region; none: the region is empty
  /// Over skin, of the picture itself, not of a larger one: filtering and the resolution of a blur in the
  /// picture count. None: supersample is 1, and `errors` say it.
  std::optional<RegionError> at_size;
  std::vector<std::uint8_t> display_rgba;  ///< averaged down
  std::vector<float> flip;                 ///< of display_rgba, one per pixel

  /// Returns the median of the frames.
  double ms() const { return statistics.frame_ms_median; }
};

/// Returns taps of blurs per pixel of skin; 0: not counted, or none.
inline double taps_per_pixel(const Statistics& s) {
  return s.skin_pixels == 0 ? 0 : static_cast<double>(s.light_reads) / static_cast<double>(s.skin_pixels);
}

/// A technique with one of its quality settings.
struct QualityPoint {
  std::string curve, label;    ///< "separable, kernel profile"; "25 taps"
  double ms = 0;               ///< median, of the same turns as the techniques
  double taps_per_pixel = 0;   ///< as ComparedTechnique
  RegionError error, at_size;  ///< over skin
};

struct SceneComparison {
  std::string scene, tone_map, model;
  std::string reference_file;    ///< empty: rendered now, or given
  int samples = 0;               ///< of the reference, if it is not of a file
  double noise_percent = 0;      ///< the same
  double reference_seconds = 0;  ///< of one that was rendered now
  int width = 0, height = 0, supersample = 1;
  double exposure_ev = 0;  ///< of all pictures; chosen by a frame of texture-space where none was given
  std::vector<PictureRegion> regions;           ///< "skin" first
  std::vector<std::uint8_t> reference_display;  ///< RGBA
  std::vector<ComparedTechnique> techniques;
  std::vector<QualityPoint> curves;
  /// The reference's own noise, measured as an error: the reference against itself with noise of its
  /// variance.
  std::optional<std::vector<std::optional<RegionError>>> noise;
};

/// Throws InputError for what can be refused before anything is drawn: an unknown technique, a size.
void check_comparison(const SceneComparisonSettings& settings);

/// Draws every technique and the truth, and compares them. Times are medians of render.output.frames frames,
/// all techniques in turns. Throws InputError: a setting out of range, an unknown technique (lists the known
/// ones), a reference of another size, no skin in the picture. DeviceError: as the renderer. Cancelled.
SceneComparison compare_scene(const Scene& scene, const SceneComparisonSettings& settings);

}  // namespace dermis
