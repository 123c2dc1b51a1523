// SPDX-License-Identifier: MIT
/// Numbers what the shadow maps of each head show: the same number, the same maps.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "api/scene_on_device.h"
#include "render/setup/frame_setup.h"

namespace dermis::api {

class ShadowVersions {
 public:
  /// Sets passes::Head::shadow_version of the heads of a frame. A head keeps the number of the frame
  /// before if nothing that casts its shadows, and no light, has moved or changed since. Else it has a new
  /// one. It is 0 where a host may change it unseen, and in plans that keep no maps.
  void fill(const setup::FrameSetup& setup, const SceneOnDevice& scene, const setup::PlacedScene& placed,
            const setup::HostSetup* host, passes::FrameData& data);

  /// Gives new numbers from here on: the last frame was not drawn.
  void forget() { heads_.clear(); }

 private:
  // All that the layers of a head are drawn from. Objects are told apart without being kept.
  struct Source {
    std::weak_ptr<const SharedLook> look;  // of its asset
    std::weak_ptr<const setup::PosedAsset> posed;
    scene::Similarity world_from_asset;
    std::vector<glm::mat4> shadow_from_world;
    std::uint32_t shadow_side = 0;
    bool white_albedo = false;
    std::uint64_t version = 0;
  };
  static bool are_equal(const Source& a, const Source& b);

  std::vector<Source> heads_;  // by number, of the last frame
  std::uint64_t last_ = 0;
};

}  // namespace dermis::api
