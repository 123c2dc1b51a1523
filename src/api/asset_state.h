// SPDX-License-Identifier: MIT
/// State of an Asset, for the library and its tests.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "base/core/assert.h"
#include "dermis/asset.h"
#include "head/scene/asset_data.h"

namespace dermis {

struct Asset::State {
  /// Source of an asset.
  struct Source {
    std::filesystem::path file;  ///< absolute; empty: built in
    SceneOptions options;
    std::string skin = "medium";  ///< of the built-in head
    bool holds_time = false;      ///< a scene file says at which time of its clip it stands
  };

  std::shared_ptr<const scene::AssetData> data;
  std::optional<Source> source;  ///< none: made in memory

  /// `data`: measured, unless it has no primitives.
  static Asset make(std::shared_ptr<const scene::AssetData> data, std::optional<Source> source = {}) {
    DERMIS_ASSERT(data->primitives.empty() || !data->caster_corners_m.empty());
    return Asset(std::make_shared<const State>(State{std::move(data), std::move(source)}));
  }
  /// Null for an asset that was moved away.
  static std::shared_ptr<const scene::AssetData> of(const Asset& asset) {
    return asset.state_ ? asset.state_->data : nullptr;
  }
  static const std::optional<Source>& source_of(const Asset& asset) { return asset.state_->source; }
};

}  // namespace dermis
