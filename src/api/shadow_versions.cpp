// SPDX-License-Identifier: MIT
#include "api/shadow_versions.h"

#include <algorithm>
#include <utility>

namespace dermis::api {
namespace {

// Returns whether both name the same object, also one that is gone: another one in its place is another.
template <class T>
bool is_same(const std::weak_ptr<T>& a, const std::weak_ptr<T>& b) {
  return !a.owner_before(b) && !b.owner_before(a);
}

// A host writes what it deforms, its images and its shadow maps whenever it likes.
bool may_change_unseen(const passes::Head& head, const SharedLook& look, const setup::HostSetup* host) {
  return !head.host_shadows.empty() || !look.settings.maps.empty() ||
         (host &&
          std::find(host->deformed.begin(), host->deformed.end(), head.instance) != host->deformed.end());
}

}  // namespace

bool ShadowVersions::are_equal(const Source& a, const Source& b) {
  return is_same(a.look, b.look) && is_same(a.posed, b.posed) && a.world_from_asset == b.world_from_asset &&
         a.shadow_from_world == b.shadow_from_world && a.shadow_side == b.shadow_side &&
         a.white_albedo == b.white_albedo;
}

void ShadowVersions::fill(const setup::FrameSetup& setup, const SceneOnDevice& scene,
                          const setup::PlacedScene& placed, const setup::HostSetup* host,
                          passes::FrameData& data) {
  if (!setup.plan.keep_shadows) return;
  heads_.resize(data.heads.size());
  for (passes::Head& head : data.heads) {
    const std::shared_ptr<const SharedLook>& look = scene.look(head.instance);
    if (may_change_unseen(head, *look, host)) continue;

    Source now{.look = look,
               .posed = placed.instances[head.instance].posed,
               .world_from_asset = head.world_from_asset,
               .shadow_from_world = head.shadow_from_world,
               .shadow_side = head.shadow_side,
               .white_albedo = setup.frame.white_albedo != 0};
    Source& before = heads_[head.number];
    now.version = before.version != 0 && are_equal(before, now) ? before.version : ++last_;
    before = std::move(now);
    head.shadow_version = before.version;
  }
}

}  // namespace dermis::api
