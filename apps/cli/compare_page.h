// SPDX-License-Identifier: MIT
// The results of `dermis compare` as text, JSON and a page.
#pragma once

#include <string>

#include "image/compare.h"

namespace dermis::cli {

struct Compared {
  std::string a, b;         ///< names of the files; a is the reference
  std::string region_name;  ///< empty: none
  std::string tone_map;     ///< of linear pictures; empty: display pictures
  image::Image8 shown_a, shown_b;
  image::Region region;
  image::Comparison found;
};

std::string compared_text(const Compared& compared);
std::string compared_json(const Compared& compared);
/// Pictures side by side, a slider between them, the map of errors on two scales, the table.
std::string compared_page(const Compared& compared);

}  // namespace dermis::cli
