// SPDX-License-Identifier: MIT
/// From a scene and settings to what a plan and a frame need: cameras, lights, profiles, heads. No device.
#pragma once

#include <vector>

#include "dermis/settings.h"
#include "setup/subject.h"
#include "shared/scene_io.h"
#include "techniques/technique.h"

namespace dermis::setup {

/// Throws InputError for a setting out of range; names it and its range. Called once per set of settings,
/// before anything is made or read for them.
void check_settings(const RenderSettings& settings);

/// What the frame's structure takes from the device.
struct DeviceTraits {
  bool software = false;
  std::uint64_t memory_bytes = 0;        ///< of the device; 0: unknown
  std::uint32_t max_image_side = 16384;  ///< texels
};

struct HeadSetup {
  int number = 0;  ///< in the row
  glm::vec3 offset_m{0};
  std::vector<io::LightIo> lights;
  std::uint32_t first_shadow_layer = 0;
  std::vector<glm::mat4> shadow_from_world;
  int map_side = 0;  ///< T
  bool visible = true;
};

struct FrameSetup {
  const techniques::Technique* technique = nullptr;
  techniques::FrameSettings plan;
  std::vector<HeadSetup> heads;  ///< far to near
  io::FrameIo frame{};
  double d_ref = 0;  ///< see reference_distance()
  int lights = 0, gaussians = 0;
  int environment_lights = 0;  ///< those of the lights that an environment brings
};

/// Returns T of each head that is drawn, texels.
std::vector<std::uint32_t> sides_of_drawn_heads(const FrameSetup& setup);

/// Decides what a frame needs. `settings` have passed check_settings(): who calls this checks them before
/// reading surroundings. `environment_lights`: besides those that the settings choose. Throws InputError: see
/// choose_camera(); or a map budget that does not hold one head.
FrameSetup set_up(const Subject& subject, const RenderSettings& settings, const DeviceTraits& device = {},
                  const std::vector<scene::Light>& environment_lights = {});

/// Warns, in one line, if parts of the skin have so few texels that terms are lit at the pixel: which mesh
/// has fewest, how many, what that means and what helps.
void warn_coarse(const Subject& subject, const FrameSetup& setup);

}  // namespace dermis::setup
