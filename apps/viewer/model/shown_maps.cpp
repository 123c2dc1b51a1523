// SPDX-License-Identifier: MIT
#include "viewer/model/shown_maps.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "base/settings/fields.h"
#include "viewer/model/camera_moves.h"

namespace dermis::viewer {
namespace {

std::string_view values_of_show() {
  std::string_view values;
  const OutputSettings settings;
  for_each_setting(settings, [&](const std::string& path, const About& about, const auto&, std::string_view) {
    if (path == "show") values = about.values;
  });
  return values;
}

void add_labels(PixelValues& pixel, const Results& labels, const Statistics& statistics, std::size_t i) {
  static constexpr const char* regions[] = {"no skin", "nose", "ear", "skin"};
  pixel.is_labelled = true;
  pixel.instance = labels.instance[i];
  pixel.material = labels.material[i];
  pixel.region = regions[std::min<std::size_t>(labels.region[i], 3)];
  pixel.depth_m = labels.depth_m[i];
  for (std::size_t c = 0; c < 3; ++c) pixel.normal[c] = labels.normal[3 * i + c];
  if (pixel.instance == 0) return;

  const std::size_t head = pixel.instance - 1;
  if (head < statistics.used_size.size()) pixel.map_side = statistics.used_size[head];
  if (head < statistics.mapped_terms.size()) pixel.mapped_terms = statistics.mapped_terms[head];
  for (std::size_t c = 0; c < 2; ++c) pixel.uv[c] = labels.uv[2 * i + c];
  pixel.skin_mesh = labels.skin_mesh[i];
  pixel.thickness_mm = labels.thickness_mm[i];
  for (std::size_t c = 0; c < 2; ++c)
    pixel.texel[c] = labels.unwrap[2 * i + c] * static_cast<float>(pixel.map_side);
}

// The map is that of the first skin mesh of the nearest head: of several heads, nobody says which.
void add_irradiance(PixelValues& pixel, const LightMap& map, const Statistics& statistics) {
  if (pixel.skin_mesh != 1 || statistics.heads != 1 || map.side != pixel.map_side) return;
  std::array<std::size_t, 2> at{};
  for (std::size_t c = 0; c < 2; ++c)
    at[c] = static_cast<std::size_t>(std::clamp(static_cast<int>(pixel.texel[c]), 0, map.side - 1));
  const std::size_t i = 4 * (at[1] * static_cast<std::size_t>(map.side) + at[0]);
  if (map.rgba[i + 3] <= 0) return;

  const float scale = std::numbers::pi_v<float> / std::exp2(static_cast<float>(map.exposure_ev));
  pixel.irradiance = {scale * map.rgba[i], scale * map.rgba[i + 1], scale * map.rgba[i + 2]};
}

}  // namespace

std::vector<std::string> shown_map_names(int gaussians, int lights) {
  std::vector<std::string> names;
  std::string_view rest = values_of_show();
  while (!rest.empty()) {
    const std::size_t bar = rest.find('|');
    const std::string name(rest.substr(0, bar));
    rest = bar == std::string_view::npos ? std::string_view{} : rest.substr(bar + 1);
    if (!name.ends_with(":K")) {
      names.push_back(name);
      continue;
    }
    const int count = name.starts_with("shadow") ? lights : gaussians;
    for (int k = 0; k < count; ++k) names.push_back(name.substr(0, name.size() - 1) + std::to_string(k));
  }
  return names;
}

std::optional<PixelValues> pixel_at(const Painted& painted, float u, float v) {
  const Picture& picture = painted.picture;
  const int x = static_cast<int>(std::floor(u * static_cast<float>(picture.width)));
  const int y = static_cast<int>(std::floor(v * static_cast<float>(picture.height)));
  if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) return {};

  PixelValues pixel{.x = x, .y = y};
  const auto i =
      static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x);
  for (std::size_t c = 0; c < 4; ++c) pixel.linear[c] = picture.linear_rgba[4 * i + c];
  for (std::size_t c = 0; c < 3; ++c) pixel.display[c] = picture.display_rgba[4 * i + c];
  if (painted.labels && i < painted.labels->instance.size())
    add_labels(pixel, *painted.labels, picture.statistics, i);
  if (painted.camera && pixel.instance != 0)
    pixel.position_m = point_at_depth(*painted.camera, (x + 0.5) / picture.width, (y + 0.5) / picture.height,
                                      static_cast<double>(pixel.depth_m));
  if (painted.light) add_irradiance(pixel, *painted.light, picture.statistics);
  return pixel;
}

}  // namespace dermis::viewer
