// SPDX-License-Identifier: MIT
/// An environment prepared as light, on the device, and what a frame needs of it.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dermis/scene.h"
#include "dermis/settings.h"
#include "environment/environment.h"
#include "environment/occlusion.h"
#include "environment/sources.h"
#include "gpu/resources.h"
#include "render/passes/frame_data.h"
#include "render/shared/scene_io.h"

namespace dermis::setup {

/// The environment of a frame.
struct EnvironmentSource {
  std::string name{};                         ///< a file or "studio"; empty: the pixels
  SceneEnvironment pixels{};                  ///< without a file
  std::filesystem::file_time_type written{};  ///< of the file
  bool shown = false;                         ///< behind the heads
  bool operator==(const EnvironmentSource& other) const;
};

/// Returns the environment that the settings name, else the scene's, else none.
std::optional<EnvironmentSource> choose_environment(const RenderSettings& settings,
                                                    const std::optional<SceneEnvironment>& of_scene);

/// Reads it. Throws InputError: see environment::from_name_or_file and from_pixels.
environment::Environment read_environment(const EnvironmentSource& source);

struct EnvironmentLight {
  EnvironmentSource source;
  std::vector<environment::Source> sources;  ///< light as lamps do; the rest has none of them
  environment::Irradiance irradiance;        ///< of the rest
  environment::SkyHarmonics sky;             ///< of the rest
  environment::SkyHarmonics bouncing_sky;    ///< with the sources: they light occluders, too
  gpu::Texture map;                          ///< of the rest; RGBA16F, prefiltered
  gpu::Texture picture;                      ///< of all; RGBA16F, valid if it is shown
};

/// Reads and prepares an environment. Throws InputError: see read_environment().
EnvironmentLight environment_light(gpu::Device& device, const EnvironmentSource& source);

/// Light of an environment of intensity 1 that arrives on each texel of each skin mesh of an asset, on the
/// device. Instances of the asset that are turned alike share it.
struct SkyOnSkin {
  std::shared_ptr<const EnvironmentLight> of;       ///< none: no maps
  double rotation_deg = 0;                          ///< of the environment
  glm::mat3 world_from_asset{1};                    ///< a rotation
  environment::SkyHarmonics sky{}, bouncing_sky{};  ///< in the coordinates of the asset
  std::vector<passes::SkyMaps> maps;
  bool is_of(const EnvironmentLight& environment, double rotation_deg,
             const glm::mat3& world_from_asset) const;
};

/// Multiplies the harmonics of the sky with the transfer of each texel. `occlusion`: one per skin mesh. Takes
/// some 15 ms per mesh, on the processor.
SkyOnSkin sky_on_skin(gpu::Device& device, std::shared_ptr<const EnvironmentLight> environment_light,
                      double rotation_deg, const glm::mat3& world_from_asset,
                      const std::vector<environment::Occlusion>& occlusion);

/// Returns directional lights as wide as the sources, turned and multiplied as the settings say.
std::vector<scene::Light> environment_lights(const std::vector<environment::Source>& sources,
                                             const RenderSettings& settings);

/// Fills in the environment: its turn, its intensity, the irradiance by normal.
void fill_environment(io::FrameIo& frame, const EnvironmentLight& environment_light,
                      const RenderSettings& settings);

}  // namespace dermis::setup
