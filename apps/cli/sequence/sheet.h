// SPDX-License-Identifier: MIT
/// A contact sheet: small pictures of frames, in rows, on one picture.
#pragma once

#include <cstddef>
#include <vector>

#include "image/image.h"

namespace dermis::cli::sequence {

class Sheet {
 public:
  /// Of so many frames of this size, pixels.
  Sheet(std::size_t frames, int width, int height);

  /// The frames that it shows, at most 24, evenly spread, the first one among them; rising.
  const std::vector<std::size_t>& shown() const { return shown_; }
  /// Puts a frame into its place, if it has one: made small by area averages of linear light, never enlarged.
  /// `picture`: display values, of the size given.
  void add(std::size_t frame, const image::Image8& picture);
  const image::Image8& picture() const { return sheet_; }

 private:
  std::vector<std::size_t> shown_;
  int columns_ = 1, cell_width_ = 1, cell_height_ = 1;  ///< pixels
  image::Image8 sheet_;
};

}  // namespace dermis::cli::sequence
