// SPDX-License-Identifier: MIT
// Collects samples and estimates their noise.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "image/image.h"
#include "truth/reference/tracer.h"

namespace dermis::reference {

class Film {
 public:
  Film(int width, int height);

  /// Adds one sample of every pixel, row by row. Sums are in the order of the samples, for any number of
  /// threads.
  void add(const std::vector<Tracer::Sample>& pass);

  int width() const { return width_; }
  int height() const { return height_; }
  std::uint32_t samples() const { return samples_; }

  /// Returns radiance, and the share of skin as alpha.
  image::ImageF picture() const;
  /// Returns the variance of each channel of picture(), from the scatter of the means of blocks of samples,
  /// which are independent (random.h): (mean of squares - square of mean) / (blocks - 1). Alpha: its own. 0
  /// with fewer than two blocks, which say nothing.
  image::ImageF variance() const;
  /// Returns the mean standard error in per cent of the mean, over skin (pixels at least half skin; over all
  /// pixels if there is none) and channels. 100 with fewer than two blocks; 0 for a black picture.
  double noise_percent() const;

  /// Returns all sums as bytes, exactly; restore() returns false for another number of bytes.
  std::vector<std::byte> state() const;
  bool restore(std::span<const std::byte> state);

 private:
  double variance_of_mean(std::size_t value) const;

  int width_, height_;
  std::uint32_t samples_ = 0;
  std::vector<double> sums_;     // r g b skin per pixel
  std::vector<double> squares_;  // squares of the sums of complete blocks
  std::vector<double> block_;    // sums of the incomplete block
};

}  // namespace dermis::reference
