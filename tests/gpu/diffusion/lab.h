// SPDX-License-Identifier: MIT
// Diffusion under the microscope: a scene's skin, painted with light known in closed form, blurred by the
// passes of the product.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "head/scene/asset_data.h"
#include "head/scene/rig/rig.h"
#include "paint_io.h"

namespace dermis::lab {

struct Map {
  int side = 0;
  std::vector<float> rgba;
  const float* at(int x, int y) const {
    return rgba.data() +
           (static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x)) * 4;
  }
};

struct Experiment {
  scene::AssetData scene;
  int map_size = 256;
  std::vector<double> variances_mm2;  ///< narrow to wide
  io::PaintIo paint{};
  double variance_factor = 1;  ///< a deliberate mistake: every step is this much too wide
  bool drop_shear = false;     ///< a deliberate mistake: the metric's g_uv is forgotten
  bool gutters = true;
  bool from_light = false;  ///< both of two variances start from the light, and share its reads

  /// The scene's rig takes this pose on the device.
  std::optional<scene::PosedRig> pose{};
  bool keep_metric = false;  ///< a deliberate mistake: the metric stays that of the scene as it is
};

struct Result {
  Map painted;
  std::vector<Map> levels;  ///< one a variance
};

/// False if there is no Vulkan device: tests then skip.
bool available();
Result run(const Experiment& experiment);

}  // namespace dermis::lab
