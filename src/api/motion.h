// SPDX-License-Identifier: MIT
/// Instances as they stood in the frame before, for labels of motion.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "dermis/scene.h"
#include "gpu/frame_memory.h"
#include "render/passes/frame_data.h"
#include "render/setup/placed_scene.h"
#include "render/shared/scene_io.h"

namespace dermis::api {

class Motion {
 public:
  /// Writes Head::before and Head::placements_before of `data`, whose heads have their poses, and
  /// remembers this frame. `ids`: of all instances of `placed`. An instance of the frame before counts if it
  /// was of the same asset.
  void fill(gpu::FrameMemory& memory, const setup::PlacedScene& placed, const std::vector<InstanceId>& ids,
            passes::FrameData& data);

  /// Makes the frame before the last one the one before the next: the last one was not drawn.
  void undo() { last_ = before_; }

 private:
  struct Stood {
    std::shared_ptr<const scene::AssetData> asset;
    io::SimilarityIo world_from_asset;
    std::shared_ptr<const setup::PosedAsset> posed;  // null: none
  };
  struct Frame {
    glm::mat4 clip_from_world{1};
    // A row of heads has several numbers of one instance.
    std::map<std::pair<InstanceId, std::uint32_t>, Stood> heads;
  };
  Frame last_, before_;
};

}  // namespace dermis::api
