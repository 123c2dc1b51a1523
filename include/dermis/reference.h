// SPDX-License-Identifier: MIT
/// Ground truth on the CPU: the same scene, camera, lights and coefficients as the renderer's, without its
/// approximations. No device.
///
///   const dermis::RenderSettings settings{.output = {.width = 512, .height = 512}};
///   dermis::ReferencePicture truth = dermis::render_reference(scene, settings, {.samples = 256});
///   truth.picture.save("truth.exr");
///
/// Three models (docs/theory.md, "Ground truth"): "bssrdf" integrates the very profile that the real-time
/// techniques blur, over the surface, so a difference is the error of their method. "volume" follows light
/// through the medium, so a difference to "bssrdf" is the error of diffusion theory. "gaussians" is "bssrdf"
/// of every profile that the techniques take, those with a term without width too.
///
/// Takes minutes to hours. The picture depends on settings and seed only: threads, stops and checkpoints do
/// not change a bit of it. Hooks (dermis/hooks.h) that end it leave the samples that there are.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "dermis/renderer.h"

namespace dermis {

/// Progress of a run.
struct ReferenceProgress {
  int samples = 0, most_samples = 0;     ///< per pixel: so far, and at most
  double noise_percent = 100;            ///< mean standard error over skin, per cent of the mean
  double seconds = 0, seconds_left = 0;  ///< since the start of this run, and an estimate
};

/// Model by which light spreads in the skin.
enum class ReferenceModel : std::uint8_t {
  bssrdf,  ///< the profile, integrated over the surface
  volume,  ///< the medium, in which light is followed from one scattering to the next
  /// the Gaussians that techniques blur, gathered over the surface by straight distance; a term of variance 0
  /// leaves where it entered. With other profiles the same bits as bssrdf
  gaussians
};

/// Options of ground truth; RenderSettings say of which picture.
struct ReferenceSettings {
  ReferenceModel model = ReferenceModel::bssrdf;
  /// Of the model "volume": a preset, or "sigma_a=... sigma_s=... g=... eta=..." per mm; empty: the medium
  /// that the profile was made of.
  std::string medium;
  std::optional<int> samples;  ///< per pixel, 1 to 1e9; none: 64, or with noise_percent as many as it takes
  /// End as soon as the mean standard error over skin is at most so many per cent of the mean, but not before
  /// 32 samples; 1e-6 to 100.
  std::optional<double> noise_percent;
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0 (all cores) to 4096
  /// Written every half minute, and when hooks end the work. Not removed at the end: that is for the caller.
  /// Empty: none. If it cannot be written, the work goes on, with a warning.
  std::filesystem::path checkpoint;
  /// Go on from the checkpoint, or begin anew (with a note) if there is no such file.
  bool resume = false;
  /// Called by the calling thread after each sample of all pixels: what Hooks::progress does not tell. May be
  /// empty.
  std::function<void(const ReferenceProgress&)> after_sample{};
};

/// The truth, and how far to trust it.
struct ReferencePicture {
  Picture picture;  ///< statistics are empty but for the size
  /// Variance of each value of picture.linear_rgba: the square of its standard error. 0 with fewer samples
  /// than two blocks of 8, which say nothing about it.
  std::vector<float> variance_rgba;
  ReferenceModel model = ReferenceModel::bssrdf;  ///< that made it
  int samples = 0;                                ///< per pixel
  double noise_percent = 100;                     ///< as ReferenceProgress
  bool complete = false;                          ///< false: a hook has ended the work
  /// Of the model "volume": walks that left through a hole or a fold of the mesh, which counts as absorbed;
  /// per cent of all.
  double lost_percent = 0;

  /// Writes the variance as .exr, atomically. Throws InputError: another ending, a missing folder.
  void save_variance(const std::filesystem::path& path) const;
};

/// Computes the truth. Of RenderSettings, what concerns the real-time techniques alone (technique, quality,
/// skin.translucency, output.bloom, output.frames, output.show) is not used; camera.heads must be 1 and
/// output.exposure_ev given. Throws
/// - InputError: a setting out of range, an unknown name or medium, a checkpoint of another picture;
/// - DeviceError: too little memory for the triangles;
/// - Cancelled: a hook has ended the work before every pixel had a sample. Later it returns what there is;
/// - any exception of a hook, once the checkpoint is written.
ReferencePicture render_reference(const Scene& scene, const RenderSettings& settings,
                                  const ReferenceSettings& reference = {}, const Hooks& hooks = {});

/// A part of a picture: which pixels show it.
struct PictureRegion {
  std::string name;
  std::vector<std::uint8_t> mask;  ///< one per pixel, rows from top to bottom; 0 = outside
  std::size_t pixels = 0;          ///< inside
};

/// Returns the parts of a picture where techniques differ from the truth for different reasons, found from
/// the scene, its camera and its lights. They are "skin", "ears", "nose", "terminator", "shadow edges", "thin
/// parts", "folds", "seams" and "the rest"; docs/methodology.md defines each. Any may be empty. Needs no
/// device. Throws as render_reference() does, and Cancelled if a hook ends the work.
std::vector<PictureRegion> picture_regions(const Scene& scene, const RenderSettings& settings,
                                           const Hooks& hooks = {});

}  // namespace dermis
