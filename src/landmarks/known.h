// SPDX-License-Identifier: MIT
/// Heads of others whose landmarks the library brings: assets/heads/*.landmarks.json, known by their
/// triangles.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "landmarks/sidecar.h"
#include "scene/scene.h"

namespace dermis::landmarks {

struct KnownFile {
  std::string name, text;
};
std::span<const KnownFile> known_files();

/// Returns the first of them that fits.
std::optional<Sidecar> known_landmarks(const scene::Scene& asset);

}  // namespace dermis::landmarks
