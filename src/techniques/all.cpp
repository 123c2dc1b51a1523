// SPDX-License-Identifier: MIT
#include <array>

#include "core/error.h"
#include "shared/entries_io.h"
#include "techniques/lambert/lambert.h"
#include "techniques/technique.h"
#include "techniques/texture_space/texture_space.h"

namespace dermis::techniques {
namespace {

constexpr std::array all{
    &texture_space,
    &lambert,
};

}  // namespace

std::span<const Technique* const> techniques() { return all; }

const Technique& find_technique(std::string_view name) {
  std::string names;
  for (const Technique* t : all) {
    if (t->name == name) return *t;
    names += fmt::format("{}{}", names.empty() ? "" : ", ", t->name);
  }
  throw input_error("technique", "'{}' is not known; there are: {}", name, names);
}

std::uint32_t FrameSettings::draws_of(const Model& model) const {
  std::uint32_t draws = 0;
  for (std::uint32_t i = 0; i < model.meshes; ++i) draws += skin[model.first_mesh + i].draws;
  return draws;
}

bool FrameSettings::can_shade_entries() const {
  std::uint64_t parts = 0;
  for (const std::uint32_t model : heads) parts += draws_of(models[model]);
  const bool few_triangles = std::all_of(
      skin.begin(), skin.end(), [](const SkinPart& part) { return part.triangles <= MOST_TRIANGLES; });
  return !host && parts > 0 && parts <= MOST_PARTS && few_triangles &&
         std::uint64_t{width} * height <= MOST_SHADED_PIXELS;
}

std::uint32_t FrameSettings::most_meshes() const {
  std::uint32_t most = 0;
  for (const Model& model : models) most = std::max(most, model.meshes);
  return most;
}

}  // namespace dermis::techniques
