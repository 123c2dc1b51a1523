// SPDX-License-Identifier: MIT
/// Clears the squares of a map and lets a host draw irradiance into them: FrameData::draw_irradiance.
/// Irradiance then takes it from there, in place of the lights of the scene. It leaves out what the camera
/// does not see, multiplies by the part of the albedo that acts first, and marks charts: a host knows nothing
/// of these.
#pragma once

#include <vector>

#include "frame/graph.h"
#include "render/passes/light_map/light_pool.h"

namespace dermis::passes {

class HostIrradiance {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
  } settings;
  struct In {
    frame::TextureId map;  ///< RGBA16F pool
  } in;
  struct Out {
    frame::TextureId map;
  };
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

}  // namespace dermis::passes
