// SPDX-License-Identifier: MIT
#include "cli/picture_hints.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/core/log.h"

namespace dermis::cli {
namespace {

/// Luminance of skin as the exposure that is found by itself would leave it, on a skin of middle colour.
constexpr float well_exposed = 0.4f;
/// Radiance of pictures is held in half floats, which end at 65504.
constexpr float brightest = 60000;

/// Luminance (Rec.709) of the pixels that skin covers.
std::vector<float> skin_luminance(const Picture& picture) {
  std::vector<float> all;
  for (std::size_t i = 0; i + 3 < picture.linear_rgba.size(); i += 4) {
    const float* p = &picture.linear_rgba[i];
    if (p[3] >= 0.5f) all.push_back(0.2126f * p[0] + 0.7152f * p[1] + 0.0722f * p[2]);
  }
  return all;
}

}  // namespace

void hint_at_picture(const Picture& picture, bool display) {
  if (picture.statistics.skin_materials.empty()) return;

  std::vector<float> skin = skin_luminance(picture);
  if (skin.empty()) {
    warn(
        "no skin is in the picture: camera.orbit_deg and camera.distance, or camera.eye_m and "
        "camera.target_m, "
        "place the camera");
    return;
  }
  if (!display) return;

  const auto middle = skin.begin() + static_cast<std::ptrdiff_t>(skin.size() / 2);
  std::nth_element(skin.begin(), middle, skin.end());
  if (*middle <= 1) return;

  const auto over = std::count_if(skin.begin(), skin.end(), [](float y) { return y > 1; });
  const double share = 100.0 * static_cast<double>(over) / static_cast<double>(skin.size());
  if (*middle >= brightest)
    warn("{:.0f} % of the skin is over white: output.exposure_ev auto finds the exposure", share);
  else
    warn("{:.0f} % of the skin is over white: output.exposure_ev {:.1f} would show it, or auto", share,
         picture.statistics.exposure_ev + std::log2(well_exposed / *middle));
}

}  // namespace dermis::cli
