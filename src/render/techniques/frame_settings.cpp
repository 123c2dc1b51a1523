// SPDX-License-Identifier: MIT
#include "render/techniques/frame_settings.h"

#include <algorithm>

namespace dermis::techniques {

std::uint32_t FrameSettings::parts_of(const Model& model) const {
  std::uint32_t parts = 0;
  for (std::uint32_t i = 0; i < model.meshes; ++i) parts += skin[model.first_mesh + i].parts;
  return parts;
}

std::uint64_t FrameSettings::parts() const {
  std::uint64_t parts = 0;
  for (const std::uint32_t model : heads) parts += parts_of(models[model]);
  return parts;
}

std::uint32_t FrameSettings::most_meshes() const {
  std::uint32_t most = 0;
  for (const Model& model : models) most = std::max(most, model.meshes);
  return most;
}

}  // namespace dermis::techniques
