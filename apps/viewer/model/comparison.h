// SPDX-License-Identifier: MIT
/// Two pictures of one view: how far they are apart, and where.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "dermis/reference.h"
#include "image/image.h"

namespace dermis::viewer {

enum class CompareMode {
  off,
  slider,      ///< A at the left of a line, B at its right
  blink,       ///< one after the other
  difference,  ///< |A - B| of display values, four times
  flip         ///< FLIP, from black to white
};
inline constexpr const char* compare_mode_titles[] = {"A alone", "slider", "blink", "difference", "FLIP"};

/// Figures over a part of the picture.
struct RegionFigures {
  std::string name;
  double flip = 0, psnr_db = 0, rel_mse = 0;
  std::size_t pixels = 0;
};

struct Comparison {
  int width = 0, height = 0;
  std::vector<std::uint8_t> map_rgba{};  ///< as the mode shows it; empty where it shows none
  std::vector<RegionFigures> regions{};  ///< all of the picture first
};

/// Compares pictures of one size; B is the one that is right. FLIP takes a second per million pixels. Throws
/// InputError for different sizes.
Comparison compare(const Picture& a, const Picture& b, const std::vector<PictureRegion>& regions,
                   CompareMode mode);

}  // namespace dermis::viewer
