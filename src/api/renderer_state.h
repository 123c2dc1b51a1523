// SPDX-License-Identifier: MIT
// What a renderer owns, and its prepared frames share: the device, pipelines, and the scenes that are on the
// device.
#pragma once

#include <memory>
#include <optional>

#include "api/memory.h"
#include "core/hooks.h"
#include "dermis/renderer.h"
#include "gpu/device.h"
#include "passes/gpu_scene.h"
#include "setup/environment_light.h"
#include "setup/subject.h"

namespace dermis {

namespace api {

/// A scene, examined and (once per frame has found room) on the device; shared by all frames that show it.
struct SharedScene {
  setup::Subject subject;
  std::optional<float> mix;             ///< it is uploaded with
  std::optional<passes::GpuScene> gpu;  ///< its materials point into it: never moved
  /// one per skin mesh, once an environment was asked for; values are on the device only
  std::vector<environment::Occlusion> bent_normal;
  double upload_ms = 0;
  bool warned_coarse = false;  ///< once is enough, however many views follow
};

}  // namespace api

struct Renderer::State {
  explicit State(const Options& wanted);

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

  /// Returns the cached scene if it is this one with the same mix, else examines this one.
  std::shared_ptr<api::SharedScene> shared(const Scene& scene, const RenderSettings& settings);

  /// Returns the cached environment if unchanged, else loads it; null if the settings name none.
  std::shared_ptr<const setup::EnvironmentLight> environment_light(const RenderSettings& settings);

  Options options;
  gpu::Device device;
  gpu::PipelineLibrary library;
  std::shared_ptr<api::SharedScene> last_scene;
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
