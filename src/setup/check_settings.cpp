// SPDX-License-Identifier: MIT
#include "core/error.h"
#include "settings/check.h"
#include "setup/frame_setup.h"

namespace dermis::setup {

void check_settings(const RenderSettings& s) {
  check_ranges(s);
  techniques::find_technique(s.technique);
  if (s.quality.samples != 1 && s.quality.samples != 4)
    throw input_error("", "quality.samples must be 1 or 4, got {}", s.quality.samples);
  if (s.lighting.rig_lights && !s.lighting.placed_lights.empty())
    throw input_error(
        "", "lighting.rig_lights and lighting.placed_lights both replace the lights of the scene; give one");
}

}  // namespace dermis::setup
