// SPDX-License-Identifier: MIT
/// Ground truth on the CPU: the same scene, camera, lights and coefficients as the renderer's, without its
/// approximations. No device.
///
///   const dermis::RenderSettings settings{.output = {.width = 512, .height = 512}};
///   dermis::ReferencePicture truth = dermis::render_reference(scene, settings, {.samples = 256});
///   truth.picture.save("truth.exr");
///
/// Two models (docs/theory.md, "Ground truth"): "bssrdf" integrates the very profile that the real-time
/// techniques blur, over the surface, so a difference is the error of their method; "volume" follows light
/// through the medium, so a difference to "bssrdf" is the error of diffusion theory.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "dermis/renderer.h"

namespace dermis {

struct ReferenceProgress {
  int samples = 0, most_samples = 0;  ///< a pixel, so far and at most
  double noise_percent = 100;         ///< mean standard error over skin, per cent of the mean
  double seconds = 0, seconds_left = 0;
};

struct ReferenceSettings {
  std::string model = "bssrdf";  ///< bssrdf, volume
  std::string medium;  ///< volume: a preset, or "sigma_a=... sigma_s=... g=... eta=..." per mm; empty: what
                       ///< the profile was made of
  std::optional<int> samples;  ///< a pixel, 1 to 1e9; none: 64, or with noise_percent as many as it takes
  /// end as soon as the mean standard error over skin is this part of the mean; > 0
  std::optional<double> noise_percent;
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: all cores; the picture does not depend on it
  /// written every half minute and when stopped, removed at the end; empty: none
  std::filesystem::path checkpoint;
  /// go on from the checkpoint, if there is one: equal bits to a run that never stopped
  bool resume = false;
  const std::atomic<bool>* stop = nullptr;  ///< set by another thread or a signal: ends with what there is
  std::function<void(const ReferenceProgress&)> progress{};  ///< after each sample of all pixels
};

struct ReferencePicture {
  Picture picture;                   ///< statistics are empty but for the size
  std::vector<float> variance_rgba;  ///< of each value of picture.linear_rgba
  int samples = 0;
  double noise_percent = 100;
  bool complete = false;  ///< false: stopped; with 0 samples the picture is black
  /// volume: walks that left through a hole or a fold of the mesh, which counts as absorbed
  double lost_percent = 0;

  /// The variance as .exr, atomically.
  void save_variance(const std::filesystem::path& path) const;
};

/// Of RenderSettings, what concerns the real-time techniques alone (technique, quality, skin.translucency,
/// output.bloom, output.frames, output.show) is not used, and camera.heads must be 1. InputError: a setting
/// out of range, an unknown name, a checkpoint of another picture, a medium that is not known. DeviceError:
/// too little memory for the triangles.
ReferencePicture render_reference(const Scene& scene, const RenderSettings& settings,
                                  const ReferenceSettings& reference = {});

/// A part of a picture: which pixels show it.
struct PictureRegion {
  std::string name;
  std::vector<std::uint8_t> mask;  ///< width * height, rows from top to bottom; 0 = outside
  std::size_t pixels = 0;          ///< inside
};

/// Where techniques differ from the truth for different reasons, from the scene, its camera and its lights:
/// "skin", "ears", "nose", "terminator", "shadow edges", "thin parts", "folds", "seams", "the rest"
/// (docs/truth.md says how each is found). Any may be empty. No device. Errors as render_reference().
std::vector<PictureRegion> picture_regions(const Scene& scene, const RenderSettings& settings);

/// "bssrdf", "volume".
std::vector<std::string> reference_models();

}  // namespace dermis
