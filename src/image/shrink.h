// SPDX-License-Identifier: MIT
// Downsamples pictures while they are read, so that the large picture is never in memory.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "image/image.h"

namespace dermis::image {

/// Downsampling of a picture while it is read. Both sides are halved `halvings` times (rounded down, at least
/// 1), and each pixel is the exact average of its area. `srgb`: averages colours in linear light, weighted by
/// alpha; else plain data.
struct Shrink {
  int halvings = 0;
  bool srgb = false;
  bool deep = false;  ///< fills Image8::rgba16: of heights steps of 8 bits would show
};

/// Returns a side after `halvings`: rounded down, at least 1.
int halved(int side, int halvings);

/// Exact area average of a picture over a smaller grid: a source pixel that two target pixels share counts
/// for both, by area. Pixels may come in any order, each once; finished rows are passed on.
class AreaAverage {
 public:
  using Row = std::function<void(int y, std::span<const float> values)>;  ///< target width * channels
  struct Size {
    int width = 0, height = 0;  ///< pixels, >= 1; the target's at most the source's
  };
  AreaAverage(Size source, Size target, int channels, Row finished);

  /// Adds every `step`th pixel of source row y from `first` on, `channels` values each.
  void add(int y, std::span<const float> values, int first = 0, int step = 1);
  /// Declares source rows up to y complete: passes on target rows that need no others, from the top.
  void done_to(int y);

 private:
  /// The target pixel in which a source pixel begins, and the shares of its area in this one and the next,
  /// over the area of a target pixel.
  struct Cover {
    int first = 0;
    std::array<float, 2> share{};
  };
  static std::vector<Cover> covers(int source, int target);

  Size target_;
  std::size_t channels_;
  Row finished_;
  std::vector<Cover> columns_, rows_;
  std::vector<std::vector<float>> sums_;  ///< by target row; empty: not begun, or passed on
  std::vector<float> line_;               ///< a source row on the columns of the target
  int next_ = 0;                          ///< target row to pass on
};

/// Receives an RGBA picture in rows of 8 or 16 bits from a decoder, and keeps it at 1 / 2^halvings of its
/// size. `deep` concerns rows of 16 bits. `srgb`: averages colours in linear light, weighted by alpha (as
/// for_each_mip does); else all four channels are plain data.
class Shrinking {
 public:
  Shrinking(int width, int height, const Shrink& shrink);
  Shrinking(const Shrinking&) = delete;
  Shrinking& operator=(const Shrinking&) = delete;

  /// Adds every `step`th pixel of row y from `first` on.
  void row8(int y, const std::uint8_t* rgba, int count, int first = 0, int step = 1);
  void row16(int y, const std::uint16_t* rgba, int count, int first = 0, int step = 1);
  void done_to(int y);
  Image8 take() { return std::move(picture_); }

 private:
  Shrink shrink_;
  Image8 picture_;
  AreaAverage average_;
  std::vector<float> values_;
};

/// A texel for averaging: linear colours times a weight that grows with alpha (srgb), or plain values. The
/// weight is linear in alpha, so the average of the weights is the weight of the average.
using Texel = std::array<float, 4>;
Texel weighted(const std::uint8_t* rgba, bool srgb);
/// Writes the 8-bit texel of an average.
void round_texel(const float* average, bool srgb, std::uint8_t* rgba);

}  // namespace dermis::image
