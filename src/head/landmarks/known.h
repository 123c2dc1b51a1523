// SPDX-License-Identifier: MIT
/// Heads of others whose landmarks the library brings: assets/heads/*.landmarks.json, known by their
/// triangles.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "head/landmarks/sidecar.h"
#include "head/scene/asset_data.h"

namespace dermis::landmarks {

struct KnownFile {
  std::string name, text;
};
std::span<const KnownFile> known_files();

/// Returns the first of them that fits.
std::optional<Sidecar> known_landmarks(const scene::AssetData& asset);

}  // namespace dermis::landmarks
