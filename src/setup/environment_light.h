// SPDX-License-Identifier: MIT
/// An environment prepared as light, on the device, and what a frame needs of it.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "dermis/settings.h"
#include "environment/environment.h"
#include "environment/occlusion.h"
#include "environment/sources.h"
#include "gpu/resources.h"
#include "passes/frame_data.h"
#include "shared/scene_io.h"

namespace dermis::setup {

struct EnvironmentLight {
  std::string name;                          ///< LightingSettings::environment
  std::filesystem::file_time_type written;   ///< of the file when it was read
  std::vector<environment::Source> sources;  ///< light as lamps do; the rest has none of them
  environment::Irradiance irradiance;        ///< of the rest
  environment::SkyHarmonics sky;             ///< of the rest
  environment::SkyHarmonics bouncing_sky;    ///< with the sources: they light occluders, too
  gpu::Texture map;                          ///< of the rest; RGBA16F, prefiltered
};

/// Loads and prepares an environment. Throws InputError: see environment::from_name_or_file.
EnvironmentLight environment_light(gpu::Device& device, const std::string& name);

/// Returns whether a name still means this environment: a file may have changed.
bool is_current(const EnvironmentLight& environment_light, const std::string& name);

/// Light of an environment of intensity 1 that arrives on each texel of each skin mesh, on the device.
struct SkyOnSkin {
  std::shared_ptr<const EnvironmentLight> of;  ///< none: no maps
  double rotation_deg = 0;
  std::vector<passes::SkyMaps> maps;
};

/// Multiplies the harmonics of the sky with the transfer of each texel. `occlusion`: one per skin mesh. Takes
/// some 15 ms per mesh, on the processor.
SkyOnSkin sky_on_skin(gpu::Device& device, std::shared_ptr<const EnvironmentLight> environment_light,
                      double rotation_deg, const std::vector<environment::Occlusion>& occlusion);

/// Returns directional lights as wide as the sources, turned and multiplied as the settings say.
std::vector<scene::Light> environment_lights(const std::vector<environment::Source>& sources,
                                             const RenderSettings& settings);

/// Fills in the environment: its turn, its intensity, the irradiance by normal.
void fill_environment(io::FrameIo& frame, const EnvironmentLight& environment_light,
                      const RenderSettings& settings);

}  // namespace dermis::setup
