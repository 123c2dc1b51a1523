// SPDX-License-Identifier: MIT
/// Scenes: instances of assets, lights, an environment. A Scene is a value: copies share the assets, but no
/// edits. Edits are cheap: the next frame does the work.
///
///   dermis::Scene scene;
///   const dermis::Asset head = dermis::Asset::load("head.glb");
///   scene.add({.asset = head});
///   const auto second = scene.add({.asset = head, .tint = {0.8, 0.7, 0.6}});
///   scene.set_transform(second, {1, 0, 0, 0,  0, 1, 0, 0,  0, 0, 1, 0,  0.3, 0, 0, 1});
///
/// A transform is column-major, 4x4: element 4 * column + row, columns multiplied by vectors from the right,
/// as GLSL and glm have it. Metres, right-handed, +Y up. Any number of threads may read a Scene while none
/// edits it.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dermis/asset.h"
#include "dermis/hooks.h"
#include "dermis/light.h"
#include "dermis/pose.h"
#include "dermis/profile.h"

namespace dermis {

/// An environment: that of a file, or pixels.
struct SceneEnvironment {
  std::string file{};         ///< as LightingSettings::environment names them; empty: the pixels
  int width = 0, height = 0;  ///< at most 4096 x 2048 pixels; meant to be twice as wide as high
  /// Linear Rec.709 radiance, width x height x 3 values, rows from top to bottom, as LightingSettings has
  /// files: the middle of the picture lies behind the head. Shared, and must not change.
  std::shared_ptr<const std::vector<float>> rgb{};
};

/// An asset, placed. Instances cast no shadows on each other in a Renderer; they do in render_reference().
struct Instance {
  Asset asset;
  std::string name{};  ///< for messages and files
  /// Turns, scales (one positive factor for all directions) and moves. Millimetres of skin stay
  /// millimetres: in a head of half the size light spreads over twice as much of it.
  std::array<double, 16> world_from_asset{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  bool visible = true;
  /// Instead of those of the asset's materials; SkinSettings that name a profile or a mix win over both.
  std::optional<ScatterProfile> profile{};
  std::optional<double> mix{};          ///< 0 to 1
  std::array<double, 3> tint{1, 1, 1};  ///< multiplies the skin's colour, linear, 0 to 100
  std::optional<RigPose> pose{};        ///< none: as the asset was loaded
};

/// Names an instance or a light of one scene, until that is removed.
enum class InstanceId : std::uint32_t {};
enum class LightId : std::uint32_t {};

/// A light of a scene.
struct SceneLight {
  Light light;
  /// The instance that the light moves with, in whose asset's coordinates it stands; it still lights all
  /// instances. None: it stands in the world.
  std::optional<InstanceId> rig{};
};

/// When something of an instance was last edited. Numbers grow with every edit in the program, so equal
/// numbers mean equal contents, also in copies of a scene.
struct InstanceChanges {
  std::uint64_t pose = 0;      ///< transform, visible
  std::uint64_t material = 0;  ///< profile, mix, tint
  std::uint64_t rig = 0;       ///< pose of its joints and morph targets
  bool operator==(const InstanceChanges&) const = default;
};

class Scene {
 public:
  /// Empty: cannot be rendered before it has an instance.
  Scene();
  /// One instance of the asset, where it stands, and the lights of its file, which move with its poses as
  /// their nodes do, until set_light() has changed them.
  explicit Scene(const Asset& asset);
  Scene(const Scene&);
  Scene(Scene&&) noexcept;
  Scene& operator=(const Scene&);
  Scene& operator=(Scene&&) noexcept;
  ~Scene();

  /// Loads a glTF file as a scene of one instance: Scene(Asset::load(...)); or a scene file (docs/scenes.md),
  /// known by its content, where `options` are what its assets do not say themselves. Throws as Asset::load()
  /// does.
  static Scene load(const std::filesystem::path& path, const SceneOptions& options = {},
                    const Hooks& hooks = {});
  /// Scene(Asset::built_in(...)).
  static Scene built_in(const Hooks& hooks = {});

  /// Writes a scene file, atomically: load() of it gives an equal scene, and the same picture to the bit.
  /// Assets stay in their files, which it names relative to itself. Throws InputError: an asset that is of no
  /// file, surroundings of pixels, or an instance whose pose is more than a clip at a time (says which). Also
  /// if the file cannot be written, or holds one of the assets.
  void save(const std::filesystem::path& path) const;

  /// Names the scene file or the asset, or how many instances there are.
  std::string name() const;

  // All that follow throw InputError: an id of another scene, a number out of its range or not finite, a
  // transform that is not rigid with one scale > 0. The scene is then as before.

  InstanceId add(const Instance& instance);
  void remove(InstanceId id);                 ///< with the lights of its rig
  std::vector<InstanceId> instances() const;  ///< in the order of add()
  const Instance& instance(InstanceId id) const;
  void set_transform(InstanceId id, const std::array<double, 16>& world_from_asset);
  void set_visible(InstanceId id, bool visible);
  void set_profile(InstanceId id, const std::optional<ScatterProfile>& profile);
  void set_mix(InstanceId id, std::optional<double> mix);
  void set_tint(InstanceId id, const std::array<double, 3>& tint);

  /// Poses an instance; none: as its asset was loaded. Costs a fraction of a millisecond on the host; the
  /// next frame moves the vertices, of this instance alone. Throws InputError in one line: a clip, joint or
  /// morph weight that the asset does not have (lists those it has), or a name of several nodes. Likewise for
  /// a clip with faulty key frames, a number out of range or not finite, and a pose in which something is
  /// more than 1e6 m away. The instance then stands as before.
  void set_pose(InstanceId id, const std::optional<RigPose>& pose);
  /// set_pose() with one clip.
  void pose(InstanceId id, const std::string& clip, double seconds);

  /// Returns where these vertices stand, posed, metres in the world. A mesh and its vertices have the numbers
  /// that their source has (dermis/asset.h). Throws InputError: no such mesh, a vertex that no triangle uses,
  /// a mesh that stands at several nodes.
  std::vector<std::array<double, 3>> positions_m(InstanceId id, int mesh,
                                                 std::span<const std::uint32_t> vertices) const;

  LightId add_light(const SceneLight& light);
  void remove_light(LightId id);
  std::vector<LightId> lights() const;
  const SceneLight& light(LightId id) const;
  void set_light(LightId id, const SceneLight& light);

  /// LightingSettings::environment, where it names one, wins over these.
  void set_environment(const std::optional<SceneEnvironment>& environment);
  const std::optional<SceneEnvironment>& environment() const;

  InstanceChanges changes(InstanceId id) const;
  /// Also grows when an instance moves lights, by a rig of them or by a pose of its file's nodes.
  std::uint64_t light_changes() const;
  std::uint64_t environment_changes() const;

  struct State;  // of the library
  const State& state() const { return *state_; }

 private:
  std::unique_ptr<State> state_;
};

}  // namespace dermis
