// SPDX-License-Identifier: MIT
/// Labels of each pixel as colours, in place of the picture of a session.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "viewer/model/painter.h"

namespace dermis::viewer {

inline constexpr std::array<std::string_view, 6> label_views{"instances", "materials", "regions",
                                                             "depth",     "normals",   "thickness"};
bool is_label_view(std::string_view name);

/// Returns four values per pixel. Nothing is black; numbers have colours far from each other. Regions have
/// colours of skin, nose and ear, and grey where there is no skin. Near surfaces are bright; normals are 0.5
/// + n/2. Thickness has the colours of thickness_legend(), and grey where there is no skin. Empty: no such
/// view, or no labels.
std::vector<std::uint8_t> label_picture(const Painted& painted, std::string_view view);

/// Meaning of a colour of the view "thickness".
struct LegendMark {
  float mm = 0;
  std::array<float, 3> colour{};
};
/// Returns marks at round lengths up to the greatest thickness in the picture, and that. Empty: no labels, or
/// no skin in them.
std::vector<LegendMark> thickness_legend(const Painted& painted);

}  // namespace dermis::viewer
