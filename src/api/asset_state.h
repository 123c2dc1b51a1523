// SPDX-License-Identifier: MIT
/// What an Asset holds, for the library and its tests.
#pragma once

#include <memory>

#include "dermis/asset.h"
#include "scene/scene.h"

namespace dermis {

struct Asset::State {
  std::shared_ptr<const scene::Scene> data;

  static Asset make(std::shared_ptr<const scene::Scene> data) {
    return Asset(std::make_shared<const State>(State{std::move(data)}));
  }
  /// Null for an asset that was moved away.
  static std::shared_ptr<const scene::Scene> of(const Asset& asset) {
    return asset.state_ ? asset.state_->data : nullptr;
  }
};

}  // namespace dermis
