// SPDX-License-Identifier: MIT
/// Instances that take poses: their moved vertices on the device, kept from frame to frame.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "api/scene_on_device.h"
#include "dermis/scene.h"
#include "gpu/frame_memory.h"
#include "render/passes/pose/move_rig/move_rig.h"
#include "render/passes/pose/turn_sky/turn_sky.h"
#include "render/setup/placed_scene.h"

namespace dermis::api {

class PosedInstances {
 public:
  /// Makes vertices of their own for the instances that have a pose, and in an environment maps of its light,
  /// unless they are there; forgets those of others. `ids`: of all instances of `placed`. Throws DeviceError:
  /// no memory, or more than shaders read.
  /// `recorded`: record() moves them, else fill() says what a plan is to move.
  void keep(gpu::PipelineLibrary& library, const SceneOnDevice& scene, const std::vector<InstanceId>& ids,
            const setup::PlacedScene& placed, bool recorded = false);

  /// Writes what a frame moves and lights anew, and where its heads have their vertices. Needs their
  /// assets.
  /// Both count as done from here on, unless the frame is only `measured`.
  void fill(gpu::FrameMemory& memory, passes::FrameData& data, bool measured = false);

  /// Moves and lights anew what has changed since the last call, seen or not, by commands of their own. Makes
  /// nothing: what they need travels in the command buffer.
  void record(gpu::Cmd& cmd);

  /// Returns the moved shape of an instance, and the placements of its surfaces as record() writes them, one
  /// per page or none; null: it has no pose.
  const passes::PosedShape* shape(std::size_t instance) const;
  std::vector<gpu::BufferBinding> placements(std::size_t instance) const;

  /// Makes the next frame move all of them: the last one was not drawn, or what it made of them is lost.
  void move_all();

 private:
  struct Posed {
    AssetPointer asset;
    passes::PosedShape shape;
    // InstanceChanges::rig of the pose that the vertices have, and of that whose light the maps have; 0: none
    std::uint64_t moved = 0, lit = 0;
    std::uint64_t shown = 0;  // likewise, of the pose that the plan has seen
    std::shared_ptr<const SharedSky> lit_by;
    bool has_shape = false;  // as the asset, when its buffers were copied

    // For record(); empty otherwise.
    gpu::Buffer matrices, weights, sky;
    std::vector<gpu::Buffer> placements;  // PlacementIo[], one per page, or none
  };
  struct Current {
    std::shared_ptr<Posed> posed;  // null: the instance has no pose
    std::shared_ptr<const setup::PosedAsset> pose;
    std::uint64_t change = 0;
    bool visible = true;
    std::shared_ptr<const SharedSky> sky;  // null: no environment, or the instance is not seen
  };
  static std::shared_ptr<Posed> make(gpu::Device& device, const AssetPointer& asset);
  static void make_sky(gpu::Device& device, Posed& posed);
  static void make_recorded(gpu::Device& device, const Current& current);
  static bool is_lit(const Current& current);
  static passes::RigMove recorded_move(gpu::Cmd& cmd, const Current& current);
  static passes::SkyTurn recorded_turn(gpu::Cmd& cmd, const Current& current);
  static void add_move(gpu::FrameMemory& memory, const Current& current, passes::FrameData& data);
  static void add_sky_turn(gpu::FrameMemory& memory, const Current& current, passes::FrameData& data);
  static void add_placements(gpu::FrameMemory& memory, const Current& current, passes::Head& head);

  std::map<InstanceId, std::shared_ptr<Posed>> posed_;
  std::vector<Current> instances_;  // by number in the scene
  bool recorded_ = false;
  passes::MoveRig move_;  // for record()
  passes::TurnSky turn_;
  bool move_prepared_ = false, turn_prepared_ = false;
};

}  // namespace dermis::api
