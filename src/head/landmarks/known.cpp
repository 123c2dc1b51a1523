// SPDX-License-Identifier: MIT
#include "head/landmarks/known.h"

#include "head/landmarks/places.h"

namespace dermis::landmarks {
namespace {

const std::vector<Sidecar>& known_sidecars() {
  static const std::vector<Sidecar> sidecars = [] {
    std::vector<Sidecar> read;
    for (const KnownFile& file : known_files())
      read.push_back(read_sidecar(json::Document(file.text, file.name, sidecar_limits).root()));
    return read;
  }();
  return sidecars;
}

}  // namespace

std::optional<Sidecar> known_landmarks(const scene::AssetData& asset) {
  for (const Sidecar& sidecar : known_sidecars())
    if (misfit(sidecar, asset).empty()) return sidecar;
  return std::nullopt;
}

}  // namespace dermis::landmarks
