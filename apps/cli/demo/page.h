// SPDX-License-Identifier: MIT
/// The page of `dermis demo`.
#pragma once

#include <string>
#include <vector>

#include "dermis/renderer.h"
#include "image/image.h"

namespace dermis::cli::demo {

/// A picture, what it shows and what it cost.
struct Shown {
  std::string command;  ///< that makes it
  image::Image8 pixels;
  Statistics cost;
};

/// A head, drawn with scattering and without.
struct Pair {
  std::string name;
  Shown scattered, lambert;
};

struct Page {
  std::vector<Pair> heads;    ///< at least one
  std::string strip_command;  ///< empty: there is no strip
  image::Image8 strip;
};

/// Returns one file of HTML, pictures and all: the pairs under sliders, the strip, and the times of the
/// passes.
std::string html(const Page& page);

}  // namespace dermis::cli::demo
