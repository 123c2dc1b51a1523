// SPDX-License-Identifier: MIT
// State of a renderer, which its prepared frames share: the device, pipelines, and the assets that are on the
// device.
#pragma once

#include <memory>
#include <vector>

#include "api/memory.h"
#include "api/readbacks.h"
#include "api/scene_on_device.h"
#include "base/core/hooks.h"
#include "dermis/renderer.h"
#include "gpu/device.h"
#include "gpu/pipelines.h"

namespace dermis {

struct Renderer::State {
  explicit State(const Options& wanted);
  State(const vulkan::Host& host, const Hooks& hooks);

  /// Runs a call that prepares a frame of the scene, with all hooks. Throws InternalError for every call
  /// after the first one that did.
  template <class Work>
  auto preparing(const Scene& scene, const Work& work) {
    return call(scene, options.hooks, work);
  }
  /// Runs a call that takes no longer than a frame, with the log alone.
  template <class Work>
  auto drawing(const Scene& scene, const Work& work) {
    return call(scene, Hooks{.log = options.hooks.log}, work);
  }

  /// Returns the asset of each instance: those that a frame holds or the last scene had, else examines them.
  std::vector<api::AssetPointer> assets_of(const Scene& scene);

  /// Returns the cached environment if unchanged, else loads it; null if there is none.
  std::shared_ptr<const setup::EnvironmentLight> environment_light(const Scene& scene,
                                                                   const RenderSettings& settings);

  Options options;
  gpu::Device device;
  gpu::PipelineLibrary library;
  api::Readbacks readbacks;
  std::vector<api::AssetPointer> last_assets;                ///< of the last scene, each once
  std::vector<std::weak_ptr<api::SharedAsset>> live_assets;  ///< those and what other frames hold
  std::shared_ptr<const setup::EnvironmentLight> last_environment;
  bool broken = false;  ///< by a mistake of ours: what is on the device may be half-done

 private:
  template <class Work>
  auto call(const Scene& scene, const Hooks& hooks, const Work& work) {
    if (broken)
      throw InternalError("internal error: this renderer has met one before and may only be destroyed");
    const HookScope scope(hooks);
    try {
      return api::naming_the_scene(scene, work);
    } catch (const InternalError&) {
      broken = true;
      throw;
    }
  }
};

}  // namespace dermis
