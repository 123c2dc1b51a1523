// SPDX-License-Identifier: MIT
#include "tissue/gaussians/known.h"

#include <string>

#include "base/core/error.h"
#include "base/core/known_names.h"
#include "tissue/gaussians/json.h"

namespace dermis::gaussians {
namespace {

struct Preset {
  std::string_view name, file;
};
constexpr Preset presets[] = {
#include "tissue/gaussians/presets.inc"
};

}  // namespace

// [DLE07] in GPU Gems 3 (2007), ch. 14 "Advanced Techniques for Realistic Real-Time Skin Rendering", table
// 14-1: variance in mm^2, weights of red, green and blue, normalised to white. G(v, r) is that of sum.h.
ScatterProfile skin_six() {
  ScatterProfile sum;
  sum.name = "skin";
  sum.terms = {
      {0.0064, {0.233, 0.455, 0.649}}, {0.0484, {0.100, 0.336, 0.344}}, {0.187, {0.118, 0.198, 0.000}},
      {0.567, {0.113, 0.007, 0.007}},  {1.99, {0.358, 0.004, 0.000}},   {7.41, {0.078, 0.000, 0.000}},
  };
  return sum;
}

std::vector<std::string_view> known_names() {
  std::vector<std::string_view> names{"skin"};
  for (const Preset& preset : presets) names.push_back(preset.name);
  return names;
}

ScatterProfile known(std::string_view name) {
  if (name == "skin") return skin_six();
  for (const Preset& preset : presets)
    if (name == preset.name) return parse_json(preset.file, std::string(name));
  throw input_error("", "profile {}", unknown_name(name, known_names()));
}

}  // namespace dermis::gaussians
