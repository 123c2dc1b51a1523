// SPDX-License-Identifier: MIT
#include "head/scene/import/texture_budget.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <queue>

#include "base/core/error.h"
#include "base/core/log.h"
#include "base/core/one_line.h"
#include "head/scene/import/material_source.h"
#include "image/shrink.h"

namespace dermis::scene {

namespace {

void note_halved(const std::string& file, std::uint64_t wanted, std::uint64_t budget_bytes,
                 const std::vector<MapUse>& uses) {
  constexpr std::size_t named = 3;
  std::vector<std::string> lines;
  std::size_t halved = 0;
  for (const MapUse& use : uses) {
    if (use.halvings == 0 || ++halved > named) continue;
    lines.push_back(fmt::format("'{}' is {} x {} pixels, read as {} x {}", one_line(use.name, 80),
                                use.full_width, use.full_height, use.width(), use.height()));
  }

  if (halved > named) lines.push_back(fmt::format("and {} more", halved - named));
  if (halved > 0)
    note("{}: its maps would take {} MB, the texture budget is {} MB (texture_budget_mb): {}", file,
         wanted / 1'000'000, budget_bytes / 1'000'000, fmt::join(lines, "; "));
}

}  // namespace

std::uint64_t map_bytes(int width, int height, bool colour) {
  const std::uint64_t pixels = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
  return pixels * 4 + pixels * (colour ? 8 : 4) * 4 / 3;
}

int MapUse::width() const { return image::halved(full_width, halvings); }
int MapUse::height() const { return image::halved(full_height, halvings); }

std::uint64_t MapUse::bytes() const {
  const auto pixels = static_cast<std::uint64_t>(width()) * static_cast<std::uint64_t>(height());
  return map_bytes(width(), height(), colour) + (deep ? 8 * pixels : 0);
}

std::vector<MapUse> map_uses(const AssetData& scene) {
  std::map<std::pair<int, bool>, bool> deep;
  for (const Material& m : scene.materials)
    for_each_map(m, [&](const MapRef& map, bool colour) {
      if (map.present()) deep[{map.image, colour}] |= &map == &m.skin_settings.displacement;
    });

  std::vector<MapUse> uses;
  for (const auto& [key, is_deep] : deep)
    uses.push_back({.source = key.first, .colour = key.second, .deep = is_deep});
  return uses;
}

void point_maps_at_first(const std::map<int, int>& first, AssetData& scene) {
  for (Material& m : scene.materials)
    for_each_map(m, [&](MapRef& map, bool) {
      if (!map.present()) return;
      const int image = first.at(map.image);
      if (image < 0) map = {};
      map.image = image;
    });
}

void fit_to_budget(const std::string& file, std::uint64_t budget_bytes, std::vector<MapUse>& uses) {
  std::uint64_t wanted = 0;
  std::priority_queue<std::pair<std::uint64_t, std::size_t>> largest;  // bytes, uses from the end
  for (std::size_t i = 0; i < uses.size(); ++i) {
    wanted += uses[i].bytes();
    largest.emplace(uses[i].bytes(), uses.size() - i);
  }

  for (std::uint64_t sum = wanted; sum > budget_bytes;) {
    const auto [bytes, from_end] = largest.top();
    largest.pop();
    MapUse& use = uses[uses.size() - from_end];
    if (use.width() == 1 && use.height() == 1)
      throw input_error(file, "its {} maps do not fit into the texture budget of {} bytes", uses.size(),
                        budget_bytes);
    ++use.halvings;
    sum -= bytes - use.bytes();
    largest.emplace(use.bytes(), from_end);
  }

  note_halved(file, wanted, budget_bytes, uses);
}

std::vector<const MapUse*> number_images(std::vector<MapUse>& uses) {
  std::vector<MapUse*> made;
  for (MapUse& use : uses) {
    const bool same =
        !made.empty() && made.back()->source == use.source && made.back()->halvings == 0 && use.halvings == 0;
    if (same)
      made.back()->deep |= use.deep;
    else
      made.push_back(&use);
    use.image = static_cast<int>(made.size()) - 1;
  }
  return {made.begin(), made.end()};
}

void point_maps_at_images(const std::vector<MapUse>& uses, AssetData& scene) {
  for (Material& m : scene.materials)
    for_each_map(m, [&](MapRef& map, bool colour) {
      if (!map.present()) return;
      const auto use = std::ranges::lower_bound(uses, std::pair(map.image, colour), {}, &MapUse::key);
      if (use->image < 0) map = {};
      map.image = use->image;
    });
}

}  // namespace dermis::scene
