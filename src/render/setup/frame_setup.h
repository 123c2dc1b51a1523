// SPDX-License-Identifier: MIT
/// From a scene and settings to what a plan and a frame need: cameras, lights, profiles, heads. No device.
#pragma once

#include <optional>
#include <vector>

#include "dermis/settings.h"
#include "render/passes/head.h"
#include "render/setup/frame_camera.h"
#include "render/setup/placed_scene.h"
#include "render/setup/pool.h"
#include "render/shared/scene_io.h"
#include "render/techniques/technique.h"

namespace dermis::setup {

/// Throws InputError for a setting out of range; names it and its range. Called once per set of settings,
/// before anything is made or read for them.
void check_settings(const RenderSettings& settings);

/// A skin mesh of the plan.
struct MeshSource {
  std::size_t instance = 0;  ///< one of those that have it
  std::uint32_t mesh = 0;    ///< among the meshes of its asset
};

struct FrameSetup {
  const techniques::Technique* technique = nullptr;
  techniques::FrameSettings plan;
  std::vector<passes::Head> heads;  ///< in the order of the plan, without what api::SceneOnDevice gives them
  std::vector<MeshSource> meshes;   ///< one for each of FrameSettings::skin
  io::FrameIo frame{};
  double d_ref = 0;  ///< see reference_distance()
  int gaussians = 0;
  std::vector<scene::Light> lights;
  int environment_lights = 0;  ///< the last of the lights, which an environment brings
};

/// Returns a head of each model for each size of map that one may have, large to small.
std::vector<passes::Head> every_size(const FrameSetup& setup, const RenderSettings& settings);

/// A shadow map of a host in place of one of ours.
struct HostShadow {
  std::size_t light = 0;           ///< number in PlacedScene::lights
  glm::mat4 shadow_from_world{1};  ///< depth reversed, as passes::ShadowFit has it
  float texel = 0;                 ///< likewise
  const gpu::Texture* depth = nullptr;
  bool reversed = false;  ///< as the host has it
  bool operator==(const HostShadow&) const = default;
};

/// An image of a host in place of a map of an instance.
struct HostMapOfInstance {
  std::size_t instance = 0;
  passes::HostMap map;
};

/// The part of a host in a frame, with what its images are.
struct HostSetup {
  techniques::HostPart part;
  std::uint32_t samples = 1;           ///< of its targets
  std::vector<std::size_t> not_drawn;  ///< instances that are lit, but drawn by the host
  std::vector<std::size_t> deformed;   ///< instances whose vertices the host moves
  std::vector<HostMapOfInstance> maps;
  std::vector<HostShadow> shadows;
};

/// Decides what a frame needs. Reads no file: take_profile() of choose.h has. `settings` have passed
/// check_settings(), and the scene check_seen(): who calls this checks them before reading surroundings.
/// `environment_lights`: besides those that the settings choose; none: there is no environment, light
/// from everywhere is uniform. Throws InputError: no instance, or a row of several; see choose_camera();
/// or a map budget that does not hold one head. With a `host`, the frame is for its targets: the plan
/// does not depend on the size of the picture, and the matrices of the camera are the host's, depth
/// included. With `every_view` the plan serves every camera; else this one, and takes no more memory for
/// light and shadow maps than its heads use.
FrameSetup set_up(const PlacedScene& scene, const RenderSettings& settings, const DeviceTraits& device = {},
                  const std::optional<std::vector<scene::Light>>& environment_lights = {},
                  const HostSetup* host = nullptr, bool every_view = true);

/// Takes a setup with a `host` and `every_view`, and all that it was made from, to the camera and the size of
/// the picture that `settings` have. The plan serves all of these. Throws InputError, half way: no camera.
void set_view(FrameSetup& setup, const PlacedScene& scene, const RenderSettings& settings,
              const HostSetup& host);

/// Warns, in one line, if parts of the skin have so few texels that terms are lit at the pixel. The line says
/// which mesh has fewest, how many, what that means and what helps.
void warn_coarse(const PlacedScene& scene, const FrameSetup& setup);

}  // namespace dermis::setup
