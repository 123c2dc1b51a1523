// SPDX-License-Identifier: MIT
/// Views other than the picture, and the values of one pixel.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "viewer/model/painter.h"

namespace dermis::viewer {

inline constexpr const char* first_shown = "picture";

/// Returns the values of output.show, from the row of the setting: those with a number, once for each of it.
std::vector<std::string> shown_map_names(int gaussians, int lights);

/// Values of a picture and its labels at a pixel.
struct PixelValues {
  int x = 0, y = 0;
  std::array<float, 4> linear{};  ///< radiance with exposure, and the share of skin
  std::array<int, 3> display{};
  bool is_labelled = false;  ///< the rest is known
  std::uint32_t instance = 0, material = 0;
  std::string region;
  float depth_m = 0;
  std::optional<std::array<double, 3>> position_m{};  ///< none: the camera is not known
  std::array<float, 3> normal{};
  std::array<float, 2> uv{};
  std::uint32_t skin_mesh = 0;  ///< 0: no skin, and the rest is not known
  float thickness_mm = 0;
  std::array<float, 2> texel{};  ///< of the light map
  int map_side = 0;              ///< T of its head
  int mapped_terms = -1;         ///< Gaussians that its head reads from maps; -1: not known
  /// Light that enters the skin at that texel, pi times its value in the light map, without exposure; none:
  /// no map has it.
  std::optional<std::array<float, 3>> irradiance{};
};

/// `u`, `v`: place in the picture, 0 to 1. None: outside.
std::optional<PixelValues> pixel_at(const Painted& painted, float u, float v);

}  // namespace dermis::viewer
