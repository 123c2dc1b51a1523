// SPDX-License-Identifier: MIT
#include "viewer/model/label_views.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace dermis::viewer {
namespace {

using Colour = std::array<float, 3>;

// Hues a golden section apart, so that neighbours are far from each other.
Colour colour_of_number(std::uint32_t number) {
  if (number == 0) return {};
  const float hue = std::fmod(0.08f + 0.618034f * static_cast<float>(number - 1), 1.0f);
  Colour colour;
  for (std::size_t c = 0; c < 3; ++c) {
    const float along = std::fmod(hue + static_cast<float>(3 - c) / 3, 1.0f);
    colour[c] = 0.25f + 0.7f * std::clamp(std::abs(6 * along - 3) - 1, 0.0f, 1.0f);
  }
  return colour;
}

Colour colour_of_region(std::uint32_t region) {
  static constexpr std::array<Colour, 4> colours{
      {{0.35f, 0.37f, 0.4f}, {0.95f, 0.75f, 0.3f}, {0.35f, 0.65f, 0.95f}, {0.8f, 0.55f, 0.45f}}};
  return colours[std::min<std::size_t>(region, colours.size() - 1)];
}

// Nearest and farthest of what is there.
std::array<float, 2> depth_range(const Results& labels) {
  std::array<float, 2> range{std::numeric_limits<float>::max(), 0};
  for (const float depth : labels.depth_m)
    if (std::isfinite(depth)) range = {std::min(range[0], depth), std::max(range[1], depth)};
  return range;
}

float most_thickness_mm(const Results& labels) {
  return labels.thickness_mm.empty()
             ? 0
             : *std::max_element(labels.thickness_mm.begin(), labels.thickness_mm.end());
}

// From bright, where light comes through, to dark. By the square root: ears and lids differ as much as
// cheeks.
Colour colour_of_thickness(float mm, float most_mm) {
  static constexpr std::array<Colour, 4> colours{
      {{1.0f, 0.95f, 0.6f}, {0.95f, 0.45f, 0.25f}, {0.55f, 0.15f, 0.45f}, {0.1f, 0.08f, 0.3f}}};
  const float at = 3 * std::sqrt(std::clamp(mm / std::max(most_mm, 1e-6f), 0.0f, 1.0f));
  const std::size_t from = std::min<std::size_t>(static_cast<std::size_t>(at), 2);
  const float share = at - static_cast<float>(from);
  Colour colour;
  for (std::size_t c = 0; c < 3; ++c)
    colour[c] = (1 - share) * colours[from][c] + share * colours[from + 1][c];
  return colour;
}

std::function<Colour(std::size_t)> colours_of(const Results& labels, std::string_view view) {
  if (view == "instances") return [&labels](std::size_t i) { return colour_of_number(labels.instance[i]); };
  if (view == "materials") return [&labels](std::size_t i) { return colour_of_number(labels.material[i]); };
  if (view == "regions") return [&labels](std::size_t i) { return colour_of_region(labels.region[i]); };
  if (view == "normals")
    return [&labels](std::size_t i) {
      return Colour{0.5f + labels.normal[3 * i] / 2, 0.5f + labels.normal[3 * i + 1] / 2,
                    0.5f + labels.normal[3 * i + 2] / 2};
    };
  if (view == "depth")
    return [&labels, range = depth_range(labels)](std::size_t i) {
      const float far = (labels.depth_m[i] - range[0]) / std::max(range[1] - range[0], 1e-6f);
      return Colour{1 - 0.85f * far, 1 - 0.85f * far, 1 - 0.85f * far};
    };
  if (view == "thickness")
    return [&labels, most_mm = most_thickness_mm(labels)](std::size_t i) {
      return labels.skin_mesh[i] == 0 ? colour_of_region(Results::no_region)
                                      : colour_of_thickness(labels.thickness_mm[i], most_mm);
    };
  return {};
}

}  // namespace

bool is_label_view(std::string_view name) {
  return std::find(label_views.begin(), label_views.end(), name) != label_views.end();
}

std::vector<std::uint8_t> label_picture(const Painted& painted, std::string_view view) {
  if (!painted.labels) return {};
  const Results& labels = *painted.labels;
  const std::function<Colour(std::size_t)> colour_of = colours_of(labels, view);
  if (!colour_of) return {};

  std::vector<std::uint8_t> rgba;
  rgba.reserve(4 * labels.instance.size());
  for (std::size_t i = 0; i < labels.instance.size(); ++i) {
    const Colour colour = labels.instance[i] == 0 ? Colour{} : colour_of(i);
    for (const float value : colour)
      rgba.push_back(static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0f, 1.0f))));
    rgba.push_back(255);
  }
  return rgba;
}

std::vector<LegendMark> thickness_legend(const Painted& painted) {
  const float most_mm = painted.labels ? most_thickness_mm(*painted.labels) : 0;
  if (most_mm <= 0) return {};

  std::vector<LegendMark> marks;
  for (float decade_mm = 1; decade_mm < most_mm; decade_mm *= 10)
    for (const float step : {1.0f, 2.0f, 5.0f})
      if (step * decade_mm < 0.95f * most_mm) marks.push_back({.mm = step * decade_mm});
  marks.push_back({.mm = most_mm});
  for (LegendMark& mark : marks) mark.colour = colour_of_thickness(mark.mm, most_mm);
  return marks;
}

}  // namespace dermis::viewer
