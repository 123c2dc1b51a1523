// SPDX-License-Identifier: MIT
/// A frame with its plan, memory and pipelines, and its scene on the device: what a PreparedFrame and a
/// Session have in common.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "api/motion.h"
#include "api/posed_instances.h"
#include "api/renderer_state.h"
#include "api/scene_on_device.h"
#include "api/shadow_versions.h"
#include "frame/executor.h"
#include "render/setup/frame_setup.h"

namespace dermis::api {

/// Counts of recording a frame.
struct RecordCounts {
  std::uint64_t shadow_maps = 0;  ///< layers that were drawn
  RecordedWork work;
  std::uint64_t light_map_bytes = 0;  ///< of the plan
};

void fill_recorded(Statistics& statistics, const RecordCounts& counts);

class PlannedFrame {
 public:
  struct Options {
    /// A plan brings what it needs for every camera with it, light maps of every size for instance, so that a
    /// head may come nearer without an upload.
    bool all_views = false;
    /// Members of techniques::FrameSettings.
    bool picture = true, display = true, linear = false, matte = false;
    std::uint32_t labels = 0;
  };

  explicit PlannedFrame(std::shared_ptr<Renderer::State> renderer) : PlannedFrame(std::move(renderer), {}) {}
  PlannedFrame(std::shared_ptr<Renderer::State> renderer, const Options& options)
      : renderer_(std::move(renderer)), options_(options) {}

  /// Sets scene and settings. Makes a plan with its memory unless that of the last frame serves, and uploads
  /// what is new. Returns whether it made a plan.
  ///
  /// Throws InputError: the frame is as before. Throws DeviceError or Cancelled: the frame cannot be drawn
  /// until this succeeds.
  bool set(const Scene& scene, const RenderSettings& settings,
           const std::optional<setup::HostSetup>& host = {});

  /// Takes the scene and the settings of the last set() as another camera sees them, in this part of its
  /// targets. Makes nothing and uploads nothing. Throws InputError, and is as before: the camera is none, or
  /// its depth runs the other way than the host's.
  void set_view(const CameraMatrices& camera, const VkRect2D& area);

  /// False if the last set() has thrown half way.
  bool is_ready() const { return ready_; }
  void make_unready() {
    ready_ = false;
    posed_.move_all();
    motion_.undo();
    shadow_versions_.forget();
    kept_texels_ = {};
  }
  void make_ready() { ready_ = true; }
  /// Until make_ready(); what has moved stays moved.
  void pause() { ready_ = false; }

  /// Writes what changes per frame. Poses count as drawn from here on, unless make_unready() is called, or
  /// the frame is only `measured`.
  passes::FrameData data(gpu::FrameMemory& memory, bool measured = false);

  /// Calls `record`, which records a frame, and returns what that has counted.
  RecordCounts count(const std::function<void()>& record) const;

  /// Instances in poses, for the frames of a host: these record what has moved by themselves.
  PosedInstances& posed() { return posed_; }

  gpu::Device& device() const { return renderer_->device; }
  Renderer::State& renderer() const { return *renderer_; }
  const std::shared_ptr<Renderer::State>& shared_renderer() const { return renderer_; }
  frame::Executor<passes::FrameData>& executor() { return *executor_; }
  const techniques::FrameOutputs& outputs() const { return outputs_; }
  const setup::FrameSetup& setup() const { return setup_; }
  const SceneOnDevice& scene() const { return scene_; }
  double pipeline_ms() const { return pipeline_ms_; }

 private:
  /// Inputs of a setup.
  struct Input {
    setup::PlacedScene placed;
    std::optional<std::vector<scene::Light>> environment_lights;
    std::optional<setup::HostSetup> host;
  };
  setup::FrameSetup set_up(const Input& input, const RenderSettings& settings) const;
  void plan(const RenderSettings& settings, const setup::FrameSetup& next);

  std::shared_ptr<Renderer::State> renderer_;
  Options options_;
  SceneOnDevice scene_;
  PosedInstances posed_;
  Motion motion_;
  ShadowVersions shadow_versions_;
  std::vector<InstanceId> ids_;  // of the scene's instances
  std::shared_ptr<const setup::EnvironmentLight> environment_;
  setup::FrameSetup setup_;
  Input input_;  // and settings_: of the last set()
  RenderSettings settings_;
  techniques::FrameOutputs outputs_;
  std::uint64_t light_map_bytes_ = 0;  // of the plan
  std::optional<frame::Executor<passes::FrameData>> executor_;
  passes::KeptMaps kept_shadows_, kept_texels_;  // of its memory
  /// Of the meshes whose metric the memory of the plan holds, in the order of their unwraps.
  std::vector<AssetPointer> unwrap_assets_;
  double pipeline_ms_ = 0;
  bool ready_ = false;
};

}  // namespace dermis::api
