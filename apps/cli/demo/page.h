// SPDX-License-Identifier: MIT
/// The page of `dermis demo`.
#pragma once

#include <string>
#include <vector>

#include "dermis/renderer.h"
#include "image/image.h"

namespace dermis::cli::demo {

/// A picture, the command that makes it, and its cost.
struct Shown {
  std::string command;
  image::Image8 pixels;
  Statistics cost;
};

/// A view, drawn with scattering and without.
struct Pair {
  std::string title;
  Shown scattered, lambert;
};

/// A command to try, and its purpose in a sentence.
struct Next {
  std::string why, command;
};

struct Page {
  std::vector<Pair> pairs;  ///< at least one; the first is under a slider, the others are details
  std::vector<Shown> skins;
  std::string credit;  ///< author and licence of the head; empty: none is needed
  double seconds = 0;  ///< that the pictures took
  std::vector<Next> next;
};

/// Returns one file of HTML, pictures and all.
std::string html(const Page& page);

}  // namespace dermis::cli::demo
