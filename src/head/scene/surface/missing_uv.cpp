// SPDX-License-Identifier: MIT
#include "head/scene/surface/missing_uv.h"

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "base/core/one_line.h"
#include "base/core/warnings.h"
#include "head/scene/import/material_source.h"
#include "head/scene/surface/topology.h"

namespace dermis::scene {

namespace {

bool lacks(const std::array<bool, 2>& has_uv, const MapRef& map) {
  return map.present() && !has_uv[static_cast<std::size_t>(map.uv_set)];
}

bool has_map_without_uv(const Material& material, const std::array<bool, 2>& has_uv) {
  bool any = false;
  for_each_map(material, [&](const MapRef& map, bool) { any = any || lacks(has_uv, map); });
  return any;
}

Material without_such_maps(Material material, const std::array<bool, 2>& has_uv) {
  for_each_map(material, [&](MapRef& map, bool) {
    if (lacks(has_uv, map)) map = {};
  });
  return material;
}

// Exporters write coordinates where there are none: all at one point, or on a line.
bool has_area_on_map(const Primitive& primitive) {
  const auto uv = [&](std::size_t i) { return primitive.vertices[primitive.indices[i]].uv0; };
  for (std::size_t i = 0; i < primitive.indices.size(); i += 3)
    if (uv_area2(uv(i), uv(i + 1), uv(i + 2)) != 0) return true;
  return false;
}

void warn_of_missing_uv(const std::string& file, const Primitive& primitive, bool skin, bool lost_maps) {
  const bool no_area = skin && primitive.has_uv && !primitive.indices.empty() && !has_area_on_map(primitive);
  const bool unlit_map = skin && !primitive.has_uv;
  if (!unlit_map && !lost_maps && !no_area) return;

  const char* why = no_area      ? "texture coordinates without area, so skin is lit without scattering"
                    : !unlit_map ? "some maps are left out, for want of their texture coordinates"
                    : !lost_maps
                        ? "no texture coordinates, so skin is lit without scattering"
                        : "no texture coordinates, so skin is lit without scattering, its maps left out";
  const std::string name = one_line(primitive.name, 80);
  warn_of(fmt::format("{}: {}", file, why), name, fmt::format("{}: '{}': {}", file, name, why));
}

}  // namespace

void leave_out_maps_without_uv(const std::string& file, const std::vector<std::array<bool, 2>>& has_uv,
                               AssetData& scene) {
  const std::vector<Material> whole = scene.materials;
  std::vector<std::uint8_t> used(whole.size(), 0);  // materials used unchanged
  std::map<std::pair<int, std::array<bool, 2>>, int> without;

  // Handles primitives that keep all maps first, so that a material that none can use unchanged is changed in
  // place and its pictures are not read.
  for (std::size_t i = 0; i < scene.primitives.size(); ++i) {
    const auto number = static_cast<std::size_t>(scene.primitives[i].material);
    if (!has_map_without_uv(whole[number], has_uv[i])) used[number] = 1;
  }

  for (std::size_t i = 0; i < scene.primitives.size(); ++i) {
    Primitive& primitive = scene.primitives[i];
    const auto number = static_cast<std::size_t>(primitive.material);
    const bool lost = has_map_without_uv(whole[number], has_uv[i]);
    warn_of_missing_uv(file, primitive, whole[number].skin, lost);
    if (!lost) continue;

    const auto [entry, is_new] = without.try_emplace({primitive.material, has_uv[i]}, primitive.material);
    if (is_new && std::exchange(used[number], 1) != 0) {
      entry->second = static_cast<int>(scene.materials.size());
      scene.materials.push_back(without_such_maps(whole[number], has_uv[i]));
    } else if (is_new) {
      scene.materials[number] = without_such_maps(whole[number], has_uv[i]);
    }
    primitive.material = entry->second;
  }
}

}  // namespace dermis::scene
