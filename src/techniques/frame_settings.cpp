// SPDX-License-Identifier: MIT
#include <algorithm>

#include "shared/entries_io.h"
#include "techniques/technique.h"

namespace dermis::techniques {

std::uint32_t FrameSettings::draws_of(const Model& model) const {
  std::uint32_t draws = 0;
  for (std::uint32_t i = 0; i < model.meshes; ++i) draws += skin[model.first_mesh + i].draws;
  return draws;
}

bool FrameSettings::has_skin() const {
  return std::any_of(heads.begin(), heads.end(),
                     [&](std::uint32_t model) { return draws_of(models[model]) > 0; });
}

bool FrameSettings::can_shade_entries() const {
  std::uint64_t parts = 0;
  for (const std::uint32_t model : heads) parts += draws_of(models[model]);
  const bool few_triangles = std::all_of(
      skin.begin(), skin.end(), [](const SkinPart& part) { return part.triangles <= MOST_TRIANGLES; });
  const bool has_room = !host || (host->picture && host->width > 0 && host->height > 0);
  return has_room && parts > 0 && parts <= MOST_PARTS && few_triangles &&
         std::uint64_t{width} * height <= MOST_SHADED_PIXELS;
}

std::uint32_t FrameSettings::most_meshes() const {
  std::uint32_t most = 0;
  for (const Model& model : models) most = std::max(most, model.meshes);
  return most;
}

}  // namespace dermis::techniques
