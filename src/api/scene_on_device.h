// SPDX-License-Identifier: MIT
/// The assets of a scene on the device, and what its instances add to them: looks, and the light of the sky.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "dermis/asset.h"
#include "render/passes/asset/gpu_asset.h"
#include "render/passes/frame_data.h"
#include "render/setup/environment_light.h"
#include "render/setup/frame_setup.h"

namespace dermis::api {

/// An asset that (once a frame has found room) is on the device; shared by all that show it.
struct SharedAsset {
  std::shared_ptr<const scene::AssetData> data;
  std::optional<Asset> source{};        ///< whose landmarks divide the skin; none: not asked for
  std::optional<passes::GpuAsset> gpu;  ///< looks point into it: never moved
  /// one per skin mesh, once an environment was asked for; values are on the device only
  std::vector<environment::Occlusion> bent_normal;
  bool has_shape = false;           ///< vertices know the shape of the body, once a profile asked for it
  bool has_label_vertices = false;  ///< of each skin mesh and page of surfaces, once labels were asked for
  double upload_ms = 0;
  bool warned_of_unwrap = false;  ///< once is enough, however many views follow
};
using AssetPointer = std::shared_ptr<SharedAsset>;

/// Returns each asset where it first stands.
std::vector<AssetPointer> each_once(const std::vector<AssetPointer>& assets);

/// Materials of an asset for instances that change them alike.
struct SharedLook {
  AssetPointer asset;
  passes::LookSettings settings;
  passes::GpuLook look;
};

/// The sky that the skin of an asset sees, for instances that are turned alike.
struct SharedSky {
  AssetPointer asset;
  setup::SkyOnSkin sky;
};

/// All that a frame shows of a scene. Holds what it points to.
class SceneOnDevice {
 public:
  SceneOnDevice() = default;
  /// `assets`: one per instance.
  explicit SceneOnDevice(std::vector<AssetPointer> assets) : assets_(std::move(assets)) {}

  std::vector<AssetPointer> different_assets() const;                  ///< each once
  const std::vector<AssetPointer>& assets() const { return assets_; }  ///< one per instance
  const AssetPointer& asset(std::size_t instance) const { return assets_[instance]; }
  const std::shared_ptr<const SharedLook>& look(std::size_t instance) const {  ///< after upload()
    return looks_[instance];
  }
  /// After upload(); null: there is no environment, or the instance is not seen.
  std::shared_ptr<const SharedSky> sky(std::size_t instance) const {
    return instance < skies_.size() ? skies_[instance] : nullptr;
  }
  double upload_ms() const;

  /// Brings the scene to the device: assets, looks, and the gutters for `heads`. With an environment
  /// also what the skin sees of it, with labels the parts of the skin. Leaves out what is there, also of
  /// `before`, the same frame's last scene. With a `host`: its maps, and all also for instances that the
  /// camera does not see.
  void upload(gpu::PipelineLibrary& library, const setup::PlacedScene& scene, const RenderSettings& settings,
              const setup::FrameSetup& setup, std::span<const passes::Head> heads,
              const std::shared_ptr<const setup::EnvironmentLight>& environment, const SceneOnDevice& before,
              const setup::HostSetup* host = nullptr);

  /// Tells heads where their assets, looks and skies are. After upload(); the scene must outlive them.
  void give(std::span<passes::Head> heads) const;

 private:
  void make_looks(gpu::Device& device, const setup::PlacedScene& scene, const RenderSettings& settings,
                  const SceneOnDevice& before, const setup::HostSetup* host);
  void make_skies(gpu::Device& device, const setup::PlacedScene& scene, const setup::FrameSetup& setup,
                  const RenderSettings& settings,
                  const std::shared_ptr<const setup::EnvironmentLight>& environment,
                  const SceneOnDevice& before, const setup::HostSetup* host);

  // By instance.
  std::vector<AssetPointer> assets_;
  std::vector<std::shared_ptr<const SharedLook>> looks_;
  std::vector<std::shared_ptr<const SharedSky>> skies_;  // null where none is needed
};

}  // namespace dermis::api
