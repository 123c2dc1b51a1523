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
std::array<float, 2> depth_range(const Labels& labels) {
  std::array<float, 2> range{std::numeric_limits<float>::max(), 0};
  for (const float depth : labels.depth_m)
    if (std::isfinite(depth)) range = {std::min(range[0], depth), std::max(range[1], depth)};
  return range;
}

std::function<Colour(std::size_t)> colours_of(const Labels& labels, std::string_view view) {
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
  return {};
}

}  // namespace

bool is_label_view(std::string_view name) {
  return std::find(label_views.begin(), label_views.end(), name) != label_views.end();
}

std::vector<std::uint8_t> label_picture(const Painted& painted, std::string_view view) {
  if (!painted.labels) return {};
  const Labels& labels = *painted.labels;
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

}  // namespace dermis::viewer
